// SPDX-License-Identifier: MIT
// The faces of a mesh of either kind under one number: triangles first, then quads.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm {

/// A view; the mesh must outlive it.
class Polygons {
 public:
  explicit Polygons(const Mesh& mesh) : mesh_(mesh) {}

  Index size() const { return static_cast<Index>(mesh_.triangles.size() + mesh_.quads.size()); }
  Index corners(Index face) const { return face < mesh_.triangles.size() ? 3 : 4; }
  /// The face's vertices, as many as it has corners.
  const Index* operator[](Index face) const {
    const std::size_t triangles = mesh_.triangles.size();
    return face < triangles ? mesh_.triangles[face].data() : mesh_.quads[face - triangles].data();
  }

  /// Calls `visit(triangle)`; a quad gives its two triangles at the corners 0 and 2.
  template <typename Visit>
  void for_each_triangle_of(Index face, const Visit& visit) const {
    const Index* v = (*this)[face];
    visit(Triangle{v[0], v[1], v[2]});
    if (corners(face) == 4) visit(Triangle{v[0], v[2], v[3]});
  }

  /// Calls `visit(face, triangle)` for all faces.
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
