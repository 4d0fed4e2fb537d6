// SPDX-License-Identifier: MIT
// A tree of boxes over triangles that come and go: a complete binary tree over leaves of four
// triangles each, in the order of a space-filling curve. `BoxTree` of room `mesh` is for boxes that
// stay what they are.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "mesh/numbers.h"
#include "mesh/small_box.h"

namespace kdm {

/// The tree. It keeps a box for each triangle.
class TriangleTree {
 public:
  TriangleTree() = default;
  /// `boxes` has a box for each triangle; empty ones take no part.
  explicit TriangleTree(std::vector<SmallBox> boxes);

  /// Calls `test(t)` for triangles whose boxes meet the box until it returns true, and returns
  /// whether it did. Begins beside the triangle `hint` (kNone: anywhere), which makes it quick if
  /// that one is near.
  template <typename Test>
  bool any_meeting(const SmallBox& box, TriangleId hint, const Test& test) const {
    if (nodes_.empty()) return false;
    Index node = first_node(hint);
    if (any_below(node, box, test)) return true;
    for (; node > 1; node /= 2) {
      if (any_below(node ^ 1, box, test)) return true;
    }
    return false;
  }

  /// Returns the triangle that is nearest to the point, of those whose squared distance is at most
  /// `bound`; kNone if there is none. `squared_distance(t)` returns a triangle's. The search ends
  /// with the first triangle that is no further than `enough`. It begins beside the triangle `hint`
  /// (kNone: anywhere), which makes it quick if that one is near; of triangles that are equally
  /// near, the answer depends on the hint.
  template <typename Distance>
  TriangleId nearest(const Vec3& p, double bound, double enough, TriangleId hint,
                     const Distance& squared_distance) const {
    Nearest<Distance> search{p, bound, enough, kNone, squared_distance};
    if (nodes_.empty()) return kNone;
    Index node = first_node(hint);
    if (nodes_[node].squared_distance(p) <= bound) look_below(node, search);
    for (; node > 1 && !search.done(); node /= 2) {
      if (nodes_[node ^ 1].squared_distance(p) <= search.bound) look_below(node ^ 1, search);
    }
    return search.best;
  }

  /// Gives a triangle another box; `SmallBox{}` takes it out.
  void change(TriangleId t, const SmallBox& box);
  /// Builds the tree anew, without the triangles that were taken out.
  void rebuild() { *this = TriangleTree(std::move(boxes_)); }

  const SmallBox& box(TriangleId t) const { return boxes_[t]; }

 private:
  static constexpr Index kLeafSize = 4;

  // The state of a search for what is nearest.
  template <typename Distance>
  struct Nearest {
    const Vec3& p;
    double bound;
    double enough;
    TriangleId best;
    const Distance& squared_distance;

    bool done() const { return best != kNone && bound <= enough; }
  };

  // Returns the leaf of a triangle, or the root.
  Index first_node(TriangleId hint) const {
    return hint == kNone || place_[hint] == kNone ? 1 : leaves_ + place_[hint] / kLeafSize;
  }

  template <typename Test>
  bool any_below(Index top, const SmallBox& box, const Test& test) const {
    if (!nodes_[top].meets(box)) return false;
    std::array<Index, 64> stack;
    int size = 0;
    stack[size++] = top;
    while (size > 0) {
      const Index node = stack[--size];
      if (node < leaves_) {
        if (nodes_[2 * node + 1].meets(box)) stack[size++] = 2 * node + 1;
        if (nodes_[2 * node].meets(box)) stack[size++] = 2 * node;
        continue;
      }
      const std::size_t first = std::size_t{node - leaves_} * kLeafSize;
      for (std::size_t i = first; i < first + kLeafSize; ++i) {
        const TriangleId t = order_[i];
        if (t == kNone) break;
        if (boxes_[t].meets(box) && test(t)) return true;
      }
    }
    return false;
  }

  template <typename Distance>
  void look_below(Index top, Nearest<Distance>& search) const {
    std::array<Index, 64> stack;
    std::array<double, 64> distance;
    int size = 0;
    for (Index node = top;;) {
      while (node < leaves_) {
        Index near = 2 * node;
        Index far = near + 1;
        double to_near = nodes_[near].squared_distance(search.p);
        double to_far = nodes_[far].squared_distance(search.p);
        if (to_far < to_near) {
          std::swap(near, far);
          std::swap(to_near, to_far);
        }
        if (to_far <= search.bound) {
          distance[size] = to_far;
          stack[size++] = far;
        }
        if (to_near > search.bound) break;
        node = near;
      }
      if (node >= leaves_) look_at_leaf(node - leaves_, search);
      if (search.done()) return;
      do {
        if (size == 0) return;
        node = stack[--size];
      } while (distance[size] > search.bound);
    }
  }

  template <typename Distance>
  void look_at_leaf(Index leaf, Nearest<Distance>& search) const {
    for (Index i = leaf * kLeafSize; i < (leaf + 1) * kLeafSize; ++i) {
      const TriangleId t = order_[i];
      if (t == kNone) return;
      if (boxes_[t].squared_distance(search.p) > search.bound) continue;
      const double distance = search.squared_distance(t);
      if (distance > search.bound || (distance == search.bound && search.best != kNone)) continue;
      search.bound = distance;
      search.best = t;
      if (search.done()) return;
    }
  }

  SmallBox leaf_box(Index leaf) const;

  Index leaves_ = 0;               // a power of two; node i has the children 2i and 2i + 1
  std::vector<SmallBox> nodes_;    // from 1 on, the leaves last
  std::vector<TriangleId> order_;  // four a leaf, kNone for none
  std::vector<Index> place_;       // per triangle: where it stands in order_
  std::vector<SmallBox> boxes_;    // per triangle
};

}  // namespace kdm
