// SPDX-License-Identifier: MIT
// Tests positions by samples, in the way in which `reduce` does it (reduce/near_test.h).
#include "simplify/near_surface.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// How far points along an edge are apart, in allowed distances, and how many there are at most.
constexpr double kSpacing = 2;
constexpr int kMostPieces = 32;
// Further than anything within the root cell.
constexpr double kFar = 4.0 * kLatticeSize;

int pieces_of(double length, double distance) {
  return static_cast<int>(std::clamp(length / (kSpacing * distance) + 1, 2.0, 1.0 * kMostPieces));
}

std::vector<std::array<Vec3, 3>> lattice_triangles(const Mesh& mesh, const Lattice& lattice) {
  std::vector<std::array<Vec3, 3>> triangles;
  triangles.reserve(mesh.triangles.size());
  const auto at = [&](Index p) {
    return lattice.to_lattice({mesh.positions[p][0], mesh.positions[p][1], mesh.positions[p][2]});
  };
  for (const Triangle& t : mesh.triangles) triangles.push_back({at(t[0]), at(t[1]), at(t[2])});
  return triangles;
}

std::vector<std::array<Vec3, 3>> hit_triangles(const WorkGrid& work) {
  std::vector<std::array<Vec3, 3>> triangles;
  triangles.reserve(work.grid.hits.size());
  for (HitId h = 0; h < work.grid.hits.size(); ++h) triangles.push_back(work.corners(h));
  return triangles;
}

// Fills the ring as it would be round the piece's vertex, but for the vertex itself.
void fill_ring(const WorkGrid& work, const JoinedPiece& piece, CollapseRing& ring) {
  ring.gone.assign(piece.gone.begin(), piece.gone.end());
  ring.triangles.clear();
  for (const HalfEdgeId h : piece.ring) {
    const HalfEdgeId second = work.next(h);
    const LoopId from = work.loop[second];
    const LoopId to = work.loop[work.next(second)];
    ring.triangles.push_back({h / 3, from, to, kNone, work.position[from], work.position[to],
                              work.position[work.loop[h]]});
  }
}

// Tells whether a triangle is turned away from its hit's plane. One without area is not.
bool is_turned(const Plane& plane, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double kThin = 1e-6;
  const Vec3 normal = doubled_area_vector(a, b, c);
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return normal.norm() > kThin * longest && normal.dot(plane.normal) < 0;
}

bool turns_over(const WorkGrid& work, const CollapseRing& ring) {
  return std::any_of(ring.triangles.begin(), ring.triangles.end(), [&](const RingTriangle& t) {
    const Plane& plane = work.grid.plane_of(t.number);
    return is_turned(plane, ring.point, t.from_point, t.to_point) &&
           !is_turned(plane, t.old_point, t.from_point, t.to_point);
  });
}

}  // namespace

NearSurface::NearSurface(const WorkGrid& work, const Mesh& reference, double distance)
    : distance_(distance),
      reference_(lattice_triangles(reference, work.grid.lattice)),
      samples_(static_cast<Index>(work.grid.hits.size())) {
  // Some points are far from the triangles, where `extract` adds vertices to them: no removal
  // passes there that does not bring the triangles near.
  const Reference surface(hit_triangles(work));
  TriangleId hint = kNone;
  const auto add = [&](const Vec3& point, TriangleId t) {
    const TriangleId place = surface.nearest(point, kFar, hint);
    samples_.add(point, place, t);
    hint = place;
  };
  Marks seen(reference.positions.size());
  for (TriangleId t = 0; t < reference_.size(); ++t) {
    const std::array<Vec3, 3>& c = reference_.corners(t);
    for (int i = 0; i < 3; ++i) {
      if (!seen.test_and_set(reference.triangles[t][i])) add(c[i], t);
      const Index next = reference.triangles[t][(i + 1) % 3];
      if (!work.grid.sheet && next < reference.triangles[t][i]) continue;  // the neighbour's
      const Vec3 along = c[(i + 1) % 3] - c[i];
      const int pieces = pieces_of(along.norm(), distance_);
      for (int k = 1; k < pieces; ++k) add(c[i] + (static_cast<double>(k) / pieces) * along, t);
    }
    add((c[0] + c[1] + c[2]) / 3, t);
  }
}

// Looks at rows of points between the sides of the triangle that meet at the new vertex, along
// these sides too.
bool NearSurface::is_near(const RingTriangle& t, TriangleId hint) {
  if (hint != kNone) near_ = hint;
  const Vec3 from = t.from_point - ring_.point;
  const Vec3 to = t.to_point - ring_.point;
  const int rows = pieces_of(std::max(from.norm(), to.norm()), distance_);
  for (int row = 1; row < rows; ++row) {
    const double out = static_cast<double>(row) / rows;
    const int pieces = pieces_of(out * (to - from).norm(), distance_);
    for (int i = 0; i <= pieces; ++i) {
      const double across = static_cast<double>(i) / pieces;
      const Vec3 point = ring_.point + out * ((1 - across) * from + across * to);
      if (!reference_.is_near(point, distance_, near_)) return false;
    }
  }
  return true;
}

bool NearSurface::fits(const WorkGrid& work) {
  if (turns_over(work, ring_) || !samples_.fit(ring_, distance_, places_)) return false;
  if (!reference_.is_near(ring_.point, distance_, near_)) return false;
  for (std::size_t i = 0; i < ring_.triangles.size(); ++i) {
    if (!is_near(ring_.triangles[i], places_.hint(i))) return false;
  }
  return true;
}

bool NearSurface::find_position(const WorkGrid& work, const JoinedPiece& piece,
                                const LatticeBox& box, Vec3& position) {
  Vec3 sum = Vec3::Zero();
  for (const LoopId v : piece.loops) sum += work.position[v];
  const Vec3 lo = to_vec3(box.lo);
  const Vec3 hi = to_vec3(box.hi);
  const Vec3 middle = (sum / static_cast<double>(piece.loops.size())).cwiseMax(lo).cwiseMin(hi);
  PrimalQuadric planes(middle);
  for (const LoopId v : piece.loops) planes.add(work.planes[v]);
  std::vector<Vec3> candidates;
  for (const LoopId v : piece.loops) candidates.push_back(work.position[v]);
  sort_by(candidates,
          [&](const Vec3& a, const Vec3& b) { return planes.error(a) < planes.error(b); });
  candidates.insert(candidates.begin(), planes.minimiser_in(lo, hi));
  fill_ring(work, piece, ring_);
  for (const Vec3& candidate : candidates) {
    ring_.point = candidate;
    if (!fits(work)) continue;
    position = candidate;
    return true;
  }
  return false;
}

void NearSurface::move(const WorkGrid& work, const JoinedPiece& piece, const Vec3& position) {
  fill_ring(work, piece, ring_);
  ring_.point = position;
  samples_.fit(ring_, distance_, places_);
  samples_.move(ring_, places_);
}

}  // namespace kdm
