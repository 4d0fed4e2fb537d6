// SPDX-License-Identifier: MIT
// Half-edges of a loaded grid: where they start follows from the faces, and so do most links; the
// others are read.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "grid/faces.h"
#include "grid/saved/grid_format.h"
#include "grid/saved/read_numbers.h"
#include "grid/saved/sheet_links.h"
#include "io/bytes.h"

namespace kdm {

/// To be called with every minimal face, and `finish`ed; rims and corners follow. Throws
/// as the reader does.
class LinkReader {
 public:
  LinkReader(ByteReader& bytes, GridData& grid) : bytes_(bytes), grid_(grid) {
    grid_.opposite.assign(3 * grid.hits.size(), kNone);
    grid_.start.assign(3 * grid.hits.size(), kNone);
  }

  void operator()(const MinimalFace& face) {
    const bool stored = grid_format::has_stored_links(face);
    if (stored) ++grid_.stats.ambiguous_faces;
    if (face.strip()) {
      link_strip(face);
      return;
    }
    if (grid_.sheet) {
      link_sheet(face);
      return;
    }
    open_.clear();
    for_each_hit(face, [&](const FaceEdge& edge, Index hit, int) {
      const End end = end_of(edge, hit);
      if (stored ? next_bit() : open_.empty()) {
        open_.push_back(end);
      } else {
        if (open_.empty()) bytes_.fail("a link of a minimal face ends that has not begun");
        link(face, open_.back(), end, 0);
        open_.pop_back();
      }
    });
    if (!open_.empty()) bytes_.fail("a link of a minimal face has no end");
  }

  void finish() const {
    if (byte_ != 0) bytes_.fail("the links end here, but not the bits");
  }

  void read_rims() const {
    read_kept("rim", 6, grid_.rims, [&](Index half_edge) {
      const Vec3 point = take_point("a rim's point");
      return RimHit{half_edge, point, take_normal(bytes_, true, "a rim's normal")};
    });
  }

  void read_corners() const {
    read_kept("corner", 3, grid_.corners, [&](Index half_edge) {
      return KeptCorner{half_edge, take_point("a corner's point")};
    });
  }

 private:
  struct End {
    Index half_edge;
    bool starts_below;
  };

  // What is kept of some half-edges, in the order of these, each with some real numbers.
  template <typename Kept, typename Read>
  void read_kept(std::string_view name, std::uint64_t reals, std::vector<Kept>& kept,
                 const Read& read) const {
    const std::string what = fmt::format("a {}'s half-edge", name);
    const std::uint64_t half_edges = grid_.opposite.size();
    const std::uint64_t count =
        bytes_.take_varint(half_edges, fmt::format("the number of {}s", name));
    bytes_.require(count, 1 + reals * sizeof(double), name);
    kept.reserve(static_cast<std::size_t>(count));
    std::uint64_t next = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t half_edge = next + bytes_.take_varint(half_edges, what);
      if (half_edge >= half_edges) bytes_.fail(what + " is none");
      next = half_edge + 1;
      kept.push_back(read(static_cast<Index>(half_edge)));
    }
  }

  Vec3 take_point(std::string_view what) const {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = take_real(bytes_, 0, kLatticeSize, what);
    return point;
  }

  End end_of(const FaceEdge& edge, Index hit) const {
    return {3 * hit + edge.slot, starts_below(edge, grid_.hits[hit].reversed())};
  }

  void link_strip(const MinimalFace& face) {
    const std::size_t first = face.lo(0) == face.hi(0) ? 1 : 0;
    const FaceEdge& a = face.edges[first];
    const FaceEdge& b = face.edges[first + 2];
    if (a.hits.size() != b.hits.size())
      bytes_.fail("the long sides of a strip carry different hits");
    for (Index i = 0; i < a.hits.size(); ++i) {
      link(face, end_of(a, a.hits.first + i), end_of(b, b.hits.first + i), GridData::kStrip);
    }
  }

  void link_sheet(const MinimalFace& face) {
    ends_.clear();
    starts_below_.clear();
    for_each_hit(face, [&](const FaceEdge& edge, Index hit, int) {
      ends_.push_back(end_of(edge, hit));
      starts_below_.push_back(ends_.back().starts_below);
      grid_.start[ends_.back().half_edge] = starts_below_.back() ? face.below : face.above;
    });
    decide_(
        starts_below_, [&](Index) { return next_bit(); }, [&](Index, Index) { return next_bit(); },
        [&](Index i, Index j) { link(face, ends_[i], ends_[j], 0); });
  }

  void link(const MinimalFace& face, const End& a, const End& b, std::uint32_t strip) {
    if (a.starts_below == b.starts_below) bytes_.fail("a link joins hits that do not fit");
    grid_.opposite[a.half_edge] = b.half_edge;
    grid_.opposite[b.half_edge] = a.half_edge;
    grid_.start[a.half_edge] = (a.starts_below ? face.below : face.above) | strip;
    grid_.start[b.half_edge] = (b.starts_below ? face.below : face.above) | strip;
  }

  bool next_bit() {
    if (bits_ == 0) {
      bytes_.require(1, 1, "byte of links");
      byte_ = bytes_.take_unsigned<std::uint8_t>();
      bits_ = 8;
    }
    const bool bit = (byte_ & 1u) != 0;
    byte_ >>= 1;
    --bits_;
    return bit;
  }

  ByteReader& bytes_;
  GridData& grid_;
  std::vector<End> open_;
  std::vector<End> ends_;
  std::vector<bool> starts_below_;
  SheetLinkDecisions decide_;
  unsigned byte_ = 0;  // what is left of the last one
  int bits_ = 0;
};

}  // namespace kdm
