// SPDX-License-Identifier: MIT
// Makes a triangle mesh of the vertices and polygons that a reader finds.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
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
    if (!is_somewhere(position)) {
      nowhere_.push_back({vertex_count(), place()});
      mesh_.positions.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
      return;
    }
    mesh_.positions.push_back(position);
  }
  static bool is_somewhere(const Vec3& p) {
    return std::isfinite(p.x()) && std::isfinite(p.y()) && std::isfinite(p.z());
  }

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
  Mesh finish(Warnings& warnings) {
    Triangulator triangulator;
    for (const Polygon& polygon : polygons_) {
      if (!nowhere_.empty() && mark_if_nowhere(polygon)) continue;
      triangulator.cut(mesh_.positions, corners_.data() + polygon.first_corner, polygon.count,
                       mesh_.triangles.data() + polygon.first_triangle);
    }
    if (!nowhere_.empty()) skip_nowhere(warnings);
    return std::move(mesh_);
  }

 private:
  struct Polygon {
    std::size_t first_triangle, first_corner, count;
  };

  struct Nowhere {
    Index vertex;
    Place place;
  };

  // If a corner is nowhere, the polygon's triangles name it, so that they are skipped.
  bool mark_if_nowhere(const Polygon& polygon) {
    for (std::size_t i = 0; i < polygon.count; ++i) {
      const Index corner = corners_[polygon.first_corner + i];
      if (is_somewhere(mesh_.positions[corner])) continue;
      const auto first =
          mesh_.triangles.begin() + static_cast<std::ptrdiff_t>(polygon.first_triangle);
      std::fill_n(first, polygon.count - 2, Triangle{corner, corner, corner});
      return true;
    }
    return false;
  }

  // Skips the faces with a vertex that is nowhere, and then moves these vertices to one that is
  // somewhere: the others keep their numbers, and the mesh its extent.
  void skip_nowhere(Warnings& warnings) {
    Index first = kNone;
    std::uint64_t faces = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < mesh_.triangles.size(); ++i) {
      const Triangle t = mesh_.triangles[i];
      const Index face = mesh_.source_faces[i];
      Index bad = kNone;
      for (const Index v : t) {
        if (!is_somewhere(mesh_.positions[v])) bad = std::min(bad, v);
      }
      if (bad == kNone) {
        mesh_.triangles[kept] = t;
        mesh_.source_faces[kept++] = face;
      } else {
        first = std::min(first, bad);
        faces += last_skipped_ != face;
        last_skipped_ = face;
      }
    }
    mesh_.triangles.resize(kept);
    mesh_.source_faces.resize(kept);
    if (faces > 0) {
      const auto found =
          std::lower_bound(nowhere_.begin(), nowhere_.end(), first,
                           [](const Nowhere& n, Index vertex) { return n.vertex < vertex; });
      warnings.skip(Skip::kNotFinite, found->place, faces);
    }
    const auto anchor = std::find_if(mesh_.positions.begin(), mesh_.positions.end(), is_somewhere);
    const Vec3 place = anchor == mesh_.positions.end() ? Vec3(0, 0, 0) : *anchor;
    for (const Nowhere& vertex : nowhere_) mesh_.positions[vertex.vertex] = place;
  }

  Mesh mesh_;
  std::vector<Nowhere> nowhere_;
  Index last_skipped_ = kNone;
  std::vector<Polygon> polygons_;
  std::vector<Index> corners_;
  Index face_ = 0;  // the number of the next face in the file
};

}  // namespace kdm
