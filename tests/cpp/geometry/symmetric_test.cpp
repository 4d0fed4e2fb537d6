// SPDX-License-Identifier: MIT
// Eigenvalues and eigenvectors against Eigen's own solver.
#include "geometry/symmetric.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>

#include "support/random.h"

namespace kdm {
namespace {

using check::Random;

// Values that lie apart to rounding, the others nearly; vectors of values that lie apart.
void expect_eigen_system(const Eigen::Matrix3d& matrix) {
  const Vec3 values = eigenvalues(matrix);
  const Vec3 wanted =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvalues().reverse();
  const double scale = std::max(matrix.norm(), 1e-300);
  for (int k = 0; k < 3; ++k) {
    const double gap = std::min(k > 0 ? wanted[k - 1] - wanted[k] : scale,
                                k < 2 ? wanted[k] - wanted[k + 1] : scale);
    const bool apart = gap > 1e-3 * scale;
    const bool extreme = apart && k != 1;
    EXPECT_NEAR(values[k], wanted[k], (extreme ? 1e-13 : 1e-7) * scale) << matrix;
    if (!extreme) continue;
    const Vec3 v = eigenvector(matrix, values[k]);
    EXPECT_NEAR(v.norm(), 1, 1e-14) << matrix;
    EXPECT_LE((matrix * v - values[k] * v).norm(), 1e-11 * scale) << matrix;
  }
  EXPECT_GE(values[0], values[1]) << matrix;
  EXPECT_GE(values[1], values[2]) << matrix;
}

TEST(Symmetric, EigenvaluesOfRandomMatrices) {
  Random random(1);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::pow(10.0, random.between(-6, 12));
    Eigen::Matrix3d m;
    for (int row = 0; row < 3; ++row) {
      for (int column = row; column < 3; ++column) {
        m(row, column) = m(column, row) = scale * random.between(-1, 1);
      }
    }
    expect_eigen_system(m);
  }
}

TEST(Symmetric, EigenvaluesOfSumsOfFewPlanes) {
  Random random(2);
  for (int i = 0; i < 2000; ++i) {
    Eigen::Matrix3d m = Eigen::Matrix3d::Zero();
    const Vec3 main = random.direction();
    for (std::uint32_t planes = 1 + random.below(4); planes > 0; --planes) {
      // Exactly, nearly and not at all parallel to each other.
      const double spread = std::array<double, 4>{0, 1e-9, 1e-3, 1}[random.below(4)];
      const Vec3 n = (main + spread * random.direction()).normalized();
      m += n * n.transpose();
    }
    expect_eigen_system(m);
  }
}

TEST(Symmetric, EigenvaluesOfDegenerateMatrices) {
  expect_eigen_system(Eigen::Matrix3d::Zero());
  expect_eigen_system(Eigen::Matrix3d::Identity());
  expect_eigen_system(Vec3(1, 2, 3).asDiagonal());
  expect_eigen_system(Vec3(-5, 0, 5).asDiagonal());
  expect_eigen_system(Eigen::Matrix3d::Ones());
  expect_eigen_system(Eigen::Matrix3d::Ones() + 1e-12 * Eigen::Matrix3d::Identity());
  Eigen::Matrix3d twice = Eigen::Matrix3d::Identity();
  twice(0, 1) = twice(1, 0) = 1e-9;
  expect_eigen_system(twice);
}

TEST(Symmetric, SolvesWhatIsRegular) {
  Random random(3);
  for (int i = 0; i < 1000; ++i) {
    Eigen::Matrix3d root;
    for (int k = 0; k < 3; ++k) root.col(k) = random.point(-1, 1);
    const Eigen::Matrix3d m = root * root.transpose() + 0.1 * Eigen::Matrix3d::Identity();
    const Vec3 x = random.point(-10, 10);
    EXPECT_LE((solve(m, m * x) - x).norm(), 1e-11);
    EXPECT_LE((m * adjugate(m) - m.determinant() * Eigen::Matrix3d::Identity()).norm(),
              1e-12 * m.squaredNorm() * m.norm());
  }
}

}  // namespace
}  // namespace kdm
