// SPDX-License-Identifier: MIT
// Links across one minimal face: every pattern of up to eight hits, and what the rules promise.
#include "link/link.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grid/faces.h"
#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "support/random.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr std::array<Pairing, 4> kPairings{Pairing::kTrace, Pairing::kHermite, Pairing::kInside,
                                           Pairing::kOutside};
constexpr std::int32_t kPlane = kLatticeSize / 2;

// The root cell split once, across z: one splitting face, whose outline carries the given hits.
//
//          side 2          The outline runs round the face: up sides 0 and 1, down 2 and 3.
//        +--------+        Position is the distance along the outline, as a fraction of the side.
//  side 3|        |side 1
//        +--------+
//          side 0
struct OutlinePoint {
  int side;
  double fraction;  // in the direction of the outline
  Vec3 normal;
};

class OneFace {
 public:
  // The outline enters the solid at the first hit, or leaves it there; then they alternate.
  OneFace(std::vector<OutlinePoint> points, bool enters_first)
      : OneFace(points, alternating(points.size(), enters_first)) {}

  // Enters it where told.
  OneFace(std::vector<OutlinePoint> points, std::vector<bool> directions)
      : points_(std::move(points)), enters_(std::move(directions)) {
    grid_.cells = {Cell(1, 2, kPlane), Cell(), Cell()};
    grid_.edge_begin = {0};
    half_edge_.resize(points_.size());
    check::Random random(static_cast<std::uint32_t>(points_.size()));
    for (int side = 0; side < 4; ++side) {
      std::vector<std::size_t> on_side;
      for (std::size_t i = 0; i < points_.size(); ++i) {
        if (points_[i].side == side) on_side.push_back(i);
      }
      if (side >= 2) std::reverse(on_side.begin(), on_side.end());  // edges ascend
      for (const std::size_t i : on_side) {
        const bool ascending = side < 2;
        const double f = ascending ? points_[i].fraction : 1 - points_[i].fraction;
        const bool leaving = enters(i) != ascending;
        const auto number = static_cast<Index>(grid_.hits.size());
        half_edge_[i] = 3 * number;
        grid_.hits.push_back(Hit(static_cast<LinePosition>(f * 4294967040.0), number, leaving,
                                 reversed_on_edge(side, leaving)));
        grid_.planes.push_back({points_[i].normal, 0});
        grid_.source_faces.push_back(number);
        triangle_of_hit_.push_back(number);
        // Some triangles cross the plane upwards, some downwards, some not at all; neighbours are
        // anything: what a trace finds there is nonsense, and must do no harm.
        LatticeTriangle t{};
        for (LatticePoint& corner : t) {
          for (std::int32_t& x : corner) x = static_cast<std::int32_t>(random.below(kLatticeSize));
        }
        surface_.triangles.push_back(t);
        for (int k = 0; k < 3; ++k) {
          surface_.topology.opposite.push_back(
              random.below(static_cast<Index>(3 * points_.size())));
        }
      }
      grid_.edge_begin.push_back(static_cast<Index>(grid_.hits.size()));
    }
  }

  static std::vector<bool> alternating(std::size_t count, bool enters_first) {
    std::vector<bool> enters;
    for (std::size_t i = 0; i < count; ++i) enters.push_back((i % 2 == 0) == enters_first);
    return enters;
  }
  bool enters(std::size_t i) const { return enters_[i]; }

  // Partners round the outline.
  std::vector<std::size_t> link(Pairing pairing) {
    grid_.stats = {};
    link_half_edges(surface_, triangle_of_hit_, pairing, grid_);
    std::vector<std::size_t> partner(points_.size(), points_.size());
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Index other = grid_.opposite[half_edge_[i]];
      for (std::size_t j = 0; j < points_.size(); ++j) {
        if (half_edge_[j] == other) partner[i] = j;
      }
    }
    return partner;
  }

  const GridData& grid() const { return grid_; }
  Index start_leaf(std::size_t i) const { return grid_.start_leaf(half_edge_[i]); }

 private:
  std::vector<OutlinePoint> points_;
  std::vector<bool> enters_;
  GridData grid_;
  Surface surface_;
  std::vector<TriangleId> triangle_of_hit_;
  std::vector<Index> half_edge_;
};

void expect_matching(const OneFace& face, const std::vector<std::size_t>& partner) {
  const std::size_t count = partner.size();
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_LT(partner[i], count) << "linked";
    ASSERT_EQ(partner[partner[i]], i) << "mutual";
    ASSERT_NE(partner[i], i);
    ASSERT_NE(face.start_leaf(i), face.start_leaf(partner[i])) << "against each other";
    ASSERT_TRUE(face.start_leaf(i) == 1 || face.start_leaf(i) == 2);
    for (std::size_t k = 0; k < count; ++k) {
      const auto between = [&](std::size_t p) {
        return p > std::min(i, partner[i]) && p < std::max(i, partner[i]);
      };
      if (k != i && k != partner[i]) {
        ASSERT_EQ(between(k), between(partner[k])) << "do not cross";
      }
    }
  }
}

std::vector<OutlinePoint> random_points(const std::array<int, 4>& count, check::Random& random) {
  std::vector<OutlinePoint> points;
  for (int side = 0; side < 4; ++side) {
    for (int i = 0; i < count[side]; ++i) {
      Vec3 normal = random.direction();
      if (random.below(8) == 0) normal = Vec3(0, 0, 1);  // no tangent line in the face
      points.push_back({side, (i + 0.1 + 0.8 * random.unit()) / count[side], normal});
    }
  }
  return points;
}

// Calls visit(count per side) for every way to spread `total` hits over the four sides.
template <typename Visit>
void for_each_spread(int total, Visit&& visit) {
  for (int a = 0; a <= total; ++a) {
    for (int b = 0; a + b <= total; ++b) {
      for (int c = 0; a + b + c <= total; ++c) {
        visit(std::array<int, 4>{a, b, c, total - a - b - c});
      }
    }
  }
}

// The directions of a solid alternate; those of other surfaces need not.
std::vector<std::vector<bool>> balanced_directions(int total) {
  std::vector<std::vector<bool>> all;
  for (unsigned bits = 0; bits < 1u << total; ++bits) {
    std::vector<bool> enters;
    for (int i = 0; i < total; ++i) enters.push_back((bits >> i & 1u) != 0);
    if (std::count(enters.begin(), enters.end(), true) == total / 2) all.push_back(enters);
  }
  return all;
}

TEST(Link, EveryPatternOfUpToEightHitsIsMatched) {
  check::Random random(1);
  int patterns = 0;
  for (int total = 2; total <= 8; total += 2) {
    for (const std::vector<bool>& enters : balanced_directions(total)) {
      for_each_spread(total, [&](const std::array<int, 4>& count) {
        if (testing::Test::HasFatalFailure()) return;
        OneFace face(random_points(count, random), enters);
        ++patterns;
        for (const Pairing pairing : kPairings) {
          SCOPED_TRACE(testing::Message()
                       << count[0] << ' ' << count[1] << ' ' << count[2] << ' ' << count[3]
                       << " enters " << testing::PrintToString(enters) << " pairing "
                       << static_cast<int>(pairing));
          expect_matching(face, face.link(pairing));
          ASSERT_EQ(face.grid().stats.ambiguous_faces, total > 2 ? 1u : 0u);
        }
      });
    }
  }
  EXPECT_EQ(patterns, 2 * 10 + 6 * 35 + 20 * 84 + 70 * 165);
}

TEST(Link, TheFixedRulesJoinTheEndsOfInsideOrOutsideStretches) {
  check::Random random(2);
  for (int total = 4; total <= 8; total += 2) {
    for_each_spread(total, [&](const std::array<int, 4>& count) {
      for (const bool enters_first : {false, true}) {
        OneFace face(random_points(count, random), enters_first);
        const std::vector<std::size_t> inside = face.link(Pairing::kInside);
        const std::vector<std::size_t> outside = face.link(Pairing::kOutside);
        for (std::size_t i = 0; i < inside.size(); ++i) {
          const std::size_t next = (i + 1) % inside.size();
          EXPECT_EQ(inside[i] == next, face.enters(i));
          EXPECT_EQ(outside[i] == next, !face.enters(i));
        }
      }
    });
  }
}

// Two corners of the face cut off, or a band between them.
std::vector<OutlinePoint> four_hits(const Vec3& first, const Vec3& second) {
  // Numbers 0 and 3 lie by the corner (low, low), 1 and 2 by the corner (high, high).
  return {{0, 0.25, first.normalized()},
          {1, 0.75, second.normalized()},
          {2, 0.25, second.normalized()},
          {3, 0.75, first.normalized()}};
}

TEST(Link, HermiteFollowsTheTangentLines) {
  // Normals across the corners: the surface cuts both corners off.
  OneFace corners(four_hits(Vec3(1, 1, 0), Vec3(1, 1, 0)), true);
  EXPECT_EQ(corners.link(Pairing::kHermite), (std::vector<std::size_t>{3, 2, 1, 0}));
  // Normals along the corners: the surface runs from one corner to the other, twice.
  OneFace band(four_hits(Vec3(1, -1, 0), Vec3(1, -1, 0)), true);
  EXPECT_EQ(band.link(Pairing::kHermite), (std::vector<std::size_t>{1, 0, 3, 2}));
}

TEST(Link, HermiteSeparatesThinWalls) {
  // Walls that cross the face from bottom to top: hits at 0.2 0.25 (one wall), 0.7 0.72 (another).
  std::vector<OutlinePoint> points;
  for (const double x : {0.2, 0.25, 0.7, 0.72}) points.push_back({0, x, Vec3(1, 0, 0)});
  for (const double x : {0.72, 0.7, 0.25, 0.2}) points.push_back({2, 1 - x, Vec3(1, 0, 0)});
  OneFace face(points, true);
  EXPECT_EQ(face.link(Pairing::kHermite), (std::vector<std::size_t>{7, 6, 5, 4, 3, 2, 1, 0}));
  // The fixed rules would close the walls off.
  EXPECT_EQ(face.link(Pairing::kInside), (std::vector<std::size_t>{1, 0, 3, 2, 5, 4, 7, 6}));
}

TEST(Link, ManyHitsStillLink) {
  std::vector<OutlinePoint> points;
  for (int i = 0; i < 400; ++i) points.push_back({0, (i + 0.5) / 400, Vec3(1, 0, 0)});
  OneFace face(points, false);
  for (const Pairing pairing : kPairings) expect_matching(face, face.link(pairing));
}

TEST(Link, WholeGridsAreLinkedInEveryMode) {
  for (std::uint32_t seed = 0; seed < 8; ++seed) {
    for (const Mesh& mesh :
         {shapes::random_tetrahedra(6, seed), shapes::random_voxels(3, 0.5, seed),
          shapes::collapsed_polyhedron(3, seed)}) {
      for (const Pairing pairing : kPairings) {
        const Grid grid =
            build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = 6, .pairing = pairing});
        ASSERT_NO_THROW(validate(grid.data())) << "seed " << seed;
        ASSERT_LE(grid.stats().guessed_faces, grid.stats().ambiguous_faces);
      }
    }
  }
}

TEST(Link, ModesDifferOnlyWhereFacesAreAmbiguous) {
  const Mesh wall = shapes::rotated(shapes::thin_walled_box(0.02), Vec3(3, 1, 2), 1);
  std::vector<Grid> grids;
  for (const Pairing pairing : kPairings) {
    grids.push_back(
        build_grid(wall, {.strategy = SplitStrategy::kUniform, .depth = 6, .pairing = pairing}));
  }
  ASSERT_GT(grids[0].stats().ambiguous_faces, 0u);
  EXPECT_NE(grids[0].data().opposite, grids[2].data().opposite);
  EXPECT_NE(grids[2].data().opposite, grids[3].data().opposite);
  const GridData& traced = grids[0].data();
  for_each_face(traced, cell_boxes(traced), [&](const MinimalFace& face) {
    if (face.hit_count() > 2 && !face.strip()) return;
    for (const FaceEdge& edge : face.edges) {
      for (const HitId h : edge.hits) {
        for (const Grid& grid : grids) {
          ASSERT_EQ(grid.data().opposite[3 * h + edge.slot], traced.opposite[3 * h + edge.slot]);
        }
      }
    }
  });
}

}  // namespace
}  // namespace kdm
