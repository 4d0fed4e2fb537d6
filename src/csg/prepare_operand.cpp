// SPDX-License-Identifier: MIT
#include "csg/prepare_operand.h"

#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "csg/solidify.h"
#include "kdmanifold/error.h"
#include "kdmanifold/thicken.h"
#include "text/compose.h"

namespace kdm {
namespace {

double determinant_of(const Transform& transform) {
  return transform.col(0).cross(transform.col(1)).dot(transform.col(2));
}

void check_transform(const Transform& transform) {
  if (!transform.allFinite()) {
    throw Error(ErrorCode::kInvalidOption, "transform: a number of it is not finite");
  }
  // The determinant as a fraction of what it would be if the columns were at right angles.
  constexpr double kLeast = 1e-12;
  double size = 1;
  for (int column = 0; column < 3; ++column) size *= transform.col(column).norm();
  const double determinant = determinant_of(transform);
  if (!(std::abs(determinant) > kLeast * size)) {
    throw Error(ErrorCode::kInvalidOption,
                compose("transform: it is not invertible, its determinant is {}", determinant));
  }
}

// A mirrored solid keeps its outside outside.
Mesh transformed(const Mesh& mesh, const Transform& transform) {
  if (transform == Transform::Identity()) return mesh;
  check_transform(transform);
  Mesh result = mesh;
  for (Vec3& p : result.positions) p = transform.leftCols<3>() * p + transform.col(3);
  if (determinant_of(transform) < 0) {
    for (Triangle& t : result.triangles) std::swap(t[1], t[2]);
    for (Quad& q : result.quads) std::swap(q[1], q[3]);
  }
  return result;
}

SolidFaces prepare(const Operand& operand, Index number, const BuildOptions& options,
                   const Progress& progress) {
  BuildOptions own = options;
  own.inside = operand.inside.value_or(options.inside);
  if (own.inside == InsideRule::kSheet) {
    throw Error(ErrorCode::kInvalidOption, "inside: sheets bound no solid");
  }
  Mesh mesh = transformed(*operand.mesh, operand.transform);
  if (options.thicken > 0 && options.thicken_what == ThickenWhat::kAll)
    mesh = thicken(mesh, std::exchange(own.thicken, 0));
  SolidFaces solid{prepare_faces(mesh, own), own.inside, number};
  if (solid.faces.repair) solidify_open_parts(solid.faces, own, progress);
  if (solid.inside == InsideRule::kRepair) solid.inside = InsideRule::kPositive;
  return solid;
}

}  // namespace

SolidFaces prepare_operand(const Operand& operand, Index number, const BuildOptions& options,
                           const Progress& progress) try {
  return prepare(operand, number, options, progress);
} catch (const Error& error) {
  if (error.code() == ErrorCode::kAborted) throw;
  throw Error(error.code(), compose("operand {}: {}", number, error.what()));
}

}  // namespace kdm
