// SPDX-License-Identifier: MIT
// Normals at the corners of faces: exact on flat parts, radial on spheres, apart at creases.
#include "extract/place/normals.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <map>

#include "kdmanifold/build.h"
#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "kdmanifold/mesh_io.h"
#include "support/mesh_assert.h"
#include "support/random_meshes.h"
#include "support/shapes.h"
#include "support/sheets.h"

namespace kdm {
namespace {

ExtractedMesh with_normals(const Mesh& mesh, double crease_angle = 30, bool quads = false) {
  const Grid grid = build_grid(mesh, {.strategy = SplitStrategy::kUniform, .depth = 12});
  return extract(grid, {.quads = quads, .normals = true, .crease_angle = crease_angle});
}

Vec3 normal_at(const Mesh& mesh, std::size_t corner) {
  const std::array<float, 3>& n = mesh.corner_normals[corner];
  return Vec3(n[0], n[1], n[2]);
}

// Calls visit(position, normal) for every corner.
template <typename Visit>
void for_each_corner(const Mesh& mesh, Visit&& visit) {
  std::size_t corner = 0;
  for (const Triangle& t : mesh.triangles) {
    for (const Index v : t) visit(mesh.positions[v], normal_at(mesh, corner++));
  }
  for (const Quad& q : mesh.quads) {
    for (const Index v : q) visit(mesh.positions[v], normal_at(mesh, corner++));
  }
  EXPECT_EQ(corner, mesh.corner_normals.size());
}

TEST(Cosine, OfDegrees) {
  EXPECT_EQ(cosine_of_degrees(0), 1);
  EXPECT_EQ(cosine_of_degrees(90), 0);
  EXPECT_EQ(cosine_of_degrees(180), -1);
  const double degree = std::acos(-1.0) / 180;
  for (double angle = 0; angle <= 180; angle += 0.25) {
    EXPECT_NEAR(cosine_of_degrees(angle), std::cos(angle * degree), 1e-15) << angle;
    EXPECT_EQ(cosine_of_degrees(180 - angle), -cosine_of_degrees(angle)) << angle;
  }
}

TEST(Normals, OnlyOnRequest) {
  EXPECT_TRUE(extract(build_grid(shapes::cube())).corner_normals.empty());
}

TEST(Normals, ACubeHasThoseOfItsFaces) {
  for (const bool quads : {false, true}) {
    const ExtractedMesh mesh = with_normals(shapes::cube(), 30, quads);
    ASSERT_EQ(mesh.corner_normals.size(), 3 * mesh.triangles.size() + 4 * mesh.quads.size());
    const Vec3 centre = 0.5 * (describe(mesh).bounds.min + describe(mesh).bounds.max);
    std::map<int, int> seen;
    for_each_corner(mesh, [&](const Vec3& position, const Vec3& normal) {
      int axis = 0;
      ASSERT_EQ(normal.cwiseAbs().maxCoeff(&axis), 1);
      ASSERT_EQ(normal.cwiseAbs().sum(), 1) << "exactly along an axis";
      // The corner lies on the face with this normal.
      ASSERT_NEAR((position - centre).dot(normal), 0.5, 1e-4);
      ++seen[normal[axis] > 0 ? axis : axis + 3];
    });
    EXPECT_EQ(seen.size(), 6u);
  }
}

TEST(Normals, ATurnedCubeHasThoseOfItsFaces) {
  const Mesh input = shapes::rotated(shapes::cube(), Vec3(1, 2, 3), 1);
  std::vector<Vec3> faces;
  for (const Triangle& t : input.triangles) {
    const Vec3& a = input.positions[t[0]];
    const Vec3 u = input.positions[t[1]] - a;
    const Vec3 v = input.positions[t[2]] - a;
    faces.push_back(
        Vec3(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
            .normalized());
  }
  for_each_corner(with_normals(input), [&](const Vec3&, const Vec3& normal) {
    double nearest = 1;
    for (const Vec3& face : faces) nearest = std::min(nearest, (face - normal).norm());
    ASSERT_LT(nearest, 1e-6);
  });
}

TEST(Normals, ASphereIsSmooth) {
  const Mesh input = shapes::icosphere(4);
  const ExtractedMesh mesh = with_normals(input);
  std::map<std::array<double, 3>, Vec3> at;
  for_each_corner(mesh, [&](const Vec3& position, const Vec3& normal) {
    ASSERT_NEAR(normal.norm(), 1, 1e-6);
    // Faces of the input turn by about 4 degrees, cells by about as much.
    ASSERT_GT(normal.dot(position.normalized()), std::cos(0.1));
    const auto [found, fresh] = at.insert({{position[0], position[1], position[2]}, normal});
    ASSERT_TRUE(fresh || found->second == normal) << "one normal a vertex";
  });
}

TEST(Normals, TheCreaseAngleDecides) {
  // Neighbouring faces of a cube turn by 90 degrees: creases below that, none from there on.
  const auto off_axis = [](double angle) {
    int count = 0;
    for_each_corner(with_normals(shapes::cube(), angle), [&](const Vec3&, const Vec3& normal) {
      EXPECT_NEAR(normal.norm(), 1, 1e-6) << angle;
      count += normal.cwiseAbs().maxCoeff() < 0.99 ? 1 : 0;
    });
    return count;
  };
  EXPECT_EQ(off_axis(0), 0);
  EXPECT_EQ(off_axis(89.9), 0);
  EXPECT_GT(off_axis(90), 0);
  EXPECT_EQ(off_axis(180), off_axis(90));
}

// The inner cube faces outwards like the outer one; with odd windings it is a cavity.
TEST(Normals, PointOutOfTheSolidInCavitiesToo) {
  Mesh nested = shapes::cube();
  const auto count = static_cast<Index>(nested.positions.size());
  const Vec3 centre = 0.5 * (describe(nested).bounds.min + describe(nested).bounds.max);
  for (Index v = 0; v < count; ++v) {
    nested.positions.push_back(centre + 0.5 * (nested.positions[v] - centre));
  }
  const std::vector<Triangle> outer = nested.triangles;
  for (const Triangle& t : outer) {
    nested.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  }
  nested.source_faces.clear();
  const Grid grid = build_grid(
      nested, {.strategy = SplitStrategy::kUniform, .depth = 12, .inside = InsideRule::kOdd});
  int inner = 0;
  for_each_corner(extract(grid, {.normals = true}), [&](const Vec3& position, const Vec3& normal) {
    const Vec3 from_centre = position - centre;
    const bool cavity = from_centre.cwiseAbs().maxCoeff() < 0.4;
    inner += cavity ? 1 : 0;
    ASSERT_EQ(from_centre.dot(normal) < 0, cavity);
  });
  EXPECT_GT(inner, 0);
}

// On the boundary, corners are chains instead of rings.
ExtractedMesh sheet_with_normals(const Mesh& mesh) {
  const Grid grid = build_grid(mesh, {.relative_tolerance = 0.005, .inside = InsideRule::kSheet});
  ExtractedMesh out = extract(grid, {.normals = true});
  EXPECT_GT(out.report.boundary_loops, 0u);
  EXPECT_EQ(out.corner_normals.size(), 3 * out.triangles.size());
  return out;
}

TEST(Normals, AFlatSheetHasOne) {
  const Vec3 axis(1, 2, 3);
  const Mesh square = shapes::grid_sheet(1, 1, [](double, double) { return 0.0; });
  const Vec3 up = Eigen::AngleAxisd(0.9, axis.normalized()) * Vec3::UnitZ();
  int corners = 0;
  for_each_corner(sheet_with_normals(shapes::rotated(square, axis, 0.9)),
                  [&](const Vec3&, const Vec3& normal) {
                    ASSERT_LT((normal - up).norm(), 1e-6);
                    ++corners;
                  });
  EXPECT_GE(corners, 6);
}

TEST(Normals, HalfACylinderIsSmoothUpToItsRim) {
  Mesh half = shapes::tube(0.4, 1, 64);
  half.triangles.resize(half.triangles.size() / 2);
  for_each_corner(sheet_with_normals(half), [](const Vec3& position, const Vec3& normal) {
    ASSERT_NEAR(normal.norm(), 1, 1e-6);
    ASSERT_NEAR(normal.z(), 0, 1e-6);
    const Vec3 radial = Vec3(position.x(), position.y(), 0).normalized();
    ASSERT_GT(normal.dot(radial), std::cos(0.2)) << position.transpose();
  });
}

TEST(Normals, CreasesRunUpToTheBoundary) {
  for (const shapes::OpenShape& shape : shapes::open_shapes()) {
    if (shape.name != "lidless_cube") continue;
    int on_rim = 0;
    for_each_corner(sheet_with_normals(shape.mesh), [&](const Vec3& position, const Vec3& normal) {
      ASSERT_EQ(normal.cwiseAbs().maxCoeff(), 1) << "exactly along an axis";
      on_rim += position.z() > 0.999 ? 1 : 0;
    });
    EXPECT_GE(on_rim, 8 + 4);
  }
}

TEST(Normals, AreUnitWhateverTheInput) {
  for (const Mesh& input :
       {shapes::thin_walled_box(0.02), shapes::overlapping_cubes(),
        shapes::integer_tetrahedra(9, 4, 1), shapes::inverted(shapes::torus())}) {
    for (const double angle : {0.0, 30.0, 180.0}) {
      const ExtractedMesh mesh = with_normals(input, angle);
      ASSERT_EQ(mesh.corner_normals.size(), 3 * mesh.triangles.size());
      for_each_corner(mesh, [](const Vec3&, const Vec3& n) { ASSERT_NEAR(n.norm(), 1, 1e-6); });
    }
  }
}

TEST(Normals, TheMeshStaysWhatItIs) {
  const Grid grid = build_grid(shapes::torus(), {.relative_tolerance = 0.01});
  const ExtractedMesh plain = extract(grid);
  const ExtractedMesh shaded = extract(grid, {.normals = true});
  EXPECT_EQ(plain.positions, shaded.positions);
  EXPECT_EQ(plain.triangles, shaded.triangles);
  EXPECT_TRUE(check::is_two_manifold(shaded));
}

TEST(Normals, TheAngleIsChecked) {
  const Grid grid = build_grid(shapes::cube());
  for (const double bad : {-1.0, 180.1, std::nan(""), std::numeric_limits<double>::infinity()}) {
    try {
      extract(grid, {.normals = true, .crease_angle = bad});
      FAIL() << bad;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kInvalidOption);
      EXPECT_NE(std::string(error.what()).find("crease_angle"), std::string::npos);
    }
  }
}

TEST(Normals, ObjFilesHaveThem) {
  Mesh mesh = shapes::tetrahedron();
  mesh.corner_normals.assign(12, {0, 0, 1});
  mesh.corner_normals[4] = {0, -1, -0.0f};
  mesh.corner_normals[5] = {0, -1, 0};
  const std::string text = format_mesh(mesh, MeshFormat::kObj);
  EXPECT_NE(text.find("\nvn 0 -1 0\nvn 0 0 1\nf "), std::string::npos) << text;
  const Triangle& t = mesh.triangles[1];
  EXPECT_NE(text.find("f " + std::to_string(t[0] + 1) + "//2 " + std::to_string(t[1] + 1) + "//1 " +
                      std::to_string(t[2] + 1) + "//1\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(parse_mesh(text, MeshFormat::kObj).triangles, mesh.triangles);
  for (const MeshFormat other : {MeshFormat::kStl, MeshFormat::kPly, MeshFormat::kOff}) {
    Mesh plain = mesh;
    plain.corner_normals.clear();
    EXPECT_EQ(format_mesh(mesh, other), format_mesh(plain, other));
  }
  mesh.corner_normals.pop_back();
  EXPECT_THROW(format_mesh(mesh, MeshFormat::kObj), Error);
  mesh.corner_normals.push_back({0, std::nanf(""), 1});
  EXPECT_THROW(format_mesh(mesh, MeshFormat::kObj), Error);
}

}  // namespace
}  // namespace kdm
