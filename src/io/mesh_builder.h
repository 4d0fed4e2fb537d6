// SPDX-License-Identifier: MIT
// Makes a triangle mesh of the vertices and polygons that a reader finds.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "io/triangulate.h"
#include "kdmanifold/mesh.h"

namespace kdm {

/// Collects vertices and faces. Triangles go straight to the mesh. Faces with more corners are cut
/// into triangles at the end, when all vertices are known: some files name a vertex before they
/// define it.
class MeshBuilder {
 public:
  /// Returns how many vertices were added until now.
  Index vertex_count() const { return static_cast<Index>(mesh_.positions.size()); }

  void reserve_vertices(std::size_t count) { mesh_.positions.reserve(count); }
  void reserve_faces(std::size_t count) {
    mesh_.triangles.reserve(count);
    mesh_.source_faces.reserve(count);
  }

  void add_vertex(const Vec3& position) { mesh_.positions.push_back(position); }

  /// Adds the next face of the file. Its vertices must have been added when `finish` is called. A
  /// face with fewer than three corners has no area: it gets a number, but no triangle.
  void add_face(const Index* corners, std::size_t count) {
    if (count == 3) {
      mesh_.triangles.push_back({corners[0], corners[1], corners[2]});
      mesh_.source_faces.push_back(face_);
    } else if (count > 3) {
      polygons_.push_back({mesh_.triangles.size(), corners_.size(), count});
      corners_.insert(corners_.end(), corners, corners + count);
      mesh_.triangles.resize(mesh_.triangles.size() + count - 2);
      mesh_.source_faces.resize(mesh_.triangles.size(), face_);
    }
    ++face_;
  }
  void add_face(const std::vector<Index>& corners) { add_face(corners.data(), corners.size()); }

  /// Returns the mesh. The builder cannot be used any more.
  Mesh finish() {
    Triangulator triangulator;
    for (const Polygon& polygon : polygons_) {
      triangulator.cut(mesh_.positions, corners_.data() + polygon.first_corner, polygon.count,
                       mesh_.triangles.data() + polygon.first_triangle);
    }
    return std::move(mesh_);
  }

 private:
  struct Polygon {
    std::size_t first_triangle, first_corner, count;
  };

  Mesh mesh_;
  std::vector<Polygon> polygons_;
  std::vector<Index> corners_;
  Index face_ = 0;  // the number of the next face in the file
};

}  // namespace kdm
