// SPDX-License-Identifier: MIT
// Checks that all faces name vertices that exist.
#include "mesh/check_indices.h"

#include "kdmanifold/error.h"
#include "text/compose.h"

namespace kdm {
namespace {

template <typename Face>
void check_faces(const std::vector<Face>& faces, const char* array, std::size_t vertices) {
  for (std::size_t i = 0; i < faces.size(); ++i) {
    for (Index vertex : faces[i]) {
      if (vertex < vertices) continue;
      throw Error(
          ErrorCode::kInvalidMesh,
          compose("{}[{}] names vertex {}, but there are {} vertices", array, i, vertex, vertices));
    }
  }
}

}  // namespace

void check_indices(const Mesh& mesh) {
  check_faces(mesh.triangles, "triangles", mesh.positions.size());
  check_faces(mesh.quads, "quads", mesh.positions.size());
}

}  // namespace kdm
