// SPDX-License-Identifier: MIT
// Records what was done to a dual mesh since its loops were found.
#pragma once

#include <vector>

#include "extract/dual/dual_mesh.h"

namespace kdm {

/// The passes that add vertices.
enum class AddedBy { kVertexSplits, kLinks, kDoubleEdges };

/// Records which hits and loops the passes have changed, and what they added. Embedding needs it to
/// take back the edits in a part of the mesh; reports need it to count. It holds any numbers of
/// hits and loops; what was never noted counts as not done.
class EditLog {
 public:
  /// Notes that the hit's triangles were changed otherwise than by division: by a flip, a vertex
  /// split or a separated edge.
  void note_edited(HitId hit) {
    mark(edited_, hit, 1);
    touched_hits_.push_back(hit);
  }
  /// Notes that a triangle of the hit was divided.
  void note_divided(HitId hit) { touched_hits_.push_back(hit); }
  /// Notes that vertices were split off from the loop's vertex.
  void note_split(LoopId loop) { mark(loop_was_split_, loop, 1); }
  /// Notes whether the surface passes through the inside of the minimal face that half-edge
  /// 3 * hit + place crosses by its first link.
  void note_link(HalfEdgeId half_edge, bool inside_face) {
    const HitId hit = half_edge / 3;
    const int bit = 1 << half_edge % 3;
    const int bits = hit < links_inside_face_.size() ? links_inside_face_[hit] : 0;
    mark(links_inside_face_, hit, inside_face ? bits | bit : bits & ~bit);
  }
  /// Notes that the mesh's vertices from `first` on were added by this pass.
  void note_added(AddedBy pass, VertexId first, const DualMesh& mesh) {
    if (first < mesh.vertices()) added_.push_back({pass, first, mesh.vertices()});
  }
  void note_flips(Index flips) { flips_ += flips; }

  bool edited(HitId hit) const { return hit < edited_.size() && edited_[hit] != 0; }
  bool was_split(LoopId loop) const {
    return loop < loop_was_split_.size() && loop_was_split_[loop] != 0;
  }
  /// Returns bit i for half-edge 3 * hit + i; see `note_link`.
  int links_inside_face(HitId hit) const {
    return hit < links_inside_face_.size() ? links_inside_face_[hit] : 0;
  }
  /// Lists the hits whose triangles were edited or divided since `forget_touched`, in the order in
  /// which that was noted. A hit may be listed several times.
  const std::vector<HitId>& touched_hits() const { return touched_hits_; }
  /// Tells whether the pass has added this vertex.
  bool has_added(AddedBy pass, VertexId v) const {
    for (const Addition& addition : added_) {
      if (v < addition.end) return v >= addition.first && addition.pass == pass;
    }
    return false;
  }
  /// Counts the vertices that the pass has added and that the mesh still has.
  Index added_vertices(AddedBy pass, const DualMesh& mesh) const {
    Index count = 0;
    for (const Addition& addition : added_) {
      if (addition.pass != pass) continue;
      for (VertexId v = addition.first; v < addition.end; ++v) {
        count += mesh.first_half_edge[v] != kNone ? 1 : 0;
      }
    }
    return count;
  }
  /// Counts all flips, also those that were taken back.
  Index flips() const { return flips_; }

  void forget_touched() { touched_hits_.clear(); }
  /// Notes that the hit's triangles, or the loop's vertex, are again as they were at first.
  void forget_edits(HitId hit) {
    if (hit < edited_.size()) edited_[hit] = 0;
  }
  void forget_split(LoopId loop) {
    if (loop < loop_was_split_.size()) loop_was_split_[loop] = 0;
  }

 private:
  struct Addition {
    AddedBy pass;
    VertexId first;
    VertexId end;
  };

  static void mark(std::vector<char>& marks, Index i, int value) {
    if (marks.size() <= i) marks.resize(i + 1, 0);
    marks[i] = static_cast<char>(value);
  }

  std::vector<char> edited_;             // per hit
  std::vector<char> loop_was_split_;     // per loop
  std::vector<char> links_inside_face_;  // per hit, three bits
  std::vector<HitId> touched_hits_;
  std::vector<Addition> added_;
  Index flips_ = 0;
};

}  // namespace kdm
