// SPDX-License-Identifier: MIT
// Grid -> bytes, section by section; grid_format.h describes them.
#include <algorithm>
#include <new>
#include <utility>

#include "geometry/assert.h"
#include "grid/faces.h"
#include "grid/grid_format.h"
#include "kdmanifold/error.h"
#include "kdmanifold/grid_io.h"
#include "mesh/bytes.h"

namespace kdm {
namespace {

namespace format = grid_format;

class GridWriter {
 public:
  explicit GridWriter(const GridData& grid)
      : grid_(grid), boxes_(cell_boxes(grid)), cell_of_split_(grid.splits()) {
    for (std::size_t c = 0; c < grid.cells.size(); ++c) {
      if (!grid.cells[c].leaf()) cell_of_split_[grid.cells[c].split()] = static_cast<Index>(c);
    }
  }

  std::string payload() {
    write_lattice();
    write_reports();
    append_varint(out_, grid_.splits());
    append_varint(out_, grid_.hits.size());
    write_cells();
    write_edges();
    write_hits();
    write_links();
    return std::move(out_);
  }

 private:
  void write_lattice() {
    for (int axis = 0; axis < 3; ++axis) append_f64(out_, grid_.lattice.origin[axis]);
    append_f64(out_, grid_.lattice.step);
    append_f64(out_, grid_.tolerance);
  }

  void write_reports() {
    const InputReport& input = grid_.input;
    for (const Index count :
         {input.vertices, input.triangles, input.boundary_edges, input.non_manifold_edges,
          input.degenerate_faces, input.cancelled_faces, input.components,
          grid_.stats.unresolved_leaves, grid_.stats.guessed_faces}) {
      append_varint(out_, count);
    }
    append_u8(out_,
              static_cast<std::uint8_t>(
                  (input.closed ? format::kClosed : 0) | (input.flipped ? format::kFlipped : 0) |
                  (grid_.stats.topology_resolved ? format::kTopologyResolved : 0)));
  }

  // Keeps account of what the reader knows: `pending` are the cells known to be split, of which
  // those that have been are `done`.
  void write_cells() {
    std::vector<char> done(grid_.cells.size(), 0);
    std::vector<Index> pending{0};
    for (const Index c : cell_of_split_) {
      while (done[pending.back()] != 0) pending.pop_back();
      const bool stray = pending.back() != c;
      done[c] = 1;
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

  Index hits_on(Index edge) const { return grid_.edge_begin[edge + 1] - grid_.edge_begin[edge]; }

  void write_edges() {
    for (Index k = 0; k < grid_.splits(); ++k) {
      unsigned packed = 0;
      for (Index i = 0; i < 4; ++i) {
        packed |= std::min(hits_on(4 * k + i), format::kManyHits) << (2 * i);
      }
      append_u8(out_, static_cast<std::uint8_t>(packed));
      for (Index i = 0; i < 4; ++i) {
        const Index count = hits_on(4 * k + i);
        if (count >= format::kManyHits) append_varint(out_, count - format::kManyHits);
      }
    }
  }

  void write_hits() {
    Index met = 0;
    Index source_before = 0;
    for (Index edge = 0; edge < 4 * grid_.splits(); ++edge) {
      const Index c = cell_of_split_[edge / 4];
      const int axis = axis_of_edge(grid_.cells[c].axis(), static_cast<int>(edge % 4));
      std::uint64_t lowest = static_cast<std::uint64_t>(boxes_[c].lo[axis]) << kFractionBits;
      for (Index h = grid_.edge_begin[edge]; h < grid_.edge_begin[edge + 1]; ++h) {
        const Hit& hit = grid_.hits[h];
        append_varint(out_, hit.position - lowest);
        lowest = std::uint64_t{hit.position} + 1;
        KDM_ASSERT(hit.plane() <= met, "planes come in the order of their first hits");
        const std::uint64_t back = met - hit.plane();
        const bool first = h == grid_.edge_begin[edge];
        append_varint(out_, first ? 2 * back + (hit.leaving() ? 1 : 0) : back);
        if (back > 0) continue;
        write_plane(grid_.planes[met]);
        const Index source = grid_.source_faces[met++];
        append_varint(out_, format::from_signed(std::int64_t{source} - source_before));
        source_before = source;
      }
    }
  }

  void write_plane(const Plane& plane) {
    for (int axis = 0; axis < 3; ++axis) append_f64(out_, plane.normal[axis]);
    append_f64(out_, plane.offset);
  }

  void write_links() {
    unsigned byte = 0;
    int bits = 0;
    std::vector<Index> place(3 * grid_.hits.size());
    for_each_face(grid_, boxes_, [&](const MinimalFace& face) {
      if (!format::has_stored_links(face)) return;
      Index count = 0;
      for_each_hit(face, [&](const FaceEdge& edge, Index hit, int) {
        place[3 * hit + edge.slot] = count++;
      });
      for_each_hit(face, [&](const FaceEdge& edge, Index hit, int) {
        const Index half_edge = 3 * hit + edge.slot;
        const bool begins = place[grid_.opposite[half_edge]] > place[half_edge];
        byte |= (begins ? 1u : 0u) << bits;
        if (++bits < 8) return;
        append_u8(out_, static_cast<std::uint8_t>(byte));
        byte = 0;
        bits = 0;
      });
    });
    if (bits > 0) append_u8(out_, static_cast<std::uint8_t>(byte));
  }

  const GridData& grid_;
  std::vector<LatticeBox> boxes_;
  std::vector<Index> cell_of_split_;
  std::string out_;
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
