// SPDX-License-Identifier: MIT
// Triangles in a tree of dipoles: seen from afar, those of a node make nearly the winding number
// that one small piece of surface makes (Barill et al. 2018).
#pragma once

#include <array>
#include <span>
#include <vector>

#include "geometry/predicates.h"
#include "mesh/numbers.h"

namespace kdm {

/// A tree over triangles with what each node adds to winding numbers far away from it. Lengths are
/// in lattice units.
class WindingTree {
 public:
  /// The first two terms of the Taylor series, about a centre, of the winding number that some
  /// triangles make.
  struct Dipole {
    Vec3 centre;
    double far;             // the squared distance beyond which the other terms are negligible
    Vec3 area;              // integral of the normal
    Eigen::Matrix3d first;  // integral of normal times offset from the centre
  };
  struct Node {
    Dipole dipole;
    double radius;     // of the ball about the centre that holds its triangles
    Index begin, end;  // its triangles, as places in the tree's order
    Index right;       // node of its right child; the left child follows it; 0: a leaf
  };
  /// A triangle by itself, seen from afar. The first moment about its centroid is zero.
  struct Triangle {
    Vec3 centre;
    double far;
    Vec3 area;
  };

  /// Takes time n log n. The triangles must outlive the tree.
  explicit WindingTree(std::span<const LatticeTriangle> triangles);

  bool empty() const { return nodes_.empty(); }
  const Node& node(Index number) const { return nodes_[number]; }

  /// Visits all triangles of some nodes. Calls add_dipole(dipole, r, squared length of r) for nodes
  /// and add_far(triangle, r, squared length of r) for single triangles that are far from the
  /// point, r leading from the point to their centre, and add_near(triangle) for all others.
  /// Returns how long that took, in triangles close by.
  template <typename AddDipole, typename AddFar, typename AddNear>
  std::size_t visit(const Vec3& p, std::span<const Index> roots, const AddDipole& add_dipole,
                    const AddFar& add_far, const AddNear& add_near) const;

 private:
  Index build(Index begin, Index end);
  void summarise(Node& node) const;

  std::span<const LatticeTriangle> triangles_;
  std::vector<TriangleId> order_;  // each node's triangles are consecutive
  std::vector<Triangle> alone_;    // as in order_
  std::vector<Node> nodes_;
};

template <typename AddDipole, typename AddFar, typename AddNear>
std::size_t WindingTree::visit(const Vec3& p, std::span<const Index> roots,
                               const AddDipole& add_dipole, const AddFar& add_far,
                               const AddNear& add_near) const {
  std::size_t far = 0;
  std::size_t near = 0;
  const auto look_at_leaf = [&](const Node& node) {
    for (Index i = node.begin; i < node.end; ++i) {
      const Triangle& triangle = alone_[i];
      const Vec3 r = triangle.centre - p;
      const double square = r.squaredNorm();
      if (square > triangle.far) {
        add_far(triangle, r, square);
        ++far;
      } else {
        add_near(triangles_[order_[i]]);
        ++near;
      }
    }
  };
  std::array<Index, 64> stack;
  for (const Index root : roots) {
    int open = 0;
    stack[open++] = root;
    while (open > 0) {
      const Index number = stack[--open];
      const Node& node = nodes_[number];
      const Vec3 r = node.dipole.centre - p;
      const double square = r.squaredNorm();
      if (square > node.dipole.far) {
        add_dipole(node.dipole, r, square);
        ++far;
      } else if (node.right == 0) {
        look_at_leaf(node);
      } else {
        stack[open++] = node.right;
        stack[open++] = number + 1;
      }
    }
  }
  constexpr std::size_t kFarPerNear = 4;  // take the same time
  return near + far / kFarPerNear + 1;
}

}  // namespace kdm
