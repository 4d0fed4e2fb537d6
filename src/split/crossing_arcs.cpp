// SPDX-License-Identifier: MIT
#include "split/crossing_arcs.h"

#include <algorithm>
#include <bit>

#include "geometry/distance.h"
#include "mesh/sides.h"

namespace kdm {
namespace {

// More pairs than these are not looked at: cells where so many triangles cross are not plain.
constexpr std::size_t kMostPairs = 1024;

int sign_of(std::int64_t value) { return value > 0 ? 1 : (value < 0 ? -1 : 0); }

// Returns the sign of `value`; if that is 0, the sign of what a step of (e, e^2, e^3) adds to it, e
// infinitesimal, forwards or backwards. `slope` says how the value changes along each axis.
int sign_after_step(std::int64_t value, const std::array<std::int64_t, 3>& slope, int step) {
  if (value != 0) return sign_of(value);
  for (const std::int64_t component : slope) {
    if (component != 0) return step * sign_of(component);
  }
  return 0;
}

std::int64_t dot(const std::array<std::int64_t, 3>& n, const LatticePoint& from,
                 const LatticePoint& to) {
  std::int64_t sum = 0;
  for (int i = 0; i < 3; ++i) sum += n[i] * (to[i] - from[i]);
  return sum;
}

// Returns where the mesh edge from p to q pierces the triangle, which takes the step; nothing if
// it does not.
std::optional<Vec3> piercing_point(const LatticePoint& p, const LatticePoint& q,
                                   const LatticeTriangle& t, int step) {
  const std::array<std::int64_t, 3> normal = area_vector(t);
  const std::int64_t from = dot(normal, t[0], p);
  const std::int64_t to = dot(normal, t[0], q);
  // The points seem to step backwards from the triangle's plane.
  if (sign_after_step(from, normal, -step) * sign_after_step(to, normal, -step) >= 0) {
    return std::nullopt;
  }
  int side = 0;
  for (int i = 0; i < 3; ++i) {
    const LatticePoint& a = t[i];
    const LatticePoint& b = t[next_corner(i)];
    const std::int64_t volume = dot(area_vector({p, q, a}), p, b);
    // Its slope is (q - p) x (a - b).
    LatticePoint beside = p;
    for (int k = 0; k < 3; ++k) beside[k] += a[k] - b[k];
    const int sign = sign_after_step(volume, area_vector({p, q, beside}), step);
    if (sign == 0 || sign == -side) return std::nullopt;
    side = sign;
  }
  const double part = static_cast<double>(from) / static_cast<double>(from - to);
  return to_vec3(p) + part * (to_vec3(q) - to_vec3(p));
}

// Tells whether two triangles lie in one plane and face the same way.
bool lie_on_each_other(const LatticeTriangle& s, const LatticeTriangle& t) {
  const std::array<std::int64_t, 3> normal = area_vector(s);
  const std::array<std::int64_t, 3> other = area_vector(t);
  for (const LatticePoint& p : t) {
    if (dot(normal, s[0], p) != 0) return false;
  }
  for (int i = 0; i < 3; ++i) {
    if (normal[i] != 0) return (normal[i] > 0) == (other[i] > 0);
  }
  return false;
}

}  // namespace

CrossingArcs::Answer CrossingArcs::join_pieces_to_disks(const CellSurface& cell,
                                                        std::span<const CrossingPair> pairs) {
  if (pairs.size() > kMostPairs) return Answer::kUnclear;
  crossed_by_.clear();
  for (const CrossingPair& pair : pairs) {
    crossed_by_.insert(crossed_by_.end(), {pair, {pair[1], pair[0]}});
  }
  std::sort(crossed_by_.begin(), crossed_by_.end());
  clear_ = true;
  const bool disks_there = join_pieces(cell, pairs, 1);
  lowest_joined_.clear();
  const auto count = static_cast<PieceId>(cell.pieces.all().size());
  for (PieceId piece = 0; piece < count; ++piece) lowest_joined_.push_back(joined_->find(piece));
  const bool disks_back = join_pieces(cell, pairs, -1);
  if (!disks_there && !disks_back) return clear_ ? Answer::kTooMuch : Answer::kUnclear;
  for (PieceId piece = 0; piece < count; ++piece) {
    if (joined_->find(piece) != lowest_joined_[piece]) return Answer::kUnclear;
  }
  return disks_there && disks_back ? Answer::kDisks : Answer::kUnclear;
}

// Joins the pieces along arcs, while those with the higher numbers take the step. Returns false if
// anything is not plain.
bool CrossingArcs::join_pieces(const CellSurface& cell, std::span<const CrossingPair> pairs,
                               int step) {
  joined_.emplace(cell.pieces.all().size());
  segments_.clear();
  flush_.clear();
  for (const CrossingPair& pair : pairs) {
    if (add_segment(cell, pair, step)) continue;
    clear_ = false;
    return false;
  }
  std::stable_sort(segments_.begin(), segments_.end(),
                   [](const Segment& x, const Segment& y) { return x.pieces < y.pieces; });
  turns_.assign(cell.pieces.all().size(), 0);
  guessed_.clear();
  for (std::size_t i = 0; i < segments_.size();) {
    std::size_t end = i;
    while (end < segments_.size() && segments_[end].pieces == segments_[i].pieces) ++end;
    if (!join_along_curves(cell, std::span(segments_).subspan(i, end - i))) return false;
    i = end;
  }
  for (const PieceId piece : guessed_) {
    if (turns_[piece] != 1) return false;
  }
  for (const auto& [first, second] : flush_) {
    if (joined_->find(first) == joined_->find(second)) continue;
    if (turns_[first] != 0 || turns_[second] != 0) {
      clear_ = false;
      return false;
    }
    joined_->join(first, second);
  }
  return true;
}

// Adds what two members have in common within the cell, if anything. Returns false if that is not
// plain.
bool CrossingArcs::add_segment(const CellSurface& cell, const CrossingPair& pair, int step) {
  const CellTriangles& members = cell.triangles;
  Segment segment{{cell.pieces.piece_of(pair[0]), cell.pieces.piece_of(pair[1])}, pair, {}, {}};
  if (segment.pieces[0] == segment.pieces[1]) return false;
  if (segment.pieces[0] > segment.pieces[1]) {
    std::swap(segment.pieces[0], segment.pieces[1]);
    std::swap(segment.members[0], segment.members[1]);
  }
  std::array<Vec3, 2> points;
  std::size_t count = 0;
  for (int i = 0; i < 2; ++i) {
    const MemberId member = segment.members[i];
    const MemberId other = segment.members[1 - i];
    const LatticeTriangle& t = members.corners(member);
    for (int corner = 0; corner < 3; ++corner) {
      const std::optional<Vec3> point = piercing_point(
          t[corner], t[next_corner(corner)], members.corners(other), i == 0 ? step : -step);
      if (!point) continue;
      const SideId side = 3 * members.triangle(member) + static_cast<SideId>(corner);
      const SideId opposite = members.surface().topology.opposite[side];
      if (count == 2 || opposite == kNone) return false;
      segment.pierced[count] = std::uint64_t{std::min(side, opposite)} << 32 | other;
      points[count++] = *point;
    }
  }
  if (count == 0 && lie_on_each_other(members.corners(pair[0]), members.corners(pair[1]))) {
    flush_.push_back(segment.pieces);
  }
  if (count != 2) return count == 0;
  const std::optional<SegmentInBox> part = segment_in_box(points[0], points[1], members.cell());
  if (!part) return false;
  segment.part = *part;
  if (!part->meets) return true;
  segments_.push_back(segment);
  return !meets_third_piece(cell, segment);
}

// Tells whether a piece besides the two of a segment may pass through it. A member that does so
// crosses both members of the segment.
bool CrossingArcs::meets_third_piece(const CellSurface& cell, const Segment& segment) const {
  const auto crossing = [&](MemberId m) {
    const auto begin = std::lower_bound(crossed_by_.begin(), crossed_by_.end(), CrossingPair{m, 0});
    const auto end = std::lower_bound(begin, crossed_by_.end(), CrossingPair{m + 1, 0});
    return std::span(begin, end);
  };
  for (const auto& [first, other] : crossing(segment.members[0])) {
    const PieceId piece = cell.pieces.piece_of(other);
    if (piece == segment.pieces[0] || piece == segment.pieces[1]) continue;
    const CrossingPair with_second{segment.members[1], other};
    if (!std::binary_search(crossed_by_.begin(), crossed_by_.end(), with_second)) continue;
    const Plane& plane = cell.triangles.surface().planes[cell.triangles.triangle(other)];
    const double from = plane.signed_distance(segment.part.ends[0]);
    const double to = plane.signed_distance(segment.part.ends[1]);
    // Rounding to the lattice moves a triangle off its plane by less than a unit.
    if (!(std::min(from, to) > 1 || std::max(from, to) < -1)) return true;
  }
  return false;
}

// Joins two pieces, of which these are all segments, if the solid's boundary turns from one to the
// other along an arc. Returns false if it does in another way.
bool CrossingArcs::join_along_curves(const CellSurface& cell, std::span<const Segment> segments) {
  DisjointSets connected(segments.size());
  if (!connect_segments(segments, connected)) {
    clear_ = false;
    return false;
  }
  curves_.assign(segments.size(), {});
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const SegmentInBox& part = segments[i].part;
    Curve& curve = curves_[connected.find(static_cast<Index>(i))];
    for (int end = 0; end < 2; ++end) {
      if (part.ends_in[end]) continue;
      curve.faces |= 1u << part.leaves_by[end];
      ++curve.ends;
    }
    const Sheets sheets = sheets_along(cell.triangles, segments[i]);
    if (sheets == Sheets::kUnknown) continue;
    if (curve.sheets != Sheets::kUnknown && curve.sheets != sheets) {
      clear_ = false;  // pieces of three solids cross there
      return false;
    }
    curve.sheets = sheets;
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Curve& curve = curves_[i];
    if (connected.find(static_cast<Index>(i)) != i || curve.sheets == Sheets::kThrough) continue;
    const auto& [first, second] = segments[i].pieces;
    const bool some_inner = cell.pieces.all()[first].is_inner || cell.pieces.all()[second].is_inner;
    if (curve.sheets == Sheets::kUnknown && some_inner) continue;
    clear_ = clear_ && curve.sheets == Sheets::kTurn;
    if (curve.sheets == Sheets::kAll || curve.ends != 2 || std::popcount(curve.faces) != 2 ||
        some_inner || joined_->find(first) == joined_->find(second)) {
      return false;
    }
    joined_->join(first, second);
    ++turns_[first];
    ++turns_[second];
    if (curve.sheets == Sheets::kTurn) continue;
    // Around a curve an even number of sheets bounds the solid: of two pieces that no other curve
    // divides not all four, if some of them lies within it.
    if (!is_partly_inner(cell, first) && !is_partly_inner(cell, second)) return false;
    guessed_.insert(guessed_.end(), {first, second});
  }
  return true;
}

// Tells whether some of a piece is known to bound nothing.
bool CrossingArcs::is_partly_inner(const CellSurface& cell, PieceId piece) {
  for (MemberId m = 0; m < cell.triangles.size(); ++m) {
    if (cell.pieces.piece_of(m) != piece) continue;
    if (cell.triangles.surface().degenerate.test(cell.triangles.triangle(m))) continue;
    if (cell.inner[m].all || cell.inner[m].corners != 0) return true;
  }
  return false;
}

// Connects the segments that meet in the cell: where an edge pierces a triangle, those of the
// edge's two triangles do. Returns false if something else meets there.
bool CrossingArcs::connect_segments(std::span<const Segment> segments, DisjointSets& connected) {
  ends_.clear();
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (int end = 0; end < 2; ++end) {
      if (!segments[i].part.ends_in[end]) continue;
      ends_.emplace_back(segments[i].pierced[end], static_cast<Index>(i));
    }
  }
  std::sort(ends_.begin(), ends_.end());
  for (std::size_t i = 0; i < ends_.size(); i += 2) {
    if (i + 1 == ends_.size() || ends_[i].first != ends_[i + 1].first) return false;
    connected.join(ends_[i].second, ends_[i + 1].second);
  }
  return true;
}

// Counts states on the four sides of a segment, from a lattice point beside its middle. Nothing is
// known if that point may lie beside other triangles as well.
CrossingArcs::Sheets CrossingArcs::sheets_along(const CellTriangles& members,
                                                const Segment& segment) const {
  const Vec3 middle = 0.5 * (segment.part.ends[0] + segment.part.ends[1]);
  for (MemberId m = 0; m < members.size(); ++m) {
    if (m == segment.members[0] || m == segment.members[1]) continue;
    const LatticeTriangle& t = members.corners(m);
    if (squared_distance(middle, to_vec3(t[0]), to_vec3(t[1]), to_vec3(t[2])) > 1) continue;
    const auto continues = [&](MemberId of) { return lie_on_each_other(members.corners(of), t); };
    if (!continues(segment.members[0]) && !continues(segment.members[1])) return Sheets::kUnknown;
  }
  const LatticePoint point = nearest_point_in(members.cell(), middle);
  const bool before_first = lies_before(members.corners(segment.members[0]), point);
  const bool before_second = lies_before(members.corners(segment.members[1]), point);
  const int state = states_.at(point);
  const int beyond_first = states_.beyond(segment.members[0], state, !before_first);
  const int beyond_second = states_.beyond(segment.members[1], state, !before_second);
  const int beyond_both = states_.beyond(segment.members[1], beyond_first, !before_second);
  const bool at_point = states_.is_inside(state);
  const bool first = states_.is_inside(beyond_first);
  const bool second = states_.is_inside(beyond_second);
  const bool both = states_.is_inside(beyond_both);
  const int of_first = (at_point != first) + (second != both);
  const int of_second = (at_point != second) + (first != both);
  if (of_first == 1) return Sheets::kTurn;
  return of_first + of_second == 4 ? Sheets::kAll : Sheets::kThrough;
}

}  // namespace kdm
