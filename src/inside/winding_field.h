// SPDX-License-Identifier: MIT
// The generalised winding number of triangles, whether they form a closed surface or not (Jacobson
// et al. 2013): the fraction of its surroundings in which a point sees triangles from behind, minus
// the fraction in which it sees them from the front. Summed over a tree (Barill et al. 2018).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "inside/point_field.h"
#include "mesh/numbers.h"

namespace kdm {

/// Winding numbers of points, and which of them are inside. Near a closed surface the number is 0
/// outside and 1 inside; at a hole it passes smoothly from one to the other. Points are in lattice
/// units.
class WindingField final : public PointField {
 public:
  /// Builds the tree, in time n log n. Points with a winding number above `threshold` will be
  /// inside; 0 stands for a threshold that suits the triangles (see choose_winding_threshold). The
  /// triangles must outlive the field.
  WindingField(std::span<const LatticeTriangle> triangles, double threshold);

  double threshold() const override { return threshold_; }

  /// Returns the winding number of a point, exact to about 0.01.
  double winding(const Vec3& p) const;

  /// Returns whether the winding number is above the threshold. A rough sum is taken first, and a
  /// finer one only if the threshold lies within the error of the rough one. If the winding number
  /// is within about 0.01 of the threshold, the answer may be wrong. That happens at holes only:
  /// beside a triangle, winding numbers are about one half away from the threshold.
  bool inside(const Vec3& p) const override;
  /// On which side of each triangle the vertex lies is decided exactly.
  bool inside(const LatticePoint& p) const override;
  /// Returns the gradient of the winding number, per lattice unit. It points towards the inside.
  /// The triangles close to the point count exactly, those far away as in the finer sum.
  Vec3 gradient(const Vec3& p) const override;

  /// Returns how much was summed so far, in triangles. Four tree nodes seen from afar count as one
  /// triangle: they take as long.
  std::size_t work() const override { return work_; }

 private:
  static constexpr int kLevels = 2;  // of accuracy: 0 rough, 1 fine

  // Some neighbouring triangles. Far away, the winding number that they make is nearly given by the
  // first two terms of its Taylor series about the centre.
  struct Node {
    Vec3 centre;
    // Per level the squared distance beyond which the other terms are negligible.
    std::array<double, kLevels> far;
    Vec3 area;              // integral of the normal
    Eigen::Matrix3d first;  // integral of normal times offset from the centre
    Index begin, end;       // its triangles, as places in order_
    Index right;            // node of its right child; the left child follows it; 0: a leaf
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
  std::vector<TriangleId> order_;  // each node's triangles are consecutive
  std::vector<Node> nodes_;
  mutable std::size_t work_ = 0;
};

/// Chooses the threshold above which winding numbers are to be inside: one of 0.5, 0.45, ..., 0.1.
/// A threshold keeps a point of a triangle if the winding number is above it behind the triangle
/// and not above it in front. Returns the highest threshold that keeps as much of the triangles'
/// area as the best one does, up to a hundredth of the whole area. Thresholds above 0.5 are no
/// candidates: they would keep more of what lies inside a body, and open the body instead. Looks at
/// 1024 points, spread evenly; the result depends on nothing but the triangles.
double choose_winding_threshold(const WindingField& field,
                                std::span<const LatticeTriangle> triangles);

}  // namespace kdm
