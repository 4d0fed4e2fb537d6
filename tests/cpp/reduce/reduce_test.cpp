// SPDX-License-Identifier: MIT
// What `reduce` promises, on shapes whose best answer is known and on curved ones.
#include "kdmanifold/reduce.h"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <numeric>

#include <Eigen/Geometry>
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/mesh_assert.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

Mesh built(const Mesh& input, double tolerance) {
  return extract(build_grid(input, {.tolerance = tolerance}), {.strict = Strict::kEmbedded});
}

Mesh l_shape() {
  return shapes::voxels(2, 2, 1, [](int x, int y, int) { return x + y < 2; });
}

Mesh box_with_hole() {
  return shapes::voxels(3, 3, 1, [](int x, int y, int) { return x != 1 || y != 1; });
}

// As good as possible, in whatever direction the shape lies.
TEST(Reduce, FindsTheFewestTrianglesOfFlatSolids) {
  struct Case {
    Mesh mesh;
    std::size_t best;
    double volume;
  };
  const std::vector<Case> cases = {{shapes::cube(), 12, 1},
                                   {l_shape(), 20, 3},
                                   {box_with_hole(), 32, 8},
                                   {shapes::face_to_face_cubes(), 12, 2}};
  for (const Case& c : cases) {
    const ReducedMesh straight = reduce(built(c.mesh, 1e-5), c.mesh, {.error = 1e-4});
    EXPECT_EQ(straight.triangles.size(), c.best);
    EXPECT_TRUE(check::is_two_manifold(straight));
    const Mesh turned = shapes::rotated(c.mesh, Vec3(1, 1.2, -0.7).normalized(), 1.6);
    const ReducedMesh result = reduce(built(turned, 1e-5), turned, {.error = 1e-4});
    EXPECT_EQ(result.triangles.size(), c.best);
    EXPECT_NEAR(check::check_mesh(result).volume, c.volume, 1e-3);
  }
}

// Distances both ways, topology and embeddedness.
TEST(Reduce, KeepsDistanceTopologyAndStaysEmbedded) {
  const std::vector<Mesh> inputs = {
      shapes::torus(), shapes::rotated(shapes::stairs(3), Vec3(0, 0.6, 0.8), 0.5),
      shapes::glass(0.05), shapes::nested_spheres(), shapes::swiss_cheese(2)};
  for (const Mesh& input : inputs) {
    const MeshReport of_input = describe(input);
    const double error = 0.01 * (of_input.bounds.max - of_input.bounds.min).norm();
    const Mesh fine = built(input, 0.8 * error);
    const ReducedMesh few = reduce(fine, input, {.error = error});
    EXPECT_LT(few.triangles.size(), fine.triangles.size() / 2);
    EXPECT_TRUE(check::is_two_manifold(few));
    const MeshReport before = describe(fine);
    const MeshReport after = describe(few);
    EXPECT_EQ(after.components, before.components);
    EXPECT_EQ(after.euler_characteristic, before.euler_characteristic);
    EXPECT_EQ(find_self_intersections(few).pairs, 0u);
    EXPECT_LE(check::distance_to(few, input), 1.3 * error);
    EXPECT_LE(check::distance_to(input, few), 1.3 * error);
    EXPECT_EQ(before.triangles - after.triangles, 2 * few.report.collapses);
  }
}

// A finer mesh than the tolerance asks for must not make more of the result.
TEST(Reduce, GoesByTheErrorNotByTheMesh) {
  const Mesh input = shapes::torus(1, 0.4, 64, 32);
  const std::size_t from_coarse =
      reduce(built(input, 0.008), input, {.error = 0.01}).triangles.size();
  const std::size_t from_fine =
      reduce(built(input, 0.002), input, {.error = 0.01}).triangles.size();
  EXPECT_LT(static_cast<double>(from_fine), 1.3 * static_cast<double>(from_coarse));
}

TEST(Reduce, MakesLevelsOutOfOneRun) {
  const Mesh sphere = shapes::icosphere(3);
  const ReducedMesh levels = reduce(sphere, sphere, {.target_triangles = {1000, 400, 100}});
  ASSERT_EQ(levels.levels.size(), 3u);
  EXPECT_EQ(levels.levels[0].triangles.size(), 1000u);
  EXPECT_EQ(levels.levels[1].triangles.size(), 400u);
  EXPECT_EQ(levels.levels[2].triangles.size(), 100u);
  EXPECT_EQ(levels.triangles, levels.levels[2].triangles);
  double off = 0;
  for (const Mesh& level : levels.levels) {
    EXPECT_TRUE(check::is_two_manifold(level));
    EXPECT_EQ(find_self_intersections(level).pairs, 0u);
    const double distance = check::distance_to(level, sphere);
    EXPECT_GT(distance, off);
    off = distance;
  }
  EXPECT_LT(off, 0.1);
  const ReducedMesh single = reduce(sphere, sphere, {.target_triangles = {400}});
  EXPECT_EQ(single.triangles, levels.levels[1].triangles);
}

// What is measured in points is near to what holds everywhere.
TEST(Reduce, TellsHowFarEachLevelIs) {
  const Mesh sphere = shapes::scaled(shapes::icosphere(4), Vec3::Constant(50));
  for (const double error : {0.0, 5.0}) {
    const ReducedMesh few =
        reduce(sphere, sphere, {.error = error, .target_triangles = {2000, 400, 100}});
    ASSERT_EQ(few.levels.size(), 3u);
    double before = 0;
    for (const ReducedLevel& level : few.levels) {
      const double to_input = check::distance_to(level, sphere);
      const double to_output = check::distance_to(sphere, level);
      EXPECT_NEAR(level.error.to_input.largest, to_input, 0.1 * to_input);
      EXPECT_NEAR(level.error.to_output.largest, to_output, 0.1 * to_output);
      for (const Deviation& d : {level.error.to_input, level.error.to_output}) {
        EXPECT_GT(d.rms, before / 10);
        EXPECT_LT(d.rms, 0.8 * d.largest);
      }
      EXPECT_GT(level.error.to_output.rms, before);
      before = level.error.to_output.rms;
    }
  }
}

// Closed holes are part of what the distance counts from; what the mesh lacks altogether is not.
TEST(Reduce, MeasuresLevelsWhereThereIsSomethingToMeasure) {
  const Mesh open = shapes::open(shapes::cube(), 2);
  const ExtractedMesh fine =
      extract(build_grid(open, {.tolerance = 1e-3}), {.strict = Strict::kEmbedded});
  const Mesh with_stray = shapes::merged({open, shapes::translated(shapes::cube(), {9, 0, 0})});
  const ReducedMesh few = reduce(fine, with_stray, {.error = 2e-3, .target_triangles = {12}});
  ASSERT_EQ(few.levels.size(), 1u);
  EXPECT_LT(few.levels[0].error.to_input.largest, 3e-3);
  EXPECT_LT(few.levels[0].error.to_output.largest, 3e-3);
  EXPECT_TRUE(reduce({}, {}, {.target_triangles = {10}}).levels[0].triangles.empty());
}

// A ball a twentieth as large as another has a 400th of the area; by area alone it is left with 48
// triangles of 4,000, and further off, for its size, than is needed.
TEST(Reduce, LeavesSmallPartsTheirShareByCount) {
  const Mesh balls = shapes::merged(
      {shapes::icosphere(5), shapes::translated(shapes::icosphere(3, 0.05), Vec3(3, 0, 0))});
  const ReducedMesh few = reduce(balls, balls, {.target_triangles = {4000}});
  int of_the_small_one = 0;
  for (const Triangle& t : few.triangles) of_the_small_one += few.positions[t[0]].x() > 2 ? 1 : 0;
  EXPECT_GT(of_the_small_one, 64);
  EXPECT_EQ(few.triangles.size(), 4000u);
}

TEST(Reduce, StopsAtTheErrorBeforeTheNumber) {
  const Mesh sphere = shapes::icosphere(3);
  const ReducedMesh kept = reduce(sphere, sphere, {.error = 0.01, .target_triangles = {4}});
  EXPECT_GT(kept.triangles.size(), 60u);
  EXPECT_LE(check::distance_to(sphere, kept), 0.013);
}

TEST(Reduce, LeavesThinWallsApart) {
  const Mesh box = shapes::thin_walled_box(1.0 / 200);
  const ReducedMesh few = reduce(built(box, 0.001), box, {.error = 0.05});
  EXPECT_EQ(describe(few).components, 2u);
  EXPECT_EQ(find_self_intersections(few).pairs, 0u);
}

// Its sides are slivers whatever one does, unless one cuts them up.
TEST(Reduce, FindsTheFewestTrianglesOfThinPlates) {
  Mesh plate = shapes::scaled(shapes::cube(), {1, 0.6, 0.002});
  for (int i = 0; i < 4; ++i) plate = shapes::subdivided(plate);
  const Mesh turned = shapes::turned(plate);
  for (const Mesh& mesh : {plate, turned}) {
    const ReducedMesh few = reduce(mesh, mesh, {.error = 0.001});
    EXPECT_TRUE(check::is_two_manifold(few));
    EXPECT_EQ(few.triangles.size(), 12u);
    EXPECT_NEAR(describe(few).volume, 0.0012, 1e-6);
  }
}

TEST(Reduce, CarriesSourceFacesOver) {
  const Mesh input = shapes::rotated(shapes::cube(), Vec3(0.6, 0, 0.8), 0.7);
  const ReducedMesh few = reduce(built(input, 1e-4), input, {.error = 1e-3});
  ASSERT_EQ(few.source_faces.size(), few.triangles.size());
  for (std::size_t t = 0; t < few.triangles.size(); ++t) {
    const auto normal = [](const Mesh& mesh, std::size_t face) {
      const Triangle& c = mesh.triangles[face];
      return (mesh.positions[c[1]] - mesh.positions[c[0]])
          .cross(mesh.positions[c[2]] - mesh.positions[c[0]])
          .normalized();
    };
    ASSERT_LT(few.source_faces[t], input.triangles.size());
    EXPECT_GT(normal(few, t).dot(normal(input, few.source_faces[t])), 0.999);
  }
}

TEST(Reduce, KeepsWhatClosesHolesAndItsSource) {
  const Mesh open = shapes::open(shapes::cube(), 2);
  const ExtractedMesh fine =
      extract(build_grid(open, {.tolerance = 1e-3}), {.strict = Strict::kEmbedded});
  const ReducedMesh few = reduce(fine, open, {.error = 2e-3});
  EXPECT_TRUE(check::is_two_manifold(few));
  EXPECT_EQ(few.triangles.size(), 12u);
  EXPECT_NEAR(check::check_mesh(few).volume, 1, 0.01);
  EXPECT_EQ(std::count(few.source_faces.begin(), few.source_faces.end(), kNone), 2);
}

TEST(Reduce, CarriesNormalsOver) {
  const Mesh cube = shapes::cube();
  const Mesh fine = extract(build_grid(cube, {.tolerance = 1e-4}),
                            {.strict = Strict::kEmbedded, .normals = true});
  const ReducedMesh few = reduce(fine, cube, {.error = 1e-3});
  ASSERT_EQ(few.corner_normals.size(), 3 * few.triangles.size());
  for (std::size_t t = 0; t < few.triangles.size(); ++t) {
    const Triangle& c = few.triangles[t];
    const Vec3 normal = (few.positions[c[1]] - few.positions[c[0]])
                            .cross(few.positions[c[2]] - few.positions[c[0]])
                            .normalized();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& n = few.corner_normals[3 * t + i];
      EXPECT_GT(normal.dot(Vec3(n[0], n[1], n[2])), 0.999);
    }
  }
}

TEST(Reduce, ReducesSheetsAlongTheirRims) {
  const Mesh flat = shapes::grid_sheet(30, 30, [](double, double) { return 0.0; });
  const ReducedMesh square = reduce(flat, flat, {.error = 0.01});
  EXPECT_EQ(square.triangles.size(), 2u);
  EXPECT_TRUE(check::is_manifold(square));
  EXPECT_NEAR(describe(square).area, describe(flat).area, 1e-9);

  const Mesh bent = shapes::grid_sheet(30, 30, [](double x, double y) { return 0.1 * x * y; });
  const ReducedMesh few = reduce(bent, bent, {.error = 0.01});
  EXPECT_TRUE(check::is_manifold(few));
  EXPECT_EQ(describe(few).boundary_loops, 1u);
  EXPECT_LT(few.triangles.size(), bent.triangles.size() / 20);
  EXPECT_LE(check::distance_to(few, bent), 0.013);
  EXPECT_LE(check::distance_to(bent, few), 0.013);
  EXPECT_LE(check::rim_distance_to(few, bent), 0.013);
  EXPECT_LE(check::rim_distance_to(bent, few), 0.013);
}

// The same of what a grid makes of a sheet with a round hole, whose rim it makes anew.
TEST(Reduce, KeepsTheRimsOfHolesInSheets) {
  const Mesh input = shapes::grid_sheet(
      40, 40, [](double x, double y) { return 0.2 * std::sin(3 * x) * y; },
      [](int i, int j) { return std::hypot(i - 18, j - 22) < 9; });
  const Mesh fine = extract(build_grid(input, {.tolerance = 0.008, .inside = InsideRule::kSheet}),
                            {.strict = Strict::kEmbedded});
  const ReducedMesh few = reduce(fine, input, {.error = 0.01});
  EXPECT_TRUE(check::is_manifold(few));
  EXPECT_EQ(describe(few).boundary_loops, 2u);
  EXPECT_EQ(find_self_intersections(few).pairs, 0u);
  EXPECT_LT(few.triangles.size(), fine.triangles.size() / 3);
  EXPECT_LE(check::distance_to(few, input), 0.013);
  EXPECT_LE(check::distance_to(input, few), 0.013);
  EXPECT_LE(check::rim_distance_to(few, input), 0.02);
  EXPECT_LE(check::rim_distance_to(input, few), 0.02);
}

TEST(Reduce, KeepsTheRimsOfTubesApart) {
  // Both ends of a tube are rounds that must neither close nor join.
  const Mesh tube = shapes::tube(1, 2, 48);
  for (const ReduceOptions& options :
       {ReduceOptions{.error = 0.02}, ReduceOptions{.target_triangles = {4}}}) {
    const ReducedMesh few = reduce(tube, tube, options);
    const MeshReport report = describe(few);
    EXPECT_TRUE(report.manifold);
    EXPECT_EQ(report.boundary_loops, 2u);
    EXPECT_EQ(report.euler_characteristic, 0);
    EXPECT_EQ(find_self_intersections(few).pairs, 0u);
    EXPECT_LT(few.triangles.size(), tube.triangles.size());
  }
  EXPECT_LE(check::distance_to(tube, reduce(tube, tube, {.error = 0.02})), 0.026);
}

// Sides of a cube that is cut very finely, in groups left and right of a slanting wavy line.
struct TwoSides {
  Mesh mesh = shapes::subdivided(
      shapes::subdivided(shapes::subdivided(shapes::subdivided(shapes::cube()))));
  std::vector<Index> groups;

  TwoSides() {
    for (const Triangle& t : mesh.triangles) {
      const Vec3 middle = (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
      const double line = 0.5 + 0.2 * std::sin(4 * middle[1]) + 0.1 * middle[2];
      groups.push_back(middle[0] < line ? 7 : 3);
    }
  }
};

// The edges between faces of two groups, as triangles without area.
Mesh borders_of(const Mesh& mesh, const std::vector<Index>& groups) {
  std::map<std::pair<Index, Index>, Index> group_of_edge;
  Mesh out;
  out.positions = mesh.positions;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const Index from = mesh.triangles[t][i];
      const Index to = mesh.triangles[t][(i + 1) % 3];
      const auto [at, is_new] = group_of_edge.insert({std::minmax(from, to), groups[t]});
      if (!is_new && at->second != groups[t]) out.triangles.push_back({from, to, to});
    }
  }
  return out;
}

double area_of_group(const Mesh& mesh, const std::vector<Index>& groups, Index group) {
  double area = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& c = mesh.triangles[t];
    if (groups[t] != group) continue;
    area += (mesh.positions[c[1]] - mesh.positions[c[0]])
                .cross(mesh.positions[c[2]] - mesh.positions[c[0]])
                .norm() /
            2;
  }
  return area;
}

std::vector<Index> groups_of_sources(const Mesh& mesh, const std::vector<Index>& of_sources) {
  std::vector<Index> groups;
  for (const Index source : mesh.source_faces) groups.push_back(of_sources[source]);
  return groups;
}

TEST(Reduce, KeepsGroupsApart) {
  TwoSides sides;
  sides.mesh.source_faces.resize(sides.mesh.triangles.size());
  std::iota(sides.mesh.source_faces.begin(), sides.mesh.source_faces.end(), 0);
  const Mesh before = borders_of(sides.mesh, sides.groups);
  for (const double error : {0.005, 0.02, 0.05}) {
    const ReducedMesh few =
        reduce(sides.mesh, sides.mesh, {.error = error, .keep_groups = sides.groups});
    EXPECT_TRUE(check::is_two_manifold(few));
    EXPECT_LT(few.triangles.size(), sides.mesh.triangles.size() / 4);
    const std::vector<Index> groups = groups_of_sources(few, sides.groups);
    const Mesh after = borders_of(few, groups);
    EXPECT_LE(check::distance_to(after, before), 1.05 * error);
    EXPECT_LE(check::distance_to(before, after), 1.05 * error);
    // One line, not several, and nothing of the other group beyond it.
    EXPECT_NEAR(area_of_group(few, groups, 7), area_of_group(sides.mesh, sides.groups, 7),
                4 * error);
    EXPECT_LT(after.triangles.size(), before.triangles.size());
  }
  // Without the groups nothing holds the line.
  const ReducedMesh plain = reduce(sides.mesh, sides.mesh, {.error = 0.05});
  EXPECT_EQ(plain.triangles.size(), 12u);
}

TEST(Reduce, KeepsGroupsApartByNumbersOfTriangles) {
  const TwoSides sides;
  const ReducedMesh few =
      reduce(sides.mesh, sides.mesh, {.target_triangles = {400, 100}, .keep_groups = sides.groups});
  for (const ReducedLevel& level : few.levels) {
    EXPECT_TRUE(check::is_two_manifold(level));
    EXPECT_EQ(find_self_intersections(level).pairs, 0u);
  }
  EXPECT_LE(few.triangles.size(), 100u);
}

TEST(Reduce, KeepsGroupsThatAreSingleTriangles) {
  Mesh mesh = shapes::icosphere(3);
  mesh.source_faces.assign(mesh.triangles.size(), 0);
  mesh.source_faces[17] = 1;
  mesh.source_faces[900] = kNone;
  const ReducedMesh few = reduce(mesh, mesh, {.error = 0.3, .keep_groups = {5, 6}});
  EXPECT_TRUE(check::is_two_manifold(few));
  EXPECT_EQ(std::count(few.source_faces.begin(), few.source_faces.end(), 1u), 1);
  EXPECT_EQ(std::count(few.source_faces.begin(), few.source_faces.end(), kNone), 1);
}

TEST(Reduce, RefusesFacesWithoutGroup) {
  Mesh mesh = shapes::cube();
  const auto complaint = [&] {
    try {
      reduce(mesh, mesh, {.error = 0.1, .keep_groups = {0, 1, 2}});
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint(), "`keep_groups`: it has 3 entries, but there is a face 11");
  mesh.source_faces.assign(12, 2);
  EXPECT_EQ(complaint(), "");
  mesh.source_faces[4] = 3;
  EXPECT_EQ(complaint(), "`keep_groups`: it has 3 entries, but there is a face 3");
}

TEST(Reduce, CutsQuads) {
  const Mesh input = shapes::torus();
  const Mesh quads = extract(build_grid(input, {.strategy = SplitStrategy::kUniform, .depth = 12}),
                             {.quads = true});
  ASSERT_FALSE(quads.quads.empty());
  const ReducedMesh few = reduce(quads, input, {.target_triangles = {400}});
  EXPECT_TRUE(check::is_two_manifold(few));
  EXPECT_EQ(few.triangles.size(), 400u);
  EXPECT_EQ(few.source_faces.size(), 400u);
}

// Edges at which a closed mesh turns by more than 30 degrees.
int creases_of(const Mesh& mesh) {
  std::map<std::pair<Index, Index>, Vec3> normals;
  int creases = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 normal = (mesh.positions[t[1]] - mesh.positions[t[0]])
                            .cross(mesh.positions[t[2]] - mesh.positions[t[0]])
                            .normalized();
    for (int i = 0; i < 3; ++i) {
      const auto [at, is_new] = normals.insert({std::minmax(t[i], t[(i + 1) % 3]), normal});
      if (!is_new && at->second.dot(normal) < std::cos(std::acos(-1.0) / 6)) ++creases;
    }
  }
  return creases;
}

TEST(Reduce, MakesNoCreasesOnSmoothSurfaces) {
  const Mesh sphere = shapes::icosphere(5);
  const ReducedMesh few = reduce(built(sphere, 0.004), sphere, {.error = 0.005});
  for (std::size_t t = 0; t < few.triangles.size(); ++t) {
    const Triangle& c = few.triangles[t];
    const Vec3 normal = (few.positions[c[1]] - few.positions[c[0]])
                            .cross(few.positions[c[2]] - few.positions[c[0]])
                            .normalized();
    const Vec3 middle = (few.positions[c[0]] + few.positions[c[1]] + few.positions[c[2]]) / 3;
    EXPECT_GT(normal.dot(middle.normalized()), 0.9);
  }
}

// The tube of this torus may have four sides within the error, and turn by a quarter at each.
TEST(Reduce, MakesNoCreasesWhereTheErrorWouldAllowThem) {
  const Mesh torus = shapes::torus(1, 0.3, 128, 64);
  const double error = 0.037;
  const Mesh fine = built(torus, 0.8 * error);
  EXPECT_GT(creases_of(fine), 100);
  const ReducedMesh few = reduce(fine, torus, {.error = error});
  EXPECT_TRUE(check::is_two_manifold(few));
  EXPECT_EQ(find_self_intersections(few).pairs, 0u);
  EXPECT_EQ(creases_of(few), 0);
  EXPECT_LT(few.triangles.size(), 400u);
  EXPECT_LE(check::distance_to(few, torus), 1.2 * error);
  EXPECT_LE(check::distance_to(torus, few), 1.2 * error);
}

TEST(Reduce, GivesTheSameWhereverAndHoweverLargeTheModelIs) {
  const Mesh input = shapes::torus();
  const Mesh fine = built(input, 0.01);
  const ReducedMesh here = reduce(fine, input, {.error = 0.0125});
  const ReducedMesh again = reduce(fine, input, {.error = 0.0125});
  EXPECT_EQ(here.triangles, again.triangles);
  EXPECT_EQ(here.positions, again.positions);
  const double scale = std::ldexp(1.0, 40);
  const ReducedMesh large =
      reduce(shapes::scaled(fine, Vec3::Constant(scale)),
             shapes::scaled(input, Vec3::Constant(scale)), {.error = 0.0125 * scale});
  EXPECT_EQ(large.triangles, here.triangles);
}

TEST(Reduce, RefusesWhatItCannotTake) {
  const Mesh cube = shapes::cube();
  const auto code = [&](const Mesh& mesh, const Mesh& reference, const ReduceOptions& options) {
    try {
      reduce(mesh, reference, options);
    } catch (const Error& error) {
      return error.code();
    }
    return ErrorCode::kInternal;
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(cube, cube, {}), ErrorCode::kInvalidOption);
  EXPECT_EQ(code(cube, cube, {.error = -1}), ErrorCode::kInvalidOption);
  EXPECT_EQ(code(cube, cube, {.error = kNan}), ErrorCode::kInvalidOption);
  EXPECT_EQ(code(cube, cube, {.target_triangles = {10, 10}}), ErrorCode::kInvalidOption);
  EXPECT_EQ(code(shapes::cubes_at_edge(), cube, {.error = 1}), ErrorCode::kInvalidMesh);
  Mesh bad = cube;
  bad.positions[0].x() = kNan;
  EXPECT_EQ(code(bad, cube, {.error = 1}), ErrorCode::kInvalidMesh);
  EXPECT_EQ(code(cube, bad, {.error = 1}), ErrorCode::kInvalidMesh);
  bad = cube;
  bad.triangles[0][0] = 99;
  EXPECT_EQ(code(bad, cube, {.error = 1}), ErrorCode::kInvalidMesh);
  EXPECT_EQ(code(cube, bad, {.error = 1}), ErrorCode::kInvalidMesh);
}

TEST(Reduce, TakesAnEmptyMesh) {
  EXPECT_TRUE(reduce({}, {}, {.error = 1}).triangles.empty());
  EXPECT_TRUE(reduce({}, shapes::cube(), {.target_triangles = {10}}).triangles.empty());
}

TEST(Reduce, ReportsProgressAndStops) {
  const Mesh sphere = shapes::icosphere(5);
  double last = 0;
  int calls = 0;
  const Progress watch = [&](double fraction, std::string_view phase) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    EXPECT_EQ(phase, "reduce");
    last = fraction;
    ++calls;
    return true;
  };
  reduce(sphere, sphere, {.error = 0.01, .target_triangles = {1000, 10}}, watch);
  EXPECT_GT(calls, 4);
  EXPECT_EQ(last, 1);
  const Progress stop = [](double fraction, std::string_view) { return fraction < 0.3; };
  try {
    reduce(sphere, sphere, {.error = 0.01}, stop);
    ADD_FAILURE() << "not stopped";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kAborted);
  }
}

}  // namespace
}  // namespace kdm
