// SPDX-License-Identifier: MIT
// A tree of boxes over triangles that come and go: four children to a node, in the order of a
// space-filling curve. `BoxTree` of room `mesh` is for boxes that stay what they are.
#pragma once

#include <array>
#include <bit>
#include <limits>
#include <utility>
#include <vector>

#include "mesh/four_boxes.h"
#include "mesh/numbers.h"

namespace kdm {

/// The tree. It keeps a box for each triangle.
class TriangleTree {
 public:
  TriangleTree() = default;
  /// `boxes` has a box for each triangle; empty ones take no part.
  explicit TriangleTree(const std::vector<SmallBox>& boxes);

  /// Calls `test(t)` for triangles whose boxes meet the box until it returns true, and returns
  /// whether it did. Begins beside the triangle `hint` (kNone: anywhere), which makes it quick if
  /// that one is near.
  template <typename Test>
  bool any_meeting(const SmallBox& box, TriangleId hint, const Test& test) const {
    if (nodes_.empty()) return false;
    const FourBoxes::Same same(box);
    Place at = first_place(hint);
    if (any_below(at, node(at).meeting(same), same, test)) return true;
    while (!is_root(at)) {
      const unsigned behind = 1u << at.number % kChildren;
      at = parent(at);
      if (any_below(at, node(at).meeting(same) & ~behind, same, test)) return true;
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
    if (nodes_.empty()) return kNone;
    Nearest<Distance> search{FourBoxes::Same(small_box(p, 0)), bound, enough, kNone,
                             squared_distance};
    Place at = first_place(hint);
    look_below(at, kNone, search);
    while (!is_root(at) && !search.done()) {
      const Index behind = at.number % kChildren;
      at = parent(at);
      look_below(at, behind, search);
    }
    return search.best;
  }

  /// Gives a triangle another box; `SmallBox{}` takes it out.
  void change(TriangleId t, const SmallBox& box);
  /// Builds the tree anew, without the triangles that were taken out.
  void rebuild();

  SmallBox box(TriangleId t) const {
    const Index place = place_[t];
    return place == kNone ? SmallBox{} : nodes_[place / kChildren][child_of(place)];
  }

 private:
  static constexpr Index kChildren = 4;
  static constexpr std::size_t kMostLevels = 16;
  static constexpr std::size_t kMostWaiting = kMostLevels * kChildren;

  static constexpr float kNowhere = std::numeric_limits<float>::infinity();  // of empty boxes
  static constexpr double kSurely = 1 - 1e-6;  // makes up for rounding

  // Where a node is. Level 0 has the boxes of triangles, the last level is the root.
  struct Place {
    Index level;
    Index number;  // within the level
  };

  // The state of a search for what is nearest.
  template <typename Distance>
  struct Nearest {
    FourBoxes::Same point;
    double bound;
    double enough;
    TriangleId best;
    const Distance& squared_distance;

    bool done() const { return best != kNone && bound <= enough; }
    // Tells whether something may be near enough in a box at a squared distance that is rounded.
    bool reaches(float gap) const { return gap < kNowhere && kSurely * gap <= bound; }
  };

  static int child_of(Index number) { return static_cast<int>(number % kChildren); }
  static Place parent(const Place& at) { return {at.level + 1, at.number / kChildren}; }
  bool is_root(const Place& at) const { return at.level + 1 == levels_.size(); }
  const FourBoxes& node(const Place& at) const { return nodes_[levels_[at.level] + at.number]; }
  // Returns the node with the triangle's box, or the root.
  Place first_place(TriangleId hint) const {
    if (hint == kNone || place_[hint] == kNone) return {static_cast<Index>(levels_.size() - 1), 0};
    return {0, place_[hint] / kChildren};
  }

  // Looks at some children of a node.
  template <typename Test>
  bool any_below(Place at, FourBoxes::Bits children, const FourBoxes::Same& box,
                 const Test& test) const {
    std::array<Place, kMostWaiting> waiting;
    std::size_t size = 0;
    while (true) {
      for (; children != 0; children &= children - 1) {
        const Index number = kChildren * at.number + static_cast<Index>(std::countr_zero(children));
        if (at.level > 0) {
          waiting[size++] = {at.level - 1, number};
        } else if (test(order_[number])) {
          return true;
        }
      }
      if (size == 0) return false;
      at = waiting[--size];
      children = node(at).meeting(box);
    }
  }

  // Looks at the children of a node but for one (kNone: at all).
  template <typename Distance>
  void look_below(Place at, Index behind, Nearest<Distance>& search) const {
    std::array<Place, kMostWaiting> waiting;
    std::array<float, kMostWaiting> gap;
    std::size_t size = 0;
    while (true) {
      const std::array<float, kChildren> gaps = node(at).squared_gaps(search.point);
      const std::size_t before = size;
      for (Index child = 0; child < kChildren; ++child) {
        if (child == behind || !search.reaches(gaps[child])) continue;
        const Index number = kChildren * at.number + child;
        if (at.level == 0) {
          look_at(order_[number], search);
          if (search.done()) return;
          continue;
        }
        // The nearest is looked at first.
        std::size_t i = size++;
        for (; i > before && gap[i - 1] < gaps[child]; --i) {
          gap[i] = gap[i - 1];
          waiting[i] = waiting[i - 1];
        }
        gap[i] = gaps[child];
        waiting[i] = {at.level - 1, number};
      }
      behind = kNone;
      do {
        if (size == 0) return;
        at = waiting[--size];
      } while (!search.reaches(gap[size]));
    }
  }

  template <typename Distance>
  void look_at(TriangleId t, Nearest<Distance>& search) const {
    const double distance = search.squared_distance(t);
    if (distance > search.bound || (distance == search.bound && search.best != kNone)) return;
    search.bound = distance;
    search.best = t;
  }

  std::vector<FourBoxes> nodes_;   // level after level
  std::vector<Index> levels_;      // per level: its first node
  std::vector<TriangleId> order_;  // four a node of level 0
  std::vector<Index> place_;       // per triangle: where it stands in order_; kNone: nowhere
};

}  // namespace kdm
