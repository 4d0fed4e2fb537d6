// SPDX-License-Identifier: MIT
#include "support/mesh_check.h"

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace kdm::check {
namespace {

using Polygon = std::vector<Index>;
using Edge = std::pair<Index, Index>;

std::vector<Polygon> polygons_of(const Mesh& mesh) {
  std::vector<Polygon> polygons;
  for (const Triangle& t : mesh.triangles) polygons.emplace_back(t.begin(), t.end());
  for (const Quad& q : mesh.quads) polygons.emplace_back(q.begin(), q.end());
  return polygons;
}

Index after(const Polygon& polygon, std::size_t i) { return polygon[(i + 1) % polygon.size()]; }
Index before(const Polygon& polygon, std::size_t i) {
  return polygon[(i + polygon.size() - 1) % polygon.size()];
}

// Tells whether the faces at a vertex form one fan. `link` has for each face the two vertices next
// to the vertex: they are an edge of the vertex's link. The faces form one fan if the edges of the
// link can be walked through in one go, in a ring or along a path.
bool is_one_fan(const std::vector<Edge>& link) {
  std::map<Index, std::vector<std::size_t>> at;
  for (std::size_t i = 0; i < link.size(); ++i) {
    at[link[i].first].push_back(i);
    at[link[i].second].push_back(i);
  }
  std::size_t start = 0;
  for (const auto& [vertex, edges] : at) {
    if (edges.size() > 2) return false;
    if (edges.size() == 1) start = edges[0];  // a path must be walked from one of its ends
  }
  std::vector<bool> walked(link.size(), false);
  walked[start] = true;
  std::size_t count = 1;
  Index vertex = at[link[start].first].size() == 1 ? link[start].second : link[start].first;
  for (bool moved = true; moved;) {
    moved = false;
    for (std::size_t edge : at[vertex]) {
      if (walked[edge]) continue;
      walked[edge] = moved = true;
      ++count;
      vertex = link[edge].first == vertex ? link[edge].second : link[edge].first;
      break;
    }
  }
  return count == link.size();
}

// Returns the signed volume between a triangle and the plane z = 0: its mean height times the area
// of its shadow. Over the faces of a closed mesh this adds up to the enclosed volume.
double prism(const Vec3& a, const Vec3& b, const Vec3& c) {
  const double shadow = ((b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x())) / 2;
  return shadow * (a.z() + b.z() + c.z()) / 3;
}

int count_components(const std::vector<Polygon>& polygons,
                     const std::map<Edge, std::vector<std::size_t>>& faces_at) {
  std::vector<bool> seen(polygons.size(), false);
  int components = 0;
  for (std::size_t first = 0; first < polygons.size(); ++first) {
    if (seen[first]) continue;
    ++components;
    std::vector<std::size_t> to_visit = {first};
    seen[first] = true;
    while (!to_visit.empty()) {
      const Polygon& polygon = polygons[to_visit.back()];
      to_visit.pop_back();
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        for (std::size_t next : faces_at.at(std::minmax(polygon[i], after(polygon, i)))) {
          if (seen[next]) continue;
          seen[next] = true;
          to_visit.push_back(next);
        }
      }
    }
  }
  return components;
}

// Goes from each boundary edge to the one that starts where it ends.
int count_boundary_loops(const std::vector<Polygon>& polygons,
                         const std::map<Edge, std::vector<std::size_t>>& faces_at) {
  std::map<Index, Index> next;
  for (const Polygon& polygon : polygons) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const bool boundary = faces_at.at(std::minmax(polygon[i], after(polygon, i))).size() == 1;
      if (boundary) next[polygon[i]] = after(polygon, i);
    }
  }
  int loops = 0;
  while (!next.empty()) {
    ++loops;
    for (auto at = next.begin(); at != next.end();) {
      const Index to = at->second;
      next.erase(at);
      at = next.find(to);
    }
  }
  return loops;
}

}  // namespace

MeshCheck check_mesh(const Mesh& mesh) {
  MeshCheck result;
  std::vector<Polygon> polygons;
  std::set<std::set<Index>> vertex_sets;
  for (const Polygon& polygon : polygons_of(mesh)) {
    for (Index v : polygon) result.bad_indices += v >= mesh.positions.size();
    if (std::set<Index>(polygon.begin(), polygon.end()).size() < polygon.size()) {
      ++result.degenerate_faces;
      continue;
    }
    result.duplicate_faces += !vertex_sets.emplace(polygon.begin(), polygon.end()).second;
    polygons.push_back(polygon);
  }
  if (result.bad_indices > 0) return result;

  std::map<Edge, std::vector<std::size_t>> faces_at;
  std::map<Edge, int> balance;  // uses upwards less uses downwards
  std::map<Index, std::vector<Edge>> links;
  for (std::size_t face = 0; face < polygons.size(); ++face) {
    const Polygon& polygon = polygons[face];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Edge edge = std::minmax(polygon[i], after(polygon, i));
      faces_at[edge].push_back(face);
      balance[edge] += polygon[i] < after(polygon, i) ? 1 : -1;
      links[polygon[i]].emplace_back(before(polygon, i), after(polygon, i));
    }
    for (std::size_t i = 2; i < polygon.size(); ++i) {
      result.volume += prism(mesh.positions[polygon[0]], mesh.positions[polygon[i - 1]],
                             mesh.positions[polygon[i]]);
    }
  }
  result.oriented = true;
  for (const auto& [edge, faces] : faces_at) {
    result.boundary_edges += faces.size() == 1;
    result.non_manifold_edges += faces.size() > 2;
    result.misoriented_edges += faces.size() == 2 && balance[edge] != 0;
    result.oriented = result.oriented && balance[edge] == 0;
  }
  for (const auto& [vertex, link] : links) {
    result.non_manifold_vertices += !is_one_fan(link);
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isfinite(mesh.positions[vertex][axis])) continue;
      ++result.bad_positions;
      break;
    }
  }
  result.components = count_components(polygons, faces_at);
  result.euler_characteristic = static_cast<std::int64_t>(links.size()) -
                                static_cast<std::int64_t>(faces_at.size()) +
                                static_cast<std::int64_t>(polygons.size());
  result.closed = !polygons_of(mesh).empty() && result.boundary_edges == 0;
  result.boundary_loops = count_boundary_loops(polygons, faces_at);
  result.two_manifold = result.closed && result.faults().empty();
  MeshCheck closed = result;
  closed.boundary_edges = 0;
  result.manifold = !polygons.empty() && closed.faults().empty();
  return result;
}

MeshCheck check_mesh(const ExtractedMesh& mesh) {
  MeshCheck result = check_mesh(static_cast<const Mesh&>(mesh));
  if (!result.two_manifold || mesh.report.crossings != std::uint64_t{0}) return result;
  const MeshCheck welded = check_mesh(welded_in_single(mesh));
  if (welded.two_manifold) return result;
  result.falls_together = true;
  result.two_manifold = result.manifold = false;
  return result;
}

Mesh welded_in_single(const Mesh& mesh) {
  Mesh welded = mesh;
  std::map<std::array<float, 3>, Index> number;
  std::vector<Index> vertex;
  welded.positions.clear();
  for (const Vec3& p : mesh.positions) {
    const Eigen::Vector3f single = p.cast<float>();
    // Adding zero makes 0 of -0.
    const std::array<float, 3> key{single[0] + 0.0f, single[1] + 0.0f, single[2] + 0.0f};
    const auto [at, added] = number.emplace(key, static_cast<Index>(welded.positions.size()));
    if (added) welded.positions.push_back(single.cast<double>());
    vertex.push_back(at->second);
  }
  for (Triangle& t : welded.triangles) {
    for (Index& v : t) v = vertex[v];
  }
  for (Quad& q : welded.quads) {
    for (Index& v : q) v = vertex[v];
  }
  return welded;
}

std::string MeshCheck::faults() const {
  std::ostringstream text;
  const auto add = [&text](int count, const char* what) {
    if (count != 0) text << (text.tellp() > 0 ? ", " : "") << count << ' ' << what;
  };
  add(boundary_edges, "boundary edges");
  add(non_manifold_edges, "non-manifold edges");
  add(misoriented_edges, "misoriented edges");
  add(non_manifold_vertices, "non-manifold vertices");
  add(degenerate_faces, "degenerate faces");
  add(duplicate_faces, "duplicate faces");
  add(bad_indices, "corners without a vertex");
  add(bad_positions, "vertices that are not finite");
  if (falls_together) text << "not 2-manifold once welded by position";
  return text.str();
}

}  // namespace kdm::check
