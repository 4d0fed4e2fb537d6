// SPDX-License-Identifier: MIT
// Keeps a record of the pairs of triangles that cross or touch, and of the triangles without area,
// while a mesh changes.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "extract/embed/leaf_tree.h"
#include "extract/embed/leaf_triangles.h"
#include "extract/embed/pair_test.h"
#include "extract/embed/remade_triangles.h"
#include "extract/embed/suspects.h"

namespace kdm {

/// Finds and keeps all pairs of triangles of a mesh that cross or touch where they share nothing.
/// Tests only pairs with a suspect (suspects.h), and of these only pairs that may lie in one leaf.
class CrossingPairs {
 public:
  /// `loops` is the mesh with one triangle for each hit from which the mesh was made; its
  /// `next_loop_in_leaf` must be filled. `log` says what was done since to make the mesh. Both must
  /// outlive this object.
  CrossingPairs(const GridView& view, const DualMesh& loops, const EditLog& log);

  /// Finds all pairs of the mesh. Its vertices must be rounded to what 32 bits hold in model units.
  /// To be called once, before `update`.
  void find(const DualMesh& mesh);
  /// Brings the record up to date after the triangles of these hits, and no others, have changed:
  /// the result is the same as that of `find`. Tests pairs only of hits whose triangles have other
  /// corners than before, or that are enclosed where they were not. Takes time for these and their
  /// surroundings, and for quick passes over all triangles.
  void update(const DualMesh& mesh, const std::vector<HitId>& hits);

  /// Lists the triangles of all pairs and those without area; ascending.
  std::vector<TriangleId> triangles() const;
  /// Lists the pairs of triangles that cross or touch, in no particular order.
  std::span<const std::pair<TriangleId, TriangleId>> pairs() const { return pairs_; }
  /// Counts the triangles without area.
  std::size_t flat() const { return flat_triangles_.size(); }

 private:
  // A triangle that has changed, and the leaves in which it may lie.
  struct Changed {
    TriangleId triangle;
    bool is_suspect;
    std::size_t first_leaf;  // in `leaves_`; its leaves end where those of the next one begin
  };
  // What one thread remembers while it tests.
  struct Tester {
    std::vector<TriangleId> last_tested_with;  // per triangle
    TestedFans fans;
  };
  using Pairs = std::vector<std::pair<TriangleId, TriangleId>>;

  void find_changed(const DualMesh& mesh, const std::vector<HitId>& updated);
  void renumber(const DualMesh& mesh);
  void collect(const DualMesh& mesh);
  void collect_suspect(const DualMesh& mesh, TriangleId t);
  void collect_enclosed(HitId hit);
  void test_all(const DualMesh& mesh);
  void test(const DualMesh& mesh, Index number, Tester& tester, Pairs& found) const;

  const DualMesh& loops_;
  Suspects suspects_;
  RemadeTriangles remade_;
  Marks was_enclosed_;          // per hit: as of the last update
  Marks is_changed_;            // per hit: it is one of `changed_`
  std::vector<HitId> changed_;  // in the last update, ascending
  LeafTree leaf_tree_;
  LeafTriangles leaf_triangles_;
  PairTest pair_test_;
  std::vector<Changed> changed_triangles_;  // in the last update
  std::vector<CellId> leaves_;              // of one changed triangle after another
  std::vector<Index> changed_number_;       // per triangle: in `changed_triangles_`, or kNone
  Pairs pairs_;
  std::vector<TriangleId> flat_triangles_;  // without area
};

}  // namespace kdm
