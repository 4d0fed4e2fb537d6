// SPDX-License-Identifier: MIT
#include "split/fit_check.h"

#include <algorithm>
#include <cmath>

#include "geometry/distance.h"
#include "geometry/quadric.h"
#include "geometry/triangle_box.h"
#include "prepare/rim.h"

namespace kdm {
namespace {

// An edge is sharp if its faces' normals differ by more than 45 degrees.
constexpr double kSharpCosine = 0.7071067811865476;
// The sides of a knife's edge differ by more than 120 degrees.
constexpr double kKnifeCosine = -0.5;
// A vertex keeps to a sharp edge within this fraction of the tolerance. The rest is left for the
// hits which splits of neighbouring cells will add, and which move the vertex a little.
constexpr double kSharpEdgeShare = 0.9;
// The planes through a rim weigh as much as this many planes of hits, however many they are.
constexpr double kRimWeight = 2;

// Returns how much of the segment from p to q lies in the box.
double length_within(const Vec3& p, const Vec3& q, const LatticeBox& box) {
  const Vec3 along = q - p;
  double from = 0;
  double to = 1;
  for (int axis = 0; axis < 3; ++axis) {
    if (along[axis] == 0) continue;  // the edge meets the box
    const double a = (box.lo[axis] - p[axis]) / along[axis];
    const double b = (box.hi[axis] - p[axis]) / along[axis];
    from = std::max(from, std::min(a, b));
    to = std::min(to, std::max(a, b));
  }
  return std::max(to - from, 0.0) * along.norm();
}

}  // namespace

bool FitCheck::is_clear_misfit(const LatticeBox& box, std::span<const ListEntry> entries,
                               const CellCrossings& crossings) {
  if (hits_.empty()) return crossings.all.empty();
  for (const ListEntry& entry : entries) {
    for (const LatticePoint& p : surface_.triangles[entry.triangle]) {
      if (!vertex_in_box(p, box)) continue;
      if (!hits_.meets_a_plane(to_vec3(p), kAllPieces, tolerance_)) return true;
    }
  }
  return joint_vertex_misses(box, crossings);
}

// Tells whether all hits are sure to be of one piece whose vertex lies off one of their planes.
bool FitCheck::joint_vertex_misses(const LatticeBox& box, const CellCrossings& crossings) {
  if (surface_.has_rims() || crossings.some_dropped() || !crossings.form_one_loop()) return false;
  limit_ = tolerance_;
  rim_planes_.clear();
  joint_vertex_ = planned_vertex(box, kAllPieces);
  const std::span<const PlannedHit> hits = hits_.all();
  return std::any_of(hits.begin(), hits.end(), [&](const PlannedHit& hit) {
    return hit.plane->distance(*joint_vertex_) > limit_;
  });
}

bool FitCheck::pieces_fit(const CellSurface& cell, LeafVertices vertices) {
  limit_ = vertices == LeafVertices::kOneForAll ? shared_tolerance_ : tolerance_;
  if (limit_ != tolerance_) joint_vertex_.reset();
  hits_.assign_pieces(cell);
  const std::span<const Piece> pieces = cell.pieces.all();
  if (vertices == LeafVertices::kOneForAll && hits_.empty()) return nothing_bounds(cell);
  for (PieceId i = 0; i < pieces.size(); ++i) {
    if (pieces[i].kept == 0) continue;
    const bool one_for_all = vertices == LeafVertices::kOneForAll;
    if (!piece_fits_vertex(cell, one_for_all ? kAllPieces : i)) return false;
    if (one_for_all) break;
  }
  return corners_meet_planes(cell, vertices);
}

// Tells whether the member may bound the solid. Where nobody looked at the triangles, pieces
// without hits count as inner.
bool FitCheck::bounds_solid(const CellSurface& cell, MemberId member) {
  if (cell.is_inner(member)) return false;
  return !cell.inner.empty() || cell.pieces.all()[cell.pieces.piece_of(member)].kept > 0;
}

bool FitCheck::nothing_bounds(const CellSurface& cell) {
  for (MemberId m = 0; m < cell.triangles.size(); ++m) {
    if (bounds_solid(cell, m)) return false;
  }
  return true;
}

bool FitCheck::corners_meet_planes(const CellSurface& cell, LeafVertices vertices) {
  for (MemberId m = 0; m < cell.triangles.size(); ++m) {
    if (!bounds_solid(cell, m)) continue;
    const PieceId piece =
        vertices == LeafVertices::kOneForAll ? kAllPieces : cell.pieces.piece_of(m);
    // Where all of the triangle is near a plane, what is cut from it is, too.
    const LatticeTriangle& t = cell.triangles.corners(m);
    if (hits_.triangle_meets_a_plane(t, piece, limit_)) continue;
    const ClippedPolygon part = clip_to_box(t, cell.triangles.cell());
    for (int i = 0; i < part.size; ++i) {
      if (cell.is_inner_at(m, i)) continue;
      if (!hits_.meets_a_plane(part.corners[i], piece, limit_)) return false;
    }
  }
  return true;
}

bool FitCheck::piece_fits_vertex(const CellSurface& cell, PieceId piece) {
  find_triangles(cell, piece);
  find_rim(cell, piece);
  const LatticeBox& box = cell.triangles.cell();
  const Vec3 vertex = joint_vertex_ ? *joint_vertex_ : planned_vertex(box, piece);
  return is_near_planes(vertex) && is_near_triangles(vertex) && is_near_sharp_edge(vertex, cell);
}

// Finds the triangles that the piece's vertex will stand for.
void FitCheck::find_triangles(const CellSurface& cell, PieceId piece) {
  triangles_.clear();
  for (MemberId m = 0; m < cell.triangles.size(); ++m) {
    const bool shares = piece == kAllPieces || cell.pieces.piece_of(m) == piece;
    if (shares && bounds_solid(cell, m)) triangles_.push_back(cell.triangles.triangle(m));
  }
}

// Finds the planes through the rim of the piece, and the centre of the rim.
void FitCheck::find_rim(const CellSurface& cell, PieceId piece) {
  rim_planes_.clear();
  rim_centre_ = Vec3::Zero();
  for (const SideId side : cell.pieces.rim_sides()) {
    if (piece != kAllPieces && cell.piece_of_rim(side) != piece) continue;
    rim_planes_.push_back(rim_plane(surface_, side, surface_.planes[triangle_of(side)].normal));
    rim_centre_ += rim_middle(surface_, side, cell.triangles.cell());
  }
  if (!rim_planes_.empty()) rim_centre_ /= static_cast<double>(rim_planes_.size());
}

Vec3 FitCheck::planned_vertex(const LatticeBox& box, PieceId piece) const {
  Vec3 centre = rim_centre_;
  if (rim_planes_.empty()) {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    hits_.for_each_of(piece, [&](const PlannedHit& hit) {
      sum += hit.point;
      ++count;
    });
    centre = sum / count;
  }
  PrimalQuadric quadric(centre);
  hits_.for_each_of(piece, [&](const PlannedHit& hit) { quadric.add(*hit.plane); });
  for (const Plane& plane : rim_planes_) {
    const double weight = std::sqrt(kRimWeight / static_cast<double>(rim_planes_.size()));
    quadric.add({weight * plane.normal, weight * plane.offset});
  }
  const auto largest_distance = [&](const Vec3& x) {
    double largest = 0;
    hits_.for_each_of(
        piece, [&](const PlannedHit& hit) { largest = std::max(largest, hit.plane->distance(x)); });
    for (const Plane& plane : rim_planes_) largest = std::max(largest, plane.distance(x));
    return largest;
  };
  const auto is_knife = [&] {
    if (surface_.sheet || !rim_planes_.empty()) return false;
    std::vector<const Plane*> planes;
    hits_.for_each_of(piece, [&](const PlannedHit& hit) { planes.push_back(hit.plane); });
    return some_face_away(planes);
  };
  return minimiser_within(quadric, to_vec3(box.lo), to_vec3(box.hi), limit_, largest_distance,
                          is_knife)
      .point;
}

bool FitCheck::is_near_planes(const Vec3& vertex) const {
  return std::all_of(triangles_.begin(), triangles_.end(),
                     [&](TriangleId t) { return surface_.planes[t].distance(vertex) <= limit_; }) &&
         std::all_of(rim_planes_.begin(), rim_planes_.end(),
                     [&](const Plane& plane) { return plane.distance(vertex) <= limit_; });
}

bool FitCheck::is_near_triangles(const Vec3& vertex) const {
  return std::any_of(triangles_.begin(), triangles_.end(), [&](TriangleId t) {
    const auto& [a, b, c] = surface_.triangles[t];
    return squared_distance(vertex, to_vec3(a), to_vec3(b), to_vec3(c)) <= limit_ * limit_;
  });
}

// A vertex within the tolerance of two faces may be further from the edge between them. Tells
// whether the vertex is near a sharp edge of the piece, or beside none. Of a knife, the faces are
// within the tolerance far from the edge: the vertex must be near each such edge, but for those
// that pass through a corner of the cell.
bool FitCheck::is_near_sharp_edge(const Vec3& vertex, const CellSurface& cell) const {
  const double limit = kSharpEdgeShare * limit_;
  bool beside = false;
  bool near = false;
  for (const TriangleId triangle : triangles_) {
    for (int i = 0; i < 3; ++i) {
      const SideId opposite = surface_.topology.opposite[3 * triangle + static_cast<Index>(i)];
      if (opposite == kNone) continue;
      const MemberId neighbour = cell.triangles.member_of(triangle_of(opposite));
      if (neighbour != kNone && cell.is_inner(neighbour)) continue;
      const double cosine =
          surface_.planes[triangle].normal.dot(surface_.planes[triangle_of(opposite)].normal);
      if (cosine >= kSharpCosine) continue;
      const LatticeTriangle& t = surface_.triangles[triangle];
      const MemberId member = cell.triangles.member_of(triangle);
      if (!edge_meets_box(t, cell.triangles.outcodes(member), i, cell.triangles.cell())) continue;
      const LatticePoint& a = t[i];
      const LatticePoint& b = t[next_corner(i)];
      const Vec3 along = to_vec3(b) - to_vec3(a);
      const double foot = along.dot(vertex - to_vec3(a)) / along.squaredNorm();
      if (foot < 0 || foot > 1) continue;
      if ((to_vec3(a) + foot * along - vertex).squaredNorm() <= limit * limit) {
        near = true;
      } else if (cosine < kKnifeCosine &&
                 length_within(to_vec3(a), to_vec3(b), cell.triangles.cell()) > limit_) {
        return false;
      }
      beside = true;
    }
  }
  return near || !beside;
}

}  // namespace kdm
