// SPDX-License-Identifier: MIT
// The surface followed across a face: hand-made sections, and whole grids against a recount of
// what the section with each face really joins.
#include "link/trace.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grid/faces.h"
#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

// A closed mesh of integer coordinates cut by the plane z = 50; the rectangle is [0, 100]^2.
class Section {
 public:
  static constexpr std::int32_t kValue = 1050;
  static constexpr std::int32_t kLow = 1000;  // everything is shifted into the lattice
  static constexpr std::int32_t kHigh = 1100;

  explicit Section(const Mesh& mesh) {
    for (const Triangle& t : mesh.triangles) {
      LatticeTriangle corners{};
      for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
          corners[i][k] = static_cast<std::int32_t>(mesh.positions[t[i]][k]) + kLow;
        }
      }
      surface_.triangles.push_back(corners);
    }
    surface_.topology = build_topology(mesh.triangles, static_cast<Index>(mesh.positions.size()));
    // Round the outline: up sides 0 and 1, down sides 2 and 3.
    for (int side = 0; side < 4; ++side) {
      const int axis = side % 2;  // sides 0 and 2 run along x
      const std::int32_t at = side == 1 || side == 2 ? kHigh : kLow;
      std::vector<std::pair<LinePosition, Index>> found;
      for (Index t = 0; t < surface_.triangles.size(); ++t) {
        // The line along x passes through (y, z), the line along y through (z, x).
        const std::int32_t pu = axis == 0 ? at : kValue;
        const std::int32_t pv = axis == 0 ? kValue : at;
        if (line_crosses(surface_.triangles[t], axis, pu, pv) == 0) continue;
        const LinePosition p = crossing_position(surface_.triangles[t], axis, pu, pv);
        if (floor_of(p) >= kLow && floor_of(p) < kHigh) found.emplace_back(p, t);
      }
      std::sort(found.begin(), found.end());
      if (side >= 2) std::reverse(found.begin(), found.end());
      for (const auto& [position, triangle] : found) {
        ends_.push_back({triangle, side});
        positions_.push_back(real_position(position) - kLow);
      }
    }
  }

  std::vector<TraceEnd>& ends() { return ends_; }
  std::vector<int> sides() const {
    std::vector<int> sides;
    for (const TraceEnd& end : ends_) sides.push_back(end.side);
    return sides;
  }
  std::vector<double> positions() const { return positions_; }

  std::vector<Index> trace() const {
    std::vector<Index> result;
    for (Index i = 0; i < ends_.size(); ++i) {
      result.push_back(kdm::trace(surface_, 2, kValue, {kLow, kLow}, {kHigh, kHigh}, ends_, i).end);
    }
    return result;
  }

 private:
  Surface surface_;
  std::vector<TraceEnd> ends_;
  std::vector<double> positions_;
};

Mesh tube(double x0, double y0, double x1, double y1) {
  return shapes::box(Vec3(x0, y0, -100), Vec3(x1, y1, 200));
}

using Links = std::vector<Index>;

TEST(Trace, ATubeAcrossTheFaceGivesTwoWalls) {
  //  |  | |  |
  const Section section(tube(40, -50, 60, 150));
  EXPECT_EQ(section.sides(), (std::vector<int>{0, 0, 2, 2}));
  EXPECT_EQ(section.trace(), (Links{3, 2, 1, 0}));
  const Section across(tube(-50, 40, 150, 60));
  EXPECT_EQ(across.sides(), (std::vector<int>{1, 1, 3, 3}));
  EXPECT_EQ(across.trace(), (Links{3, 2, 1, 0}));
}

TEST(Trace, AThinWallKeepsItsSidesApart) {
  const Section section(tube(50, -50, 51, 150));
  EXPECT_EQ(section.trace(), (Links{3, 2, 1, 0}));
}

TEST(Trace, TwoTubesAreTwoPieces) {
  // One bulges in from the left, one from the right.
  const Section section(shapes::merged({tube(-50, 30, 30, 70), tube(70, 20, 150, 80)}));
  EXPECT_EQ(section.sides(), (std::vector<int>{1, 1, 3, 3}));
  EXPECT_EQ(section.trace(), (Links{1, 0, 3, 2}));
}

TEST(Trace, TubesAtTheCornersCutThemOff) {
  const Section section(shapes::merged({tube(-50, -50, 30, 30), tube(70, 70, 150, 150),
                                        tube(-50, 80, 20, 150), tube(90, -50, 150, 10)}));
  EXPECT_EQ(section.sides(), (std::vector<int>{0, 0, 1, 1, 2, 2, 3, 3}));
  EXPECT_EQ(section.trace(), (Links{7, 2, 1, 4, 3, 6, 5, 0}));
}

TEST(Trace, AHollowTubeNests) {
  // A wall of 5 round a corner: its outer and its inner side.
  const Section section(
      shapes::merged({tube(-50, -50, 50, 50), shapes::inverted(tube(-45, -45, 45, 45))}));
  const std::vector<double> expected{45, 50, 50, 45};
  ASSERT_EQ(section.positions().size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(section.positions()[i], expected[i], 1e-3);
  EXPECT_EQ(section.trace(), (Links{3, 2, 1, 0}));
}

TEST(Trace, ATubeWithinTheFaceDisturbsNothing) {
  const Section section(shapes::merged({tube(40, 40, 60, 60), tube(10, -50, 20, 150)}));
  EXPECT_EQ(section.sides(), (std::vector<int>{0, 0, 2, 2}));
  EXPECT_EQ(section.trace(), (Links{3, 2, 1, 0}));
}

TEST(Trace, WalksGoAlongManyTriangles) {
  // A round pillar that bulges over the low side of the face, turned through every angle.
  for (int turn = 0; turn < 24; ++turn) {
    Mesh pillar = shapes::rotated(shapes::cylinder(40, 300, 48), Vec3::UnitZ(), turn * 0.1);
    pillar = shapes::snapped(shapes::translated(pillar, Vec3(50, 0, -100)), 1);
    const Section section(pillar);
    ASSERT_EQ(section.sides(), (std::vector<int>{0, 0})) << turn;
    EXPECT_EQ(section.trace(), (Links{1, 0})) << turn;
  }
}

TEST(Trace, AWalkWhoseEndWasDroppedIsLost) {
  Section section(tube(40, -50, 60, 150));
  section.ends().erase(section.ends().begin() + 2);  // the wall x = 60 has no end above
  EXPECT_EQ(section.trace(), (Links{2, kNone, 0}));
}

TEST(Trace, AWalkThatComesBackToItsOwnTriangleIsLost) {
  Section section(tube(40, 40, 60, 60));
  ASSERT_TRUE(section.ends().empty());
  section.ends() = {{8, 0}};  // of a closed curve that meets no side
  EXPECT_EQ(section.trace(), (Links{kNone}));
}

// --- Whole grids ---------------------------------------------------------------------------------

// What the section of the input with a face joins: union-find over the triangles that cross the
// plane, joined where their common edge crosses it within the rectangle. Floating point, so only
// for inputs in general position.
class Recount {
 public:
  Recount(const Mesh& mesh, const Grid& grid) : grid_(grid.data()) {
    for (const Triangle& t : mesh.triangles) {
      std::array<Vec3, 3> corners;
      for (int i = 0; i < 3; ++i) {
        const LatticePoint p = grid_.lattice.quantise(mesh.positions[t[i]]);
        corners[i] = Vec3(p[0], p[1], p[2]);
      }
      triangles_.push_back(corners);
    }
    topology_ = build_topology(mesh.triangles, static_cast<Index>(mesh.positions.size()));
    parent_.resize(triangles_.size());
  }

  // Counts linked and unlinked pairs that the section joins, on all ambiguous faces.
  void run() {
    for_each_face(grid_, cell_boxes(grid_), [this](const MinimalFace& face) {
      if (face.hit_count() > 2 && !face.strip()) check(face);
    });
  }

  int right = 0;
  int wrong = 0;

 private:
  Index find(Index i) const { return parent_[i] == i ? i : find(parent_[i]); }

  void check(const MinimalFace& face) {
    const int u = next_axis(face.axis);
    const int v = previous_axis(face.axis);
    for (Index t = 0; t < parent_.size(); ++t) parent_[t] = t;
    for (Index t = 0; t < triangles_.size(); ++t) {
      for (Index i = 0; i < 3; ++i) {
        const Vec3& a = triangles_[t][i];
        const Vec3& b = triangles_[t][(i + 1) % 3];
        if ((a[face.axis] <= face.plane) == (b[face.axis] <= face.plane)) continue;
        const double s = (face.plane - a[face.axis]) / (b[face.axis] - a[face.axis]);
        const Vec3 p = a + s * (b - a);
        if (p[u] < face.lo(0) || p[u] > face.hi(0) || p[v] < face.lo(1) || p[v] > face.hi(1)) {
          continue;
        }
        parent_[find(t)] = find(topology_.opposite[3 * t + i] / 3);
      }
    }
    std::vector<std::pair<Index, Index>> ends;  // half-edge, piece
    for (const FaceEdge& edge : face.edges) {
      for (const HitId h : edge.hits) {
        ends.emplace_back(3 * h + edge.slot, find(grid_.source_faces[grid_.hits[h].plane()]));
      }
    }
    for (const auto& [half_edge, piece] : ends) {
      for (const auto& [other, other_piece] : ends) {
        if (other <= half_edge || piece != other_piece) continue;
        ++(grid_.opposite[half_edge] == other ? right : wrong);
      }
    }
  }

  const GridData& grid_;
  std::vector<std::array<Vec3, 3>> triangles_;
  Topology topology_;
  std::vector<Index> parent_;
};

Mesh tilted(const Mesh& mesh) { return shapes::rotated(mesh, Vec3(1, 2, 3), 0.7); }

TEST(Trace, LinksAreWhatTheSectionJoins) {
  const std::vector<std::pair<const char*, Mesh>> inputs = {
      {"tube", tilted(shapes::cylinder(0.1, 5, 12))},
      {"ring", tilted(shapes::torus(1, 0.1, 20, 8))},
      {"two rings",
       tilted(shapes::merged({shapes::torus(1, 0.15, 20, 8), shapes::torus(0.6, 0.1, 20, 8)}))},
      {"thin wall", tilted(shapes::thin_walled_box(0.02))},
      {"chain", tilted(shapes::torus_chain(3))},
      {"glass", tilted(shapes::glass(0.02))},
      {"plate", tilted(shapes::plate_with_holes(3, 2))}};
  for (const auto& [name, mesh] : inputs) {
    int right = 0;
    for (const SplitStrategy strategy : {SplitStrategy::kUniform, SplitStrategy::kMedian}) {
      const Grid grid = build_grid(mesh, {.strategy = strategy, .depth = 7});
      EXPECT_EQ(grid.stats().guessed_faces, 0u) << name << ": embedded input leaves nothing open";
      Recount recount(mesh, grid);
      recount.run();
      EXPECT_EQ(recount.wrong, 0) << name;
      right += recount.right;
    }
    EXPECT_GT(right, 5) << name;
  }
}

TEST(Trace, TheFixedRulesAreWrongSomewhere) {
  // Else the test above would prove nothing.
  const Mesh mesh = tilted(shapes::thin_walled_box(0.02));
  for (const Pairing pairing : {Pairing::kInside, Pairing::kOutside}) {
    const Grid grid =
        build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = 7, .pairing = pairing});
    EXPECT_EQ(grid.stats().guessed_faces, 0u) << "only a trace claims to know";
    Recount recount(mesh, grid);
    recount.run();
    EXPECT_GT(recount.wrong, 0);
  }
}

TEST(Trace, OverlappingInputIsGuessedAndCounted) {
  const Mesh wall = shapes::thin_walled_box(0.02);
  const Mesh crossing =
      tilted(shapes::merged({wall, shapes::translated(wall, Vec3(0.52, 0.31, 0.17))}));
  Index guessed = 0;
  for (const int depth : {6, 8, 10}) {
    const Grid grid = build_grid(crossing, {.strategy = SplitStrategy::kUniform, .depth = depth});
    ASSERT_NO_THROW(validate(grid.data()));
    EXPECT_LE(grid.stats().guessed_faces, grid.stats().ambiguous_faces);
    guessed += grid.stats().guessed_faces;
  }
  EXPECT_GT(guessed, 0u);
}

}  // namespace
}  // namespace kdm
