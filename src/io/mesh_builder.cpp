// SPDX-License-Identifier: MIT
// Cuts polygons, and skips faces whose vertices have no place.
#include "io/mesh_builder.h"

#include <algorithm>
#include <limits>

namespace kdm {

void MeshBuilder::add_nowhere(Place place) {
  nowhere_.push_back({vertex_count(), place});
  mesh_.positions.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
}

// If a corner is nowhere, the polygon's triangles name it, so that they are skipped.
bool MeshBuilder::mark_if_nowhere(const Polygon& polygon) {
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
void MeshBuilder::skip_nowhere(Warnings& warnings) {
  Index first = kNone;
  Index last = kNone;
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
      faces += last != face;
      last = face;
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

Mesh MeshBuilder::finish(Warnings& warnings) {
  Triangulator triangulator;
  for (const Polygon& polygon : polygons_) {
    if (!nowhere_.empty() && mark_if_nowhere(polygon)) continue;
    triangulator.cut(mesh_.positions, corners_.data() + polygon.first_corner, polygon.count,
                     mesh_.triangles.data() + polygon.first_triangle);
  }
  if (!nowhere_.empty()) skip_nowhere(warnings);
  return std::move(mesh_);
}

}  // namespace kdm
