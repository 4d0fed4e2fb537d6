// SPDX-License-Identifier: MIT
// Turns the dual mesh into the mesh that extraction returns.
#include "extract/emit.h"

#include <array>
#include <initializer_list>

namespace kdm {
namespace {

// Returns the half-edge across which triangle t makes a quad with its neighbour, or kNone.
Index quad_diagonal(const DualMesh& mesh, Index t) {
  for (Index i = 0; i < 3; ++i) {
    const Index half_edge = 3 * t + i;
    if ((mesh.strip[t] >> i & 1) == 0) continue;
    const Index other = mesh.opposite[half_edge];
    const bool both = (mesh.strip[other / 3] >> (other % 3) & 1) != 0;
    const Index c = mesh.vertex[previous_in_triangle(half_edge)];
    if (both && c != mesh.vertex[previous_in_triangle(other)]) return half_edge;
  }
  return kNone;
}

// Returns for each vertex its number in the result, from which dropped vertices are left out.
std::vector<Index> numbers_of_vertices(const DualMesh& mesh) {
  std::vector<Index> numbers(mesh.vertices());
  Index number = 0;
  for (Index v = 0; v < numbers.size(); ++v) {
    numbers[v] = number;
    if (mesh.first_half_edge[v] != kNone) ++number;
  }
  return numbers;
}

}  // namespace

Mesh emit(const GridData& grid, const DualMesh& mesh, const std::vector<Vec3>& normals, bool quads,
          bool single) {
  Mesh out;
  out.positions.reserve(mesh.position.size());
  const std::vector<Index> numbers = numbers_of_vertices(mesh);
  for (Index v = 0; v < mesh.position.size(); ++v) {
    if (mesh.first_half_edge[v] == kNone) continue;
    const Vec3& p = mesh.position[v];
    out.positions.push_back(single ? single_precision(grid.lattice, p) : grid.lattice.to_model(p));
  }
  const auto number = [&](Index half_edge) { return numbers[mesh.vertex[half_edge]]; };
  const auto source = [&](Index t) {
    const Index face = grid.source_faces[grid.hits[mesh.hit[t]].plane()];
    return face == kPatch ? kNone : face;
  };
  const auto plane = [&](Index t) { return grid.hits[mesh.hit[t]].plane(); };
  const bool operands = !grid.source_operands.empty();
  std::vector<Index> quad_sources;
  std::vector<Index> quad_operands;
  std::vector<std::array<float, 3>> quad_normals;
  const auto add_normals = [&](std::initializer_list<Index> half_edges,
                               std::vector<std::array<float, 3>>& to) {
    if (normals.empty()) return;
    for (const Index h : half_edges) {
      const Eigen::Vector3f n = normals[h].cast<float>();
      to.push_back({n[0], n[1], n[2]});
    }
  };
  out.triangles.reserve(mesh.triangles());
  out.source_faces.reserve(mesh.triangles());
  for (Index t = 0; t < mesh.triangles(); ++t) {
    if (mesh.dropped(t)) continue;
    const Index diagonal = quads ? quad_diagonal(mesh, t) : kNone;
    if (diagonal == kNone) {
      out.triangles.push_back({number(3 * t), number(3 * t + 1), number(3 * t + 2)});
      out.source_faces.push_back(source(t));
      if (operands) out.source_operands.push_back(grid.source_operands[plane(t)]);
      add_normals({3 * t, 3 * t + 1, 3 * t + 2}, out.corner_normals);
      continue;
    }
    const Index other = mesh.opposite[diagonal];
    if (other / 3 < t) continue;  // made with its partner
    out.quads.push_back({number(diagonal), number(previous_in_triangle(other)), number(other),
                         number(previous_in_triangle(diagonal))});
    quad_sources.push_back(source(t));
    if (operands) quad_operands.push_back(grid.source_operands[plane(t)]);
    add_normals({diagonal, previous_in_triangle(other), other, previous_in_triangle(diagonal)},
                quad_normals);
  }
  out.source_faces.insert(out.source_faces.end(), quad_sources.begin(), quad_sources.end());
  out.source_operands.insert(out.source_operands.end(), quad_operands.begin(), quad_operands.end());
  out.corner_normals.insert(out.corner_normals.end(), quad_normals.begin(), quad_normals.end());
  return out;
}

}  // namespace kdm
