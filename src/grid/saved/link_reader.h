// SPDX-License-Identifier: MIT
// Reads the links of a grid that is loaded. Where half-edges start, and most of their links,
// follows from the minimal faces; only the other links are stored.
#pragma once

#include <string>
#include <vector>

#include "grid/links.h"
#include "grid/saved/grid_format.h"
#include "grid/saved/read_numbers.h"
#include "grid/saved/sheet_links.h"
#include "io/bytes.h"
#include "text/compose.h"

namespace kdm {

/// Reads the links of each minimal face that it is called with. All faces come first, in the order
/// of `for_each_face`, then `finish`, then rims and corners. Throws `kParseError` if the bytes are
/// no links of these faces.
class LinkReader {
 public:
  LinkReader(ByteReader& bytes, GridData& grid) : bytes_(bytes), grid_(grid) {
    grid_.opposite.assign(3 * grid.hits.size(), kNone);
    grid_.start.assign(3 * grid.hits.size(), kNone);
  }

  void operator()(const MinimalFace& face) {
    if (is_ambiguous(face)) ++grid_.stats.ambiguous_faces;
    if (face.strip()) {
      link_strip(face);
    } else if (grid_.sheet) {
      link_sheet(face);
    } else {
      link_solid(face);
    }
  }

  void finish() const {
    if (byte_ != 0) bytes_.fail("the links end here, but not the bits");
  }

  void read_rims() const {
    read_kept("rim", 6, grid_.rims, [&](HalfEdgeId half_edge) {
      const Vec3 point = take_point("a rim's point");
      return RimHit{half_edge, point, take_normal(bytes_, true, "a rim's normal")};
    });
  }

  void read_corners() const {
    read_kept("corner", 3, grid_.corners, [&](HalfEdgeId half_edge) {
      KeptCorner corner{half_edge, take_point("a corner's point")};
      if (grid_.simplified > 0) {
        bytes_.require(1, 1, "corner");
        const auto joined = bytes_.take_unsigned<std::uint8_t>();
        if (joined > 1) bytes_.fail("a corner is joined or not");
        corner.joined = joined != 0;
      }
      return corner;
    });
  }

 private:
  struct End {  // of a link
    HalfEdgeId half_edge;
    bool starts_below;
  };

  // Reads what is kept for some half-edges, in ascending order of these: the half-edge of each one,
  // then as many real numbers as told, by `read`.
  template <typename Kept, typename Read>
  void read_kept(std::string_view name, std::size_t reals, std::vector<Kept>& kept,
                 const Read& read) const {
    const std::string what = compose("a {}'s half-edge", name);
    const std::uint64_t half_edges = grid_.opposite.size();
    const std::uint64_t count = bytes_.take_varint(half_edges, compose("the number of {}s", name));
    bytes_.require(count, 1 + reals * sizeof(double), name);
    kept.reserve(static_cast<std::size_t>(count));
    std::uint64_t next = 0;
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t half_edge = next + bytes_.take_varint(half_edges, what);
      if (half_edge >= half_edges) bytes_.fail(what + " is none");
      next = half_edge + 1;
      kept.push_back(read(static_cast<HalfEdgeId>(half_edge)));
    }
  }

  Vec3 take_point(std::string_view what) const {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = take_real(bytes_, 0, kLatticeSize, what);
    return point;
  }

  End end_of(const FaceEdge& edge, HitId hit) const {
    return {3 * hit + edge.slot, starts_below(edge, grid_.hits[hit].reversed())};
  }

  void link_strip(const MinimalFace& face) {
    const auto [a, b] = long_sides(face);
    if (a.hits.size() != b.hits.size())
      bytes_.fail("the long sides of a strip carry different hits");
    for (Index i = 0; i < a.hits.size(); ++i) {
      link_ends(face, end_of(a, a.hits.first + i), end_of(b, b.hits.first + i));
    }
  }

  // Links nest like brackets; of two hits they need no bits.
  void link_solid(const MinimalFace& face) {
    const bool stored = is_ambiguous(face);
    open_.clear();
    for_each_hit(face, [&](const FaceEdge& edge, HitId hit, int) {
      const End end = end_of(edge, hit);
      if (stored ? next_bit() : open_.empty()) {
        open_.push_back(end);
      } else {
        if (open_.empty()) bytes_.fail("a link of a minimal face ends that has not begun");
        link_ends(face, open_.back(), end);
        open_.pop_back();
      }
    });
    if (!open_.empty()) bytes_.fail("a link of a minimal face has no end");
  }

  void link_sheet(const MinimalFace& face) {
    ends_.clear();
    starts_below_.resize(0);
    for_each_hit(face, [&](const FaceEdge& edge, HitId hit, int) {
      ends_.push_back(end_of(edge, hit));
      starts_below_.push_back(ends_.back().starts_below);
      set_start(grid_, ends_.back().half_edge, face, ends_.back().starts_below);
    });
    decide_(
        starts_below_, [&](Index) { return next_bit(); }, [&](Index, Index) { return next_bit(); },
        [&](Index i, Index j) { link_ends(face, ends_[i], ends_[j]); });
  }

  void link_ends(const MinimalFace& face, const End& a, const End& b) {
    if (a.starts_below == b.starts_below) bytes_.fail("a link joins hits that do not fit");
    set_start(grid_, a.half_edge, face, a.starts_below);
    set_start(grid_, b.half_edge, face, b.starts_below);
    link(grid_, a.half_edge, b.half_edge);
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
  std::vector<End> open_;  // of a solid's face: links that have begun
  std::vector<End> ends_;  // of a sheet's face: all half-edges, in order
  Marks starts_below_;
  SheetLinkDecisions decide_;
  unsigned byte_ = 0;  // the bits of the last byte that were not taken yet, lowest first
  int bits_ = 0;       // how many these are
};

}  // namespace kdm
