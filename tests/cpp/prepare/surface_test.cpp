// SPDX-License-Identifier: MIT
// What input is taken and what is refused, in which words; and that its size and place do not
// matter.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "grid/validate.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/extract_any.h"
#include "support/mesh_assert.h"
#include "support/random_meshes.h"
#include "support/shapes.h"

namespace kdm {
namespace {

const BuildOptions kCoarse{
    .strategy = SplitStrategy::kUniform, .depth = 6, .inside = InsideRule::kPositive};

// The error that building throws, which must hold all of these words.
void expect_refused(const Mesh& mesh, ErrorCode code, const std::vector<std::string>& words) {
  try {
    build_grid(mesh, kCoarse);
    ADD_FAILURE() << "accepted; expected: " << words[0];
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    const std::string text = error.what();
    for (const std::string& word : words) {
      EXPECT_NE(text.find(word), std::string::npos) << "no '" << word << "' in: " << text;
    }
  }
}

// --- Refused -------------------------------------------------------------------------------------

TEST(Surface, RefusesAnEmptyMesh) {
  expect_refused(Mesh(), ErrorCode::kInvalidMesh, {"no vertices"});
  Mesh points;
  points.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0)};
  expect_refused(points, ErrorCode::kInvalidMesh, {"no faces"});
}

TEST(Surface, RefusesCoordinatesThatAreNotNumbers) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity(), 1e200}) {
    Mesh mesh = shapes::cube();
    mesh.positions[5][1] = bad;
    expect_refused(mesh, ErrorCode::kInvalidMesh, {"positions", "vertex 5", "y coordinate"});
    mesh.positions[3][2] = bad;
    expect_refused(mesh, ErrorCode::kInvalidMesh, {"vertex 3", "z coordinate"});
  }
}

TEST(Surface, RefusesIndicesOutOfRange) {
  Mesh mesh = shapes::cube();
  mesh.triangles[7][2] = 8;
  expect_refused(mesh, ErrorCode::kInvalidMesh, {"indices", "face 7", "vertex 8", "8 vertices"});
  mesh.triangles[7][2] = kNone;
  expect_refused(mesh, ErrorCode::kInvalidMesh, {"face 7", "vertex 4294967295"});
  Mesh quads = shapes::cube();
  quads.quads.push_back({0, 1, 2, 99});
  expect_refused(quads, ErrorCode::kInvalidMesh, {"face 12", "vertex 99"});
}

TEST(Surface, RefusesSourceFacesOfAnotherLength) {
  Mesh mesh = shapes::cube();
  mesh.source_faces = {1, 2, 3};
  expect_refused(mesh, ErrorCode::kInvalidMesh, {"source_faces", "3 entries", "12 faces"});
}

TEST(Surface, RefusesFacesWithoutCorners) {
  Mesh mesh = shapes::cube();
  for (Triangle& t : mesh.triangles) t[1] = t[0];
  expect_refused(mesh, ErrorCode::kInvalidMesh, {"equal corners"});
  Mesh one_point = shapes::cube();
  for (Vec3& p : one_point.positions) p = Vec3(1, 2, 3);
  expect_refused(one_point, ErrorCode::kInvalidMesh, {"equal corners"});
}

TEST(Surface, NamesTheFirstOpenEdge) {
  // The last face {1, 7, 5} is missing: three edges have one face, the first is side 5-7 of face 2,
  // the triangle {4, 5, 7}.
  expect_refused(
      shapes::open(shapes::cube()), ErrorCode::kNotClosed,
      {"not closed", "3 of its edges", "boundary edges: 3", "(1, 0, 1) - (1, 1, 1)", "of face 2"});
}

TEST(Surface, NamesTheFirstEdgeThatIsUsedTwiceTheSameWay) {
  Mesh mesh = shapes::cube();
  std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
  expect_refused(mesh, ErrorCode::kNotClosed,
                 {"consistently oriented", "3 of its edges", "boundary edges: 0", "of face 0"});
}

TEST(Surface, NamesTheFileFaceOfTheFirstEdge) {
  Mesh mesh = shapes::open(shapes::cube());
  for (Index t = 0; t < mesh.triangles.size(); ++t) mesh.source_faces.push_back(1000 + t);
  expect_refused(mesh, ErrorCode::kNotClosed, {"of face 1002"});
}

TEST(Surface, RefusesFacesThatCancel) {
  Mesh mesh = shapes::cube();
  const std::vector<Triangle> back = shapes::inverted(mesh).triangles;
  mesh.triangles.insert(mesh.triangles.end(), back.begin(), back.end());
  expect_refused(mesh, ErrorCode::kNotClosed, {"cancel", "thicken the surface"});
}

TEST(Surface, RefusesOptionsOutOfRange) {
  for (const BuildOptions& options :
       {BuildOptions{.depth = -1}, BuildOptions{.depth = 61}, BuildOptions{.tolerance = -1},
        BuildOptions{.tolerance = std::nan("")}, BuildOptions{.relative_tolerance = -0.1}}) {
    try {
      build_grid(shapes::cube(), options);
      ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidOption) << error.what();
    }
  }
}

// --- Taken ---------------------------------------------------------------------------------------

TEST(Surface, ReportsWhatItGot) {
  const InputReport cube = build_grid(shapes::cube(), kCoarse).input();
  EXPECT_EQ(cube.vertices, 8u);
  EXPECT_EQ(cube.triangles, 12u);
  EXPECT_TRUE(cube.closed);
  EXPECT_EQ(cube.boundary_edges, 0u);
  EXPECT_EQ(cube.non_manifold_edges, 0u);
  EXPECT_EQ(cube.degenerate_faces, 0u);
  EXPECT_EQ(cube.components, 1u);
  EXPECT_FALSE(cube.flipped);
  EXPECT_GT(cube.lattice_step, 0.9e-6);
  EXPECT_LT(cube.lattice_step, 1.1e-6);
  const InputReport chain = build_grid(shapes::torus_chain(3), kCoarse).input();
  EXPECT_EQ(chain.components, 3u);
  EXPECT_EQ(build_grid(shapes::cubes_at_edge(), kCoarse).input().non_manifold_edges, 1u);
}

bool same_surface(const Mesh& a, const Mesh& b) {
  const ExtractedMesh x = extract(build_grid(a, kCoarse));
  const ExtractedMesh y = extract(build_grid(b, kCoarse));
  return !x.triangles.empty() && x.positions == y.positions && x.triangles == y.triangles;
}

TEST(Surface, WeldsSoups) {
  const Mesh torus = shapes::torus(1, 0.4, 16, 8);
  const Mesh soup = shapes::soup(torus);
  EXPECT_EQ(build_grid(soup, kCoarse).input().vertices, torus.positions.size());
  EXPECT_EQ(build_grid(soup, kCoarse).input().components, 1u);
  EXPECT_TRUE(same_surface(torus, soup));
}

TEST(Surface, WeldsZeroAndMinusZero) {
  Mesh soup = shapes::soup(shapes::cube());
  for (std::size_t v = 0; v < soup.positions.size(); v += 2) {
    for (double& x : soup.positions[v]) x = x == 0 ? -0.0 : x;
  }
  EXPECT_EQ(build_grid(soup, kCoarse).input().vertices, 8u);
  EXPECT_TRUE(same_surface(shapes::cube(), soup));
}

TEST(Surface, DropsAndCountsDegenerateFaces) {
  Mesh mesh = shapes::torus(1, 0.4, 16, 8);
  const auto faces = static_cast<Index>(mesh.triangles.size());
  mesh.triangles.push_back({0, 0, 1});
  mesh.triangles.push_back({5, 5, 5});
  const InputReport report = build_grid(mesh, kCoarse).input();
  EXPECT_EQ(report.triangles, faces + 2);
  EXPECT_EQ(report.degenerate_faces, 2u);
  EXPECT_TRUE(same_surface(shapes::torus(1, 0.4, 16, 8), mesh));
}

TEST(Surface, FacesThinnerThanTheLatticeStillJoinTheirNeighbours) {
  // Each edge of a face is split in its middle by a vertex moved by less than a lattice step:
  // slivers without area on the lattice, but the surface stays closed.
  Mesh mesh = shapes::tetrahedron();
  const Triangle t = mesh.triangles[0];
  mesh.triangles.erase(mesh.triangles.begin());
  const auto middle = static_cast<Index>(mesh.positions.size());
  mesh.positions.push_back(0.5 * (mesh.positions[t[0]] + mesh.positions[t[1]]) +
                           Vec3::Constant(1e-9));
  mesh.triangles.push_back({t[0], middle, t[2]});
  mesh.triangles.push_back({middle, t[1], t[2]});
  mesh.triangles.push_back({t[0], t[1], middle});  // the sliver
  const Grid grid = build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = 9});
  EXPECT_EQ(grid.input().degenerate_faces, 1u);
  EXPECT_EQ(grid.stats().guessed_faces, 0u);
  EXPECT_TRUE(check::is_two_manifold(extract(grid)));
}

TEST(Surface, NothingIsLeftOfAFlatMesh) {
  // Collinear points: corners differ, but no face has an area.
  Mesh line;
  line.positions = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2), Vec3(3, 3, 3)};
  line.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
  for (const SplitStrategy strategy : {SplitStrategy::kAdaptive, SplitStrategy::kOctree,
                                       SplitStrategy::kMedian, SplitStrategy::kUniform}) {
    const Grid grid = build_grid(line, {.strategy = strategy, .depth = 9});
    EXPECT_EQ(grid.input().degenerate_faces, 4u);
    EXPECT_EQ(grid.stats().hits, 0u);
    try {
      extract(grid);
      ADD_FAILURE();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kEmptyResult);
      EXPECT_NE(std::string(error.what()).find("thicken the surface"), std::string::npos);
    }
  }
}

TEST(Surface, CancelsFacesBackToBack) {
  const Grid grid = build_grid(shapes::cube_with_flaps(), kCoarse);
  EXPECT_EQ(grid.input().cancelled_faces, 6u);
  EXPECT_EQ(grid.input().triangles, 18u);
  EXPECT_TRUE(check::is_two_manifold(extract(grid)));
}

TEST(Surface, TurnsWhatIsInsideOut) {
  const Mesh torus = shapes::torus(1, 0.4, 16, 8);
  const Grid grid = build_grid(shapes::inverted(torus), kCoarse);
  EXPECT_TRUE(grid.input().flipped);
  EXPECT_GT(check::check_mesh(extract(grid)).volume, 0);
  EXPECT_EQ(grid.stats().guessed_faces, 0u) << "neighbours were turned as well";
  EXPECT_TRUE(same_surface(torus, shapes::inverted(torus)));
}

TEST(Surface, ALargeCavityDoesNotTurnTheWhole) {
  EXPECT_FALSE(build_grid(shapes::thin_walled_box(0.001), kCoarse).input().flipped);
}

TEST(Surface, TakesQuads) {
  Mesh quads;
  quads.positions = shapes::cube().positions;
  quads.quads = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const Grid grid = build_grid(quads, kCoarse);
  EXPECT_EQ(grid.input().triangles, 12u);
  EXPECT_TRUE(same_surface(shapes::cube(), quads));
  // Faces keep their numbers; triangles come before quads.
  Mesh mixed = quads;
  mixed.triangles = {{0, 2, 3}, {0, 3, 1}};
  mixed.quads.erase(mixed.quads.begin());
  mixed.source_faces = {10, 11, 12, 13, 14, 15, 16};
  for (const Index face : extract(build_grid(mixed, kCoarse)).source_faces) {
    EXPECT_GE(face, 10u);
    EXPECT_LE(face, 16u);
  }
  std::vector<bool> seen(8, false);
  for (const Index face : extract(build_grid(quads, kCoarse)).source_faces) seen.at(face) = true;
  EXPECT_EQ(seen, (std::vector<bool>{true, true, true, true, true, true, false, false}));
}

TEST(Surface, IgnoresPointsThatNoFaceUses) {
  Mesh mesh = shapes::torus(1, 0.4, 16, 8);
  mesh.positions.emplace_back(1e9, -1e9, 1e9);
  mesh.positions.emplace_back(1e149, 1e149, -1e149);
  EXPECT_TRUE(same_surface(shapes::torus(1, 0.4, 16, 8), mesh));
}

// --- Size and place ------------------------------------------------------------------------------

// The result of a moved and scaled input is that of the input, moved and scaled. (An embedded one
// is not: what 32 bits tell apart depends on the place.)
void expect_similar(double factor, const Vec3& offset, double tolerance) {
  SCOPED_TRACE(testing::Message() << factor << " (" << offset.transpose() << ")");
  const Mesh torus = shapes::torus(1, 0.4, 16, 8);
  const ExtractedMesh plain = extract(build_grid(torus, kCoarse), {.strict = Strict::kManifold});
  const Mesh moved = shapes::translated(shapes::scaled(torus, Vec3::Constant(factor)), offset);
  const Grid grid = build_grid(moved, kCoarse);
  ASSERT_NO_THROW(validate(grid.data()));
  const ExtractedMesh out = extract(grid, {.strict = Strict::kManifold});
  ASSERT_TRUE(check::is_two_manifold(out));
  ASSERT_EQ(out.triangles, plain.triangles);
  for (std::size_t v = 0; v < out.positions.size(); ++v) {
    ASSERT_LE((out.positions[v] - factor * plain.positions[v] - offset).norm(), tolerance * factor);
  }
}

TEST(Surface, SizeDoesNotMatter) {
  for (const double factor : {1e-140, 1e-30, 1e-9, 1000.0, 1e30, 1e140}) {
    expect_similar(factor, Vec3::Zero(), 1e-5);
  }
}

TEST(Surface, PlaceDoesNotMatter) {
  expect_similar(1, Vec3(1e6, -1e6, 1e6), 1e-5);
  expect_similar(1e-6, Vec3(1, -1, 1), 1e-5);
  expect_similar(1e30, Vec3(1e36, 1e36, -1e36), 1e-5);
}

TEST(Surface, TheFurthestPlacesAndTheSmallestSizesStillGiveAManifold) {
  // Where positions themselves are coarse: only a few values are left for each coordinate.
  int built = 0;
  for (const double offset : {1e12, 1e13, 1e14, 1e15, 4e15, 1e16, 1e20}) {
    const Mesh far = shapes::translated(shapes::torus(1, 0.4, 16, 8), Vec3::Constant(offset));
    try {
      const Grid grid = build_grid(far, kCoarse);
      ++built;
      ASSERT_NO_THROW(validate(grid.data())) << offset;
      const ExtractedMesh out = check::extract_any(grid);
      EXPECT_TRUE(out.triangles.empty() || check::is_two_manifold(out)) << offset;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidMesh) << offset << ": " << error.what();
    }
  }
  EXPECT_GE(built, 5);
  for (const double factor : {1e-150, 1e-300, 1e-310, 1e-320, 5e-324}) {
    const Mesh tiny = shapes::scaled(shapes::cube(), Vec3::Constant(factor));
    const Grid grid = build_grid(tiny, kCoarse);
    ASSERT_NO_THROW(validate(grid.data())) << factor;
    const ExtractedMesh out = check::extract_any(grid);
    EXPECT_TRUE(out.triangles.empty() || check::is_two_manifold(out)) << factor;
  }
}

TEST(Surface, FlatAndLongInputIsTaken) {
  for (const Vec3& stretch : {Vec3(1, 1, 1e-3), Vec3(1, 1e-4, 1e-4), Vec3(1, 1, 1e-9)}) {
    const Mesh thin = shapes::scaled(shapes::torus(1, 0.4, 16, 8), stretch);
    for (const SplitStrategy strategy : {SplitStrategy::kMedian, SplitStrategy::kUniform}) {
      const Grid grid = build_grid(thin, {.strategy = strategy, .depth = 9});
      ASSERT_NO_THROW(validate(grid.data()));
      const ExtractedMesh out = check::extract_any(grid);
      EXPECT_TRUE(out.triangles.empty() || check::is_two_manifold(out));
    }
  }
}

}  // namespace
}  // namespace kdm
