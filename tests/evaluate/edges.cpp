// SPDX-License-Identifier: MIT
#include "edges.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace kdm::bench {
namespace {

using Segment = std::array<Vec3, 2>;

std::vector<Segment> sharp_edges(const Mesh& mesh, double degrees) {
  const double limit = std::cos(degrees * 3.14159265358979323846 / 180);
  std::map<std::array<double, 3>, Index> numbers;
  const auto number = [&](Index v) {
    const Vec3& p = mesh.positions[v];
    return numbers.try_emplace({p.x(), p.y(), p.z()}, v).first->second;
  };
  // Faces without area have no normal: the edges they lie at count as if they were not there.
  std::map<std::pair<Index, Index>, std::vector<Vec3>> normals;
  for (const Triangle& t : all_triangles(mesh)) {
    const Vec3& p = mesh.positions[t[0]];
    const Vec3 normal = (mesh.positions[t[1]] - p).cross(mesh.positions[t[2]] - p);
    if (normal.norm() == 0) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      normals[std::minmax({number(t[i]), number(t[(i + 1) % 3])})].push_back(normal.normalized());
    }
  }
  std::vector<Segment> edges;
  for (const auto& [edge, faces] : normals) {
    if (faces.size() != 2 || faces[0].dot(faces[1]) >= limit) continue;
    edges.push_back({mesh.positions[edge.first], mesh.positions[edge.second]});
  }
  return edges;
}

double total_length(const std::vector<Segment>& edges) {
  double length = 0;
  for (const auto& [a, b] : edges) length += (b - a).norm();
  return length;
}

// The ends of all, and points between them, evenly along the summed length.
std::vector<Vec3> points_on(const std::vector<Segment>& edges, Index samples) {
  const double step = total_length(edges) / std::max(samples, Index{1});
  std::vector<Vec3> points;
  for (const auto& [a, b] : edges) {
    const double pieces = std::max(1.0, std::ceil((b - a).norm() / step));
    for (double i = 0; i <= pieces; ++i) points.push_back(a + (b - a) * (i / pieces));
  }
  return points;
}

// As triangles with two corners in one place, which `distance_of_points` takes for what they are.
Mesh as_mesh(const std::vector<Segment>& edges) {
  Mesh mesh;
  for (const auto& [a, b] : edges) {
    const Index first = static_cast<Index>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {a, b});
    mesh.triangles.push_back({first, first + 1, first + 1});
  }
  return mesh;
}

}  // namespace

EdgeDistance sharp_edge_distance(const Mesh& reference, const Mesh& mesh, double degrees,
                                 Index samples) {
  const std::vector<Segment> wanted = sharp_edges(reference, degrees);
  const std::vector<Segment> kept = sharp_edges(mesh, degrees * 2 / 3);
  const std::vector<Vec3> points = points_on(wanted, samples);
  return {total_length(wanted), total_length(kept), distance_of_points(points, mesh),
          distance_of_points(points, as_mesh(kept))};
}

Index count_false_creases(const Mesh& reference, const Mesh& mesh) {
  std::vector<Vec3> middles;
  for (const auto& [a, b] : sharp_edges(mesh, 30)) middles.push_back((a + b) / 2);
  const std::vector<double> off = distances_of_points(middles, as_mesh(sharp_edges(reference, 15)));
  const double reach = 0.005 * diagonal(reference);
  return static_cast<Index>(
      std::count_if(off.begin(), off.end(), [&](double distance) { return distance > reach; }));
}

}  // namespace kdm::bench
