// SPDX-License-Identifier: MIT
#include "split/crossing_arcs.h"

#include <algorithm>
#include <bit>

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

}  // namespace

CrossingArcs::Answer CrossingArcs::join_pieces_to_disks(const CellSurface& cell,
                                                        std::span<const CrossingPair> pairs) {
  if (pairs.size() > kMostPairs) return Answer::kUnclear;
  triple_points_.start(cell, pairs);
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
  triples_.clear();
  divided_.clear();
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
  if (!join_at_triple_points()) return false;
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
  const std::size_t known = triples_.size();
  if (!triple_points_.find({segment.pieces, segment.members, part->ends}, triples_)) return false;
  if (triples_.size() > known + 1) return false;
  if (triples_.size() > known) segment.triple = static_cast<Index>(known);
  segments_.push_back(segment);
  return true;
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
    if (segments[i].triple == kNone) continue;
    // Smaller cells have one such point each.
    if (curve.triple != kNone) return false;
    curve.triple = segments[i].triple;
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    Curve& curve = curves_[connected.find(static_cast<Index>(i))];
    if (curve.triple != kNone) continue;
    const Sheets sheets = sheets_along(cell.triangles, segments[i]);
    if (sheets == Sheets::kUnknown) continue;
    if (curve.sheets != Sheets::kUnknown && curve.sheets != sheets) {
      clear_ = false;
      return false;
    }
    curve.sheets = sheets;
  }
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Curve& curve = curves_[i];
    if (connected.find(static_cast<Index>(i)) != i) continue;
    if (!join_along_curve(cell, segments[i].pieces, curve)) return false;
  }
  return true;
}

// Does so for one of the curves along which two pieces cross.
bool CrossingArcs::join_along_curve(const CellSurface& cell, const std::array<PieceId, 2>& pieces,
                                    const Curve& curve) {
  const auto& [first, second] = pieces;
  const bool some_inner = cell.pieces.all()[first].is_inner || cell.pieces.all()[second].is_inner;
  const bool unknown = curve.sheets == Sheets::kUnknown && curve.triple == kNone;
  if (curve.sheets == Sheets::kThrough || (unknown && some_inner)) return true;
  clear_ = clear_ && !unknown && curve.sheets != Sheets::kAll;
  if (curve.sheets == Sheets::kAll || some_inner) return false;
  if (curve.ends != 2 || std::popcount(curve.faces) != 2) return false;
  ++turns_[first];
  ++turns_[second];
  if (curve.triple != kNone) {
    divided_.push_back({triples_[curve.triple].pieces, pieces, curve.faces, curve.triple});
    return true;
  }
  if (joined_->find(first) == joined_->find(second)) return false;
  joined_->join(first, second);
  if (!unknown) return true;
  // Around a curve an even number of sheets bounds the solid: of two pieces that no other curve
  // divides not all four, if some of them lies within it.
  guessed_.insert(guessed_.end(), {first, second});
  return is_partly_inner(cell, first) || is_partly_inner(cell, second);
}

// Joins pieces three by three where they bound a disk about a triple point. Returns false if they
// cross in another way.
bool CrossingArcs::join_at_triple_points() {
  std::sort(divided_.begin(), divided_.end());
  for (std::size_t i = 0; i < divided_.size(); i += 3) {
    const std::array<PieceId, 3>& pieces = divided_[i].pieces;
    const auto& [a, b, c] = pieces;
    const std::array<std::array<PieceId, 2>, 3> along = {{{a, b}, {a, c}, {b, c}}};
    unsigned faces = ~0u;
    for (std::size_t k = 0; k < 3; ++k) {
      const bool crosses = i + k < divided_.size() && divided_[i + k].pieces == pieces &&
                           divided_[i + k].along == along[k];
      if (!crosses) return false;
      faces &= divided_[i + k].faces;
    }
    // On a face with ends of all three arcs a curve may be closed.
    if (faces != 0) return false;
    if (!triple_points_.bounds_a_disk(triples_[divided_[i].triple])) {
      clear_ = false;
      return false;
    }
    const Index first = joined_->find(a);
    const Index second = joined_->find(b);
    if (first == second || joined_->find(c) == first || joined_->find(c) == second) return false;
    joined_->join(a, b);
    joined_->join(a, c);
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
  if (!only_these_are_near(members, segment.members, middle)) return Sheets::kUnknown;
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
