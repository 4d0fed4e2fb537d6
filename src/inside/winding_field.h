// SPDX-License-Identifier: MIT
// The generalised winding number of any triangles, closed or not (Jacobson et al. 2013), by a tree
// (Barill et al. 2018): how much of its surroundings a point sees from behind.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/lattice.h"

namespace kdm {

/// 0 outside and 1 inside of a closed surface; at a hole it passes smoothly from one to the other.
class WindingField {
 public:
  /// Winding numbers above `threshold` are inside; 0 stands for one that suits the triangles, see
  /// choose_winding_threshold. These must live on.
  WindingField(std::span<const LatticeTriangle> triangles, double threshold);

  double threshold() const { return threshold_; }

  /// By the finer sum.
  double winding(const Vec3& p) const;

  /// By as rough a sum as is sure enough; within about 0.01 of the threshold by the finer one, sure
  /// or not. No more is needed: near a surface that is there, winding numbers are one half away.
  bool inside(const Vec3& p) const;
  /// The same for a grid vertex, read as shifted by (e, e^2, e^3) as in geometry/predicates.h: on
  /// which side of each triangle it lies is exact.
  bool inside(const LatticePoint& p) const;
  /// Towards the inside; of what is near exactly, of what is far as the finer sum has it.
  Vec3 gradient(const Vec3& p) const;

  /// Terms summed so far, in triangles or what takes as long.
  std::size_t work() const { return work_; }

 private:
  static constexpr int kLevels = 2;  // of accuracy

  // The triangles below it, as seen from afar: the first two terms of the Taylor series of the
  // dipole layer's potential about the centre.
  struct Node {
    Vec3 centre;
    // Squared distance from which on the rest of the series is below each level's bound.
    std::array<double, kLevels> far;
    Vec3 area;              // integral of the normal
    Eigen::Matrix3d first;  // integral of normal times offset from the centre
    Index begin, end;       // in order_
    Index right;            // the left child follows its parent; 0: a leaf
  };
  struct Value {
    double winding = 0;
    double error = 0;
  };

  Index build(Index begin, Index end, std::vector<Vec3>& centroids);
  void summarise(Node& node) const;
  template <typename AddNode, typename AddTriangle>
  void traverse(const Vec3& p, int level, const AddNode& add_node,
                const AddTriangle& add_triangle) const;
  template <typename AddTriangle>
  Value evaluate(const Vec3& p, int level, const AddTriangle& add_triangle) const;
  template <typename AddTriangle>
  bool decide(const Vec3& p, const AddTriangle& add_triangle) const;

  std::span<const LatticeTriangle> triangles_;
  double threshold_;
  std::vector<Index> order_;
  std::vector<Node> nodes_;
  mutable std::size_t work_ = 0;
};

/// Of the thresholds 0.5, 0.45, ..., 0.1 the highest that keeps, but for a hundredth of the whole
/// area, as much of the triangles' area as any of them does. A face is kept if its winding number
/// is above the threshold behind it and not above it in front. Higher ones are never chosen: they
/// would keep what is inside at the price of opening what holds it.
double choose_winding_threshold(const WindingField& field,
                                std::span<const LatticeTriangle> triangles);

}  // namespace kdm
