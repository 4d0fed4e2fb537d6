// SPDX-License-Identifier: MIT
// Finds the enclosed hits: among all hits, or only among the hits that a change concerns.
#include "extract/embed/suspects.h"

#include "mesh/sort.h"

namespace kdm {

Suspects::Suspects(const GridView& view, const DualMesh& loops, const EditLog& log)
    : loops_(loops),
      envelopes_(view, loops, log),
      triangles_(static_cast<Index>(view.grid.hits.size())),
      precise_(double_precision_suffices(view.grid.lattice)),
      enclosed_(view.grid.hits.size()),
      updated_(view.grid.hits.size()) {}

const std::vector<HitId>& Suspects::update(const DualMesh& mesh, std::span<const HitId> changed) {
  triangles_.update(mesh, changed);
  find_hits_to_update(changed);
  for (const CellId leaf : leaves_of_several_loops(updated_hits_)) {
    envelopes_.update_leaf(mesh, triangles_, leaf);
  }
  for (const HitId hit : updated_hits_) {
    enclosed_.set(hit, precise_ && envelopes_.enclose(mesh, triangles_, hit));
  }
  return updated_hits_;
}

// Whether a hit is enclosed depends on the triangles of a hit across a strip, since both have one
// envelope, and on whether planes part the loops of its leaves.
void Suspects::find_hits_to_update(std::span<const HitId> changed) {
  for (const HitId hit : updated_hits_) updated_.clear(hit);
  updated_hits_.clear();
  const auto add = [&](HitId hit) {
    if (!updated_.test_and_set(hit)) updated_hits_.push_back(hit);
  };
  for (const HitId hit : changed) add(hit);
  if (updated_hits_.size() < updated_.size()) {
    for (const CellId leaf : leaves_of_several_loops(changed)) envelopes_.for_each_hit(leaf, add);
    for (std::size_t n = 0; n < updated_hits_.size(); ++n) {
      const HitId hit = updated_hits_[n];
      for (Index i = 0; i < 3; ++i) {
        if ((loops_.strip[hit] >> i & 1) != 0) add(loops_.opposite[3 * hit + i] / 3);
      }
    }
  }
  sort_numbers(updated_hits_);
}

// Lists the leaves of these hits that hold several loops; ascending.
std::vector<CellId> Suspects::leaves_of_several_loops(std::span<const HitId> hits) const {
  std::vector<CellId> leaves;
  for (const HitId hit : hits) {
    for (Index i = 0; i < 3 && !loops_.dropped(hit); ++i) {
      const CellId leaf = loops_.leaf[loops_.vertex[3 * hit + i]];
      if (envelopes_.has_several_loops(leaf)) leaves.push_back(leaf);
    }
  }
  make_set(leaves);
  return leaves;
}

}  // namespace kdm
