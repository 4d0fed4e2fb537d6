// SPDX-License-Identifier: MIT
// Shells around surfaces: always closed, as thick as asked for, nothing of them counts negatively.
#include "kdmanifold/thicken.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "geometry/angle.h"
#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/mesh_assert.h"
#include "support/random.h"
#include "support/random_meshes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

using check::check_mesh;

constexpr double kPi = 3.14159265358979323846;

// What is promised of every shell.
void expect_closed(const Mesh& shell) {
  const check::MeshCheck result = check_mesh(shell);
  EXPECT_TRUE(result.closed);
  EXPECT_TRUE(result.oriented);
  EXPECT_EQ(result.bad_positions, 0);
  EXPECT_EQ(shell.source_faces.size(), shell.triangles.size());
}

double area_of(const Mesh& mesh) { return describe(mesh).area; }

// How often the mesh goes round a point, by solid angles.
double winding_at(const Mesh& mesh, const Vec3& p) {
  double sum = 0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]] - p;
    const Vec3 b = mesh.positions[t[1]] - p;
    const Vec3 c = mesh.positions[t[2]] - p;
    const double lengths = a.norm() * b.norm() * c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), lengths + a.dot(b) * c.norm() + b.dot(c) * a.norm() +
                                                 c.dot(a) * b.norm());
  }
  return sum / (4 * kPi);
}

// Three rectangles that meet in the z axis.
Mesh three_sheets() {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(0, 0, 1)};
  for (const Vec3& end : {Vec3(1, 0, 0), Vec3(-0.5, 0.9, 0), Vec3(-0.5, -0.9, 0)}) {
    const auto i = static_cast<Index>(mesh.positions.size());
    mesh.positions.push_back(end);
    mesh.positions.emplace_back(end + Vec3(0, 0, 1));
    mesh.triangles.push_back({0, i, i + 1});
    mesh.triangles.push_back({0, i + 1, 1});
  }
  return mesh;
}

Mesh flat(int n) {
  return shapes::grid_sheet(n, n, [](double, double) { return 0.0; });
}

TEST(Thicken, AnglesAreRight) {
  for (int i = 0; i <= 180; ++i) {
    const double angle = i * kPi / 180;
    const Vec3 other(3 * std::cos(angle), 3 * std::sin(angle), 0);
    EXPECT_NEAR(angle_between(Vec3(2, 0, 0), other), angle, 1e-9);
  }
  EXPECT_EQ(angle_between(Vec3(0, 0, 0), Vec3(1, 0, 0)), 0);
}

TEST(Thicken, AFlatSheetBecomesAPlate) {
  const Mesh shell = thicken(flat(4), 0.1);
  EXPECT_TRUE(check::is_two_manifold(shell));
  EXPECT_NEAR(check_mesh(shell).volume, 0.1, 1e-12);
  const Box bounds = describe(shell).bounds;
  EXPECT_LT((bounds.min - Vec3(0, 0, -0.05)).norm(), 1e-12);
  EXPECT_LT((bounds.max - Vec3(1, 1, 0.05)).norm(), 1e-12);
}

TEST(Thicken, WallsOfABoxAreEquallyThick) {
  // The cube without its lid: the last two faces are at x = 1.
  const Mesh box = shapes::open(shapes::cube(), 2);
  const Mesh shell = thicken(box, 0.1);
  EXPECT_TRUE(check::is_two_manifold(shell));
  EXPECT_NEAR(check_mesh(shell).volume, 1.1 * 1.1 * 1.05 - 0.9 * 0.9 * 0.95, 1e-9);
}

TEST(Thicken, AClosedSurfaceBecomesHollow) {
  const Mesh ball = shapes::icosphere(3);
  const Mesh shell = thicken(ball, 0.01);
  EXPECT_TRUE(check::is_two_manifold(shell));
  EXPECT_EQ(check_mesh(shell).components, 2);
  EXPECT_NEAR(check_mesh(shell).volume / (0.01 * area_of(ball)), 1, 0.01);
}

TEST(Thicken, ShellsOfOpenShapesAreClosed) {
  for (const shapes::OpenShape& shape : shapes::open_shapes()) {
    SCOPED_TRACE(shape.name);
    for (const double thickness : {0.01, 0.3}) expect_closed(thicken(shape.mesh, thickness));
  }
}

TEST(Thicken, ShellsOfAnythingAreClosed) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    check::Random random(seed);
    Mesh soup;
    const Index points = 4 + random.below(30);
    for (Index i = 0; i < points; ++i) soup.positions.push_back(random.point(0, 1));
    for (int i = 0; i < 60; ++i) {
      soup.triangles.push_back({random.below(points), random.below(points), random.below(points)});
    }
    expect_closed(thicken(soup, 0.02));
    expect_closed(thicken(soup, 2));
    expect_closed(thicken(shapes::collapsed_polyhedron(3, seed), 0.2));
  }
}

TEST(Thicken, TheInputsDirectionDoesNotMatter) {
  const Mesh sheet =
      shapes::grid_sheet(12, 12, [](double x, double y) { return 0.2 * x * x - 0.1 * x * y; });
  const double volume = check_mesh(thicken(sheet, 0.05)).volume;
  EXPECT_NEAR(volume / (0.05 * area_of(sheet)), 1, 0.01);
  EXPECT_NEAR(check_mesh(thicken(shapes::inverted(sheet), 0.05)).volume, volume, 1e-12);
  Mesh mixed = sheet;
  for (std::size_t t = 0; t < mixed.triangles.size(); t += 3) {
    std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
  }
  EXPECT_NEAR(check_mesh(thicken(mixed, 0.05)).volume, volume, 1e-12);
  EXPECT_TRUE(check::is_two_manifold(thicken(mixed, 0.05)));
}

TEST(Thicken, CopiesAndDegenerateFacesAddNothing) {
  Mesh sheet = flat(4);
  const std::vector<Triangle> once = sheet.triangles;
  sheet.triangles.insert(sheet.triangles.end(), once.begin(), once.end());
  for (const Triangle& t : once) sheet.triangles.push_back({t[0], t[2], t[1]});
  sheet.triangles.push_back({3, 3, 4});
  sheet.triangles.push_back({0, 1, 2});  // along the rim, no area
  const Mesh shell = thicken(sheet, 0.1);
  expect_closed(shell);
  EXPECT_NEAR(check_mesh(shell).volume, 0.1, 0.003);
}

TEST(Thicken, SheetsThatMeetGrowTogether) {
  const Mesh shell = thicken(three_sheets(), 0.1);
  expect_closed(shell);
  const Mesh solid = extract(build_grid(shell, {.relative_tolerance = 0.005}));
  EXPECT_TRUE(check::is_two_manifold(solid));
  EXPECT_EQ(check_mesh(solid).components, 1);
  EXPECT_EQ(check_mesh(solid).euler_characteristic, 2);
}

TEST(Thicken, AMoebiusBandBecomesATorus) {
  const Mesh band = shapes::moebius_band(60);
  const Mesh shell = thicken(band, 0.1);
  expect_closed(shell);
  const Mesh solid = extract(build_grid(shell, {.relative_tolerance = 0.005}));
  EXPECT_TRUE(check::is_two_manifold(solid));
  EXPECT_EQ(check_mesh(solid).components, 1);
  EXPECT_EQ(check_mesh(solid).euler_characteristic, 0);
  EXPECT_NEAR(check_mesh(solid).volume / (0.1 * area_of(band)), 1, 0.05);
}

TEST(Thicken, DetailFinerThanTheThicknessIsFilled) {
  // A ball of radius 0.3, half a unit to either side: its inner copies reach beyond the middle.
  const Mesh shell = thicken(shapes::icosphere(2, 0.3), 1);
  expect_closed(shell);
  check::Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Vec3 p = random.point(-1, 1);
    const double winding = winding_at(shell, p);
    EXPECT_GT(winding, -0.01) << p.transpose();
    if (p.norm() < 0.5) {
      EXPECT_GT(winding, 0.99) << p.transpose();
    }
    if (p.norm() > 1) {
      EXPECT_LT(winding, 0.01) << p.transpose();
    }
  }
}

TEST(Thicken, CreasesAndRipplesCountPositively) {
  const Mesh ripples = shapes::grid_sheet(40, 40, [](double x, double y) {
    return 0.05 * shapes::sine(40 * x) * shapes::sine(31 * y);
  });
  const Mesh shell = thicken(ripples, 0.2);
  expect_closed(shell);
  check::Random random(4);
  for (int i = 0; i < 200; ++i) {
    EXPECT_GT(winding_at(shell, random.point(-0.2, 1.2)), -0.01);
  }
}

// A wavy sheet whose columns lie in pairs, `gap` apart: every other triangle is a needle, and what
// its neighbours say of its ends' normals differs by more than it can bear.
Mesh needles(double gap) {
  const auto wave = [](double x, double y) { return 0.2 * shapes::sine(5 * x + y); };
  Mesh mesh = shapes::grid_sheet(60, 20, [](double, double) { return 0.0; });
  for (Vec3& p : mesh.positions) {
    const double column = std::round(60 * p.x());
    const double pair = std::floor(column / 2);
    p.x() = pair / 30 + (column - 2 * pair) * gap;
    p.z() = wave(p.x(), p.y());
  }
  return mesh;
}

TEST(Thicken, NeedlesDoNotTearTheShell) {
  for (const double gap : {1e-3, 1e-5, 1e-8}) {
    SCOPED_TRACE(gap);
    const Mesh sheet = needles(gap);
    const Mesh shell = thicken(sheet, 0.1);
    expect_closed(shell);
    EXPECT_EQ(shell.positions.size(), 2 * sheet.positions.size()) << "one piece on either side";
    EXPECT_NEAR(check_mesh(shell).volume / (0.1 * area_of(sheet)), 1, 0.02);
    for (const Vec3& p : shell.positions) EXPECT_LT(std::abs(p.z()), 0.2 + 0.08);
  }
}

TEST(Thicken, ATubeThinnerThanItsWallIsFilled) {
  // Half a unit on either side of a tube of radius 0.3 reaches across it.
  const Mesh tube = shapes::torus(1, 0.3, 32, 16);
  const Mesh shell = thicken(tube, 1);
  expect_closed(shell);
  check::Random random(5);
  for (int i = 0; i < 300; ++i) {
    const double along = 2 * kPi * random.unit();
    const double around = 2 * kPi * random.unit();
    const double from = 0.75 * random.unit();
    const double out = 1 + from * std::cos(around);
    const Vec3 p(out * std::cos(along), out * std::sin(along), from * std::sin(around));
    EXPECT_GT(winding_at(shell, p), 0.99) << p.transpose();
  }
  const Mesh solid = extract(build_grid(shell, {.relative_tolerance = 0.01}));
  EXPECT_TRUE(check::is_two_manifold(solid));
  EXPECT_NEAR(check_mesh(solid).volume / (2 * kPi * kPi * 0.8 * 0.8), 1, 0.03);
  EXPECT_LT(solid.triangles.size(), 4000u) << "its outside is as smooth as the tube's";
}

TEST(Thicken, BentPiecesLeaveNoGaps) {
  // A saddle that bends more tightly than its shell is thick, both ways and on both sides.
  const Mesh saddle = shapes::grid_sheet(24, 24, [](double x, double y) {
    return 4 * ((x - 0.5) * (x - 0.5) - (y - 0.5) * (y - 0.5));
  });
  const Mesh shell = thicken(saddle, 0.4);
  expect_closed(shell);
  check::Random random(6);
  for (int i = 0; i < 300; ++i) {
    EXPECT_GT(winding_at(shell, random.point(-0.5, 1.5)), -0.01);
    const Index at = random.below(static_cast<Index>(saddle.triangles.size()));
    const Triangle& t = saddle.triangles[at];
    const Vec3& a = saddle.positions[t[0]];
    const Vec3& b = saddle.positions[t[1]];
    const Vec3& c = saddle.positions[t[2]];
    const Vec3 normal = (b - a).cross(c - a).normalized();
    const Vec3 p = (a + b + c) / 3 + random.between(-0.19, 0.19) * normal;
    EXPECT_GT(winding_at(shell, p), 0.99) << p.transpose();
  }
  const Mesh solid = extract(build_grid(shell, {.relative_tolerance = 0.002}));
  EXPECT_TRUE(check::is_two_manifold(solid));
  EXPECT_EQ(check_mesh(solid).components, 1) << "no voids within";
}

TEST(Thicken, SizeAndPlaceDoNotMatter) {
  const Mesh box = shapes::open(shapes::cube(), 2);
  const double volume = check_mesh(thicken(box, 0.1)).volume;
  for (const double factor : {1e-30, 1e30}) {
    const Mesh sized = shapes::scaled(box, Vec3::Constant(factor));
    const Mesh shell = shapes::scaled(thicken(sized, 0.1 * factor), Vec3::Constant(1 / factor));
    EXPECT_NEAR(check_mesh(shell).volume, volume, 1e-9);
  }
  const Mesh far = thicken(shapes::translated(box, Vec3(1e6, 1e6, -1e6)), 0.1);
  EXPECT_NEAR(check_mesh(shapes::translated(far, Vec3(-1e6, -1e6, 1e6))).volume, volume, 1e-6);
  Mesh far_point = box;
  far_point.positions.emplace_back(1e149, 1e149, 1e149);
  EXPECT_NEAR(check_mesh(thicken(far_point, 0.1)).volume, volume, 1e-9);
}

TEST(Thicken, TrianglesNameTheFacesTheyComeFrom) {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0), Vec3(2, 0, 0)};
  mesh.triangles = {{1, 4, 2}};
  mesh.quads = {{0, 1, 2, 3}};
  for (const Index face : thicken(mesh, 0.1).source_faces) EXPECT_LT(face, 2u);
  mesh.source_faces = {70, 80};
  int of_quad = 0;
  for (const Index face : thicken(mesh, 0.1).source_faces) {
    EXPECT_TRUE(face == 70 || face == 80);
    of_quad += face == 80 ? 1 : 0;
  }
  EXPECT_EQ(of_quad, 2 * 2 + 3 * 2) << "two triangles on either side, three walls of two";
}

TEST(Thicken, BuildingTakesAThickness) {
  const Mesh sheet = flat(2);
  EXPECT_THROW(build_grid(sheet), Error);
  const Grid grid = build_grid(sheet, {.relative_tolerance = 0.01, .thicken = 0.1});
  EXPECT_TRUE(grid.input().closed);
  const Mesh solid = extract(grid);
  EXPECT_TRUE(check::is_two_manifold(solid));
  EXPECT_NEAR(check_mesh(solid).volume, 0.1, 1e-4);
}

void expect_refused(const Mesh& mesh, double thickness, ErrorCode code, const char* word) {
  try {
    thicken(mesh, thickness);
    ADD_FAILURE() << "accepted; expected: " << word;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code);
    EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
  }
}

TEST(Thicken, RefusesWhatMakesNoShell) {
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double thickness : {0.0, -1.0, infinity, std::nan("")}) {
    expect_refused(flat(1), thickness, ErrorCode::kInvalidOption, "thickness");
  }
  EXPECT_THROW(build_grid(flat(1), {.thicken = -1}), Error);
  EXPECT_THROW(build_grid(flat(1), {.thicken = 1e-9}), Error) << "thinner than the lattice";
  expect_refused(Mesh(), 1, ErrorCode::kInvalidMesh, "no face");
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
  expect_refused(mesh, 1, ErrorCode::kInvalidMesh, "no face");
  mesh.triangles = {{0, 1, 2}, {0, 0, 1}};
  expect_refused(mesh, 1, ErrorCode::kInvalidMesh, "no face");
  mesh.source_faces = {1};
  expect_refused(mesh, 1, ErrorCode::kInvalidMesh, "source_faces");
  mesh.source_faces.clear();
  mesh.triangles[0][1] = 9;
  expect_refused(mesh, 1, ErrorCode::kInvalidMesh, "vertex 9");
  mesh.positions[1][2] = infinity;
  expect_refused(mesh, 1, ErrorCode::kInvalidMesh, "positions");
}

}  // namespace
}  // namespace kdm
