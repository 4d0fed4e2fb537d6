// SPDX-License-Identifier: MIT
// Finds short closed walks along the edges of a mesh that do not divide its surface: round a handle
// or through a tunnel.
//
// A closed walk divides the surface, or bounds a piece of it, iff its class in the homology of the
// surface is zero. Classes are sums of basis elements, two a handle. A spanning tree of the
// vertices and one of the faces that crosses no edge of the first leave out two edges a handle
// (J. Erickson and K. Whittlesey, Greedy Optimal Homotopy and Homology Generators, 2005). Each gets
// a number of 64 bits, as if drawn at random, and sums are exclusive ors of these: what is not zero
// belongs to a walk that divides nothing, for sure; the reverse fails once in 2^64 cases.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/groups.h"
#include "mesh/marks.h"
#include "mesh/numbers.h"

namespace kdm {

/// Returns the i-th of a row of numbers without any pattern (splitmix64 of G. Steele et al., Fast
/// Splittable Pseudorandom Number Generators, 2014).
constexpr std::uint64_t mixed_bits(std::uint64_t i) {
  std::uint64_t z = (i + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

/// A set of kinds of walks with all their sums, of which it holds independent ones.
class KindSpan {
 public:
  /// Adds a kind. Returns false if it was a sum of those before.
  bool add(std::uint64_t kind) {
    kind = rest(kind);
    if (kind != 0) basis_.push_back(kind);
    return kind != 0;
  }
  bool contains(std::uint64_t kind) const { return rest(kind) == 0; }
  std::size_t size() const { return basis_.size(); }

 private:
  // What is left of a kind without the highest bits of the basis: each element, added after the
  // ones before were taken off, has none of theirs.
  std::uint64_t rest(std::uint64_t kind) const {
    for (const std::uint64_t element : basis_) kind = std::min(kind, kind ^ element);
    return kind;
  }

  std::vector<std::uint64_t> basis_;
};

/// A closed walk along edges that passes no vertex twice.
struct ShortLoop {
  std::vector<VertexId> vertices;
  double length = 0;
  std::uint64_t kind = 0;  ///< sum of the basis elements that it is made of; not 0
};

/// Finds short loops of a mesh, which must be closed, oriented and 2-manifold.
class ShortLoops {
 public:
  /// `positions` and `triangles` must outlive this. Takes linear time.
  ShortLoops(const std::vector<Vec3>& positions, std::span<const Triangle> triangles);

  /// Returns how many handles the mesh has.
  Index handles() const { return handles_; }

  /// Returns loops that divide nothing and are shorter than `below`, one or a few at each place
  /// that has such, narrowed down. There is none left iff it returns none. Loops of the kinds in
  /// `passed_over` do not count.
  std::vector<ShortLoop> find(double below, const KindSpan& passed_over);

  /// Tells whether the last call of `find` would look further if `below` were larger.
  bool limited() const { return limited_; }

  /// Returns the side of the triangle along the edge in the other direction.
  SideId opposite(SideId side) const { return opposite_[side]; }
  /// Returns the sides that start from a vertex.
  std::span<const SideId> sides_from(VertexId v) const { return sides_.of(v); }
  VertexId start(SideId side) const;
  VertexId end(SideId side) const;

 private:
  // A walk from the source of a search to itself: along the tree of shortest paths, through a side,
  // and back.
  struct Found {
    double length = 0;
    SideId side = kNone;
    bool limited = false;  // a larger radius would reach more
  };

  void find_basis();
  void grow_vertex_trees(Marks& tree) const;
  std::vector<SideId> grow_face_trees(Marks& tree) const;
  Found search(VertexId source, double radius, const KindSpan& passed_over);
  void look_across(VertexId v, const KindSpan& passed_over, Found& best) const;
  ShortLoop loop_through(const Found& found) const;
  ShortLoop narrowed(ShortLoop loop, const KindSpan& passed_over);
  double length(SideId side) const;
  std::uint64_t kind_across(SideId side) const;

  const std::vector<Vec3>& positions_;
  std::span<const Triangle> triangles_;
  std::vector<SideId> opposite_;
  Groups sides_;                     // per vertex: the sides that start there
  std::vector<std::uint64_t> kind_;  // per side: its part of a walk's kind
  Index handles_ = 0;
  bool limited_ = false;

  // Of the last search.
  Marks settled_;
  std::vector<VertexId> order_;          // the settled vertices, near ones first
  std::vector<VertexId> reached_;        // settled or not
  std::vector<double> distance_;         // per vertex, from the source
  std::vector<SideId> way_;              // per vertex: the side through which it was reached
  std::vector<std::uint64_t> way_kind_;  // per vertex: sum along the way
};

}  // namespace kdm
