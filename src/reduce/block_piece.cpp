// SPDX-License-Identifier: MIT
#include "reduce/block_piece.h"

#include <algorithm>
#include <utility>

#include "mesh/sort.h"
#include "reduce/flips.h"

namespace kdm {
namespace {

PartNumbers numbers_of(const HalfEdges& mesh, const SpaceBlock& block) {
  PartNumbers out{block.triangles, {}};
  out.vertices.reserve(3 * out.triangles.size());
  for (const TriangleId t : out.triangles) {
    for (const VertexId v : mesh.corners(t)) out.vertices.push_back(v);
  }
  make_set(out.vertices);
  return out;
}

template <typename Value>
std::vector<Value> copied(const std::vector<Value>& values, const std::vector<VertexId>& numbers) {
  std::vector<Value> out;
  out.reserve(numbers.size());
  for (const VertexId v : numbers) out.push_back(values[v]);
  return out;
}

Marks copied(const Marks& marks, const std::vector<VertexId>& numbers) {
  Marks out(numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) out.set(i, marks.test(numbers[i]));
  return out;
}

Marks inside_of(const std::vector<Vec3>& positions, const PartNumbers& numbers, const Box& box) {
  Marks out(numbers.vertices.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out.set(i, holds(box, positions[numbers.vertices[i]]));
  }
  return out;
}

Marks owned_of(const HalfEdges& mesh, const PartNumbers& numbers, const Marks& inside) {
  Marks out(numbers.triangles.size());
  for (std::size_t t = 0; t < out.size(); ++t) {
    const Triangle corners = mesh.corners(numbers.triangles[t]);
    out.set(t, std::all_of(corners.begin(), corners.end(),
                           [&](VertexId v) { return inside.test(numbers.vertex(v)); }));
  }
  return out;
}

KeptDistance distance_of(const KeptDistance& whole, const PartNumbers& numbers,
                         const Marks& owned) {
  return {whole.reference,
          Samples(whole.samples, numbers.triangles, owned),
          whole.error,
          copied(whole.limits, numbers.vertices),
          copied(whole.near, numbers.vertices),
          whole.creases};
}

std::optional<Marks> guarded_of(const Workpiece& whole, const PartNumbers& numbers) {
  if (!whole.guarded) return {};
  return copied(*whole.guarded, numbers.vertices);
}

CollapseState state_of(const CollapseState& whole, const PartNumbers& numbers) {
  CollapseState out{{whole.quadrics.centre, copied(whole.quadrics.at, numbers.vertices)},
                    Marks(3 * numbers.triangles.size())};
  for (SideId h = 0; h < out.failed.size(); ++h) {
    out.failed.set(h, whole.failed.test(numbers.whole_side(h)));
  }
  return out;
}

}  // namespace

BlockPiece::BlockPiece(const Workpiece& whole, const CollapseState& state, const SpaceBlock& block)
    : numbers_(numbers_of(whole.mesh, block)),
      inside_(inside_of(whole.positions, numbers_, block.box)),
      owned_(owned_of(whole.mesh, numbers_, inside_)),
      piece_(HalfEdges(whole.mesh, numbers_), copied(whole.positions, numbers_.vertices),
             distance_of(*whole.distance, numbers_, owned_), guarded_of(whole, numbers_)),
      state_(state_of(state, numbers_)) {
  Marks fixed(inside_.size());
  for (VertexId v = 0; v < fixed.size(); ++v) fixed.set(v, !inside_.test(v));
  piece_.within = StepsWithin{block.box, std::move(fixed)};
}

void BlockPiece::flip() { flips_ = flip_false_creases(piece_); }

void BlockPiece::collapse(const std::function<void(Index)>& between) {
  Collapser collapser(piece_, std::move(state_));
  collapser.collapse_to(0, [&] { between(gone()); });
  collapses_ = collapser.collapses();
  state_ = collapser.state();
  piece_.guard.reset();
}

void BlockPiece::put_back(Workpiece& whole, CollapseState& state) const {
  whole.mesh.put_back(piece_.mesh, numbers_, owned_, inside_);
  whole.distance->samples.put_back(piece_.distance->samples, numbers_.triangles, owned_);
  for (VertexId v = 0; v < inside_.size(); ++v) {
    if (!inside_.test(v)) continue;
    const VertexId number = numbers_.vertices[v];
    whole.positions[number] = piece_.positions[v];
    whole.joined_to[number] = numbers_.whole_vertex(piece_.joined_to[v]);
    whole.distance->limits[number] = piece_.distance->limits[v];
    whole.distance->near[number] = piece_.distance->near[v];
    if (whole.guarded) whole.guarded->set(number, piece_.guarded->test(v));
    state.quadrics.at[number] = state_.quadrics.at[v];
  }
  for (TriangleId t = 0; t < owned_.size(); ++t) {
    if (!owned_.test(t)) continue;
    whole.faces[numbers_.triangles[t]] = piece_.faces[t];
    for (SideId h = 3 * t; h < 3 * t + 3; ++h) {
      state.failed.set(numbers_.whole_side(h), state_.failed.test(h));
    }
  }
}

}  // namespace kdm
