// SPDX-License-Identifier: MIT
// Pairs of triangles that cross or touch, and triangles without area, kept while a mesh changes.
#pragma once

#include "extract/embed/envelope.h"

namespace kdm {

/// Only suspects, triangles of hits that leave their envelopes, are held against others: against
/// those of the hits and the suspects in the leaves that their boxes meet.
class Clashes {
 public:
  Clashes(const GridView& view, const DualMesh& loops, const EditLog& log);

  /// Finds all of a mesh, whose vertices are rounded to 32 bits.
  void find(const DualMesh& mesh);
  /// The same after the triangles of these hits were changed.
  void find_again(const DualMesh& mesh, const std::vector<Index>& hits);

  /// The triangles concerned; ascending.
  std::vector<Index> triangles() const;
  std::uint64_t pairs() const { return pairs_.size(); }

 private:
  using Corners = std::array<Vec3, 3>;
  enum : char { kUnknown, kNo, kYes };
  struct Entry {
    Index suspect;
    Index next;
  };

  std::vector<Index> with_neighbours(const std::vector<Index>& hits);
  std::vector<Index> crowded_leaves(const std::vector<Index>& hits) const;
  void forget(const DualMesh& mesh);
  void place(const DualMesh& mesh, Index triangle);
  void look_round(const DualMesh& mesh, Index suspect);
  Index cell_round(Index leaf, const Vec3& lo, const Vec3& hi) const;
  void look_for_suspects(const DualMesh& mesh, Index triangle);
  bool spread(const DualMesh& mesh, Index v);
  Index enclosed_in(Index leaf);
  void test(const DualMesh& mesh, Index t, Index other);
  Corners corners(const DualMesh& mesh, Index t) const;
  bool without_area(const DualMesh& mesh, Index t) const;

  GridView view_;
  const DualMesh& loops_;
  Envelopes envelopes_;
  HitTriangles triangles_;
  bool sure_;                   // envelopes count
  double scale_;                // makes the largest coordinate about one
  std::vector<Vec3> places_;    // per vertex: as it is handed out, times the scale
  std::vector<char> enclosed_;  // per hit: its triangles keep to their envelope
  std::vector<char> changed_;   // per hit, while looking again
  std::vector<char> spread_;    // per vertex: what `spread` found
  std::vector<char> suspect_;   // per triangle
  std::vector<Index> seen_;     // per triangle: the last one it was held against
  std::vector<Index> parent_;   // per cell but the root
  std::vector<Index> first_;    // per leaf: of a list of suspects, some of which are none any more
  std::vector<Entry> entries_;
  std::vector<Index> pool_;        // of `enclosed_in`
  std::vector<Index> pool_begin_;  // per leaf
  std::vector<std::pair<Index, Index>> pairs_;
  std::vector<Index> flat_;  // without area
};

}  // namespace kdm
