// SPDX-License-Identifier: MIT
// Finds crossing pairs, in all of a mesh or where it has changed.
#include "extract/embed/crossing_pairs.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "extract/dual/clearance.h"
#include "mesh/sort.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

constexpr std::size_t kTrianglesPerPart = 256;

}  // namespace

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
  collect(mesh);
  test_all(mesh);
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
  leaf_triangles_.renumber(now);
}

// Lists the triangles that have changed with their leaves, and notes the suspects among them there.
// Pairs of an enclosed triangle and a suspect are found from the suspect, if it has changed, and
// otherwise from the enclosed triangle.
void CrossingPairs::collect(const DualMesh& mesh) {
  changed_triangles_.clear();
  leaves_.clear();
  changed_number_.assign(mesh.triangles(), kNone);
  const bool had_suspects = leaf_triangles_.any_noted();
  for (const HitId hit : changed_) {
    const bool enclosed = suspects_.is_enclosed(hit);
    if (enclosed && !had_suspects) continue;
    suspects_.for_each_triangle(hit, [&](TriangleId t) {
      changed_number_[t] = static_cast<Index>(changed_triangles_.size());
      changed_triangles_.push_back({t, !enclosed, leaves_.size()});
      if (enclosed) {
        collect_enclosed(hit);
      } else {
        collect_suspect(mesh, t);
      }
    });
  }
  changed_triangles_.push_back({kNone, false, leaves_.size()});
  for (const CellId leaf : leaves_) leaf_triangles_.prepare(leaf, suspects_);
}

// Notes a suspect in all leaves which its box meets.
void CrossingPairs::collect_suspect(const DualMesh& mesh, TriangleId t) {
  if (pair_test_.has_no_area(mesh, t)) flat_triangles_.push_back(t);
  Vec3 lo = mesh.position[mesh.vertex[3 * t]];
  Vec3 hi = lo;
  for (Index i = 1; i < 3; ++i) {
    const Vec3& p = mesh.position[mesh.vertex[3 * t + i]];
    lo = lo.cwiseMin(p);
    hi = hi.cwiseMax(p);
  }
  lo -= Vec3::Constant(kClear);
  hi += Vec3::Constant(kClear);
  const CellId near = loops_.leaf[loops_.vertex[3 * mesh.hit[t]]];
  leaf_tree_.for_each_leaf(near, lo, hi, [&](CellId leaf) {
    leaves_.push_back(leaf);
    leaf_triangles_.note(leaf, t);
  });
}

// The triangles of an enclosed hit lie in leaves of the hit's envelope.
void CrossingPairs::collect_enclosed(HitId hit) {
  for (Index i = 0; i < 3; ++i) {
    leaves_.push_back(loops_.leaf[loops_.vertex[3 * hit + i]]);
    if ((loops_.strip[hit] >> i & 1) == 0) continue;
    // Two hits across a strip share four leaves; the fourth is beyond it.
    const HalfEdgeId across = loops_.opposite[3 * hit + i];
    leaves_.push_back(loops_.leaf[loops_.vertex[previous_in_triangle(across)]]);
  }
}

// Shares the tests among threads. What they find is put together in the order of the triangles.
void CrossingPairs::test_all(const DualMesh& mesh) {
  const std::size_t count = changed_triangles_.size() - 1;
  const std::size_t parts = (count + kTrianglesPerPart - 1) / kTrianglesPerPart;
  std::vector<Tester> testers(static_cast<std::size_t>(workers()));
  std::vector<Pairs> found(parts);
  share_work(parts, static_cast<int>(testers.size()), [&](std::size_t part, int worker) {
    Tester& tester = testers[static_cast<std::size_t>(worker)];
    if (tester.last_tested_with.empty()) {
      tester.last_tested_with.assign(mesh.triangles(), kNone);
      tester.fans.tested.assign(mesh.vertices());
      tester.fans.simple.assign(mesh.vertices());
    }
    const std::size_t end = std::min(count, (part + 1) * kTrianglesPerPart);
    for (std::size_t i = part * kTrianglesPerPart; i < end; ++i) {
      test(mesh, static_cast<Index>(i), tester, found[part]);
    }
  });
  for (const Pairs& pairs : found) pairs_.insert(pairs_.end(), pairs.begin(), pairs.end());
}

// Tests a changed triangle against all others in its leaves, but for changed suspects that find it
// themselves: an enclosed triangle leaves all of them out, a suspect those that come after it.
void CrossingPairs::test(const DualMesh& mesh, Index number, Tester& tester, Pairs& found) const {
  const Changed& changed = changed_triangles_[number];
  const Index first_left_out = changed.is_suspect ? number : 0;
  const CachedTriangle cached = pair_test_.cached(mesh, changed.triangle);
  const auto test_with = [&](TriangleId t) {
    if (tester.last_tested_with[t] == changed.triangle) return;
    tester.last_tested_with[t] = changed.triangle;
    if (!pair_test_.meet(mesh, cached, t, tester.fans)) return;
    found.emplace_back(changed.triangle, t);
    if (!changed.is_suspect) std::swap(found.back().first, found.back().second);
  };
  for (std::size_t i = changed.first_leaf; i < changed_triangles_[number + 1].first_leaf; ++i) {
    if (changed.is_suspect) {
      for (const TriangleId t : leaf_triangles_.enclosed(leaves_[i])) test_with(t);
    }
    leaf_triangles_.for_each_suspect(leaves_[i], [&](TriangleId t) {
      const Index its_number = changed_number_[t];
      if (its_number == kNone || its_number < first_left_out) test_with(t);
    });
  }
}

}  // namespace kdm
