// SPDX-License-Identifier: MIT
// Hand-made half-edge structures, as extraction sees them before its vertices are placed.
#pragma once

#include <stdexcept>
#include <utility>
#include <vector>

#include "extract/dual/dual_mesh.h"
#include "kdmanifold/mesh.h"

namespace kdm::shapes {

/// Makes a dual mesh of triangles whose corners are leaves (one vertex a leaf), linked as told:
/// half-edge 3t + i runs from corner i of triangle t. All corner numbers from 0 on must be used.
inline DualMesh dual_mesh(const std::vector<Triangle>& triangles,
                          const std::vector<std::pair<Index, Index>>& links) {
  DualMesh mesh;
  mesh.opposite.assign(3 * triangles.size(), kNone);
  mesh.strip.assign(triangles.size(), 0);
  for (Index t = 0; t < triangles.size(); ++t) {
    mesh.vertex.insert(mesh.vertex.end(), triangles[t].begin(), triangles[t].end());
    mesh.hit.push_back(t);
  }
  for (const auto& [a, b] : links) {
    mesh.opposite[a] = b;
    mesh.opposite[b] = a;
  }
  for (Index h = 0; h < mesh.opposite.size(); ++h) {
    const Index other = mesh.opposite[h];
    if (other == kNone || mesh.vertex[h] != mesh.vertex[next_in_triangle(other)]) {
      throw std::logic_error("a half-edge is linked to one that does not run against it");
    }
  }
  return mesh;
}

/// Makes a dual mesh in which each half-edge is linked to the one that runs against it. No edge may
/// have more than two triangles.
inline DualMesh dual_mesh(const std::vector<Triangle>& triangles) {
  std::vector<std::pair<Index, Index>> links;
  for (Index a = 0; a < 3 * triangles.size(); ++a) {
    for (Index b = 0; b < a; ++b) {
      const bool against = triangles[a / 3][a % 3] == triangles[b / 3][(b + 1) % 3] &&
                           triangles[b / 3][b % 3] == triangles[a / 3][(a + 1) % 3];
      if (against) links.emplace_back(a, b);
    }
  }
  return dual_mesh(triangles, links);
}

/// Makes a sphere of `disks` parts round the poles 0 and 1, which are joined by as many edges. Each
/// part lies between two of these edges and has a vertex of its own in the middle.
inline DualMesh beach_ball(Index disks) {
  std::vector<Triangle> triangles;
  std::vector<std::pair<Index, Index>> links;
  for (Index i = 0; i < disks; ++i) {
    const Index middle = 2 + i;
    const Index first = 6 * i;
    triangles.push_back({0, 1, middle});  // edge i up
    triangles.push_back({1, 0, middle});  // edge i + 1 down
    links.emplace_back(first + 1, first + 5);
    links.emplace_back(first + 2, first + 4);
    links.emplace_back(first + 3, 6 * ((i + 1) % disks));
  }
  return dual_mesh(triangles, links);
}

/// Makes a torus of n vertices: the plane's triangulation by (1, 0), (0, 1), (1, 1) where (i, j) is
/// vertex p i + q j modulo n. No multiple of n may be among p, q, p + q.
inline DualMesh tight_torus(Index n, Index p, Index q) {
  std::vector<Triangle> triangles;
  std::vector<std::pair<Index, Index>> links;
  for (Index v = 0; v < n; ++v) {
    const Index right = (v + p) % n;
    const Index up = (v + q) % n;
    const Index both = (v + p + q) % n;
    triangles.push_back({v, right, both});  // 2v
    triangles.push_back({v, both, up});     // 2v + 1
    links.emplace_back(6 * v + 2, 6 * v + 3);
    links.emplace_back(6 * v, 6 * ((v + n - q % n) % n) + 4);
    links.emplace_back(6 * v + 1, 6 * right + 5);
  }
  return dual_mesh(triangles, links);
}

/// Returns the dual mesh as an index mesh.
inline Mesh index_mesh(const DualMesh& dual) {
  Mesh mesh;
  mesh.positions = dual.position;
  for (Index t = 0; t < dual.triangles(); ++t) {
    if (dual.dropped(t)) continue;
    mesh.triangles.push_back({dual.vertex[3 * t], dual.vertex[3 * t + 1], dual.vertex[3 * t + 2]});
  }
  return mesh;
}

}  // namespace kdm::shapes
