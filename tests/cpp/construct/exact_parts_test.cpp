// SPDX-License-Identifier: MIT
// Thin parts that stand in the result as they are: which, and that all that sees them agrees.
#include "construct/exact_parts.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "grid/validate.h"
#include "kdmanifold/kdmanifold.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

constexpr double kPartsTolerance = 0.01;

Mesh turned(const Mesh& mesh, int number) {
  return shapes::rotated(mesh, Vec3(1, 2, 3 + number), 0.7 * number);
}

Mesh plate(double thickness) {
  return shapes::box(Vec3(-1, -1, -thickness / 2), Vec3(1, 1, thickness / 2));
}

// A ring of square section, a wire that closes in itself.
Mesh ring(double radius, double wire, int segments = 40) {
  const double a = wire / 2;
  return shapes::revolved({{radius - a, -a}, {radius + a, -a}, {radius + a, a}, {radius - a, a}},
                          segments);
}

// A pot of revolution: a thin wall round a bottom that may be thick.
Mesh pot(double wall, double bottom) {
  return shapes::revolved({{0, 0}, {1, 0}, {1, 2}, {1 - wall, 2}, {1 - wall, bottom}, {0, bottom}},
                          48);
}

struct MadeOfParts {
  Grid grid;
  ExtractedMesh mesh;
  check::MeshCheck result;
};

MadeOfParts make(const Mesh& mesh, BuildOptions options = {.tolerance = kPartsTolerance}) {
  MadeOfParts made{build_grid(mesh, options), {}, {}};
  EXPECT_NO_THROW(validate(made.grid.data()));
  made.mesh = extract(made.grid, {.strict = Strict::kEmbedded});
  made.result = check::check_mesh(made.mesh);
  EXPECT_TRUE(check::is_two_manifold(made.mesh));
  EXPECT_EQ(made.mesh.report.crossings, 0u);
  return made;
}

bool warns(const MadeOfParts& made, const char* code) {
  for (const Warning& warning : made.mesh.warnings) {
    if (warning.code == code) return true;
  }
  return false;
}

// All of the mesh goes into the result as it is.
void expect_exact(const Mesh& mesh, Index parts) {
  const MadeOfParts made = make(mesh);
  EXPECT_EQ(made.grid.stats().exact_parts, parts);
  EXPECT_EQ(made.grid.stats().exact_triangles, mesh.triangles.size());
  EXPECT_EQ(made.grid.stats().thin_parts, 0u);
  EXPECT_EQ(made.grid.stats().hits, 0u);
  EXPECT_TRUE(made.grid.stats().topology_resolved);
  EXPECT_EQ(made.mesh.triangles.size(), mesh.triangles.size());
  EXPECT_EQ(made.result.components, static_cast<int>(parts));
  EXPECT_EQ(made.result.euler_characteristic, check::check_mesh(mesh).euler_characteristic);
  const double volume = shapes::signed_volume(mesh);
  EXPECT_NEAR(made.result.volume, volume, 1e-3 * volume) << "rounded to 32 bits";
  EXPECT_TRUE(warns(made, "THIN_PARTS_EXACT"));
}

TEST(ExactParts, ThinThingsThatMeetNothingStayAsTheyAre) {
  for (int number = 0; number < 4; ++number) {
    SCOPED_TRACE(number);
    for (const double tolerances : {0.05, 0.2, 1.0, 1.6, 3.9}) {
      expect_exact(turned(plate(tolerances * kPartsTolerance), number), 1);
    }
    expect_exact(turned(shapes::box(Vec3::Zero(), Vec3(2, 0.003, 0.004)), number), 1);
    expect_exact(turned(ring(1, 0.2 * kPartsTolerance), number), 1);
    expect_exact(turned(pot(0.5 * kPartsTolerance, 0.5 * kPartsTolerance), number), 1);
    expect_exact(
        turned(shapes::merged({ring(1, 0.005), ring(1.02, 0.005), ring(1.04, 0.005)}), number), 3);
  }
}

TEST(ExactParts, AThinWallOfAThickPartIsEnough) {
  expect_exact(turned(pot(kPartsTolerance, 0.5), 2), 1);
  const MadeOfParts made = make(turned(pot(0.2, 0.5), 2));
  EXPECT_EQ(made.grid.stats().exact_parts, 0u) << "no wall is thin";
}

TEST(ExactParts, ACavityMakesAShellThin) {
  const auto shell = [](double wall) {
    return shapes::merged({shapes::icosphere(3), shapes::inverted(shapes::icosphere(3, 1 - wall))});
  };
  expect_exact(shell(0.2 * kPartsTolerance), 2);
  EXPECT_EQ(make(shell(0.3)).grid.stats().exact_parts, 0u);
}

TEST(ExactParts, WhatIsThickOrRoundGoesThroughCells) {
  for (const Mesh& mesh :
       {turned(plate(0.05), 1), shapes::cube(), shapes::icosphere(2, 0.02), shapes::torus()}) {
    const MadeOfParts made = make(mesh);
    EXPECT_EQ(made.grid.stats().exact_parts, 0u);
    EXPECT_EQ(made.grid.stats().thin_parts, 0u);
    EXPECT_GT(made.grid.stats().hits, 0u);
  }
}

TEST(ExactParts, ThickPartsFarEnoughAwayGoThroughCells) {
  const Mesh cube = shapes::box(Vec3(-0.5, -0.5, 0.2), Vec3(0.5, 0.5, 1.2));
  const MadeOfParts far = make(turned(shapes::merged({cube, plate(0.003)}), 1));
  EXPECT_EQ(far.grid.stats().exact_parts, 1u);
  EXPECT_GT(far.grid.stats().hits, 0u);
  EXPECT_EQ(far.result.components, 2);
  EXPECT_NEAR(far.result.volume, 1 + 4 * 0.003, 1e-3);
  // Nearer than two tolerances, what becomes of the cube might meet the plate.
  const MadeOfParts near =
      make(turned(shapes::merged({shapes::translated(cube, Vec3(0, 0, -0.185)), plate(0.003)}), 1));
  EXPECT_EQ(near.grid.stats().exact_parts, 0u);
  EXPECT_EQ(near.grid.stats().thin_parts, 1u);
  EXPECT_TRUE(warns(near, "THIN_PARTS"));
}

TEST(ExactParts, OnlyWhatBoundsTheSolidIsTaken) {
  const Mesh cube = shapes::box(Vec3::Constant(-1.2), Vec3::Constant(1.2));
  const Mesh thin = turned(plate(0.003), 1);
  // Within a solid it bounds nothing, within a cavity it does.
  MadeOfParts made = make(shapes::merged({shapes::scaled(cube, Vec3::Constant(2)), thin}));
  EXPECT_EQ(made.grid.stats().exact_parts, 0u);
  EXPECT_EQ(made.grid.stats().thin_parts, 0u);
  EXPECT_EQ(made.result.components, 1);
  made = make(shapes::merged({shapes::scaled(cube, Vec3::Constant(3)),
                              shapes::inverted(shapes::scaled(cube, Vec3::Constant(2))), thin}));
  EXPECT_EQ(made.grid.stats().exact_parts, 1u);
  EXPECT_EQ(made.result.components, 3);
  // A hollow within a solid, by the rule that counts.
  const Mesh hollow = shapes::merged({shapes::scaled(cube, Vec3::Constant(2)), thin});
  made = make(hollow, {.tolerance = kPartsTolerance, .inside = InsideRule::kOdd});
  EXPECT_EQ(made.grid.stats().exact_parts, 0u) << "it is turned outwards: its sides would be wrong";
}

TEST(ExactParts, APartWithOthersInItIsNotTaken) {
  // A thin shell, and a box in its cavity: that is as it should be.
  const Mesh shell = shapes::merged(
      {shapes::icosphere(3), shapes::inverted(shapes::icosphere(3, 1 - 0.2 * kPartsTolerance))});
  const Mesh box = shapes::box(Vec3::Constant(-0.2), Vec3::Constant(0.2));
  MadeOfParts made = make(shapes::merged({shell, box}));
  EXPECT_EQ(made.grid.stats().exact_parts, 2u);
  EXPECT_EQ(made.result.components, 3);
  // A thin pot whose wall holds a part: the wall stays, what is in it goes.
  made = make(shapes::merged({plate(3 * kPartsTolerance),
                              shapes::box(Vec3(-0.01, -0.01, -0.01), Vec3(0.01, 0.01, 0.01))}));
  EXPECT_EQ(made.grid.stats().exact_parts, 0u);
  EXPECT_EQ(made.result.components, 1);
}

TEST(ExactParts, WhatPiercesAThickPartIsNotTaken) {
  // Edges pass through faces, far away from all other edges.
  const Mesh cube = shapes::cube();
  for (const double thickness : {0.1 * kPartsTolerance, kPartsTolerance}) {
    const Mesh through = shapes::box(Vec3(-0.5, 0.2, 0.5), Vec3(1.5, 0.8, 0.5 + thickness));
    const MadeOfParts made = make(turned(shapes::merged({cube, through}), 1));
    EXPECT_EQ(made.grid.stats().exact_parts, 0u);
    EXPECT_EQ(made.grid.stats().thin_parts, 1u);
    EXPECT_TRUE(warns(made, "THIN_PARTS"));
  }
}

TEST(ExactParts, WhatCrossesOrTouchesIsNotTaken) {
  // By this rule nothing is united before (see csg/unite_thin.h).
  const auto stats_of = [](const Mesh& a, const Mesh& b) {
    return build_grid(shapes::merged({a, b}),
                      {.tolerance = kPartsTolerance, .inside = InsideRule::kNonzero})
        .stats();
  };
  const Mesh thin = plate(0.003);
  const GridStats crossing = stats_of(thin, shapes::rotated(thin, Vec3(1, 0, 0), 1.0));
  EXPECT_EQ(crossing.exact_parts, 0u);
  EXPECT_EQ(crossing.thin_parts, 2u);
  // A corner on the other's side, and two plates that share a vertex.
  const Mesh corner = shapes::tetrahedron(Vec3(0, 0, 0.0015), Vec3(0.5, 0.001, 1),
                                          Vec3(0.501, 0, 1), Vec3(0.5, 0, 1.001));
  EXPECT_EQ(stats_of(thin, corner).exact_parts, 0u);
  EXPECT_EQ(stats_of(thin, shapes::translated(thin, Vec3(2, 2, 0.003))).exact_parts, 0u);
}

TEST(ExactParts, AreNotTakenWhereCellsSayWhatIsFine) {
  const Mesh thin = turned(plate(0.003), 1);
  for (const SplitStrategy strategy : {SplitStrategy::kUniform, SplitStrategy::kMedian}) {
    EXPECT_EQ(build_grid(thin, {.strategy = strategy, .depth = 9}).stats().exact_parts, 0u);
  }
  EXPECT_EQ(build_grid(thin, {.tolerance = kPartsTolerance, .inside = InsideRule::kSheet})
                .stats()
                .exact_parts,
            0u);
  for (const SplitStrategy strategy : {SplitStrategy::kOctree, SplitStrategy::kFeature}) {
    EXPECT_EQ(
        build_grid(thin, {.strategy = strategy, .tolerance = kPartsTolerance}).stats().exact_parts,
        1u);
  }
}

Mesh plate_over_cube() {
  return turned(
      shapes::merged({plate(0.003), shapes::box(Vec3(-0.5, -0.5, 0.2), Vec3(0.5, 0.5, 1.2)),
                      shapes::translated(plate(0.002), Vec3(0, 0, -0.5))}),
      1);
}

TEST(ExactParts, AreSavedWithTheGrid) {
  const Grid grid = build_grid(plate_over_cube(), {.tolerance = kPartsTolerance});
  const auto bytes = save_grid(grid);
  const Grid loaded = load_grid(bytes);
  EXPECT_EQ(loaded.stats().exact_parts, 2u);
  EXPECT_EQ(loaded.stats().exact_triangles, 24u);
  EXPECT_EQ(save_grid(loaded), bytes);
  const Mesh before = extract(grid);
  const Mesh after = extract(loaded);
  EXPECT_EQ(before.positions, after.positions);
  EXPECT_EQ(before.triangles, after.triangles);
  EXPECT_EQ(before.source_faces, after.source_faces);
}

TEST(ExactParts, FacesKeepTheirSourcesAndGetNormals) {
  const Mesh mesh = plate_over_cube();
  for (const bool quads : {false, true}) {
    const ExtractedMesh out = extract(build_grid(mesh, {.tolerance = kPartsTolerance}),
                                      {.quads = quads, .normals = true, .crease_angle = 30});
    ASSERT_EQ(out.source_faces.size(), out.triangles.size() + out.quads.size());
    ASSERT_EQ(out.corner_normals.size(), 3 * out.triangles.size() + 4 * out.quads.size());
    std::vector<int> found(mesh.triangles.size(), 0);
    for (std::size_t t = 0; t < out.triangles.size(); ++t) {
      const Index source = out.source_faces[t];
      ASSERT_LT(source, mesh.triangles.size());
      ++found[source];
      const auto& [a, b, c] = mesh.triangles[source];
      const Vec3 normal = (mesh.positions[b] - mesh.positions[a])
                              .cross(mesh.positions[c] - mesh.positions[a])
                              .normalized();
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& n = out.corner_normals[3 * t + i];
        EXPECT_GT(normal.dot(Vec3(n[0], n[1], n[2])), 0.99) << "face " << t;
      }
    }
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(found[i], 1) << "the first plate's faces";
  }
}

TEST(ExactParts, AreChosenLikeOtherParts) {
  const Grid grid = build_grid(plate_over_cube(), {.tolerance = kPartsTolerance});
  const ExtractedMesh largest = extract(grid, {.parts = Parts::kLargest});
  EXPECT_EQ(largest.report.dropped_parts, 2u);
  EXPECT_NEAR(check::check_mesh(largest).volume, 1, 1e-4);
}

TEST(ExactParts, OtherPartsComeOutAsIfTheyWereAlone) {
  // The lattice is that of all, so the cube must span it in both.
  const Mesh cube = shapes::box(Vec3::Constant(-2), Vec3::Constant(2));
  const Mesh hollow = shapes::merged({cube, shapes::inverted(shapes::icosphere(3, 1.5))});
  const ExtractedMesh alone = extract(build_grid(hollow, {.tolerance = kPartsTolerance}));
  const ExtractedMesh with =
      extract(build_grid(shapes::merged({hollow, plate(0.003)}), {.tolerance = kPartsTolerance}));
  ASSERT_EQ(with.positions.size(), alone.positions.size() + 8);
  for (std::size_t i = 0; i < alone.positions.size(); ++i) {
    EXPECT_EQ(with.positions[i], alone.positions[i]);
  }
}

TEST(ExactParts, ManyAtRandomMeetNothing) {
  check::Random random(5);
  for (int round = 0; round < (check::kSanitized ? 5 : 20); ++round) {
    std::vector<Mesh> parts;
    for (int i = 0; i < 6; ++i) {
      const Mesh thin = shapes::rotated(plate(0.002 + 0.01 * random.unit()),
                                        Vec3(random.unit(), random.unit(), 1), random.unit());
      parts.push_back(shapes::translated(thin, Vec3(0, 0, 1.5 * i * random.unit())));
    }
    const Grid grid = build_grid(shapes::merged(parts),
                                 {.tolerance = kPartsTolerance, .inside = InsideRule::kNonzero});
    EXPECT_EQ(grid.stats().exact_parts + grid.stats().thin_parts, 6u);
    EXPECT_NO_THROW(validate(grid.data()));
    const ExtractedMesh out = extract(grid, {.strict = Strict::kEmbedded});
    EXPECT_TRUE(check::is_two_manifold(out));
    if (grid.stats().topology_resolved) {
      EXPECT_EQ(out.report.crossings, 0u);
    }
  }
}

}  // namespace
}  // namespace kdm
