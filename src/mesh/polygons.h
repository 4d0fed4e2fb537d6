// SPDX-License-Identifier: MIT
// Views the triangles and quads of a mesh as faces with one numbering.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm {

/// Numbers the faces of a mesh: triangles first, then quads. The mesh must outlive this view.
class Polygons {
 public:
  explicit Polygons(const Mesh& mesh) : mesh_(mesh) {}

  Index size() const { return static_cast<Index>(mesh_.triangles.size() + mesh_.quads.size()); }
  /// Returns how many corners the face has.
  Index corners(Index face) const { return face < mesh_.triangles.size() ? 3 : 4; }
  /// Returns the face's vertices, as many as it has corners.
  const Index* operator[](Index face) const {
    const std::size_t triangles = mesh_.triangles.size();
    return face < triangles ? mesh_.triangles[face].data() : mesh_.quads[face - triangles].data();
  }

  /// Calls `visit(triangle)` for a face; a quad is cut into two triangles from corner 0 to
  /// corner 2.
  template <typename Visit>
  void for_each_triangle_of(Index face, const Visit& visit) const {
    const Index* v = (*this)[face];
    visit(Triangle{v[0], v[1], v[2]});
    if (corners(face) == 4) visit(Triangle{v[0], v[2], v[3]});
  }

  /// Calls `visit(face, triangle)` for every triangle of every face; quads are cut as above.
  template <typename Visit>
  void for_each_triangle(const Visit& visit) const {
    for (Index face = 0; face < size(); ++face) {
      for_each_triangle_of(face, [&](const Triangle& t) { visit(face, t); });
    }
  }

 private:
  const Mesh& mesh_;
};

}  // namespace kdm
