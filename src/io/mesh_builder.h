// SPDX-License-Identifier: MIT
// Makes a triangle mesh of the vertices and polygons that a reader finds.
#pragma once

#include <utility>
#include <vector>

#include "io/triangulate.h"
#include "io/warnings.h"
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

  /// Adds a vertex, which `place` in the file gives. If a coordinate is not finite, `finish` skips
  /// the faces that use the vertex, and moves it to another one.
  template <typename GetPlace>
  void add_vertex(const Vec3& position, GetPlace&& place) {
    if (!is_somewhere(position)) return add_nowhere(place());
    add_vertex(position);
  }
  /// Adds a vertex whose coordinates are finite.
  void add_vertex(const Vec3& position) { mesh_.positions.push_back(position); }
  /// Tells whether the coordinates are finite: only of those 0 is a multiple.
  static bool is_somewhere(const Vec3& p) { return p.x() * 0 + p.y() * 0 + p.z() * 0 == 0; }

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
  Mesh finish(Warnings& warnings);

 private:
  struct Polygon {
    std::size_t first_triangle, first_corner, count;
  };

  struct Nowhere {
    Index vertex;
    Place place;
  };

  void add_nowhere(Place place);
  bool mark_if_nowhere(const Polygon& polygon);
  void skip_nowhere(Warnings& warnings);

  Mesh mesh_;
  std::vector<Nowhere> nowhere_;  // in the order of their vertices
  std::vector<Polygon> polygons_;
  std::vector<Index> corners_;
  Index face_ = 0;  // the number of the next face in the file
};

}  // namespace kdm
