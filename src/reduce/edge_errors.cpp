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

void add_triangles(const Workpiece& piece, VertexQuadrics& quadrics) {
  for (TriangleId t = 0; t < piece.mesh.triangles(); ++t) {
    const FaceShape& face = piece.faces[t];
    if (!(face.doubled_area > 0)) continue;
    const Triangle corners = piece.mesh.corners(t);
    const Vec3 first = piece.positions[corners[0]] - quadrics.centre;
    for (const VertexId v : corners) {
      quadrics.at[v].add_plane(face.normal, face.normal.dot(first), face.doubled_area);
    }
  }
}

// Planes through the lines, perpendicular to the triangles beside them, hold vertices there as
// those of triangles do on the surface.
void add_lines(const Workpiece& piece, VertexQuadrics& quadrics) {
  for (SideId h = 0; h < 3 * piece.mesh.triangles(); ++h) {
    if (!piece.is_line(h)) continue;
    const Vec3 start = piece.positions[piece.mesh.start(h)] - quadrics.centre;
    const Vec3 along = piece.positions[piece.mesh.end(h)] - quadrics.centre - start;
    const Vec3 across = normalized_or_zero(along.cross(piece.faces[triangle_of(h)].normal));
    if (across.isZero()) continue;
    for (const VertexId v : {piece.mesh.start(h), piece.mesh.end(h)}) {
      quadrics.at[v].add_plane(across, across.dot(start), along.squaredNorm());
    }
  }
}

}  // namespace

VertexQuadrics plane_quadrics(const Workpiece& piece) {
  VertexQuadrics out{centre_of_all(piece.positions),
                     std::vector<ErrorQuadric>(piece.positions.size())};
  add_triangles(piece, out);
  add_lines(piece, out);
  return out;
}

ErrorQuadric EdgeErrors::quadric_of(SideId edge) const {
  ErrorQuadric sum = quadrics_.at[piece_.mesh.start(edge)];
  sum += quadrics_.at[piece_.mesh.end(edge)];
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
  const Vec3 best = sum.minimiser(middle - quadrics_.centre);
  const double good = sum.error(best) + sum.weight() * kAsGood * (end - start).squaredNorm();
  const double at_start = sum.error(start - quadrics_.centre);
  const double at_end = sum.error(end - quadrics_.centre);
  if (std::min(at_start, at_end) <= good) return at_start <= at_end ? start : end;
  return rounded_to_single(best + quadrics_.centre);
}

}  // namespace kdm
