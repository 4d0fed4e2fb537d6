// SPDX-License-Identifier: MIT
// Separates double edges first and flips edges then, since no flip makes a double edge.
#include "extract/mend/mend_edges.h"

#include "extract/mend/double_edges.h"
#include "extract/mend/unfold.h"

namespace kdm {
namespace {

// Returns `numbers`, followed by the numbers from `first` up to `end`, which is left out.
std::vector<Index> with_new(std::vector<Index> numbers, Index first, Index end) {
  for (Index i = first; i < end; ++i) numbers.push_back(i);
  return numbers;
}

}  // namespace

void mend_edges(const GridView& view, const FaceSettings& settings, const EmbedLevels& levels,
                DualMesh& mesh, EditLog& log) {
  if (settings.two_manifold) separate_double_edges(view, mesh, log);
  if (settings.unfold && !settings.quads) unfold(view, levels, mesh, log);
}

void mend_edges(const GridView& view, const FaceSettings& settings, const EmbedLevels& levels,
                DualMesh& mesh, EditLog& log, const RemadePart& part) {
  if (settings.two_manifold) {
    const std::vector<VertexId> vertices =
        with_new(part.vertices, part.first_vertex, mesh.vertices());
    separate_double_edges(view, mesh, log, vertices);
  }
  if (!settings.unfold || settings.quads) return;
  std::vector<TriangleId> triangles = part.hits;  // a triangle has the number of its hit
  triangles.insert(triangles.end(), log.touched_hits().begin(), log.touched_hits().end());
  triangles = with_new(std::move(triangles), part.first_triangle, mesh.triangles());
  unfold(view, levels, mesh, log, triangles);
}

}  // namespace kdm
