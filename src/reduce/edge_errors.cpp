// SPDX-License-Identifier: MIT
// Sums planes up at vertices.
#include "reduce/edge_errors.h"

#include <algorithm>

#include "geometry/triangle.h"
#include "mesh/boxes.h"

namespace kdm {
namespace {

// Distances to planes count as equal if they differ by less than 1e-5 of the edge's length.
constexpr double kAsGood = 1e-10;

Vec3 rounded_to_single(const Vec3& p) { return p.cast<float>().cast<double>(); }

Vec3 centre_of_all(const std::vector<Vec3>& positions) {
  Box box;
  for (const Vec3& p : positions) grow(box, p);
  return centre_of(box);
}

}  // namespace

EdgeErrors::EdgeErrors(const Workpiece& piece, const KeptLines& lines)
    : piece_(piece), centre_(centre_of_all(piece.positions)), quadric_(piece.positions.size()) {
  add_triangles();
  if (lines.any()) add_lines(lines);
}

void EdgeErrors::add_triangles() {
  for (TriangleId t = 0; t < piece_.mesh.triangles(); ++t) {
    const Triangle c = piece_.mesh.corners(t);
    const Vec3 a = piece_.positions[c[0]] - centre_;
    const Vec3 doubled =
        doubled_area_vector(a, piece_.positions[c[1]] - centre_, piece_.positions[c[2]] - centre_);
    const double length = doubled.norm();
    if (!(length > 0)) continue;
    const Vec3 normal = doubled / length;
    for (const VertexId v : c) quadric_[v].add_plane(normal, normal.dot(a), length);
  }
}

// Planes through the lines, perpendicular to the triangles beside them, hold vertices there as
// those of triangles do on the surface.
void EdgeErrors::add_lines(const KeptLines& lines) {
  for (SideId h = 0; h < 3 * piece_.mesh.triangles(); ++h) {
    const TriangleId t = triangle_of(h);
    if (piece_.mesh.is_removed(t) || !lines.is_line(h)) continue;
    const Triangle c = piece_.mesh.corners(t);
    const Vec3 start = piece_.positions[piece_.mesh.start(h)] - centre_;
    const Vec3 along = piece_.positions[piece_.mesh.end(h)] - centre_ - start;
    const Vec3 across = normalized_or_zero(along.cross(
        unit_normal(piece_.positions[c[0]], piece_.positions[c[1]], piece_.positions[c[2]])));
    if (across.isZero()) continue;
    for (const VertexId v : {piece_.mesh.start(h), piece_.mesh.end(h)}) {
      quadric_[v].add_plane(across, across.dot(start), along.squaredNorm());
    }
  }
}

ErrorQuadric EdgeErrors::quadric_of(SideId edge) const {
  ErrorQuadric sum = quadric_[piece_.mesh.start(edge)];
  sum += quadric_[piece_.mesh.end(edge)];
  return sum;
}

Vec3 EdgeErrors::point_of(SideId edge, CollapsePlace place, const ErrorQuadric& sum) const {
  const Vec3& start = piece_.positions[piece_.mesh.start(edge)];
  const Vec3& end = piece_.positions[piece_.mesh.end(edge)];
  if (place == CollapsePlace::kStart) return start;
  if (place == CollapsePlace::kEnd) return end;
  const Vec3 middle = 0.5 * (start + end);
  if (place == CollapsePlace::kMiddle) return rounded_to_single(middle);
  // An end that is as good stays where it is: so corners and edges of flat parts stay exact.
  const Vec3 best = sum.minimiser(middle - centre_);
  const double good = sum.error(best) + sum.weight() * kAsGood * (end - start).squaredNorm();
  const double at_start = sum.error(start - centre_);
  const double at_end = sum.error(end - centre_);
  if (std::min(at_start, at_end) <= good) return at_start <= at_end ? start : end;
  return rounded_to_single(best + centre_);
}

}  // namespace kdm
