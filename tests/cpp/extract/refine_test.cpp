// SPDX-License-Identifier: MIT
// Vertices where edges pass from leaf to leaf, and where these go.
#include "extract/place/refine.h"

#include <gtest/gtest.h>

#include <cmath>

#include "extract/place/link_point.h"
#include "geometry/distance.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/mesh_assert.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

TEST(Distance, ToASegment) {
  EXPECT_EQ(squared_distance(Vec3(1, 2, 0), Vec3(0, 0, 0), Vec3(4, 0, 0)), 4);
  EXPECT_EQ(squared_distance(Vec3(-3, 4, 0), Vec3(0, 0, 0), Vec3(4, 0, 0)), 25);
  EXPECT_EQ(squared_distance(Vec3(7, 4, 0), Vec3(0, 0, 0), Vec3(4, 0, 0)), 25);
  EXPECT_EQ(squared_distance(Vec3(0, 2, 0), Vec3(1, 2, 2), Vec3(1, 2, 2)), 5);
}

TEST(Distance, ToATriangleIsThatToItsNearestPoint) {
  const Vec3 a(0, 0, 0), b(4, 1, 0), c(1, 3, 1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 p(i % 10 - 3, i / 10 % 10 - 3, i / 100 - 2);
    double least = 1e300;
    constexpr int kSteps = check::kSanitized ? 40 : 200;
    for (int u = 0; u <= kSteps; ++u) {
      for (int v = 0; u + v <= kSteps; ++v) {
        const Vec3 q = a + (b - a) * u / kSteps + (c - a) * v / kSteps;
        least = std::min(least, (p - q).squaredNorm());
      }
    }
    const double exact = squared_distance(p, a, b, c);
    EXPECT_LE(exact, least + 1e-9);
    EXPECT_NEAR(std::sqrt(exact), std::sqrt(least), 6.0 / kSteps);
  }
  EXPECT_EQ(squared_distance(Vec3(0, 2, 0), a, Vec3(1, 0, 0), Vec3(2, 0, 0)), 4) << "no area";
}

TEST(LinkPoint, LiesBetweenLeavesThatShareAFace) {
  const LatticeBox box{{0, 0, 0}, {8, 8, 8}};
  const std::optional<LinkFace> face = face_between(box, {{8, 2, -4}, {16, 20, 4}});
  ASSERT_TRUE(face);
  EXPECT_EQ(face->axis, 0);
  EXPECT_EQ(face->lo, Vec3(8, 2, 0));
  EXPECT_EQ(face->hi, Vec3(8, 8, 4));
  EXPECT_FALSE(face_between(box, {{8, 8, 0}, {16, 16, 8}})) << "a strip";
}

// Two hits in the face x = 8 with normals in its plane.
struct TwoHits {
  GridData grid;
  std::vector<Vec3> points;
  LinkFace face{Vec3(8, 0, 0), Vec3(8, 10, 10), 0};

  TwoHits(const Vec3& p, const Vec3& n, const Vec3& q, const Vec3& m) : points{p, q} {
    grid.tolerance = 0.01;
    grid.planes = {{n.normalized(), n.normalized().dot(p)},
                   {m.normalized(), m.normalized().dot(q)}};
    grid.hits = {Hit(0, 0, false, false), Hit(0, 1, false, false)};
  }
  GridView view() const { return {grid, {}, points}; }
  Vec3 crease() const { return crease_point(view(), face, {0, 1}, {}, 0); }
  Vec3 chord() const { return chord_point(view(), face, {0, 1}); }
};

TEST(LinkPoint, IsWhereThePlanesMeet) {
  const TwoHits roof(Vec3(8, 0, 2), Vec3(0, -1, 1), Vec3(8, 10, 2), Vec3(0, 1, 1));
  EXPECT_LT((roof.crease() - Vec3(8, 5, 7)).norm(), 1e-9);
  EXPECT_EQ(roof.chord(), Vec3(8, 5, 2));
  const TwoHits flat(Vec3(8, 0, 2), Vec3(0, 0, 1), Vec3(8, 10, 2), Vec3(0, 0, 1));
  EXPECT_LT((flat.crease() - Vec3(8, 5, 2)).norm(), 1e-9);
  // Both lines lead out of the face the same way: they meet beyond the hits.
  const TwoHits bent(Vec3(8, 0, 9), Vec3(0, -1, 1), Vec3(8, 1, 10), Vec3(0, -3, 1));
  EXPECT_TRUE((bent.crease().array() >= bent.face.lo.array()).all());
  EXPECT_TRUE((bent.crease().array() <= bent.face.hi.array()).all());
}

// A ridge just beyond the face, with one hit far higher than the other.
TEST(LinkPoint, StaysAtASharpEdgeBeyondTheFace) {
  const LinkFace face{Vec3(8, 0, 0), Vec3(8, 10, 40), 0};
  TwoHits wedge(Vec3(8, 0, 14), Vec3(0, -1, 4), Vec3(8, 0, 0), Vec3(0, 1, -1));
  const Vec3 beyond = crease_point(wedge.view(), face, {0, 1}, {}, 0);
  EXPECT_EQ(beyond[1], 10) << "the planes meet at y = 18.7";
  EXPECT_GT(beyond[2], 8) << "not halfway between the hits";
  // A third plane, of a hit elsewhere, cuts the edge off within the face.
  wedge.grid.planes.push_back({Vec3(0, 1, 0), 7});
  wedge.grid.hits.push_back(Hit(0, 2, false, false));
  const Vec3 cut = crease_point(wedge.view(), face, {0, 1}, std::vector<Index>{2}, 0.5);
  EXPECT_NEAR(cut[1], 7, 1e-9);
  EXPECT_GT(cut[2], 8);
}

// A roof whose ridge is cut flat where no side of the face meets it.
TEST(LinkPoint, IsDrawnBackToAPlaneThatCutsTheCreaseOff) {
  for (const double out : {1.0, -1.0}) {
    TwoHits roof(Vec3(8, 0, 2), Vec3(0, -out, out), Vec3(8, 10, 2), Vec3(0, out, out));
    const Vec3 ridge = roof.crease();
    const auto drawn_back = [&](double top, double distance) {
      roof.grid.planes.push_back({Vec3(0, 0, out), out * top});
      roof.grid.hits.push_back(
          Hit(0, static_cast<Index>(roof.grid.planes.size() - 1), false, false));
      const std::vector<Index> hits{0, 1, static_cast<Index>(roof.grid.hits.size() - 1)};
      return behind_planes(roof.view(), {0, 1}, hits, distance, ridge);
    };
    EXPECT_LT((drawn_back(5, 0.5) - Vec3(8, 5, 5)).norm(), 1e-9);
    EXPECT_EQ(drawn_back(5, 2.5), ridge) << "within the distance";
    EXPECT_EQ(drawn_back(1, 0.5), ridge) << "below both hits: a face of another place";
    EXPECT_EQ(drawn_back(9, 0.5), ridge) << "above the ridge";
  }
  const TwoHits bent(Vec3(8, 0, 5), Vec3(0, -1, 4), Vec3(8, 10, 5), Vec3(0, -1, 1));
  EXPECT_EQ(behind_planes(bent.view(), {0, 1}, std::vector<Index>{0, 1}, 0.01, Vec3(8, 2, 3)),
            Vec3(8, 2, 3));
}

// z  _______----- 2-3 from the edge itself to the side beyond it
//   2--. 0-1 .     passes over the arc 0-1, and that over 4-5
TEST(LinkPoint, ArcsKeepBelowWhatPassesOver) {
  const LinkFace face{Vec3(8, 0, 0), Vec3(8, 100, 50), 0};
  const std::vector<Vec3> points = {Vec3(8, 20, 0),  Vec3(8, 80, 0), Vec3(8, 10, 0),
                                    Vec3(8, 100, 1), Vec3(8, 40, 0), Vec3(8, 70, 0),
                                    Vec3(8, 30, 50), Vec3(8, 60, 50)};
  const std::vector<HitPair> links = {{4, 5}, {0, 1}, {6, 7}, {2, 3}};
  const GridData grid;
  const GridView view{grid, {}, points};
  const Vec3 outer = chord_point(view, face, {0, 1}, links);
  const Vec3 inner = chord_point(view, face, {4, 5}, links);
  EXPECT_GT(chord_point(view, face, {0, 1})[2], 1) << "by its length alone it would cross 2-3";
  // The line 2-3 rises from 0 at y = 10 to 1 at y = 100.
  EXPECT_LT(outer[2], 1.0 / 9 + 1e-12);
  EXPECT_GT(outer[2], 0.01);
  EXPECT_LT(inner[2], outer[2] * 2 / 3) << "the outer arc's height over y = 40";
  EXPECT_GT(inner[2], 0);
  EXPECT_EQ(inner[1], 55);
  EXPECT_EQ(chord_point(view, face, {2, 3}, links), Vec3(8, 55, 0.5));
  EXPECT_LT(chord_point(view, face, {6, 7}, links)[2], 50) << "the other way, from another side";
}

TEST(LinkPoint, ArcsOverOneEdgeLeaveItNested) {
  const Vec3 up(0, 0, 1);
  const TwoHits outer(Vec3(8, 1, 0), up, Vec3(8, 9, 0), up);
  const TwoHits inner(Vec3(8, 3, 0), up, Vec3(8, 5, 0), up);
  EXPECT_GT(inner.chord()[2], 0);
  EXPECT_GT(outer.chord()[2], inner.chord()[2]);
  EXPECT_GE(outer.crease()[2], outer.chord()[2]);
  const TwoHits high(Vec3(8, 1, 10), up, Vec3(8, 9, 10), up);
  EXPECT_LT(high.chord()[2], 10);
  const TwoHits peak(Vec3(8, 3, 0), Vec3(0, -1, 1), Vec3(8, 7, 0), Vec3(0, 1, 1));
  EXPECT_LT((peak.crease() - Vec3(8, 5, 2)).norm(), 1e-9) << "a feature that pokes through";
}

// The largest distance of points on the mesh's edges to the other mesh.
double furthest_edge_point(const Mesh& mesh, const Mesh& from) {
  double furthest = 0;
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      const Vec3& p = mesh.positions[t[i]];
      const Vec3& q = mesh.positions[t[(i + 1) % 3]];
      for (const double s : {0.25, 0.5, 0.75}) {
        double least = 1e300;
        for (const Triangle& f : from.triangles) {
          least = std::min(least, squared_distance(p + s * (q - p), from.positions[f[0]],
                                                   from.positions[f[1]], from.positions[f[2]]));
        }
        furthest = std::max(furthest, least);
      }
    }
  }
  return std::sqrt(furthest);
}

// The rule that cuts through features leaves long leaves beside each other, and an edge from one to
// the other may miss the surface between them by far.
TEST(Refine, EdgesStayWithinTheTolerance) {
  double before = 0;  // how far edges are off, in tolerances
  for (int turn = 1; turn <= 3; ++turn) {
    const Mesh mesh =
        shapes::rotated(shapes::plate_with_holes(3, 3), Vec3(turn, 2, 3), 0.3 + 0.2 * turn);
    const Grid grid = build_grid(mesh, {.strategy = SplitStrategy::kFeature});
    const double tolerance = grid.stats().tolerance;
    const ExtractedMesh plain = extract(grid, {.link_error = 1e9, .strict = Strict::kManifold});
    EXPECT_EQ(plain.report.link_vertices, 0u);
    before = std::max(before, furthest_edge_point(plain, mesh) / tolerance);
    const ExtractedMesh out = extract(grid);
    EXPECT_TRUE(check::is_two_manifold(out));
    EXPECT_GT(out.report.link_vertices, 0u);
    EXPECT_LT(out.report.link_vertices, grid.stats().hits / 2);
    EXPECT_LE(furthest_edge_point(out, mesh), 1.1 * tolerance) << turn;
  }
  EXPECT_GT(before, 5);
}

TEST(Refine, ErrorsMustBeNumbersFromZeroOn) {
  const Grid grid = build_grid(shapes::cube());
  for (const double error : {-1.0, std::nan("")}) {
    try {
      extract(grid, {.link_error = error});
      FAIL() << error;
    } catch (const Error& refused) {
      EXPECT_EQ(refused.code(), ErrorCode::kInvalidOption);
      EXPECT_NE(std::string(refused.what()).find("link_error"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace kdm
