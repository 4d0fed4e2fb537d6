// SPDX-License-Identifier: MIT
// Eigenvalues, eigenvectors and inverses of symmetric 3x3 matrices, by + - * / and square roots
// only, so that results are the same on every platform.
#pragma once

#include <Eigen/Core>

#include "kdmanifold/types.h"

namespace kdm {

/// Returns the eigenvalues in falling order. The first and the last are as exact as doubles can be
/// if they differ clearly from the middle one, else to about 1e-8 of the largest.
Vec3 eigenvalues(const Eigen::Matrix3d& symmetric);

/// Returns a unit vector for an eigenvalue, which must differ from both others.
Vec3 eigenvector(const Eigen::Matrix3d& symmetric, double eigenvalue);

/// Returns the adjugate: the inverse times the determinant.
Eigen::Matrix3d adjugate(const Eigen::Matrix3d& symmetric);

/// Returns x with Ax = b for a regular matrix A.
Vec3 solve(const Eigen::Matrix3d& symmetric, const Vec3& b);

}  // namespace kdm
