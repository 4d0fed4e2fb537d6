// SPDX-License-Identifier: MIT
// Writes a grid, section by section, as the bytes that grid_format.h describes.
#include <algorithm>
#include <new>
#include <utility>

#include "geometry/assert.h"
#include "grid/faces.h"
#include "grid/saved/grid_format.h"
#include "grid/saved/sheet_links.h"
#include "grid/splitting_edges.h"
#include "io/bytes.h"
#include "kdmanifold/error.h"
#include "kdmanifold/grid_io.h"
#include "kdmanifold/reports.h"
#include "mesh/marks.h"

namespace kdm {
namespace {

namespace format = grid_format;

class GridWriter {
 public:
  explicit GridWriter(const GridData& grid) : grid_(grid), boxes_(cell_boxes(grid)) {}

  std::string payload() {
    write_lattice();
    write_reports();
    append_varint(out_, grid_.splits());
    append_varint(out_, grid_.hits.size());
    write_cells();
    write_edges();
    write_hits();
    for_each_face(grid_, boxes_, [&](const MinimalFace& face) { write_links(face); });
    append_bits();
    write_rims();
    write_corners();
    write_operands();
    write_exact();
    return std::move(out_);
  }

 private:
  void write_lattice() {
    write_vector(grid_.lattice.origin);
    append_f64(out_, grid_.lattice.step);
    append_f64(out_, grid_.tolerance);
    append_f64(out_, grid_.stats.winding_threshold);
    append_f64(out_, grid_.stats.asked_tolerance);
  }

  void write_reports() {
    const InputReport& input = grid_.input;
    for (const Index count : {input.vertices,
                              input.triangles,
                              input.boundary_edges,
                              input.non_manifold_edges,
                              input.boundary_loops,
                              input.degenerate_faces,
                              input.cancelled_faces,
                              input.duplicate_faces,
                              input.sewn_edges,
                              input.turned_faces,
                              input.turned_parts,
                              input.components,
                              input.patched_holes,
                              input.lost_parts,
                              input.stray_parts,
                              input.thickened_parts,
                              input.rebuilt_parts,
                              grid_.stats.unresolved_leaves,
                              grid_.stats.guessed_faces,
                              grid_.stats.exact_parts,
                              grid_.stats.thin_parts}) {
      append_varint(out_, count);
    }
    append_u8(
        out_,
        static_cast<std::uint8_t>(
            (input.closed ? format::kClosed : 0) | (input.flipped ? format::kFlipped : 0) |
            (grid_.stats.topology_resolved ? format::kTopologyResolved : 0) |
            (grid_.sheet ? format::kSheet : 0) | (input.nesting_known ? format::kNestingKnown : 0) |
            (grid_.operands.empty() ? 0 : format::kSeveralOperands) |
            (grid_.simplified > 0 ? format::kSimplified : 0)));
    for (const double measure : {input.patch_area, input.lost_area, input.largest_lost,
                                 input.sewing_distance, input.rebuilding_tolerance, input.extent}) {
      append_f64(out_, measure);
    }
    if (grid_.simplified > 0) append_f64(out_, grid_.simplified);
  }

  // Keeps account of what the reader knows at each split: `pending` are the cells that it knows are
  // split, and `done` marks those of them whose splits are written already.
  void write_cells() {
    Marks done(grid_.cells.size());
    std::vector<CellId> pending{0};
    for (const CellId c : cells_of_splits(grid_)) {
      while (done.test(pending.back())) pending.pop_back();
      const bool stray = pending.back() != c;
      done.set(c);
      const Cell& cell = grid_.cells[c];
      const bool below_is_split = !grid_.cells[cell.below()].leaf();
      const bool above_is_split = !grid_.cells[cell.above()].leaf();
      const int middle = (boxes_[c].lo[cell.axis()] + boxes_[c].hi[cell.axis()]) / 2;
      const std::uint64_t place =
          3 * format::from_signed(cell.value() - middle) + static_cast<unsigned>(cell.axis());
      append_varint(out_, 8 * place | (below_is_split ? format::kBelowIsSplit : 0u) |
                              (above_is_split ? format::kAboveIsSplit : 0u) |
                              (stray ? format::kStray : 0u));
      if (stray) append_varint(out_, c);
      if (above_is_split) pending.push_back(cell.above());
      if (below_is_split) pending.push_back(cell.below());
    }
  }

  void write_edges() {
    for (SplitId k = 0; k < grid_.splits(); ++k) {
      unsigned packed = 0;
      for (int i = 0; i < 4; ++i) {
        packed |= std::min(grid_.edge_hits(k, i).size(), format::kManyHits) << (2 * i);
      }
      append_u8(out_, static_cast<std::uint8_t>(packed));
      for (int i = 0; i < 4; ++i) {
        const Index count = grid_.edge_hits(k, i).size();
        if (count >= format::kManyHits) append_varint(out_, count - format::kManyHits);
      }
    }
  }

  void write_hits() {
    PlaneId met = 0;          // planes written so far
    Index source_before = 0;  // the source face of the last one
    for_each_splitting_edge(grid_, boxes_, [&](const SplittingEdge& edge) {
      auto lowest = static_cast<std::uint64_t>(edge.box.lo[edge.axis]) << kFractionBits;
      for (const HitId h : edge.hits) {
        const Hit& hit = grid_.hits[h];
        append_varint(out_, hit.position - lowest);
        lowest = std::uint64_t{hit.position} + (grid_.sheet ? 0 : 1);
        KDM_ASSERT(hit.plane() <= met, "planes come in the order of their first hits");
        const std::uint64_t back = met - hit.plane();
        const bool directed = grid_.sheet || h == edge.hits.first;
        append_varint(out_, directed ? 2 * back + (hit.leaving() ? 1 : 0) : back);
        if (back > 0) continue;
        write_plane(grid_.planes[met]);
        const Index source = grid_.source_faces[met++];
        append_varint(out_, format::from_signed(std::int64_t{source} - source_before));
        source_before = source;
      }
    });
  }

  void write_plane(const Plane& plane) {
    write_vector(plane.normal);
    append_f64(out_, plane.offset);
  }

  void write_links(const MinimalFace& face) {
    if (grid_.sheet ? face.strip() : !is_ambiguous(face)) return;
    outline_.clear();
    starts_below_.resize(0);
    for_each_hit(face, [&](const FaceEdge& edge, HitId hit, int) {
      outline_.push_back(3 * hit + edge.slot);
      starts_below_.push_back(starts_below(edge, grid_.hits[hit].reversed()));
    });
    if (grid_.sheet) {
      write_sheet_links();
    } else {
      write_brackets();
    }
  }

  void write_brackets() {
    place_.resize(3 * grid_.hits.size());
    for (Index i = 0; i < outline_.size(); ++i) place_[outline_[i]] = i;
    for (Index i = 0; i < outline_.size(); ++i) {
      write_bit(place_[grid_.opposite[outline_[i]]] > i);
    }
  }

  void write_sheet_links() {
    decide_(
        starts_below_, [&](Index i) { return write_bit(grid_.opposite[outline_[i]] != kNone); },
        [&](Index i, Index j) { return write_bit(grid_.opposite[outline_[i]] == outline_[j]); },
        [](Index, Index) {});
  }

  bool write_bit(bool bit) {
    byte_ |= (bit ? 1u : 0u) << bits_;
    if (++bits_ == 8) append_bits();
    return bit;
  }

  void append_bits() {
    if (bits_ > 0) append_u8(out_, static_cast<std::uint8_t>(byte_));
    byte_ = 0;
    bits_ = 0;
  }

  void write_rims() {
    write_kept(grid_.rims, [&](const RimHit& rim) {
      write_vector(rim.point);
      write_vector(rim.normal);
    });
  }

  void write_corners() {
    write_kept(grid_.corners, [&](const KeptCorner& corner) {
      write_vector(corner.point);
      if (grid_.simplified > 0) append_u8(out_, corner.joined ? 1 : 0);
    });
  }

  void write_operands() {
    if (grid_.operands.empty()) return;
    append_varint(out_, grid_.operands.size());
    for (const InputReport& operand : grid_.operands) {
      for_each_field(operand, [&](const ReportField&, const auto& value) { write_value(value); });
    }
    for (const Index operand : grid_.source_operands) write_operand(operand);
  }
  void write_operand(Index operand) {
    append_varint(out_, operand == kNone ? grid_.operands.size() : operand);
  }
  void write_value(Index count) { append_varint(out_, count); }
  void write_value(bool flag) { append_varint(out_, flag ? 1 : 0); }
  void write_value(double measure) { append_f64(out_, measure); }

  void write_exact() {
    append_varint(out_, grid_.exact.positions.size());
    for (const Vec3& p : grid_.exact.positions) {
      for (int axis = 0; axis < 3; ++axis) append_f32(out_, static_cast<float>(p[axis]));
    }
    append_varint(out_, grid_.exact.triangles.size());
    std::int64_t source_before = 0;
    for (std::size_t t = 0; t < grid_.exact.triangles.size(); ++t) {
      for (const Index v : grid_.exact.triangles[t]) append_varint(out_, v);
      const std::int64_t source = grid_.exact.source_faces[t];
      append_varint(out_, format::from_signed(source - source_before));
      source_before = source;
      if (!grid_.operands.empty()) write_operand(grid_.exact.source_operands[t]);
    }
  }

  // Writes what is kept for some half-edges, in ascending order of these: the half-edge of each
  // one, then the rest by `write`.
  template <typename Kept, typename Write>
  void write_kept(const std::vector<Kept>& kept, const Write& write) {
    append_varint(out_, kept.size());
    HalfEdgeId next = 0;
    for (const Kept& one : kept) {
      append_varint(out_, one.half_edge - next);
      next = one.half_edge + 1;
      write(one);
    }
  }

  void write_vector(const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) append_f64(out_, v[axis]);
  }

  const GridData& grid_;
  std::vector<LatticeBox> boxes_;
  std::string out_;
  // Of the face at hand: its half-edges in order, and which of them start below it.
  std::vector<HalfEdgeId> outline_;
  Marks starts_below_;
  SheetLinkDecisions decide_;
  std::vector<Index> place_;  // per half-edge of the face at hand: its place in the outline
  unsigned byte_ = 0;         // bits that do not fill a byte yet, lowest first
  int bits_ = 0;              // how many these are
};

}  // namespace

std::vector<std::uint8_t> save_grid(const Grid& grid) try {
  const std::string payload = GridWriter(grid.data()).payload();
  std::string header(format::kMagic);
  append_u32(header, format::kVersion);
  append_u64(header, payload.size());
  append_u64(header, format::checksum(payload));
  std::vector<std::uint8_t> bytes;
  bytes.reserve(header.size() + payload.size());
  bytes.insert(bytes.end(), header.begin(), header.end());
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  return bytes;
} catch (const std::bad_alloc&) {
  throw Error(ErrorCode::kOutOfMemory, "there is not enough memory to save the grid");
}

}  // namespace kdm
