// SPDX-License-Identifier: MIT
// Symmetric 3x3 matrices. Uses + - * / and square roots only, so results are the same on every
// platform.
#pragma once

#include <Eigen/Core>

#include "kdmanifold/types.h"

namespace kdm {

/// In falling order: the first as exact as doubles are where it lies apart, so is the last, else to
/// about 1e-8 of the largest.
Vec3 eigenvalues(const Eigen::Matrix3d& symmetric);

/// The unit vector to an eigenvalue that differs from both others.
Vec3 eigenvector(const Eigen::Matrix3d& symmetric, double eigenvalue);

/// The adjugate: the inverse times the determinant.
Eigen::Matrix3d adjugate(const Eigen::Matrix3d& symmetric);

/// x with Ax = b for a regular matrix A.
Vec3 solve(const Eigen::Matrix3d& symmetric, const Vec3& b);

}  // namespace kdm
