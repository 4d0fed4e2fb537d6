// SPDX-License-Identifier: MIT
// The whole path on every test shape: properties that must hold at any depth, and figures that
// must be right once the grid is fine enough.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "grid/validate.h"
#include "kdmanifold/kdmanifold.h"
#include "support/extract_any.h"
#include "support/mesh_assert.h"
#include "support/random_meshes.h"
#include "support/sanitized.h"
#include "support/shapes.h"
#include "support/solid_check.h"

namespace kdm {
namespace {

using shapes::NamedShape;

std::string text_of(const BuildOptions& options) {
  std::ostringstream text;
  text << "strategy " << static_cast<int>(options.strategy) << " depth " << options.depth
       << " inside " << static_cast<int>(options.inside) << " pairing "
       << static_cast<int>(options.pairing) << " tolerance " << options.relative_tolerance;
  return text.str();
}

std::vector<BuildOptions> option_sets() {
  std::vector<BuildOptions> sets;
  for (const SplitStrategy strategy :
       {SplitStrategy::kAdaptive, SplitStrategy::kOctree, SplitStrategy::kFeature,
        SplitStrategy::kMedian, SplitStrategy::kUniform}) {
    for (const int depth : {1, 2, 5, 9, 12}) {
      if (check::kSanitized && depth % 2 == 0) continue;
      sets.push_back({.strategy = strategy, .depth = depth});
    }
    for (const Pairing pairing : {Pairing::kHermite, Pairing::kInside, Pairing::kOutside}) {
      sets.push_back({.strategy = strategy, .depth = 10, .pairing = pairing});
    }
    for (const InsideRule inside : {InsideRule::kOdd, InsideRule::kNonzero}) {
      sets.push_back({.strategy = strategy, .depth = 10, .inside = inside});
    }
  }
  sets.push_back({.strategy = SplitStrategy::kMedian, .depth = 60});
  if (check::kSanitized) return sets;
  // Splitting wherever the surface is not plane, and hardly at all.
  sets.push_back({.strategy = SplitStrategy::kOctree, .relative_tolerance = 0, .depth = 12});
  sets.push_back({.relative_tolerance = 0, .depth = 12});
  sets.push_back({.relative_tolerance = 0.2});
  return sets;
}

Index highest(const std::vector<Index>& numbers) {
  return numbers.empty() ? 0 : *std::max_element(numbers.begin(), numbers.end());
}

bool same(const Mesh& a, const Mesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles && a.quads == b.quads &&
         a.source_faces == b.source_faces;
}

class Model : public testing::TestWithParam<NamedShape> {};

INSTANTIATE_TEST_SUITE_P(Shapes, Model, testing::ValuesIn(shapes::all_shapes()),
                         [](const auto& shape) { return shape.param.name; });

// Tells of shapes that meet themselves in thousands of places: embedding these takes ten times as
// long as all others.
bool crosses_everywhere(const NamedShape& shape) {
  return shape.name == "tetrahedra_soup" || shape.name == "integer_tetrahedra" ||
         shape.name == "collapsed_polyhedron";
}

// Tells whether everything is there twice and odd winding numbers alone are inside. Nothing is
// enclosed then, which building says.
bool cancels(const NamedShape& shape, const BuildOptions& options) {
  return shape.name == "doubled_cube" && options.inside == InsideRule::kOdd;
}

void expect_nothing_enclosed(const Mesh& input, const BuildOptions& options) {
  try {
    build_grid(input, options);
    ADD_FAILURE() << "nothing is enclosed";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotClosed) << error.what();
  }
}

TEST_P(Model, IsTwoManifoldWhateverTheOptions) {
  const Mesh& input = GetParam().mesh;
  const bool crosses = crosses_everywhere(GetParam());
  bool odd = false;
  int number = 0;
  for (const BuildOptions& options : option_sets()) {
    if (check::kSanitized && crosses && ++number % 8 != 0) continue;
    SCOPED_TRACE(text_of(options));
    if (cancels(GetParam(), options)) {
      expect_nothing_enclosed(input, options);
      continue;
    }
    const Grid grid = build_grid(input, options);
    ASSERT_NO_THROW(validate(grid.data()));
    EXPECT_LE(grid.stats().depth, options.depth == 0 ? 60 : options.depth);
    odd = !odd;
    for (const bool quads : {false, true}) {
      if (check::kSanitized && quads == odd) continue;
      const ExtractedMesh out = check::extract_any(
          grid, {.quads = quads, .strict = quads ? Strict::kManifold : check::kSweepStrict});
      ASSERT_EQ(out.source_faces.size(), out.triangles.size() + out.quads.size());
      ASSERT_LT(highest(out.source_faces), input.triangles.size());
      // So coarse a grid that the surface meets no edge of it gives no surface.
      if (out.triangles.empty() && out.quads.empty()) {
        const Mesh raw = check::extract_any(grid, {.quads = quads, .strict = Strict::kOff});
        EXPECT_EQ(raw.triangles.size() + raw.quads.size() > 0, grid.stats().hits > 0);
        continue;
      }
      ASSERT_TRUE(check::is_two_manifold(out)) << "quads " << quads;
      // Vertices may overshoot the model on coarse grids, but never leave the root cell.
      for (const Vec3& p : out.positions) {
        const Vec3 lattice = grid.data().lattice.to_lattice(p);
        ASSERT_GE(lattice.minCoeff(), -1e-6);
        ASSERT_LE(lattice.maxCoeff(), kLatticeSize + 1e-6);
      }
    }
  }
}

TEST_P(Model, RawSurfaceIsClosedAndOriented) {
  const Grid grid = build_grid(GetParam().mesh, {.depth = 10});
  const check::MeshCheck raw = check::check_mesh(extract(grid, {.strict = Strict::kOff}));
  EXPECT_TRUE(raw.oriented) << raw.faults();
  EXPECT_EQ(raw.boundary_edges, 0);
}

TEST_P(Model, ComesOutTheSameTwice) {
  if (check::kSanitized) GTEST_SKIP() << "other tests go the same ways";
  for (const SplitStrategy strategy :
       {SplitStrategy::kAdaptive, SplitStrategy::kOctree, SplitStrategy::kMedian}) {
    const BuildOptions options{.strategy = strategy, .depth = 12};
    const ExtractOptions strict{.strict = crosses_everywhere(GetParam()) ? Strict::kManifold
                                                                         : Strict::kEmbedded};
    const Mesh first = extract(build_grid(GetParam().mesh, options), strict);
    // Copies and a second extraction change nothing either.
    const Grid grid = build_grid(GetParam().mesh, options);
    const Grid copy = grid;
    EXPECT_TRUE(same(first, extract(grid, strict)));
    EXPECT_TRUE(same(first, extract(copy, strict)));
    EXPECT_TRUE(same(first, extract(grid, strict)));
  }
}

TEST_P(Model, HasTheRightVolumeAndTopologyOnceFineEnough) {
  const NamedShape& shape = GetParam();
  for (const BuildOptions& options :
       {BuildOptions{.strategy = SplitStrategy::kUniform, .depth = 18},
        BuildOptions{.strategy = SplitStrategy::kOctree, .relative_tolerance = 0, .depth = 18},
        BuildOptions{.strategy = SplitStrategy::kOctree, .relative_tolerance = 1e-4, .depth = 24},
        BuildOptions{.relative_tolerance = 1e-4, .depth = 30}}) {
    SCOPED_TRACE(text_of(options));
    // Without an end to crossings the tolerance alone would split these to the depth limit.
    if (options.depth > 18 && !shape.volume) continue;
    if (check::kSanitized && options.depth < 24) continue;
    const Strict strict = crosses_everywhere(shape) ? Strict::kManifold : Strict::kEmbedded;
    const ExtractedMesh out = extract(build_grid(shape.mesh, options), {.strict = strict});
    const check::MeshCheck result = check::check_mesh(out);
    ASSERT_TRUE(result.two_manifold) << result.faults();
    if (shape.volume) {
      EXPECT_NEAR(result.volume, *shape.volume, 0.01 * *shape.volume);
    }
    if (shape.components) {
      EXPECT_EQ(result.components, static_cast<int>(*shape.components));
    }
    if (shape.euler) {
      EXPECT_EQ(result.euler_characteristic, *shape.euler);
    }
  }
}

TEST_P(Model, BoundsTheSolidThatTheInputDescribes) {
  const Mesh& input = GetParam().mesh;
  // What crosses everywhere is embedded by many other tests.
  const bool raw = check::kSanitized && crosses_everywhere(GetParam());
  const Grid grid = build_grid(input, {.strategy = SplitStrategy::kUniform, .depth = 15});
  const ExtractedMesh out = extract(grid, {.strict = raw ? Strict::kManifold : Strict::kEmbedded});
  // Vertices stay in leaves that meet the surface; two leaves' diagonals cover a triangle.
  const double leaf = grid.input().lattice_step * static_cast<double>(1 << 20) / (1 << 5);
  const int sign = grid.input().flipped ? -1 : 1;
  EXPECT_EQ(check::compare_solids(
                input, out, [&](int w) { return sign * w > 0; }, 2 * std::sqrt(3.0) * leaf, 100),
            "");
}

// --- Particular promises ------------------------------------------------------------------------

double volume_of(const Mesh& mesh, const BuildOptions& options) {
  return check::check_mesh(extract(build_grid(mesh, options))).volume;
}

TEST(Models, ACubeComesOutExactly) {
  for (const Mesh& cube : {shapes::cube(), shapes::translated(shapes::cube(), Vec3(3, -7, 0.1)),
                           shapes::subdivided(shapes::cube()), shapes::soup(shapes::cube())}) {
    EXPECT_NEAR(volume_of(cube, {.strategy = SplitStrategy::kOctree, .depth = 9}), 1, 1e-5);
    EXPECT_NEAR(volume_of(cube, {.strategy = SplitStrategy::kUniform, .depth = 9}), 1, 1e-5);
    EXPECT_NEAR(volume_of(cube, {.strategy = SplitStrategy::kMedian}), 1, 1e-5);
    EXPECT_NEAR(volume_of(cube, {}), 1, 1e-5);
  }
}

// Midpoint splits to this depth wherever the surface is not plane.
BuildOptions octree(int depth) {
  return {.strategy = SplitStrategy::kOctree, .relative_tolerance = 0, .depth = depth};
}

TEST(Models, OverlapsAndNestedShellsCountOnce) {
  // The default rule sees that two faces cross in a leaf that one vertex cannot serve.
  EXPECT_NEAR(volume_of(shapes::overlapping_cubes(), {}), 1.875, 0.002 * 1.875);
  EXPECT_NEAR(volume_of(shapes::doubled_cube(), {}), 1, 1e-4);
  EXPECT_NEAR(volume_of(shapes::face_to_face_cubes(), {}), 2, 1e-4);
  EXPECT_NEAR(volume_of(shapes::overlapping_cubes(), octree(15)), 1.875, 1e-4);
  EXPECT_NEAR(volume_of(shapes::doubled_cube(), octree(15)), 1, 1e-4);
  EXPECT_NEAR(volume_of(shapes::face_to_face_cubes(), octree(15)), 2, 1e-4);
  const double ball = shapes::signed_volume(shapes::icosphere(3));
  const double core = shapes::signed_volume(shapes::icosphere(3, 0.7));
  EXPECT_NEAR(volume_of(shapes::nested_shells(), octree(15)), ball, 0.01 * ball);
  EXPECT_NEAR(volume_of(shapes::nested_spheres(), octree(15)), ball - core, 0.01 * ball);
}

TEST(Models, CrossingShellsComeOutAsOnePartWithTheirCrease) {
  const auto box = [](const Vec3& low, const Vec3& high) { return shapes::box(low, high); };
  const Mesh cube = box(Vec3::Zero(), Vec3::Constant(2));
  struct Case {
    Mesh mesh;
    double volume;
    bool resolved = true;
  };
  const std::vector<Case> cases = {
      {shapes::merged({cube, shapes::translated(cube, Vec3(1, 1, 1))}), 15},
      {shapes::merged({cube, shapes::translated(cube, Vec3(0.9, 0.8, 0.7))}), 16 - 1.1 * 1.2 * 1.3},
      // Three bars through each other: 48 + the parts of the others beyond it.
      {shapes::merged({box(Vec3(-3, -1, -1), Vec3(3, 1, 1)), box(Vec3(-1, -3, -1), Vec3(1, 3, 1)),
                       box(Vec3(-1, -1, -3), Vec3(1, 1, 3))}),
       56, false},  // each side of a bar touches edges of the others
      {shapes::merged({box(Vec3(-3, -1, -1), Vec3(3, 1, 1)),
                       box(Vec3(-0.9, -3.1, -0.8), Vec3(0.8, 3, 0.9)),
                       box(Vec3(-0.7, -0.6, -3), Vec3(0.5, 0.7, 3.1))}),
       24 + 4.1 * 1.7 * 1.7 + 4.1 * 1.2 * 1.3}};
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const SplitStrategy strategy : {SplitStrategy::kAdaptive, SplitStrategy::kOctree}) {
      SCOPED_TRACE(testing::Message()
                   << "case " << i << " strategy " << static_cast<int>(strategy));
      const Grid grid = build_grid(cases[i].mesh, {.strategy = strategy});
      EXPECT_NO_THROW(validate(grid.data()));
      EXPECT_EQ(grid.stats().topology_resolved, cases[i].resolved);
      EXPECT_EQ(grid.stats().unresolved_leaves == 0, cases[i].resolved);
      const check::MeshCheck result = check::check_mesh(extract(grid));
      EXPECT_TRUE(result.two_manifold) << result.faults();
      EXPECT_EQ(result.components, 1);
      EXPECT_EQ(result.euler_characteristic, 2);
      // The tolerance is a thousandth of the diagonal.
      EXPECT_NEAR(result.volume, cases[i].volume, 2e-3 * cases[i].volume);
    }
  }
}

TEST(Models, NestedShellsAreResolved) {
  const Grid grid = build_grid(shapes::nested_shells());
  EXPECT_TRUE(grid.stats().topology_resolved) << "crossings drop out, but no shells cross";
  const Mesh nested =
      shapes::merged({shapes::cube(), shapes::box(Vec3(0.3, 0.3, 0.2), Vec3(0.6, 0.8, 0.7))});
  const ExtractedMesh out = extract(build_grid(nested));
  EXPECT_EQ(out.triangles.size(), 12u) << "what lies inside splits nothing";
}

TEST(Models, InsideRulesDifferWhereShellsOverlap) {
  BuildOptions odd = octree(15);
  odd.inside = InsideRule::kOdd;
  BuildOptions nonzero = octree(15);
  nonzero.inside = InsideRule::kNonzero;
  EXPECT_NEAR(volume_of(shapes::overlapping_cubes(), odd), 1.75, 0.01);
  EXPECT_NEAR(volume_of(shapes::overlapping_cubes(), nonzero), 1.875, 1e-4);
  const double ball = shapes::signed_volume(shapes::icosphere(3));
  const double core = shapes::signed_volume(shapes::icosphere(3, 0.7));
  EXPECT_NEAR(volume_of(shapes::nested_shells(), odd), ball - core, 0.01 * ball);
  EXPECT_NEAR(volume_of(shapes::nested_shells(), nonzero), ball, 0.01 * ball);
}

TEST(Models, InsideRulesHoldOnCrossingSoups) {
  const auto rule = [](InsideRule inside, int winding) {
    if (inside == InsideRule::kPositive) return winding > 0;
    return inside == InsideRule::kOdd ? winding % 2 != 0 : winding != 0;
  };
  int compared = 0;
  for (const InsideRule inside : {InsideRule::kPositive, InsideRule::kOdd, InsideRule::kNonzero}) {
    for (std::uint32_t seed = 0; seed < (check::kSanitized ? 1 : 6); ++seed) {
      const Mesh input = shapes::integer_tetrahedra(8, 4, seed);
      const Grid grid =
          build_grid(input, {.strategy = SplitStrategy::kUniform, .depth = 15, .inside = inside});
      ASSERT_NO_THROW(validate(grid.data()));
      const ExtractedMesh out = extract(grid);
      ASSERT_TRUE(check::is_two_manifold(out)) << "seed " << seed;
      const double leaf = grid.input().lattice_step * static_cast<double>(1 << 20) / (1 << 5);
      const int sign = grid.input().flipped ? -1 : 1;
      EXPECT_EQ(
          check::compare_solids(
              input, out, [&](int w) { return rule(inside, sign * w); }, 3 * leaf, 100, &compared),
          "")
          << "rule " << static_cast<int>(inside) << " seed " << seed;
    }
  }
  EXPECT_GT(compared, check::kSanitized ? 30 : 200);
}

TEST(Models, RandomClosedMeshesAreTwoManifold) {
  for (std::uint32_t seed = 0; seed < (check::kSanitized ? 8 : 60); ++seed) {
    const std::vector<Mesh> inputs = {
        shapes::random_tetrahedra(6, seed), shapes::integer_tetrahedra(8, 3, seed),
        shapes::random_voxels(3, 0.4, seed), shapes::collapsed_polyhedron(2, seed)};
    for (std::size_t i = 0; i < inputs.size(); ++i) {
      // The last kind takes ten times as long as the others together.
      if (i == 3 && seed % (check::kSanitized ? 8 : 4) != 0) continue;
      for (const SplitStrategy strategy :
           {SplitStrategy::kAdaptive, SplitStrategy::kOctree, SplitStrategy::kFeature,
            SplitStrategy::kMedian, SplitStrategy::kUniform}) {
        const Grid grid = build_grid(inputs[i], {.strategy = strategy, .depth = 9});
        ASSERT_NO_THROW(validate(grid.data())) << "seed " << seed << " kind " << i;
        const ExtractedMesh out = check::extract_any(grid, {.strict = check::kSweepStrict});
        if (out.triangles.empty()) continue;
        ASSERT_TRUE(check::is_two_manifold(out))
            << "seed " << seed << " kind " << i << " strategy " << static_cast<int>(strategy);
      }
    }
  }
}

TEST(Models, InsideOutInputIsTurned) {
  for (const Mesh& mesh : {shapes::cube(), shapes::torus(), shapes::nested_spheres()}) {
    const Grid straight = build_grid(mesh, octree(12));
    const Grid turned = build_grid(shapes::inverted(mesh), octree(12));
    EXPECT_FALSE(straight.input().flipped);
    EXPECT_TRUE(turned.input().flipped);
    const double volume = check::check_mesh(extract(turned)).volume;
    EXPECT_GT(volume, 0);
    EXPECT_NEAR(volume, check::check_mesh(extract(straight)).volume, 1e-9 * volume);
  }
}

TEST(Models, TriangleSoupsAreWelded) {
  const Mesh mesh = shapes::torus();
  const Grid grid = build_grid(shapes::soup(mesh), octree(12));
  EXPECT_EQ(grid.input().vertices, mesh.positions.size());
  EXPECT_TRUE(grid.input().closed);
  const ExtractedMesh welded = extract(grid);
  const ExtractedMesh indexed = extract(build_grid(mesh, octree(12)));
  EXPECT_EQ(welded.triangles, indexed.triangles);
  EXPECT_EQ(welded.positions, indexed.positions);
}

TEST(Models, OpenInputIsRefusedWithItsFirstEdge) {
  // Without its last face {1, 7, 5} the cube has three open edges.
  try {
    build_grid(shapes::open(shapes::cube()), {.inside = InsideRule::kPositive});
    FAIL() << "open input was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotClosed);
    const std::string text = error.what();
    EXPECT_NE(text.find('3'), std::string::npos) << text;
    EXPECT_TRUE(text.find("1 ") != std::string::npos || text.find("(1") != std::string::npos ||
                text.find(" 1") != std::string::npos)
        << text;
  }
  // One face turned round: closed, but inconsistently oriented.
  Mesh mixed = shapes::cube();
  std::swap(mixed.triangles[5][0], mixed.triangles[5][1]);
  try {
    build_grid(mixed, {.inside = InsideRule::kPositive});
    FAIL() << "inconsistently oriented input was accepted";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kNotClosed);
  }
}

TEST(Models, QuadsCoverAUniformGrid) {
  // The faces' planes cut no edge twice, so every hit's triangle pairs up.
  for (const Mesh& mesh :
       {shapes::icosphere(3), shapes::rotated(shapes::cube(), Vec3(1, 2, 3), 1)}) {
    const Grid grid = build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = 12});
    const ExtractedMesh out = extract(grid, {.quads = true, .strict = Strict::kOff});
    EXPECT_TRUE(out.triangles.empty());
    EXPECT_EQ(2 * out.quads.size(), grid.stats().hits);
    EXPECT_EQ(check::check_mesh(out).boundary_edges, 0);
  }
}

TEST(Models, SourceFacesLieUnderTheResult) {
  // Each side of the cube was cut into faces of one number; a result face on that side names it.
  Mesh cube = shapes::cube();
  for (Index t = 0; t < 12; ++t) cube.source_faces.push_back(100 + t / 2);
  const ExtractedMesh out = extract(build_grid(cube, octree(12)));
  const std::array<std::pair<int, double>, 6> sides = {
      {{2, 0.0}, {2, 1.0}, {1, 0.0}, {1, 1.0}, {0, 0.0}, {0, 1.0}}};
  for (std::size_t t = 0; t < out.triangles.size(); ++t) {
    ASSERT_GE(out.source_faces[t], 100u);
    ASSERT_LT(out.source_faces[t], 106u);
    const auto [axis, value] = sides[out.source_faces[t] - 100];
    for (const Index v : out.triangles[t]) {
      EXPECT_NEAR(out.positions[v][axis], value, 1e-4) << "face " << t;
    }
  }
}

TEST(Models, PositionAndSizeDoNotMatter) {
  const Mesh torus = shapes::torus(1, 0.3, 24, 12);
  // Powers of two change no rounding, so the very same faces must come out. 32 bits do not hold the
  // largest one, which thus is not embedded.
  const ExtractedMesh embedded = extract(build_grid(torus, octree(12)));
  const ExtractedMesh plain = extract(build_grid(torus, octree(12)), {.strict = Strict::kManifold});
  for (const double factor : {0x1p-40, 0x1p30, 0x1p300}) {
    const Mesh other = shapes::scaled(torus, Vec3::Constant(factor));
    const auto& expected = factor < 0x1p100 ? embedded.triangles : plain.triangles;
    EXPECT_EQ(extract(build_grid(other, octree(12))).triangles, expected) << factor;
  }
  const Mesh far = shapes::translated(torus, Vec3(1e6, -1e6, 1e6));
  const check::MeshCheck result = check::check_mesh(extract(build_grid(far, octree(12))));
  EXPECT_TRUE(result.two_manifold) << result.faults();
  EXPECT_EQ(result.euler_characteristic, 0);
}

}  // namespace
}  // namespace kdm
