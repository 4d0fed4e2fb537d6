// SPDX-License-Identifier: MIT
// Winding numbers of points that lie close together: what all of them see from afar is summed once,
// as a series about the centre of a box that holds them (Greengard, Rokhlin 1987).
#pragma once

#include <array>
#include <vector>

#include "inside/winding_tree.h"

namespace kdm {

/// An octree of boxes over the lattice. It is made where it is asked for; what a box holds does not
/// depend on which boxes were asked for before.
class WindingBoxes {
 public:
  struct Box {
    Vec3 centre;
    double half;  // of its width
    // The Taylor series of what the nodes far from the box make, about its centre.
    double value = 0;
    Vec3 gradient = Vec3::Zero();
    Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();  // second derivatives
    std::vector<Index> near{};                       // all other nodes of the tree
    bool last = false;                               // it is not halved
    std::array<Index, 8> children{};                 // 0: not made yet

    double value_at(const Vec3& p) const;
    Vec3 gradient_at(const Vec3& p) const { return gradient + bend * (p - centre); }
  };

  /// No box will be narrower than `least_width`, in lattice units. The tree must outlive the boxes.
  WindingBoxes(const WindingTree& tree, double least_width);

  /// Returns the smallest box that holds the point: one so narrow, or with so few triangles near,
  /// that halving it saves no time. Valid until the next call.
  const Box& at(const Vec3& p);

 private:
  Index make_child(Index parent, std::size_t octant);
  void take(Index node, Box& box) const;
  bool is_last(const Box& box) const;

  const WindingTree& tree_;
  double least_width_;
  std::vector<Box> boxes_;
};

}  // namespace kdm
