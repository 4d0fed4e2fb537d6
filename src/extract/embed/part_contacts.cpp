// SPDX-License-Identifier: MIT
#include "extract/embed/part_contacts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>

#include "geometry/distance.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Surfaces whose sides lead less than this sine away from the plane across a vertex are flat there.
constexpr double kFlat = 0.02;

using Corners = std::array<VertexId, 3>;

Corners corners_of(const DualMesh& mesh, TriangleId t) {
  return {mesh.vertex[3 * t], mesh.vertex[3 * t + 1], mesh.vertex[3 * t + 2]};
}

bool has(const Corners& corners, VertexId v) {
  return v == corners[0] || v == corners[1] || v == corners[2];
}

// Returns the squared distance between two segments. Where they do not cross, it is taken at one of
// their ends.
double squared_distance_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a;
  const Vec3 v = d - c;
  const Vec3 normal = u.cross(v);
  const double area = normal.squaredNorm();
  if (area > 0) {
    const double s = (c - a).cross(v).dot(normal) / area;
    const double t = (c - a).cross(u).dot(normal) / area;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) return (a + s * u - c - t * v).squaredNorm();
  }
  return std::min({squared_distance(a, c, d), squared_distance(b, c, d), squared_distance(c, a, b),
                   squared_distance(d, a, b)});
}

// Finds the vertices of t that keep it on u.
void find_touching(const DualMesh& mesh, const Corners& t, const Corners& u, double reach,
                   std::vector<VertexId>& touching) {
  const auto at = [&](VertexId v) -> const Vec3& { return mesh.position[v]; };
  const double limit = reach * reach;
  const std::size_t before = touching.size();
  for (const VertexId v : t) {
    if (has(u, v)) continue;
    if (squared_distance(at(v), at(u[0]), at(u[1]), at(u[2])) <= limit) touching.push_back(v);
  }
  if (touching.size() > before) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const VertexId a = t[i];
    const VertexId b = t[(i + 1) % 3];
    if (has(u, a) || has(u, b)) continue;
    for (std::size_t j = 0; j < 3; ++j) {
      const VertexId c = u[j];
      const VertexId d = u[(j + 1) % 3];
      if (has(t, c) || has(t, d)) continue;
      if (squared_distance_of_segments(at(a), at(b), at(c), at(d)) > limit) continue;
      touching.push_back(a);
      touching.push_back(b);
    }
  }
}

// A vertex moves by this share of its shortest edge at most.
constexpr double kMostOfEdge = 1.0 / 8;

// Returns the unit vector into the side that the surface bends round at the vertex, or towards its
// neighbours where it bends both ways; zero where it is flat. Times the length of the shortest edge
// at the vertex.
Vec3 direction_of_bend(const DualMesh& mesh, VertexId v) {
  const Vec3& p = mesh.position[v];
  Vec3 normal = Vec3::Zero();
  for (const HalfEdgeId h : mesh.ring(v)) {
    const Vec3 u = mesh.position[mesh.end_vertex(h)] - p;
    const Vec3 w = mesh.position[mesh.vertex[previous_in_triangle(h)]] - p;
    const Vec3 n = u.cross(w);
    const double area = n.norm();
    // A face counts by its angle at the vertex: 0 to 2, and 1 for a right angle.
    if (area > 0) normal += (1 - u.dot(w) / (u.norm() * w.norm())) / area * n;
  }
  const double length = normal.norm();
  if (!(length > 0)) return Vec3::Zero();
  normal /= length;
  double lowest = 0;
  double highest = 0;
  Vec3 inwards = Vec3::Zero();
  double shortest = std::numeric_limits<double>::infinity();
  for (const HalfEdgeId h : mesh.ring(v)) {
    const Vec3 along = mesh.position[mesh.end_vertex(h)] - p;
    const double distance = along.norm();
    if (!(distance > 0)) continue;
    const double height = along.dot(normal) / distance;
    lowest = std::min(lowest, height);
    highest = std::max(highest, height);
    inwards += along / distance;
    shortest = std::min(shortest, distance);
  }
  if (lowest < -kFlat && highest < -0.5 * lowest) return -shortest * normal;
  if (highest > kFlat && lowest > -0.5 * highest) return shortest * normal;
  const double size = inwards.norm();
  if (highest - lowest > kFlat && size > kFlat) return shortest / size * inwards;
  return Vec3::Zero();
}

}  // namespace

std::vector<VertexId> part_contacts(std::span<const std::pair<TriangleId, TriangleId>> pairs,
                                    double reach, double step, DualMesh& mesh) {
  std::vector<VertexId> touching;
  for (const auto& [first, second] : pairs) {
    const Corners t = corners_of(mesh, first);
    const Corners u = corners_of(mesh, second);
    find_touching(mesh, t, u, reach, touching);
    find_touching(mesh, u, t, reach, touching);
  }
  make_set(touching);
  std::vector<VertexId> moved;
  std::vector<Vec3> positions;
  for (const VertexId v : touching) {
    const Vec3 direction = direction_of_bend(mesh, v);
    if (direction.isZero(0)) continue;
    moved.push_back(v);
    const double length = direction.norm();  // of the shortest edge
    positions.push_back(mesh.position[v] +
                        std::min(step, kMostOfEdge * length) / length * direction);
  }
  for (std::size_t i = 0; i < moved.size(); ++i) mesh.position[moved[i]] = positions[i];
  return moved;
}

}  // namespace kdm
