// SPDX-License-Identifier: MIT
// Finds crossing pairs, in all of a mesh or where it has changed.
#include "extract/embed/crossing_pairs.h"

#include <numeric>

#include "extract/dual/clearance.h"
#include "mesh/sort.h"

namespace kdm {

CrossingPairs::CrossingPairs(const GridView& view, const DualMesh& loops, const EditLog& log)
    : loops_(loops),
      suspects_(view, loops, log),
      remade_(loops.triangles()),
      was_enclosed_(loops.triangles()),
      is_changed_(loops.triangles()),
      leaf_tree_(view),
      leaf_triangles_(static_cast<Index>(view.grid.cells.size())),
      pair_test_(view) {}

void CrossingPairs::find(const DualMesh& mesh) {
  std::vector<HitId> all_hits(loops_.triangles());
  std::iota(all_hits.begin(), all_hits.end(), HitId{0});
  update(mesh, all_hits);
}

void CrossingPairs::update(const DualMesh& mesh, const std::vector<HitId>& hits) {
  const std::vector<HitId>& updated = suspects_.update(mesh, hits);
  find_changed(mesh, updated);
  renumber(mesh);
  pair_test_.update(mesh);
  for (const HitId hit : updated) {
    suspects_.for_each_triangle(hit, [&](TriangleId t) { pair_test_.read_corners(mesh, t); });
  }
  // Pairs of an enclosed triangle and a suspect are found from the suspect, if it has changed, and
  // otherwise from the enclosed triangle.
  const bool had_suspects = leaf_triangles_.any_noted();
  for (const HitId hit : changed_) {
    const bool enclosed = suspects_.is_enclosed(hit);
    if (enclosed && !had_suspects) continue;
    suspects_.for_each_triangle(hit, [&](TriangleId t) {
      if (enclosed) {
        test_against_suspects(mesh, t);
      } else {
        if (pair_test_.has_no_area(mesh, t)) flat_triangles_.push_back(t);
        test_around(mesh, t);
      }
    });
  }
}

std::vector<TriangleId> CrossingPairs::triangles() const {
  std::vector<TriangleId> triangles = flat_triangles_;
  for (const auto& [t, other] : pairs_) triangles.insert(triangles.end(), {t, other});
  make_set(triangles);
  return triangles;
}

// Finds the hits whose pairs may be others than before. What two triangles have in common depends
// on nothing but their corners, and whether a pair is tested on whether the hits are enclosed.
void CrossingPairs::find_changed(const DualMesh& mesh, const std::vector<HitId>& updated) {
  remade_.compare(mesh, suspects_.triangles(), updated);
  for (const HitId hit : changed_) is_changed_.clear(hit);
  changed_.clear();
  for (const HitId hit : updated) {
    const bool enclosed = suspects_.is_enclosed(hit);
    if (remade_.as_before(hit) && was_enclosed_.test(hit) == enclosed) continue;
    was_enclosed_.set(hit, enclosed);
    is_changed_.set(hit);
    changed_.push_back(hit);
  }
}

// Forgets all about triangles of hits that have changed, and gives the others the numbers that they
// have now.
void CrossingPairs::renumber(const DualMesh& mesh) {
  const auto now = [&](TriangleId before) {
    const TriangleId t = remade_.now(before);
    return t == kNone || is_changed_.test(mesh.hit[t]) ? kNone : t;
  };
  for (auto& [t, other] : pairs_) {
    t = now(t);
    other = now(other);
  }
  std::erase_if(pairs_,
                [](const auto& pair) { return pair.first == kNone || pair.second == kNone; });
  for (TriangleId& t : flat_triangles_) t = now(t);
  std::erase(flat_triangles_, kNone);
  leaf_triangles_.renumber(mesh.triangles(), now);
  last_tested_with_.assign(mesh.triangles(), kNone);
}

// Tests a new suspect against all triangles that may lie in the leaves which its box meets, and
// notes it in them.
void CrossingPairs::test_around(const DualMesh& mesh, TriangleId suspect) {
  Vec3 lo = mesh.position[mesh.vertex[3 * suspect]];
  Vec3 hi = lo;
  for (Index i = 1; i < 3; ++i) {
    const Vec3& p = mesh.position[mesh.vertex[3 * suspect + i]];
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  lo -= Vec3::Constant(kClear);
  hi += Vec3::Constant(kClear);
  const CachedTriangle cached = pair_test_.cached(mesh, suspect);
  const auto test_with = [&](TriangleId t) {
    if (last_tested_with_[t] == suspect) return;
    last_tested_with_[t] = suspect;
    if (pair_test_.meet(mesh, cached, t)) pairs_.emplace_back(suspect, t);
  };
  const CellId near = loops_.leaf[loops_.vertex[3 * mesh.hit[suspect]]];
  leaf_tree_.for_each_leaf(near, lo, hi, [&](CellId leaf) {
    for (const TriangleId t : leaf_triangles_.enclosed(leaf, suspects_)) test_with(t);
    leaf_triangles_.for_each_suspect(leaf, test_with);
    leaf_triangles_.note(leaf, suspect);
  });
  leaf_triangles_.mark_suspect(suspect);
}

// Tests a changed triangle of an enclosed hit against the suspects that have not changed and may
// lie in leaves of the hit's envelope.
void CrossingPairs::test_against_suspects(const DualMesh& mesh, TriangleId enclosed) {
  const HitId hit = mesh.hit[enclosed];
  const CachedTriangle cached = pair_test_.cached(mesh, enclosed);
  const auto test_in = [&](CellId leaf) {
    leaf_triangles_.for_each_suspect(leaf, [&](TriangleId t) {
      if (is_changed_.test(mesh.hit[t]) || last_tested_with_[t] == enclosed) return;
      last_tested_with_[t] = enclosed;
      if (pair_test_.meet(mesh, cached, t)) pairs_.emplace_back(t, enclosed);
    });
  };
  for (Index i = 0; i < 3; ++i) {
    test_in(loops_.leaf[loops_.vertex[3 * hit + i]]);
    if ((loops_.strip[hit] >> i & 1) == 0) continue;
    // Two hits across a strip share four leaves; the fourth is beyond it.
    const HalfEdgeId across = loops_.opposite[3 * hit + i];
    test_in(loops_.leaf[loops_.vertex[previous_in_triangle(across)]]);
  }
}

}  // namespace kdm
