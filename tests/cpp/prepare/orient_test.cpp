// SPDX-License-Identifier: MIT
// Parts that are inside out, cavities, sheets: which way they must look.
#include "prepare/orient.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "prepare/weld.h"
#include "support/random.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

Orientation orientation_of(const Mesh& mesh) {
  return orient(mesh.triangles, mesh.positions,
                build_topology(mesh.triangles, static_cast<Index>(mesh.positions.size())));
}

Marks all_marked(std::size_t size) {
  Marks marks(size);
  for (std::size_t i = 0; i < size; ++i) marks.set(i);
  return marks;
}

void expect_turned(const Orientation& result, const Marks& expected) {
  EXPECT_EQ(result.must_turn, expected);
  EXPECT_EQ(result.flipped_triangles, expected.count());
}

void expect_no_flips(const Mesh& mesh) {
  expect_turned(orientation_of(mesh), Marks(mesh.triangles.size()));
}

void expect_all_flipped(const Mesh& mesh) {
  expect_turned(orientation_of(mesh), all_marked(mesh.triangles.size()));
}

// Parts one after the other, those in `inside_out` (one bit each) turned; turning exactly these
// back is right.
void expect_turned_back(const std::vector<Mesh>& parts, unsigned inside_out) {
  SCOPED_TRACE(inside_out);
  std::vector<Mesh> turned;
  Marks expected;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool turn = (inside_out >> i & 1) != 0;
    turned.push_back(turn ? shapes::inverted(parts[i]) : parts[i]);
    for (std::size_t t = 0; t < parts[i].triangles.size(); ++t) expected.push_back(turn);
  }
  expect_turned(orientation_of(shapes::merged(turned)), expected);
}

// A box without the side at its lowest z; the cube's triangles there are the ones with all z = 0.
Mesh open_box(const Vec3& min, const Vec3& max) {
  Mesh mesh = shapes::box(min, max);
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    const bool bottom =
        std::all_of(t.begin(), t.end(), [&](Index v) { return mesh.positions[v][2] == min[2]; });
    if (!bottom) kept.push_back(t);
  }
  mesh.triangles = kept;
  return mesh;
}

// The part of a sphere above z.
Mesh cap(double z) {
  Mesh mesh = shapes::uv_sphere(32, 32);
  std::vector<Triangle> kept;
  for (const Triangle& t : mesh.triangles) {
    const bool above =
        std::all_of(t.begin(), t.end(), [&](Index v) { return mesh.positions[v][2] > z; });
    if (above) kept.push_back(t);
  }
  mesh.triangles = kept;
  return mesh;
}

// --- One part ------------------------------------------------------------------------------------

TEST(Orient, OneClosedPartIsTurnedIfItsVolumeIsNegative) {
  for (const shapes::NamedShape& shape : shapes::all_shapes()) {
    const Orientation result = orientation_of(shape.mesh);
    if (result.parts.size() != 1 || result.parts[0].sheet) continue;
    SCOPED_TRACE(shape.name);
    expect_no_flips(shape.mesh);
    expect_all_flipped(shapes::inverted(shape.mesh));
    EXPECT_TRUE(result.changes_nothing());
    EXPECT_EQ(result.flipped_parts, 0u);
    EXPECT_EQ(orientation_of(shapes::inverted(shape.mesh)).flipped_parts, 1u);
  }
}

TEST(Orient, SizeAndPlaceDoNotMatter) {
  const Mesh inverted = shapes::inverted(shapes::torus());
  for (const double factor : {1e-140, 1e-30, 1e30, 1e140}) {
    const Mesh sized = shapes::scaled(inverted, Vec3::Constant(factor));
    expect_all_flipped(sized);
    EXPECT_NEAR(orientation_of(sized).parts[0].area / (factor * factor),
                orientation_of(inverted).parts[0].area, 1e-9);
  }
  expect_all_flipped(shapes::translated(inverted, Vec3(1e6, -1e6, 1e6)));
  Mesh far_point = inverted;
  far_point.positions.emplace_back(1e149, 1e149, 1e149);
  expect_all_flipped(far_point);
}

TEST(Orient, AnOpenPartShowsItsOuterSide) {
  for (const Mesh& mesh : {open_box(Vec3(0, 0, 0), Vec3(1, 1, 1)), cap(0), cap(-0.9),
                           shapes::open(shapes::torus(), 20), shapes::tube(1, 4, 24)}) {
    for (const bool inside_out : {false, true}) {
      const Mesh turned = inside_out ? shapes::inverted(mesh) : mesh;
      const Orientation result = orientation_of(turned);
      const std::size_t size = mesh.triangles.size();
      expect_turned(result, inside_out ? all_marked(size) : Marks(size));
      ASSERT_EQ(result.parts.size(), 1u);
      EXPECT_FALSE(result.parts[0].closed);
      EXPECT_FALSE(result.parts[0].sheet);
      EXPECT_EQ(result.parts[0].flipped, inside_out);
    }
  }
}

TEST(Orient, SheetsAreToldApartAndStay) {
  const auto waves = [](double x, double y) {
    return 0.1 * shapes::sine(12 * x) * shapes::sine(12 * y);
  };
  for (const Mesh& mesh : {shapes::grid_sheet(4, 4, [](double, double) { return 0.0; }),
                           shapes::grid_sheet(16, 16, waves)}) {
    for (const Mesh& either : {mesh, shapes::inverted(mesh)}) {
      const Orientation result = orientation_of(either);
      EXPECT_EQ(result.sheets, 1u);
      EXPECT_TRUE(result.parts[0].sheet);
      EXPECT_EQ(result.flipped_triangles, 0u);
    }
  }
}

TEST(Orient, AVolumeDecidesWhereBothSidesSeeTheSame) {
  EXPECT_EQ(orientation_of(cap(0.9)).sheets, 1u);
  expect_no_flips(cap(0.9));
  expect_all_flipped(shapes::inverted(cap(0.9)));
}

TEST(Orient, AMoebiusBandKeepsOneContradiction) {
  EXPECT_EQ(orientation_of(shapes::moebius_band(24)).contradictions, 1u);
}

TEST(Orient, APillowWithoutVolumeIsASheet) {
  Mesh mesh;
  mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 1, 0}, {3, 2, 1}};
  const Orientation result = orientation_of(mesh);
  ASSERT_EQ(result.parts.size(), 1u);
  EXPECT_TRUE(result.parts[0].closed);
  EXPECT_TRUE(result.parts[0].sheet);
}

// --- Several parts -------------------------------------------------------------------------------

// Seat, back and four legs, each a box that reaches into the next.
std::vector<Mesh> chair() {
  std::vector<Mesh> parts = {shapes::box(Vec3(0, 0, 4), Vec3(4, 4, 4.4)),
                             shapes::box(Vec3(0, 3.7, 4.2), Vec3(4, 4, 9))};
  for (const double x : {0.2, 3.4}) {
    for (const double y : {0.2, 3.4}) {
      parts.push_back(shapes::box(Vec3(x, y, 0), Vec3(x + 0.4, y + 0.4, 4.2)));
    }
  }
  return parts;
}

TEST(Orient, PartsOfAChairAreTurnedOneByOne) {
  for (unsigned inside_out = 0; inside_out < 64; ++inside_out) {
    expect_turned_back(chair(), inside_out);
  }
}

TEST(Orient, OpenPartsOfAChairAreTurnedOneByOne) {
  std::vector<Mesh> parts = {open_box(Vec3(0, 0, 4), Vec3(4, 4, 4.4)),
                             open_box(Vec3(0, 3.7, 4.2), Vec3(4, 4, 9))};
  for (const double x : {0.2, 3.4}) parts.push_back(open_box(Vec3(x, 0, 0), Vec3(x + 0.4, 1, 4.2)));
  for (unsigned inside_out = 0; inside_out < 16; ++inside_out) {
    expect_turned_back(parts, inside_out);
  }
}

TEST(Orient, CrossingBoxesAreTurnedOneByOne) {
  const std::vector<Mesh> cross = {shapes::box(Vec3(-3, -1, -1), Vec3(3, 1, 1)),
                                   shapes::box(Vec3(-1, -3, -1.1), Vec3(1, 3, 1.1)),
                                   shapes::box(Vec3(-1.2, -1.2, -3), Vec3(1.2, 1.2, 3))};
  for (unsigned inside_out = 0; inside_out < 8; ++inside_out) expect_turned_back(cross, inside_out);
}

TEST(Orient, BoxesFaceToFaceAreTurnedOneByOne) {
  const std::vector<Mesh> boxes = {shapes::box(Vec3(0, 0, 0), Vec3(1, 1, 1)),
                                   shapes::box(Vec3(1, 0, 0), Vec3(2, 1, 1)),
                                   shapes::box(Vec3(0, 0, 1), Vec3(2, 1, 2))};
  for (unsigned inside_out = 0; inside_out < 8; ++inside_out) expect_turned_back(boxes, inside_out);
}

TEST(Orient, TheSidesOfABoxThatAreNotJoinedAreTurnedOneByOne) {
  // Six plates of two triangles with vertices of their own, a little apart.
  const Mesh cube = shapes::cube();
  std::vector<Mesh> plates;
  for (std::size_t t = 0; t < 12; t += 2) {
    Mesh plate = cube;
    plate.triangles = {cube.triangles[t], cube.triangles[t + 1]};
    Vec3 middle = Vec3::Zero();
    for (const Triangle& c : plate.triangles) {
      for (const Index v : c) middle += plate.positions[v] / 6;
    }
    plates.push_back(shapes::translated(plate, 0.01 * (middle - Vec3::Constant(0.5))));
  }
  for (unsigned inside_out = 0; inside_out < 64; ++inside_out) {
    expect_turned_back(plates, inside_out);
  }
}

TEST(Orient, TurnedFacesOfSeveralPartsAreTurnedBack) {
  for (const double share : {0.01, 0.1, 0.3}) {
    check::Random random(11);
    Mesh mesh = shapes::torus_chain(3);
    Marks turned(mesh.triangles.size());
    for (std::size_t t = 0; t < turned.size(); ++t) {
      if (random.unit() >= share) continue;
      turned.set(t);
      std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
    expect_turned(orientation_of(mesh), turned);
  }
}

// --- Nested parts --------------------------------------------------------------------------------

TEST(Orient, CavitiesStayCavities) {
  for (const Mesh& mesh :
       {shapes::nested_spheres(), shapes::swiss_cheese(6), shapes::thin_walled_box()}) {
    const Orientation result = orientation_of(mesh);
    expect_no_flips(mesh);
    EXPECT_FALSE(result.parts[0].enclosed);
    for (std::size_t p = 1; p < result.parts.size(); ++p) EXPECT_TRUE(result.parts[p].enclosed);
  }
}

TEST(Orient, AHollowBallInsideOutIsAHollowBall) {
  expect_all_flipped(shapes::inverted(shapes::nested_spheres()));
  expect_all_flipped(shapes::inverted(shapes::swiss_cheese(6)));
}

TEST(Orient, ASolidWithinASolidStaysOne) { expect_no_flips(shapes::nested_shells()); }

TEST(Orient, ACavityWithTurnedFacesIsACavity) {
  Mesh mesh = shapes::nested_spheres();
  const Index inner = orientation_of(mesh).parts.at(1).first;
  check::Random random(5);
  Marks turned(mesh.triangles.size());
  for (Index t = inner; t < mesh.triangles.size(); ++t) {
    if (random.below(10) != 0) continue;
    turned.set(t);
    std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
  }
  expect_turned(orientation_of(mesh), turned);
}

TEST(Orient, ACavityBehindASmallHoleIsACavity) {
  // One face of 1,280 is missing from the outer shell.
  const Mesh outer = shapes::open(shapes::icosphere(3, 2));
  const Mesh inner = shapes::inverted(shapes::icosphere(2, 1));
  expect_no_flips(shapes::merged({outer, inner}));
}

TEST(Orient, AWallWithinASolidBoundsNothing) {
  Mesh wall = shapes::grid_sheet(2, 2, [](double, double) { return 0.5; });
  wall = shapes::translated(shapes::scaled(wall, Vec3(0.8, 0.8, 1)), Vec3(0.1, 0.1, 0));
  const Orientation result = orientation_of(shapes::merged({shapes::cube(), wall}));
  ASSERT_EQ(result.parts.size(), 2u);
  EXPECT_FALSE(result.parts[0].sheet);
  EXPECT_TRUE(result.parts[1].sheet);
  EXPECT_TRUE(result.parts[1].enclosed);
  EXPECT_EQ(result.flipped_triangles, 0u);
}

// --- Not to be turned ----------------------------------------------------------------------------

TEST(Orient, FlapsOfAClosedMeshStay) {
  expect_no_flips(shapes::cube_with_flaps());
  expect_no_flips(shapes::doubled_cube());
  expect_no_flips(shapes::cubes_at_vertex());
}

TEST(Orient, AStreetOfManyPartsStays) { expect_no_flips(shapes::street(6000)); }

TEST(Orient, PartsWithoutAreaAreHarmless) {
  Mesh line;
  line.positions = {Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
  line.triangles = {{0, 1, 2}};
  const Orientation result = orientation_of(shapes::merged({line, shapes::cube()}));
  EXPECT_EQ(result.flipped_triangles, 0u);
  EXPECT_TRUE(result.parts.at(0).sheet);
  EXPECT_TRUE(orient({}, {}, {}).parts.empty());
}

}  // namespace
}  // namespace kdm
