// SPDX-License-Identifier: MIT
// Collects the vertices and polygons a reader finds and makes a triangle mesh of them.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "io/triangulate.h"
#include "kdmanifold/mesh.h"

namespace kdm {

/// Polygons are cut when all vertices are known, since some files name a vertex before they
/// define it; triangles go straight to the mesh.
class MeshBuilder {
 public:
  Index vertex_count() const { return static_cast<Index>(mesh_.positions.size()); }

  void reserve_vertices(std::size_t count) { mesh_.positions.reserve(count); }
  void reserve_faces(std::size_t count) {
    mesh_.triangles.reserve(count);
    mesh_.source_faces.reserve(count);
  }

  void add_vertex(const Vec3& position) { mesh_.positions.push_back(position); }

  /// Adds the file's next face. Its corners must exist when `finish` is called. Faces with fewer
  /// than three corners have no area: they are numbered and left out.
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

  /// The mesh; the builder is empty afterwards.
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
  Index face_ = 0;
};

}  // namespace kdm
