// SPDX-License-Identifier: MIT
// Looks sources up.
#include "reduce/face_groups.h"

#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {
namespace {

Index source_of(const Mesh& mesh, Index face) {
  return mesh.source_faces.empty() ? face : mesh.source_faces[face];
}

}  // namespace

void check_groups(const Mesh& mesh, const std::vector<Index>& of_sources) {
  if (of_sources.empty()) return;
  const auto check = [&](Index source) {
    if (source == kNone || source < of_sources.size()) return;
    throw Error(ErrorCode::kInvalidOption,
                compose("`keep_groups`: it has {} entries, but there is a face {}",
                        of_sources.size(), source));
  };
  for (const Index source : mesh.source_faces) check(source);
  const std::size_t faces = mesh.triangles.size() + mesh.quads.size();
  if (mesh.source_faces.empty() && faces > 0) check(static_cast<Index>(faces - 1));
}

std::vector<Index> face_groups(const Mesh& mesh, const std::vector<Index>& of_sources) {
  check_groups(mesh, of_sources);
  std::vector<Index> groups;
  if (of_sources.empty()) return groups;
  const Index triangles = static_cast<Index>(mesh.triangles.size());
  const Index all = triangles + 2 * static_cast<Index>(mesh.quads.size());
  for (Index t = 0; t < all; ++t) {
    const Index source = source_of(mesh, t < triangles ? t : triangles + (t - triangles) / 2);
    groups.push_back(source == kNone ? kNone : of_sources[source]);
  }
  return groups;
}

}  // namespace kdm
