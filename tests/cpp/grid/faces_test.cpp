// SPDX-License-Identifier: MIT
// The walk over minimal faces against their definition: overlaps of two leaves' sides.
#include "grid/faces.h"
#include "grid/splitting_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "kdmanifold/build.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

struct Scene {
  std::string name;
  Grid grid;
};

std::vector<Scene> scenes() {
  std::vector<Scene> list;
  const auto add = [&](std::string name, const Mesh& mesh, const BuildOptions& options) {
    list.push_back({std::move(name), build_grid(mesh, options)});
  };
  const Mesh torus = shapes::rotated(shapes::torus(1, 0.4, 20, 10), Vec3(1, 2, 3), 1);
  add("uniform torus", torus, {.strategy = SplitStrategy::kUniform, .depth = 9});
  add("octree torus", torus,
      {.strategy = SplitStrategy::kOctree, .relative_tolerance = 0.01, .depth = 12});
  add("median torus", torus, {.strategy = SplitStrategy::kMedian, .depth = 9});
  add("adaptive torus", torus, {.strategy = SplitStrategy::kAdaptive, .relative_tolerance = 0.02});
  for (std::uint32_t seed = 0; seed < 12; ++seed) {
    const std::string number = std::to_string(seed);
    const Mesh tetrahedra = shapes::random_tetrahedra(4, seed);
    add("median tetrahedra " + number, tetrahedra,
        {.strategy = SplitStrategy::kMedian, .depth = 7 + static_cast<int>(seed % 4)});
    add("octree lattice tetrahedra " + number, shapes::integer_tetrahedra(5, 4, seed),
        {.strategy = SplitStrategy::kOctree, .depth = 8});
    add("median voxels " + number, shapes::random_voxels(3, 0.4, seed),
        {.strategy = SplitStrategy::kMedian, .depth = 9});
  }
  return list;
}

TEST(Faces, EveryHalfEdgeCrossesExactlyOne) {
  for (const Scene& scene : scenes()) {
    const GridData& grid = scene.grid.data();
    std::vector<int> visits(3 * grid.hits.size(), 0);
    for_each_face(grid, cell_boxes(grid), [&](const MinimalFace& face) {
      Index hits = 0;
      for (const FaceEdge& edge : face.edges) {
        for (const HitId h : edge.hits) {
          ++visits[3 * h + edge.slot];
          ++hits;
        }
      }
      EXPECT_EQ(face.hit_count(), hits);
      EXPECT_GT(hits, 0u) << "faces without hits are not visited";
    });
    ASSERT_GT(grid.hits.size(), 0u) << scene.name;
    EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), static_cast<long>(visits.size()))
        << scene.name;
  }
}

TEST(Faces, AFaceIsTheOverlapOfItsLeaves) {
  for (const Scene& scene : scenes()) {
    const GridData& grid = scene.grid.data();
    const std::vector<LatticeBox> boxes = cell_boxes(grid);
    int wrong = 0;
    for_each_face(grid, boxes, [&](const MinimalFace& face) {
      const LatticeBox& below = boxes[face.below];
      const LatticeBox& above = boxes[face.above];
      wrong += grid.cells[face.below].leaf() && grid.cells[face.above].leaf() ? 0 : 1;
      wrong += below.hi[face.axis] == face.plane && above.lo[face.axis] == face.plane ? 0 : 1;
      for (int i = 0; i < 2; ++i) {
        const int k = i == 0 ? next_axis(face.axis) : previous_axis(face.axis);
        wrong += face.lo(i) == std::max(below.lo[k], above.lo[k]) ? 0 : 1;
        wrong += face.hi(i) == std::min(below.hi[k], above.hi[k]) ? 0 : 1;
      }
      for (int side = 0; side < 4; ++side) {
        const int along = side % 2;  // sides 0 and 2 run along u
        const FaceEdge& edge = face.edges[side];
        for (const HitId h : edge.hits) {
          const std::int32_t position = floor_of(grid.hits[h].position);
          wrong += position >= face.lo(along) && position < face.hi(along) ? 0 : 1;
        }
      }
    });
    EXPECT_EQ(wrong, 0) << scene.name;
  }
}

using Place = std::array<LinePosition, 3>;

// Where the hits are, exactly: lattice coordinates, in units of a position, and along which axis.
std::map<std::pair<int, Place>, int> places_of_hits(const GridData& grid,
                                                    const std::vector<LatticeBox>& boxes) {
  std::map<std::pair<int, Place>, int> places;
  for_each_splitting_edge(grid, boxes, [&](const SplittingEdge& edge) {
    const int side = 3 - edge.axis - edge.split.axis();
    const bool high = edge.i == 1 || edge.i == 2;
    for (const HitId h : edge.hits) {
      Place place{};
      place[edge.axis] = grid.hits[h].position;
      place[edge.split.axis()] = static_cast<LinePosition>(edge.split.value());
      place[side] = static_cast<LinePosition>(high ? edge.box.hi[side] : edge.box.lo[side]);
      ++places[{edge.axis, place}];
    }
  });
  return places;
}

// Every pair of leaves with a common rectangle, and how many hits lie on its outline.
using Overlaps = std::map<std::tuple<int, Index, Index>, Index>;
Overlaps overlaps_with_hits(const GridData& grid, const std::vector<LatticeBox>& boxes) {
  const auto places = places_of_hits(grid, boxes);
  Overlaps overlaps;
  for (Index a = 0; a < boxes.size(); ++a) {
    if (!grid.cells[a].leaf()) continue;
    for (Index b = 0; b < boxes.size(); ++b) {
      if (!grid.cells[b].leaf()) continue;
      for (int w = 0; w < 3; ++w) {
        if (boxes[a].hi[w] != boxes[b].lo[w]) continue;
        const std::array<int, 2> across{next_axis(w), previous_axis(w)};
        std::array<std::int32_t, 3> lo{}, hi{};
        for (const int k : across) {
          lo[k] = std::max(boxes[a].lo[k], boxes[b].lo[k]);
          hi[k] = std::min(boxes[a].hi[k], boxes[b].hi[k]);
        }
        if (lo[across[0]] >= hi[across[0]] || lo[across[1]] >= hi[across[1]]) continue;
        Index count = 0;
        for (const auto& [key, hits] : places) {
          const auto& [axis, place] = key;
          if (axis == w || place[w] != static_cast<LinePosition>(boxes[a].hi[w])) continue;
          const int other = 3 - axis - w;
          const auto at = static_cast<std::int32_t>(place[other]);
          if (at != lo[other] && at != hi[other]) continue;
          const std::int32_t position = floor_of(place[axis]);
          if (position >= lo[axis] && position < hi[axis]) ++count;
        }
        if (count > 0) overlaps[{w, a, b}] = count;
      }
    }
  }
  return overlaps;
}

TEST(Faces, EveryOverlapOfLeavesWithHitsIsVisited) {
  const std::vector<std::pair<const char*, Grid>> grids = {
      {"uniform", build_grid(shapes::rotated(shapes::cube(), Vec3(1, 2, 3), 1),
                             {.strategy = SplitStrategy::kUniform, .depth = 6})},
      {"octree", build_grid(shapes::random_tetrahedra(2, 3),
                            {.strategy = SplitStrategy::kOctree, .depth = 7})},
      {"median", build_grid(shapes::random_tetrahedra(3, 5),
                            {.strategy = SplitStrategy::kMedian, .depth = 8})},
      {"median voxels", build_grid(shapes::random_voxels(3, 0.4, 2),
                                   {.strategy = SplitStrategy::kMedian, .depth = 7})}};
  for (const auto& [title, handle] : grids) {
    const auto& name = title;  // clang 14 captures no structured bindings
    const GridData& grid = handle.data();
    const std::vector<LatticeBox> boxes = cell_boxes(grid);
    Overlaps visited;
    for_each_face(grid, boxes, [&](const MinimalFace& face) {
      if (face.strip()) return;
      const bool fresh =
          visited.emplace(std::tuple(face.axis, face.below, face.above), face.hit_count()).second;
      EXPECT_TRUE(fresh) << name << ": a face was visited twice";
    });
    EXPECT_GT(visited.size(), 20u) << name;
    EXPECT_EQ(visited, overlaps_with_hits(grid, boxes)) << name;
  }
}

TEST(Faces, UniformGridsHaveAStripForEveryHit) {
  const Grid handle =
      build_grid(shapes::icosphere(2), {.strategy = SplitStrategy::kUniform, .depth = 9});
  const GridData& grid = handle.data();
  std::vector<int> strips(grid.hits.size(), 0);
  const std::vector<LatticeBox> boxes = cell_boxes(grid);
  for_each_face(grid, boxes, [&](const MinimalFace& face) {
    if (!face.strip()) return;
    // Two coincident edges with the same hits, and no others.
    const int along = face.lo(0) == face.hi(0) ? 1 : 0;
    EXPECT_EQ(face.edges[1 - along].hits.size() + face.edges[3 - along].hits.size(), 0u);
    const FaceEdge& one = face.edges[along];
    const FaceEdge& other = face.edges[along + 2];
    EXPECT_NE(one.owner, other.owner);
    ASSERT_EQ(one.hits.size(), other.hits.size());
    for (Index i = 0; i < one.hits.size(); ++i) {
      EXPECT_EQ(grid.hits[one.hits.first + i].position, grid.hits[other.hits.first + i].position);
      EXPECT_EQ(grid.hits[one.hits.first + i].leaving(), grid.hits[other.hits.first + i].leaving());
      ++strips[one.hits.first + i];
      ++strips[other.hits.first + i];
    }
    // The leaves lie diagonally opposite: they share the edge only.
    const int k = along == 1 ? next_axis(face.axis) : previous_axis(face.axis);
    EXPECT_TRUE(boxes[face.below].hi[k] == boxes[face.above].lo[k] ||
                boxes[face.below].lo[k] == boxes[face.above].hi[k]);
  });
  EXPECT_GT(grid.hits.size(), 100u);
  EXPECT_EQ(std::count(strips.begin(), strips.end(), 1), static_cast<long>(strips.size()));
}

TEST(Faces, AllHalfEdgesOfOneDirectionStartOnOneSide) {
  // Round a face, hits that enter the solid and hits that leave it alternate, and so do the leaves
  // in which their half-edges start.
  for (const Scene& scene : scenes()) {
    const GridData& grid = scene.grid.data();
    int wrong = 0;
    for_each_face(grid, cell_boxes(grid), [&](const MinimalFace& face) {
      if (face.strip()) return;
      std::vector<std::pair<bool, bool>> outline;  // enters the solid, starts below
      for (int side = 0; side < 4; ++side) {
        const FaceEdge& edge = face.edges[side];
        for (Index i = 0; i < edge.hits.size(); ++i) {
          const Hit& hit = grid.hits[side < 2 ? edge.hits.first + i : edge.hits.beyond - 1 - i];
          outline.emplace_back(hit.leaving() != (side < 2), starts_below(edge, hit.reversed()));
        }
      }
      wrong += outline.size() % 2 == 0 ? 0 : 1;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& next = outline[(i + 1) % outline.size()];
        wrong += outline[i].first != next.first && outline[i].second != next.second ? 0 : 1;
      }
    });
    EXPECT_EQ(wrong, 0) << scene.name;
  }
}

TEST(FirstAbove, FindsTheCutInShortAndLongRanges) {
  std::vector<Hit> hits;
  for (std::uint32_t i = 0; i < 40; ++i) {
    hits.push_back(Hit((10 + i / 2) << kFractionBits | (i % 2 == 0 ? 0u : 4095u), 0, false, false));
  }
  for (Index begin = 0; begin < 40; begin += 7) {
    for (Index end = begin; end <= 40; end += 3) {
      for (std::int32_t value = 8; value < 33; ++value) {
        Index expected = begin;
        while (expected < end && floor_of(hits[expected].position) < value) ++expected;
        ASSERT_EQ(first_above(hits, {begin, end}, value), expected);
      }
    }
  }
}

}  // namespace
}  // namespace kdm
