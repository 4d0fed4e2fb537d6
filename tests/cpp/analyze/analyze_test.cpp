// SPDX-License-Identifier: MIT
// `analyze`: one small mesh for every defect with its exact lists, and counts against the judge.
#include "kdmanifold/analyze.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <string>

#include "kdmanifold/error.h"
#include "support/mesh_check.h"
#include "support/random.h"
#include "support/random_meshes.h"
#include "support/sanitized.h"
#include "support/shapes.h"

namespace kdm {
namespace {

using Edges = std::vector<Edge>;
using Indices = std::vector<Index>;
using Loops = std::vector<Indices>;

//    7---6
//   4---5|      Faces 2i and 2i+1 are the halves of side i: bottom, top, front, right, back, left.
//   |3--|2
//   0---1
Mesh cube_mesh() {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                    {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  for (const Quad& q : {Quad{3, 2, 1, 0}, Quad{4, 5, 6, 7}, Quad{0, 1, 5, 4}, Quad{1, 2, 6, 5},
                        Quad{2, 3, 7, 6}, Quad{3, 0, 4, 7}}) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return mesh;
}

// Only what is given here is wrong.
struct Expected {
  Edges boundary_edges = {}, non_manifold_edges = {}, misoriented_edges = {};
  Loops boundary_loops = {};
  Indices non_manifold_vertices = {}, degenerate_faces = {}, zero_area_faces = {};
  Indices duplicate_faces = {}, flipped_faces = {};
  std::size_t parts = 1;
};

void expect_defects(const MeshDefects& found, const Expected& expected) {
  EXPECT_EQ(found.boundary_edges, expected.boundary_edges);
  EXPECT_EQ(found.boundary_loops, expected.boundary_loops);
  EXPECT_EQ(found.report.boundary_loops, expected.boundary_loops.size());
  EXPECT_EQ(found.non_manifold_edges, expected.non_manifold_edges);
  EXPECT_EQ(found.misoriented_edges, expected.misoriented_edges);
  EXPECT_EQ(found.non_manifold_vertices, expected.non_manifold_vertices);
  EXPECT_EQ(found.degenerate_faces, expected.degenerate_faces);
  EXPECT_EQ(found.zero_area_faces, expected.zero_area_faces);
  EXPECT_EQ(found.duplicate_faces, expected.duplicate_faces);
  EXPECT_EQ(found.flipped_faces, expected.flipped_faces);
  EXPECT_EQ(found.parts.size(), expected.parts);
  EXPECT_TRUE(found.self_intersecting_faces.empty()) << "nobody asked for them";
}

TEST(Analyze, ACubeHasNoDefects) {
  const MeshDefects found = analyze(cube_mesh());
  expect_defects(found, {});
  EXPECT_TRUE(found.balanced);
  EXPECT_TRUE(found.report.two_manifold);
  EXPECT_EQ(found.report.vertices, 8u);
  EXPECT_EQ(found.part_of, Indices(12, 0));
  const MeshPart& part = found.parts[0];
  EXPECT_EQ(part.first_face, 0u);
  EXPECT_EQ(part.faces, 12u);
  EXPECT_EQ(part.boundary_loops, 0u);
  EXPECT_TRUE(part.closed);
  EXPECT_EQ(part.genus, 0u);
  EXPECT_DOUBLE_EQ(part.area, 6);
  EXPECT_DOUBLE_EQ(part.volume, 1);
  EXPECT_EQ(part.inside, kNone);
  EXPECT_FALSE(part.cavity);
  EXPECT_FALSE(part.inside_out);
}

TEST(Analyze, ACubeWithoutItsTopHasOneLoop) {
  Mesh mesh = cube_mesh();
  mesh.triangles.erase(mesh.triangles.begin() + 2, mesh.triangles.begin() + 4);
  const MeshDefects found = analyze(mesh);
  // As the sides run along them: the other way round than the top did.
  expect_defects(found, {.boundary_edges = {{5, 4}, {4, 7}, {6, 5}, {7, 6}},
                         .boundary_loops = {{5, 4, 7, 6}}});
  EXPECT_FALSE(found.balanced);
  EXPECT_FALSE(found.parts[0].closed);
  EXPECT_EQ(found.parts[0].boundary_loops, 1u);
  EXPECT_EQ(found.parts[0].genus, 0u);
  EXPECT_DOUBLE_EQ(found.parts[0].area, 5);
  EXPECT_EQ(found.parts[0].volume, 0) << "it encloses nothing";
}

TEST(Analyze, AnOpenLPrism) {
  //   5-4       The same six points above: 6 to 11. Bottom closed, top open.
  //   | 3-2
  //   0---1
  Mesh mesh;
  for (const double z : {0.0, 1.0}) {
    for (const auto& [x, y] : {std::pair{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}) {
      mesh.positions.emplace_back(x, y, z);
    }
  }
  mesh.triangles = {{0, 3, 1}, {1, 3, 2}, {0, 5, 3}, {3, 5, 4}};
  for (Index i = 0; i < 6; ++i) {
    const Index j = (i + 1) % 6;
    mesh.quads.push_back({i, j, j + 6, i + 6});
  }
  const MeshDefects found = analyze(mesh);
  expect_defects(found, {.boundary_edges = {{7, 6}, {6, 11}, {8, 7}, {9, 8}, {10, 9}, {11, 10}},
                         .boundary_loops = {{7, 6, 11, 10, 9, 8}}});
  EXPECT_EQ(found.part_of, Indices(10, 0));
  EXPECT_DOUBLE_EQ(found.report.area, 3 + 8);
}

TEST(Analyze, ATubeHasTwoLoops) {
  Mesh mesh;  // a square tube without bottom and top
  mesh = cube_mesh();
  mesh.triangles.erase(mesh.triangles.begin(), mesh.triangles.begin() + 4);
  const MeshDefects found = analyze(mesh);
  expect_defects(
      found, {.boundary_edges = {{0, 1}, {3, 0}, {1, 2}, {2, 3}, {5, 4}, {4, 7}, {6, 5}, {7, 6}},
              .boundary_loops = {{0, 1, 2, 3}, {5, 4, 7, 6}}});
  EXPECT_EQ(found.parts[0].boundary_loops, 2u);
  EXPECT_EQ(found.parts[0].genus, 0u);
}

TEST(Analyze, VerticesOfEqualPositionAreOne) {
  // In a soup vertex 3t + k is corner k of face t. The first to have corner 0 of the cube is
  // vertex 5, and so on.
  const Mesh cube = cube_mesh();
  expect_defects(analyze(shapes::soup(cube)), {});
  Mesh open = cube;
  open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);
  const Mesh soup = shapes::soup(open);
  const MeshDefects found = analyze(soup);
  EXPECT_EQ(found.report.vertices, 8u);
  ASSERT_EQ(found.boundary_loops.size(), 1u);
  const auto first_with = [&](const Vec3& p) {
    Index v = 0;
    while (soup.positions[v] != p) ++v;
    return v;
  };
  std::set<Index> lowest;
  for (const Index v : {4, 5, 6, 7}) lowest.insert(first_with(cube.positions[v]));
  EXPECT_EQ(std::set<Index>(found.boundary_loops[0].begin(), found.boundary_loops[0].end()),
            lowest);
  for (const Edge& edge : found.boundary_edges) {
    EXPECT_TRUE(lowest.count(edge[0]) && lowest.count(edge[1]));
  }
}

TEST(Analyze, TwoCubesThatTouch) {
  const Mesh cube = cube_mesh();
  // Vertex numbers of their own: joined by position, at corner 6 of the first.
  MeshDefects found = analyze(shapes::merged({cube, shapes::translated(cube, {1, 1, 1})}));
  expect_defects(found, {.non_manifold_vertices = {6}, .parts = 2});
  EXPECT_TRUE(found.balanced);
  EXPECT_FALSE(found.report.two_manifold);
  EXPECT_EQ(found.parts[1].first_face, 12u);
  EXPECT_EQ(found.parts[1].genus, 0u) << "a vertex of two fans counts twice";
  EXPECT_EQ(found.parts[1].inside, kNone);

  found = analyze(shapes::merged({cube, shapes::translated(cube, {1, 1, 0})}));
  expect_defects(found, {.non_manifold_edges = {{2, 6}}, .non_manifold_vertices = {2, 6}});
  EXPECT_TRUE(found.balanced);
  EXPECT_EQ(found.parts[0].genus, kNone);
  EXPECT_DOUBLE_EQ(found.parts[0].volume, 2);
}

TEST(Analyze, AFlippedFace) {
  Mesh mesh = cube_mesh();
  std::swap(mesh.triangles[2][0], mesh.triangles[2][1]);  // 4 5 6
  const MeshDefects found = analyze(mesh);
  expect_defects(found, {.misoriented_edges = {{4, 5}, {4, 6}, {5, 6}}, .flipped_faces = {2}});
  EXPECT_FALSE(found.balanced);
  EXPECT_TRUE(found.report.closed) << "no edge has one face";
  EXPECT_FALSE(found.parts[0].closed);
  EXPECT_FALSE(found.parts[0].inside_out);
  EXPECT_EQ(found.parts[0].genus, kNone);
}

TEST(Analyze, FacesOfWholePartsTurnedInwards) {
  const Mesh cube = cube_mesh();
  Indices all(12);
  std::iota(all.begin(), all.end(), 0);
  const MeshDefects inverted = analyze(shapes::inverted(cube));
  expect_defects(inverted, {.flipped_faces = all});
  EXPECT_TRUE(inverted.parts[0].inside_out);
  // Open parts as well, by what can be seen of them; cavities are as they should be.
  Mesh open = shapes::inverted(cube);
  open.triangles.erase(open.triangles.begin() + 2, open.triangles.begin() + 4);
  all.resize(10);
  EXPECT_EQ(analyze(open).flipped_faces, all);
  const Mesh hollow = shapes::merged(
      {shapes::box({0, 0, 0}, {4, 4, 4}), shapes::inverted(shapes::box({1, 1, 1}, {2, 2, 2}))});
  EXPECT_EQ(analyze(hollow).flipped_faces, Indices{});
}

// Faces are triangles first, then quads: here five quads, of which one is turned, and a triangle.
TEST(Analyze, AFlippedQuad) {
  Mesh mesh = cube_mesh();
  mesh.quads = {{3, 2, 1, 0}, {0, 4, 5, 1}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  mesh.triangles = {{4, 5, 6}};
  const MeshDefects found = analyze(mesh);
  EXPECT_EQ(found.flipped_faces, (Indices{2}));
  EXPECT_EQ(found.boundary_edges, (Edges{{6, 4}, {4, 7}, {7, 6}}));
}

TEST(Analyze, ADoubledFace) {
  Mesh mesh = cube_mesh();
  mesh.triangles.push_back({5, 6, 4});  // as face 2, begun elsewhere
  const Edges edges = {{4, 5}, {4, 6}, {5, 6}};
  MeshDefects found = analyze(mesh);
  expect_defects(
      found,
      {.non_manifold_edges = edges, .non_manifold_vertices = {4, 5, 6}, .duplicate_faces = {12}});
  EXPECT_FALSE(found.balanced);
  mesh.triangles.push_back({4, 6, 5});  // and back to back
  found = analyze(mesh);
  expect_defects(found, {.non_manifold_edges = edges,
                         .non_manifold_vertices = {4, 5, 6},
                         .duplicate_faces = {12, 13}});
  EXPECT_TRUE(found.balanced);
}

TEST(Analyze, FacesWithoutArea) {
  Mesh mesh = cube_mesh();
  mesh.positions.emplace_back(0, 0, 0);         // 8, as 0
  mesh.positions.emplace_back(0.5, 0.5, -0.0);  // 9, on the diagonal 1-3 of the bottom
  mesh.triangles.push_back({0, 1, 8});
  mesh.triangles.push_back({1, 1, 2});
  MeshDefects found = analyze(mesh);
  expect_defects(found, {.degenerate_faces = {12, 13}});
  EXPECT_TRUE(found.balanced) << "they take no part";
  EXPECT_EQ(found.part_of[12], kNone);
  EXPECT_EQ(found.report.unreferenced_vertices, 1u);

  // The diagonal 1-3 divided on one side of it only, as a cap without area.
  mesh = cube_mesh();
  mesh.positions.emplace_back(0.5, 0.5, 0);
  mesh.triangles[0] = {3, 2, 1};
  mesh.triangles[1] = {3, 8, 0};
  mesh.triangles.push_back({8, 1, 0});
  mesh.triangles.push_back({3, 1, 8});
  found = analyze(mesh);
  expect_defects(found, {.zero_area_faces = {13}});
  EXPECT_TRUE(found.report.two_manifold);
  // Not on one line by one unit in the last place.
  mesh.positions[8].x() = std::nextafter(0.5, 1);
  expect_defects(analyze(mesh), {});
}

TEST(Analyze, CubesInACube) {
  const Mesh large = shapes::scaled(cube_mesh(), Vec3::Constant(10));
  const Mesh small = shapes::translated(cube_mesh(), {3, 3, 3});
  const auto parts = [](const std::vector<Mesh>& meshes) {
    const MeshDefects found = analyze(shapes::merged(meshes));
    EXPECT_TRUE(found.balanced);
    EXPECT_EQ(found.parts.size(), meshes.size());
    return found.parts;
  };
  // Turned inwards: a cavity. Not: a part within another.
  std::vector<MeshPart> found = parts({large, shapes::inverted(small)});
  EXPECT_EQ(found[0].inside, kNone);
  EXPECT_EQ(found[1].inside, 0u);
  EXPECT_TRUE(found[1].cavity);
  EXPECT_FALSE(found[0].cavity || found[0].inside_out || found[1].inside_out);
  EXPECT_DOUBLE_EQ(found[1].volume, -1);
  found = parts({small, large});
  EXPECT_EQ(found[0].inside, 1u);
  EXPECT_FALSE(found[0].cavity || found[0].inside_out || found[1].cavity || found[1].inside_out);
  // All of it turned round.
  found = parts({shapes::inverted(large), small});
  EXPECT_TRUE(found[0].inside_out && found[1].inside_out);
  EXPECT_FALSE(found[0].cavity || found[1].cavity);
  // Beside each other.
  found = parts({shapes::inverted(small), shapes::translated(large, {20, 0, 0})});
  EXPECT_TRUE(found[0].inside_out);
  EXPECT_EQ(found[0].inside, kNone);
  // An island in a cavity, with a cavity of its own.
  const Mesh hollow = shapes::translated(shapes::scaled(small, Vec3::Constant(2)), {-4, -4, -4});
  const Mesh island = shapes::translated(small, {0, 0, 0});
  const Mesh bubble = shapes::translated(shapes::scaled(small, Vec3::Constant(0.5)), {2, 2, 2});
  found = parts({shapes::inverted(bubble), island, shapes::inverted(hollow), large});
  EXPECT_TRUE(found[0].cavity && found[2].cavity);
  EXPECT_EQ(found[0].inside, 1u);
  EXPECT_EQ(found[1].inside, 2u);
  EXPECT_EQ(found[2].inside, 3u);
  for (const MeshPart& part : found) EXPECT_FALSE(part.inside_out);
}

// A cavity all of whose corners lie on the surface of the block round it.
TEST(Analyze, FindsACavityThatTouchesTheOutside) {
  const Mesh mesh = shapes::voxels(3, 3, 3, [](int x, int y, int z) {
    const int middles = (x == 1 ? 1 : 0) + (y == 1 ? 1 : 0) + (z == 1 ? 1 : 0);
    return middles == 1 || middles == 2;
  });
  const MeshDefects found = analyze(mesh);
  ASSERT_EQ(found.parts.size(), 2u);
  EXPECT_EQ(found.parts[0].inside == kNone, found.parts[0].volume > 0);
  EXPECT_EQ(found.parts[1].inside == kNone, found.parts[1].volume > 0);
  EXPECT_TRUE(found.parts[0].cavity != found.parts[1].cavity);
  EXPECT_FALSE(found.parts[0].inside_out || found.parts[1].inside_out);
}

TEST(Analyze, TouchingPartsAreInsideOrNot) {
  const Mesh large = shapes::scaled(cube_mesh(), Vec3::Constant(4));
  const auto inside = [](const Mesh& outer, const Mesh& inner) {
    return analyze(shapes::merged({outer, inner})).parts.at(1).inside;
  };
  // A corner on the inner side of a face; a whole face on it; all of its corners on faces.
  EXPECT_EQ(inside(large, shapes::tetrahedron({0, 1, 1}, {1, 1, 1}, {1, 2, 1}, {1, 1, 2})), 0u);
  EXPECT_EQ(inside(large, shapes::translated(cube_mesh(), {1, 1, 0})), 0u);
  for (const double x : {0, 3}) {  // in a corner of it, three faces on it
    for (const double y : {0, 3}) {
      for (const double z : {0, 3}) {
        EXPECT_EQ(inside(large, shapes::translated(cube_mesh(), {x, y, z})), 0u);
      }
    }
  }
  EXPECT_EQ(inside(large, shapes::tetrahedron({0, 1, 1}, {4, 1, 1}, {1, 4, 2}, {1, 2, 4})), 0u)
      << "which no vertex tells";
  // In the notch of an L, within its box: outside, and touching two of its faces.
  Mesh notched = shapes::voxels(2, 2, 1, [](int x, int y, int) { return x + y < 2; });
  const double size = notched.positions[0].cwiseAbs().maxCoeff();
  ASSERT_LE(size, 2);
  EXPECT_EQ(inside(notched, shapes::box({1, 1, 0.25}, {1.5, 1.5, 0.75})), kNone);
  EXPECT_EQ(inside(notched, shapes::box({0.25, 0.25, 0}, {0.75, 0.75, 0.5})), 0u);
}

TEST(Analyze, Handles) {
  const auto genus = [](const Mesh& mesh) { return analyze(mesh).parts.at(0).genus; };
  EXPECT_EQ(genus(shapes::torus()), 1u);
  EXPECT_EQ(genus(shapes::plate_with_holes(3, 2)), 6u);
  EXPECT_EQ(genus(shapes::inverted(shapes::torus())), 1u);
  const MeshDefects open = analyze(shapes::open(shapes::torus(), 1));
  EXPECT_EQ(open.parts[0].genus, 1u);
  EXPECT_EQ(open.parts[0].boundary_loops, 1u);
  // A Moebius strip cannot be oriented.
  Mesh strip;
  for (int i = 0; i < 6; ++i) {
    strip.positions.emplace_back(i, i * i, 0);
    strip.positions.emplace_back(i, i * i, 1);
  }
  for (Index i = 0; i < 5; ++i) strip.quads.push_back({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
  strip.quads.push_back({10, 1, 0, 11});
  const MeshDefects moebius = analyze(strip);
  EXPECT_EQ(moebius.misoriented_edges, (Edges{{0, 1}}));
  EXPECT_EQ(moebius.parts[0].genus, kNone);
  ASSERT_EQ(moebius.boundary_loops.size(), 1u);
  EXPECT_EQ(moebius.boundary_loops[0].size(), 12u);
}

TEST(Analyze, LoopsAtVerticesAndEdgesThatAreNotManifold) {
  // Two faces that share a vertex: each has its own loop.
  Mesh bow;
  bow.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 0, 0}, {-1, -1, 0}};
  bow.triangles = {{0, 1, 2}, {0, 3, 4}};
  expect_defects(analyze(bow), {.boundary_edges = {{0, 1}, {2, 0}, {0, 3}, {4, 0}, {1, 2}, {3, 4}},
                                .boundary_loops = {{0, 1, 2}, {0, 3, 4}},
                                .non_manifold_vertices = {0},
                                .parts = 2});
  // Three pages of a book: two are the round, the third ends on its back.
  //   2--1--4
  //   | /|\ |     3 and 5 next to 0, 6 and 7 on the third page
  //   3--0--5
  Mesh book;
  book.positions = {{0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, {-1, 0, 0},
                    {1, 1, 0}, {1, 0, 0}, {0, 1, 1},  {0, 0, 1}};
  book.quads = {{0, 1, 2, 3}, {1, 0, 5, 4}, {0, 1, 6, 7}};
  expect_defects(
      analyze(book),
      {.boundary_edges = {{3, 0}, {0, 5}, {7, 0}, {1, 2}, {4, 1}, {1, 6}, {2, 3}, {5, 4}, {6, 7}},
       .non_manifold_edges = {{0, 1}},
       .boundary_loops = {{3, 0, 5, 4, 1, 2}},
       .non_manifold_vertices = {0, 1},
       .flipped_faces = {0, 1}});  // the third hides the upper sides of two
}

TEST(Analyze, SelfIntersectionsOnRequest) {
  const Mesh cubes =
      shapes::merged({cube_mesh(), shapes::translated(cube_mesh(), {0.5, 0.5, 0.5})});
  const MeshDefects found = analyze(shapes::soup(cubes), {.self_intersections = true});
  const SelfIntersections expected = find_self_intersections(cubes);
  EXPECT_EQ(found.self_intersections, expected.pairs);
  EXPECT_EQ(found.self_intersecting_faces, expected.faces);
  EXPECT_GT(expected.pairs, 5u);
  expect_defects(analyze(cubes), {.parts = 2});
  EXPECT_EQ(analyze(shapes::soup(cube_mesh()), {.self_intersections = true}).self_intersections, 0u)
      << "neighbours are joined first";
}

TEST(Analyze, EmptyMeshes) {
  const MeshDefects found = analyze({});
  expect_defects(found, {.parts = 0});
  EXPECT_FALSE(found.balanced);
  Mesh points;
  points.positions = {{1, 2, 3}, {1, 2, 3}};
  EXPECT_EQ(analyze(points, {.self_intersections = true}).report.vertices, 1u);
  points.triangles = {{0, 1, 0}};
  expect_defects(analyze(points), {.degenerate_faces = {0}, .parts = 0});
  EXPECT_FALSE(analyze(points).balanced);
}

TEST(Analyze, RefusesWhatCannotBeComputedWith) {
  const auto message = [](const Mesh& mesh) -> std::string {
    try {
      analyze(mesh);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidMesh);
      return error.what();
    }
    return "accepted";
  };
  Mesh mesh = cube_mesh();
  mesh.triangles[2][1] = 8;
  EXPECT_EQ(message(mesh), "triangles[2] names vertex 8, but there are 8 vertices");
  mesh = cube_mesh();
  mesh.positions[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(message(mesh).find("vertex 3 has y coordinate nan"), std::string::npos);
  mesh.positions[3].y() = 1e151;
  EXPECT_NE(message(mesh).find("vertex 3 has y coordinate 1e+151"), std::string::npos);
}

TEST(Analyze, SizesThatDoNotFitTheirProducts) {
  const Mesh pair = shapes::merged({shapes::scaled(cube_mesh(), Vec3::Constant(4)),
                                    shapes::inverted(shapes::translated(cube_mesh(), {1, 1, 1}))});
  for (const double size : {1e-120, 1e-30, 1e30, 1e120}) {
    const MeshDefects found = analyze(shapes::scaled(pair, Vec3::Constant(size)));
    expect_defects(found, {.parts = 2});
    EXPECT_TRUE(found.parts[1].cavity) << size;
    EXPECT_NEAR(found.parts[1].area / size / size, 6, 1e-9) << size;
  }
}

TEST(Analyze, FacesBackToBackEncloseNothing) {
  Mesh pillow;
  pillow.positions = {{0.1, 0.2, 0.3}, {1.7, 0, 0}, {0, 1.3, 0.1}};
  pillow.triangles = {{0, 1, 2}, {1, 0, 2}};
  const MeshDefects found = analyze(pillow);
  EXPECT_TRUE(found.balanced);
  EXPECT_EQ(found.duplicate_faces, (Indices{1}));
  EXPECT_FALSE(found.parts[0].inside_out || found.parts[0].cavity);
}

// Boxes with corners of their own on a lattice, nested or apart as they come, turned at random.
TEST(Analyze, NestedBoxesAsTheirCornersTell) {
  check::Random random(7);
  std::size_t nested = 0;
  for (int round = 0; round < 40; ++round) {
    std::vector<Box> boxes;
    std::vector<Mesh> meshes;
    std::vector<int> turns;
    while (boxes.size() < 25) {
      Box box;
      for (int axis = 0; axis < 3; ++axis) {
        const Index a = random.below(40);
        box.min[axis] = a;
        box.max[axis] = a + 1 + random.below(boxes.size() < 5 ? 40 : 6);
      }
      bool crosses = false;
      for (const Box& other : boxes) {
        const auto within = [](const Box& a, const Box& b) {
          return (a.min.array() > b.min.array()).all() && (a.max.array() < b.max.array()).all();
        };
        const bool apart = (box.min.array() > other.max.array()).any() ||
                           (box.max.array() < other.min.array()).any();
        crosses = crosses || !(apart || within(box, other) || within(other, box));
      }
      if (crosses) continue;
      boxes.push_back(box);
      turns.push_back(random.below(2) == 0 ? 1 : -1);
      const Mesh mesh = shapes::box(box.min, box.max);
      meshes.push_back(turns.back() > 0 ? mesh : shapes::inverted(mesh));
    }
    const Mesh all = shapes::merged(meshes);
    const MeshDefects found =
        analyze(round % 2 == 0 ? all : shapes::rotated(all, {1, 2, 3}, 0.1 * round));
    ASSERT_EQ(found.parts.size(), boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      Index smallest = kNone;
      int winding = 0;
      const auto volume = [&](std::size_t k) { return (boxes[k].max - boxes[k].min).prod(); };
      for (std::size_t j = 0; j < boxes.size(); ++j) {
        if (i == j || (boxes[j].min.array() > boxes[i].min.array()).any() ||
            (boxes[j].max.array() < boxes[i].max.array()).any()) {
          continue;
        }
        winding += turns[j];
        if (smallest == kNone || volume(j) < volume(smallest)) smallest = static_cast<Index>(j);
      }
      nested += smallest != kNone;
      ASSERT_EQ(found.parts[i].inside, smallest);
      ASSERT_EQ(found.parts[i].cavity, turns[i] < 0 && winding > 0);
      ASSERT_EQ(found.parts[i].inside_out, winding < 0 || (turns[i] < 0 && winding == 0));
      ASSERT_NEAR(found.parts[i].volume, turns[i] * volume(i), 1e-6 * volume(i));
    }
  }
  EXPECT_GT(nested, 50u);
}

// Shells round each other make as many pairs as the square of their number, and so does asking
// which of them hold which where boxes overlap and shells do not.
TEST(Analyze, GivesUpWhatLiesInWhatWhereTooManyOverlap) {
  const auto shells = [](int count, double growth, double step) {
    std::vector<Mesh> meshes;
    for (int i = 0; i < count; ++i) {
      const double size = 1 + growth * i;
      const Vec3 centre(step * i, 0, 0);
      meshes.push_back(shapes::box(centre - Vec3::Constant(size), centre + Vec3::Constant(size)));
    }
    return shapes::merged(meshes);
  };
  const MeshDefects few = analyze(shells(100, 0.01, 0));
  EXPECT_TRUE(few.nesting_known);
  EXPECT_EQ(few.parts[0].inside, 1u);
  std::vector<Mesh> crowds = {shells(2500, 0.001, 0)};
  if (!check::kSanitized) crowds.push_back(shells(8000, 0, 0.0001));
  for (const Mesh& many : crowds) {
    const MeshDefects found = analyze(many);
    EXPECT_FALSE(found.nesting_known);
    for (const MeshPart& part : found.parts) {
      ASSERT_EQ(part.inside, kNone);
      ASSERT_FALSE(part.cavity || part.inside_out);
      ASSERT_GT(part.volume, 0);
    }
  }
}

TEST(Analyze, CavitiesOfModels) {
  const MeshDefects cheese = analyze(shapes::swiss_cheese(20));
  Index cavities = 0;
  for (const MeshPart& part : cheese.parts) {
    cavities += part.cavity;
    EXPECT_FALSE(part.inside_out);
  }
  EXPECT_EQ(cavities, 20u);
  EXPECT_TRUE(analyze(shapes::thin_walled_box()).parts.at(1).cavity);
  EXPECT_FALSE(analyze(shapes::nested_shells()).parts.at(1).cavity);
  for (const MeshPart& part : analyze(shapes::torus_chain(4)).parts) {
    EXPECT_EQ(part.inside, kNone);
    EXPECT_EQ(part.genus, 1u);
  }
}

// Each boundary edge in one loop at most, one after the other; in exactly one if edges are
// manifold.
void expect_sound_loops(const MeshDefects& found) {
  std::multiset<Edge> open;
  for (const Edge& e : found.boundary_edges)
    open.insert({std::min(e[0], e[1]), std::max(e[0], e[1])});
  for (const Indices& loop : found.boundary_loops) {
    EXPECT_GE(loop.size(), 3u);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Index a = loop[i];
      const Index b = loop[(i + 1) % loop.size()];
      const auto at = open.find({std::min(a, b), std::max(a, b)});
      ASSERT_NE(at, open.end()) << a << " - " << b;
      open.erase(at);
    }
  }
  EXPECT_TRUE(open.empty() || !found.non_manifold_edges.empty());
}

// The judge looks at vertex numbers, so it is given meshes whose equal vertices are joined.
void expect_agreement(const Mesh& mesh, const std::string& name) {
  SCOPED_TRACE(name);
  const check::MeshCheck judge = check::check_mesh(mesh);
  const MeshDefects found = analyze(mesh);
  EXPECT_EQ(found.boundary_edges.size(), static_cast<std::size_t>(judge.boundary_edges));
  EXPECT_EQ(found.non_manifold_edges.size(), static_cast<std::size_t>(judge.non_manifold_edges));
  EXPECT_EQ(found.misoriented_edges.size(), static_cast<std::size_t>(judge.misoriented_edges));
  EXPECT_EQ(found.non_manifold_vertices.size(),
            static_cast<std::size_t>(judge.non_manifold_vertices));
  EXPECT_EQ(found.degenerate_faces.size(), static_cast<std::size_t>(judge.degenerate_faces));
  EXPECT_EQ(found.duplicate_faces.size(), static_cast<std::size_t>(judge.duplicate_faces));
  EXPECT_EQ(found.parts.size(), static_cast<std::size_t>(judge.components));
  EXPECT_EQ(found.balanced, judge.oriented && judge.components > 0);
  expect_sound_loops(found);
  if (judge.two_manifold) {
    std::int64_t euler = 0;
    double volume = 0;
    for (const MeshPart& part : found.parts) {
      euler += 2 - 2 * static_cast<std::int64_t>(part.genus);
      volume += part.volume;
    }
    EXPECT_EQ(euler, judge.euler_characteristic);
    EXPECT_NEAR(volume, judge.volume, 1e-9 * (1 + std::abs(judge.volume)));
  }
}

Mesh joined(const Mesh& mesh) {
  Mesh result;
  for (Triangle t : mesh.triangles) {
    for (Index& v : t) {
      const Vec3& p = mesh.positions[v];
      const auto at = std::find(result.positions.begin(), result.positions.end(), p);
      v = static_cast<Index>(at - result.positions.begin());
      if (at == result.positions.end()) result.positions.push_back(p);
    }
    result.triangles.push_back(t);
  }
  return result;
}

TEST(Analyze, AgreesWithTheJudge) {
  for (const shapes::NamedShape& shape : shapes::all_shapes()) {
    if (shape.mesh.triangles.size() > 1000) continue;  // the judge is slow
    const Mesh mesh = joined(shape.mesh);
    expect_agreement(mesh, shape.name);
    expect_agreement(shapes::open(mesh, 3), shape.name + ", open");
    if (shape.embedded && shape.components && check::check_mesh(mesh).two_manifold) {
      EXPECT_EQ(analyze(shape.mesh).parts.size(), *shape.components) << shape.name;
    }
  }
  for (std::uint32_t seed = 1; seed <= 10; ++seed) {
    expect_agreement(joined(shapes::integer_tetrahedra(20, 3, seed)), "tetrahedra");
    expect_agreement(joined(shapes::random_voxels(4, 0.5, seed)), "voxels");
    expect_agreement(joined(shapes::collapsed_polyhedron(3, seed)), "polyhedron");
  }
}

TEST(Analyze, AgreesWithTheJudgeOnRandomFaces) {
  check::Random random(3);
  for (int round = 0; round < 300; ++round) {
    Mesh mesh;
    for (int i = 0; i < 9; ++i) mesh.positions.emplace_back(i, i * i, i * i * i);
    mesh.triangles.resize(1 + random.below(14));
    for (Triangle& t : mesh.triangles) t = {random.below(9), random.below(9), random.below(9)};
    mesh.quads.resize(random.below(3));
    for (Quad& q : mesh.quads)
      q = {random.below(9), random.below(9), random.below(9), random.below(9)};
    expect_agreement(mesh, "round " + std::to_string(round));
  }
}

}  // namespace
}  // namespace kdm
