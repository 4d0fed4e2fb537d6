// SPDX-License-Identifier: MIT
// Taking back what was done to a part of a dual mesh.
//
// The hits' triangles are tied where their link is not as it was. Every step that changes the mesh
// spoils the links between all hits whose triangles it changes, or exchanges, so no other tie is
// needed: beyond links that are as they were lie triangles that nothing here has touched.
#include "extract/embed/restore.h"

#include <algorithm>

namespace kdm {
namespace {

class Restoring {
 public:
  Restoring(const DualMesh& loops, DualMesh& mesh, EditLog& log)
      : loops_(loops), mesh_(mesh), log_(log), included_(loops.hit.size(), 0) {}

  Restored run(const std::vector<Index>& hits) {
    for (const Index h : hits) include(h);
    for (std::size_t i = 0; i < found_.hits.size(); ++i) follow_ties(found_.hits[i]);
    std::sort(found_.hits.begin(), found_.hits.end());
    drop_added();
    for (const Index hit : found_.hits) relink(hit);
    for (const Index hit : found_.hits) reset_loops(hit);
    for (std::vector<Index>* loops : {&found_.loops, &found_.cut}) {
      std::sort(loops->begin(), loops->end());
      loops->erase(std::unique(loops->begin(), loops->end()), loops->end());
    }
    return std::move(found_);
  }

 private:
  void include(Index hit) {
    if (included_[hit] != 0 || loops_.dropped(hit)) return;
    included_[hit] = 1;
    found_.hits.push_back(hit);
  }

  void follow_ties(Index hit) {
    for (Index half_edge = 3 * hit; half_edge < 3 * hit + 3; ++half_edge) {
      const Index other = loops_.opposite[half_edge];
      if (other != kNone && !(as_it_was(half_edge) && as_it_was(other))) include(other / 3);
      const Index v = loops_.vertex[half_edge];
      if (!loops_.next_loop_in_leaf.empty() && loops_.next_loop_in_leaf[v] != v)
        include_ring(loops_.next_loop_in_leaf[v]);
      if (!log_.was_split(v)) continue;
      found_.cut.push_back(v);
      log_.forget_split(v);
      include_ring(v);
    }
  }

  void include_ring(Index v) {
    for (const HalfEdgeId h : loops_.ring(v)) include(h / 3);
  }

  bool as_it_was(Index half_edge) const {
    const Index next = next_in_triangle(half_edge);
    return mesh_.hit[half_edge / 3] == half_edge / 3 &&
           mesh_.opposite[half_edge] == loops_.opposite[half_edge] &&
           mesh_.vertex[half_edge] == loops_.vertex[half_edge] &&
           mesh_.vertex[next] == loops_.vertex[next];
  }

  void drop_added() {
    const auto hits = static_cast<Index>(loops_.hit.size());
    for (const Index hit : found_.hits) drop_vertices(hit);
    for (Index t = hits; t < mesh_.triangles(); ++t) {
      if (mesh_.dropped(t) || included_[mesh_.hit[t]] == 0) continue;
      drop_vertices(t);
      for (Index i = 0; i < 3; ++i) mesh_.vertex[3 * t + i] = kNone;
    }
  }

  void drop_vertices(Index triangle) {
    for (Index half_edge = 3 * triangle; half_edge < 3 * triangle + 3; ++half_edge) {
      const Index v = mesh_.vertex[half_edge];
      if (v >= loops_.vertices()) mesh_.first_half_edge[v] = kNone;
    }
  }

  void relink(Index hit) {
    mesh_.hit[hit] = hit;
    mesh_.strip[hit] = loops_.strip[hit];
    log_.forget_edits(hit);
    for (Index half_edge = 3 * hit; half_edge < 3 * hit + 3; ++half_edge) {
      mesh_.vertex[half_edge] = loops_.vertex[half_edge];
      mesh_.link(half_edge, loops_.opposite[half_edge]);
    }
  }

  void reset_loops(Index hit) {
    for (Index half_edge = 3 * hit; half_edge < 3 * hit + 3; ++half_edge) {
      const Index v = loops_.vertex[half_edge];
      found_.loops.push_back(v);
      mesh_.position[v] = loops_.position[v];
      mesh_.set_first_half_edge(v, half_edge);
    }
  }

  const DualMesh& loops_;
  DualMesh& mesh_;
  EditLog& log_;
  std::vector<char> included_;  // per hit
  Restored found_;
};

}  // namespace

Restored restore(const DualMesh& loops, const std::vector<Index>& hits, DualMesh& mesh,
                 EditLog& log) {
  return Restoring(loops, mesh, log).run(hits);
}

}  // namespace kdm
