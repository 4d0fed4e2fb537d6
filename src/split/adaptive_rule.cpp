// SPDX-License-Identifier: MIT
// Splitting until the surface is met within a distance and its topology is resolved: the rule that
// goes beyond paper 5.1.2.
//
// Geometry. A leaf gives each piece of the surface in it one vertex, at the minimum of its hits'
// planes. The piece is met if every corner of its triangles, cut to the cell, lies within the
// tolerance of one of those planes, the vertex within it of all of them, and the vertex within it
// of the piece.
// Topology. Every piece is a disk that reaches the cell's edges, no face of the cell holds a closed
// curve, no closed part lies all round one edge, and no two triangles cross (cell_analysis.h).
// Where no leaf fails, the input comes out homeomorphic.
// Small parts. What a part needs to come out at all, cut where it is best placed, often meets the
// tolerance too. So topology comes first among them, and they are separated before any is cut.
// Sheets. A vertex on the rim must meet the planes through it as well; pieces may be half-disks.
// Where sheets cross, each keeps its own vertices.
// Holes. Where a surface that is to be closed ends, its vertices belong on the rim as a sheet's do;
// what closes it takes part in neither geometry nor topology.
// Overlap. Where shells cross, their pieces bound the solid together: one vertex must fit them all,
// as it does on the crease of their union. Topology is neither pursued nor claimed there.
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "geometry/distance.h"
#include "geometry/quadric.h"
#include "geometry/triangle_box.h"
#include "prepare/rim.h"
#include "split/cell_analysis.h"
#include "split/feature_point.h"
#include "split/part_cuts.h"
#include "split/split_rules.h"

namespace kdm {
namespace {

// Rounding moves the surface by less than a lattice unit; nothing finer can be asked for.
constexpr double kFinestTolerance = 2.0;
// Topology is not pursued in cells smaller than this fraction of the tolerance: where the input is
// not embedded it never resolves.
constexpr double kFloor = 1.0 / 8;
// And no split is made nearer to a cell's side than this fraction of that, for slabs of a few
// lattice units are too thin for vertices in 32 bits.
constexpr double kLeastWidth = 1.0 / 4;
// Nor are cells cut along where they are thinner than this fraction of that.
constexpr double kThin = 1.0 / 16;
// A bar reaches this much further to a side, at most, than its section with a face does, if it is
// to be cut along that side's middle.
constexpr double kLean = 2;
// Edges between faces whose normals differ by more than this (45 degrees) are sharp.
constexpr double kSharpCosine = 0.7071067811865476;
// Hits that neighbours' splits add move a vertex a little: it keeps to a sharp edge by this part of
// the tolerance.
constexpr double kSharper = 0.9;
// Above this many triangles a cell is split on the first sign of misfit even where shells may hide
// others.
constexpr std::size_t kMany = 64;

// A hit to be, with its plane.
struct PlannedHit {
  Vec3 point;
  const Plane* plane;
  Index piece;
};

class AdaptiveRule : public SplitRule {
 public:
  AdaptiveRule(const Surface& surface, double tolerance, int depth, SplitPlacing placing)
      : surface_(surface),
        analysis_(surface),
        tolerance_(std::max(tolerance, kFinestTolerance)),
        floor_(std::max(kFloor * tolerance, 1.0)),
        least_(static_cast<std::int32_t>(
            std::clamp(kLeastWidth * floor_, 1.0, static_cast<double>(kLatticeSize)))),
        depth_(depth),
        placing_(placing),
        open_(std::count(surface.topology.opposite.begin(), surface.topology.opposite.end(),
                         kNone) > 0),
        features_(surface),
        parts_(surface) {}

  std::optional<Split> choose(const CellView& cell) override {
    // An octree's cell is cut in eight or not at all.
    if (placing_ == SplitPlacing::kInTurn && cell.depth % 3 != 0) return halve(cell);
    collect_crossings(cell);
    // Whatever lies in a cell smaller than the tolerance is met.
    const bool small = diagonal(cell.box) <= tolerance_;
    const bool small_parts = find_small_parts(cell);
    const bool simple = !hits_.empty() && !dropped_;
    if (!small && !small_parts && (simple || cell.entries.size() > kMany) && quick_misfit(cell)) {
      return halve(cell);
    }
    analysis_.find_pieces(cell.box, cell.entries, crossings_);
    if (analysis_.members().empty()) return std::nullopt;
    assign_pieces();
    // Crossings drop out where shells cross and where one lies within another.
    overlap_ = (dropped_ && analysis_.triangles_cross()) || several_rims();
    std::optional<LatticeBox> target;
    if (small_parts) {
      target = unresolved_part(cell.box);
      if (target && !below_floor(cell.box)) return pursue(cell, *target);
    }
    if (!small && !pieces_fit(cell.box)) return halve(cell);
    if (!small_parts) target = unresolved_part(cell.box);
    if (target) return pursue(cell, *target);
    if (surface_.sheet) return std::nullopt;
    if (overlap_) return give_up();
    if (dropped_ || !analysis_.triangles_cross()) return std::nullopt;
    overlap_ = true;
    return small || pieces_fit(cell.box) ? give_up() : halve(cell);
  }

  void report(GridStats& stats) const override {
    stats.unresolved_leaves = unresolved_;
    stats.topology_resolved = unresolved_ == 0;
  }

 private:
  // Is topology to come first here? Not among parts that crowd without a plane between them: each
  // would be cut to its end before the next.
  bool find_small_parts(const CellView& cell) {
    between_parts_.reset();
    if (placing_ == SplitPlacing::kInTurn || open_ || !parts_.all_small(cell.entries)) {
      return false;
    }
    between_parts_ = parts_.propose(cell.entries);
    return between_parts_ || !parts_.crowded(cell.entries);
  }

  // Leaf because it must be one.
  std::optional<Split> give_up() {
    ++unresolved_;
    return std::nullopt;
  }

  std::optional<Split> halve(const CellView& cell) {
    if (cell.depth >= depth_) return give_up();
    if (placing_ == SplitPlacing::kInTurn) {
      const std::optional<Split> split = midpoint_in_turn(cell.box, cell.depth);
      return split ? split : give_up();
    }
    if (placing_ == SplitPlacing::kFeature) {
      if (const std::optional<Split> split = features_.propose(cell.box, cell.entries))
        return split;
    }
    return halve_longest(cell);
  }

  std::optional<Split> halve_longest(const CellView& cell) {
    const int axis = longest_axis(cell.box);
    return split_at(cell, axis, cell.box.lo[axis] + extent(cell.box, axis) / 2);
  }

  std::optional<Split> split_at(const CellView& cell, int axis, std::int32_t value) {
    if (cell.depth >= depth_) return give_up();
    if (placing_ == SplitPlacing::kInTurn) return halve(cell);
    const LatticeBox& box = cell.box;
    if (extent(box, axis) < 2 * least_) {
      axis = longest_axis(box);
      if (extent(box, axis) < 2 * least_) return give_up();
    }
    return Split{axis, std::clamp(value, box.lo[axis] + least_, box.hi[axis] - least_)};
  }

  bool has_room(const LatticeBox& box, const Split& split) const {
    return split.value - box.lo[split.axis] >= least_ && box.hi[split.axis] - split.value >= least_;
  }

  static double diagonal(const LatticeBox& box) {
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
      const double side = extent(box, i);
      sum += side * side;
    }
    return std::sqrt(sum);
  }

  void collect_crossings(const CellView& cell) {
    crossings_.all.clear();
    crossings_.round_face = {};
    hits_.clear();
    dropped_ = overlap_ = false;
    for (int axis = 0; axis < 3; ++axis) {
      const int u = next_axis(axis);
      const int v = previous_axis(axis);
      for (int bits = 0; bits < 4; ++bits) {
        const bool high_u = (bits & 1) != 0;
        const bool high_v = (bits & 2) != 0;
        const int number = cell_edge(axis, high_u, high_v);
        const EdgeRange edge = cell.edges[number];
        crossings_.round_face[u][high_u ? 1 : 0] += edge.end - edge.begin;
        crossings_.round_face[v][high_v ? 1 : 0] += edge.end - edge.begin;
        Vec3 point;
        point[u] = high_u ? cell.box.hi[u] : cell.box.lo[u];
        point[v] = high_v ? cell.box.hi[v] : cell.box.lo[v];
        for (Index i = edge.begin; i < edge.end; ++i) {
          const ClassifiedCrossing& crossing = cell.crossings[i];
          const TriangleId triangle = crossing.triangle();
          const bool kept = crossing.kept();
          crossings_.all.push_back({triangle, number, kept});
          dropped_ = dropped_ || !kept;
          if (!kept) continue;
          point[axis] = real_position(crossing.position());
          hits_.push_back({point, &surface_.planes[triangle], triangle});
        }
      }
    }
  }

  // Do two pieces that will be closed end here? What closes one may lead to the other.
  bool several_rims() const {
    if (!surface_.repair) return false;
    const std::span<const Index> rims = analysis_.rims();
    return std::any_of(rims.begin(), rims.end(), [&](Index side) {
      return analysis_.piece_of_triangle(side / 3) != analysis_.piece_of_triangle(rims[0] / 3);
    });
  }

  // Corners of the triangles against all hits' planes: yes means yes, no means look closer.
  bool quick_misfit(const CellView& cell) {
    // Crossings but no hits: all that is in the cell may lie inside other shells.
    if (hits_.empty()) return crossings_.all.empty();
    for (const ListEntry& entry : cell.entries) {
      for (const LatticePoint& p : surface_.triangles[entry.triangle]) {
        if (!vertex_in_box(p, cell.box)) continue;
        if (!is_met(to_vec3(p), kNone)) return true;
      }
    }
    return false;
  }

  // Is the point within the tolerance of the plane of one of the piece's hits (of all hits for
  // kNone)? It often is of the one that was found last.
  bool is_met(const Vec3& p, Index piece) {
    const auto meets = [&](std::size_t i) {
      return together(hits_[i].piece, piece) && hits_[i].plane->distance(p) <= tolerance_;
    };
    if (found_ < hits_.size() && meets(found_)) return true;
    for (std::size_t i = 0; i < hits_.size(); ++i) {
      if (!meets(i)) continue;
      found_ = i;
      return true;
    }
    return false;
  }

  // Do the two share a vertex?
  bool together(Index a, Index b) const { return a == b || overlap_ || b == kNone; }

  void assign_pieces() {
    for (PlannedHit& hit : hits_) hit.piece = analysis_.piece_of_triangle(hit.piece);
  }

  bool pieces_fit(const LatticeBox& box) {
    const std::span<const Piece> pieces = analysis_.pieces();
    for (Index i = 0; i < pieces.size(); ++i) {
      if (pieces[i].kept == 0) continue;
      if (!vertex_fits(box, i)) return false;
      if (overlap_) break;
    }
    const std::span<const Index> members = analysis_.members();
    for (std::size_t m = 0; m < members.size(); ++m) {
      const Index piece = analysis_.piece_of(m);
      if (pieces[piece].kept == 0) continue;  // no vertex here: left to topology
      const ClippedPolygon part = clip_to_box(surface_.triangles[members[m]], box);
      for (int i = 0; i < part.size; ++i) {
        if (!is_met(part.corners[i], piece)) return false;
      }
    }
    return true;
  }

  // Is the member part of what the piece's vertex stands for?
  bool shows_in(std::size_t member, Index piece) const {
    const Index own = analysis_.piece_of(member);
    return together(own, piece) && analysis_.pieces()[own].kept > 0;
  }

  bool vertex_fits(const LatticeBox& box, Index piece) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    for (const PlannedHit& hit : hits_) {
      if (!together(hit.piece, piece)) continue;
      sum += hit.point;
      ++count;
    }
    if (surface_.has_rims()) find_rim(box, piece);
    PrimalQuadric quadric(rim_.empty() ? Vec3(sum / count) : rim_centre_);
    for (const PlannedHit& hit : hits_) {
      if (together(hit.piece, piece)) quadric.add(*hit.plane);
    }
    for (const Plane& plane : rim_) {
      const double weight = std::sqrt(2.0 / static_cast<double>(rim_.size()));  // two will count
      quadric.add({weight * plane.normal, weight * plane.offset});
    }
    const auto residual = [&](const Vec3& x) {
      double largest = 0;
      for (const PlannedHit& hit : hits_) {
        if (!together(hit.piece, piece)) continue;
        largest = std::max(largest, hit.plane->distance(x));
      }
      for (const Plane& plane : rim_) largest = std::max(largest, plane.distance(x));
      return largest;
    };
    const Vec3 vertex =
        minimiser_within(quadric, to_vec3(box.lo), to_vec3(box.hi), tolerance_, residual).point;
    // Splits of neighbours may yet put hits on any of the piece's triangles.
    const std::span<const Index> members = analysis_.members();
    for (std::size_t m = 0; m < members.size(); ++m) {
      if (!shows_in(m, piece)) continue;
      if (surface_.planes[members[m]].distance(vertex) > tolerance_) return false;
    }
    for (const Plane& plane : rim_) {
      if (plane.distance(vertex) > tolerance_) return false;
    }
    return near_piece(vertex, piece) && near_sharp_edge(vertex, box, piece);
  }

  // The planes through the piece's rim, and its centre.
  void find_rim(const LatticeBox& box, Index piece) {
    rim_.clear();
    rim_centre_ = Vec3::Zero();
    for (const Index side : analysis_.rims()) {
      if (!together(analysis_.piece_of_triangle(side / 3), piece)) continue;
      rim_.push_back(rim_plane(surface_, side, surface_.planes[side / 3].normal));
      rim_centre_ += rim_middle(surface_, side, box);
    }
    if (!rim_.empty()) rim_centre_ /= static_cast<double>(rim_.size());
  }

  bool near_piece(const Vec3& vertex, Index piece) const {
    const std::span<const Index> members = analysis_.members();
    for (std::size_t m = 0; m < members.size(); ++m) {
      if (!shows_in(m, piece)) continue;
      const LatticeTriangle& triangle = surface_.triangles[members[m]];
      if (squared_distance(vertex, to_vec3(triangle[0]), to_vec3(triangle[1]),
                           to_vec3(triangle[2])) <= tolerance_ * tolerance_) {
        return true;
      }
    }
    return false;
  }

  // Within the tolerance of both faces is not within it of the edge. Is the vertex near one of the
  // piece's sharp edges, if it lies beside any?
  bool near_sharp_edge(const Vec3& vertex, const LatticeBox& box, Index piece) const {
    const double limit = kSharper * tolerance_;
    const std::span<const Index> members = analysis_.members();
    bool beside = false;
    for (std::size_t m = 0; m < members.size(); ++m) {
      if (!shows_in(m, piece)) continue;
      const Index triangle = members[m];
      for (int i = 0; i < 3; ++i) {
        const SideId opposite = surface_.topology.opposite[3 * triangle + static_cast<Index>(i)];
        if (opposite == kNone) continue;
        const Vec3& normal = surface_.planes[triangle].normal;
        if (normal.dot(surface_.planes[opposite / 3].normal) >= kSharpCosine) continue;
        const LatticePoint& a = surface_.triangles[triangle][i];
        const LatticePoint& b = surface_.triangles[triangle][next_corner(i)];
        if (!edge_meets_box(a, b, box)) continue;
        const Vec3 along = to_vec3(b) - to_vec3(a);
        const double foot = along.dot(vertex - to_vec3(a)) / along.squaredNorm();
        if (foot < 0 || foot > 1) continue;
        if ((to_vec3(a) + foot * along - vertex).squaredNorm() <= limit * limit) return true;
        beside = true;
      }
    }
    return !beside;
  }

  // Where the cell must be divided for the sake of topology.
  std::optional<LatticeBox> unresolved_part(const LatticeBox& box) {
    const std::span<const Piece> pieces = analysis_.pieces();
    // Pieces whose crossings all lie within the solid (or outside) bound nothing.
    const bool all_internal = std::all_of(pieces.begin(), pieces.end(), [](const Piece& piece) {
      return piece.crossings > 0 && piece.kept == 0;
    });
    if (all_internal) return std::nullopt;
    const bool disks = analysis_.pieces_are_disks();
    if (disks || !open_) {
      if (const std::optional<ClosedCurve> curve = analysis_.find_closed_curve()) {
        if (const std::optional<LatticeBox> part = part_to_open(*curve, disks)) return part;
      }
    }
    if (!disks) return unresolved_bounds(box);
    if (const std::optional<Index> pillow = analysis_.find_pillow()) {
      const Piece& piece = pieces[*pillow];
      const int along = std::countr_zero(piece.edges) / 4;
      LatticeBox bounds = piece.bounds;
      bounds.hi[next_axis(along)] = bounds.lo[next_axis(along)];
      bounds.hi[previous_axis(along)] = bounds.lo[previous_axis(along)];
      return bounds;  // of which only the extent along the edge counts
    }
    return std::nullopt;
  }

  // A plane through the middle of a closed curve opens it. So a bar is cut along, where cuts across
  // would leave slices as thick as they are wide; unless it leans out of the plane before it ends.
  std::optional<LatticeBox> part_to_open(const ClosedCurve& curve, bool disks) const {
    const LatticeBox& piece = analysis_.pieces()[curve.piece].bounds;
    LatticeBox bounds = curve.bounds;
    bounds.hi[curve.axis] = bounds.lo[curve.axis];  // never in the face's own plane
    if (disks) return bounds;
    bool upright = false;
    for (const int axis : {next_axis(curve.axis), previous_axis(curve.axis)}) {
      if (extent(piece, axis) > kLean * extent(curve.bounds, axis)) {
        bounds.hi[axis] = bounds.lo[axis];
      } else {
        upright = true;
      }
    }
    return upright ? std::optional(bounds) : std::nullopt;
  }

  double floor() const {
    return surface_.repair && !analysis_.rims().empty() ? tolerance_ : floor_;
  }

  bool below_floor(const LatticeBox& box) const { return extent(box, longest_axis(box)) < floor(); }

  // Splits between parts, or in the middle of what is not resolved, down to the floor.
  std::optional<Split> pursue(const CellView& cell, const LatticeBox& target) {
    if (below_floor(cell.box)) return give_up();
    if (between_parts_ && cell.depth < depth_ && has_room(cell.box, *between_parts_)) {
      return between_parts_;
    }
    const int axis = longest_axis(target);
    // A spike of a sheet has two rims at any size: it would be followed to its tip.
    if (surface_.has_rims() && extent(target, axis) < floor_) return give_up();
    // Where the input is not embedded curves stay closed.
    if (extent(cell.box, axis) < kThin * floor_) return halve_longest(cell);
    return split_at(cell, axis, target.lo[axis] + extent(target, axis) / 2);
  }

  // A piece that no edge of the cell meets, or that lies between two rims; else all of them.
  LatticeBox unresolved_bounds(const LatticeBox& box) const {
    const std::span<const Piece> pieces = analysis_.pieces();
    for (const Piece& piece : pieces) {
      if (piece.crossings == 0 || piece.rims > 1) return piece.bounds;
    }
    if (open_) return box;
    LatticeBox bounds = pieces.front().bounds;
    for (const Piece& piece : pieces) widen(bounds, piece.bounds);
    return bounds;
  }

  const Surface& surface_;
  CellAnalysis analysis_;
  double tolerance_;
  double floor_;
  std::int32_t least_;
  int depth_;
  SplitPlacing placing_;
  bool open_;  // the surface has a rim
  FeatureFinder features_;
  PartCuts parts_;
  std::optional<Split> between_parts_;  // a cut between small parts, if there is one
  bool dropped_ = false;                // not all of the cell's crossings are kept
  bool overlap_ = false;                // shells cross in this cell
  Index unresolved_ = 0;
  CellCrossings crossings_;
  std::vector<PlannedHit> hits_;
  std::size_t found_ = 0;   // the hit by whose plane a point was met last
  std::vector<Plane> rim_;  // of the piece at hand
  Vec3 rim_centre_;
};

}  // namespace

std::unique_ptr<SplitRule> make_adaptive_rule(const Surface& surface, double tolerance, int depth,
                                              SplitPlacing placing) {
  return std::make_unique<AdaptiveRule>(surface, tolerance, depth, placing);
}

}  // namespace kdm
