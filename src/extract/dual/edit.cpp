// SPDX-License-Identifier: MIT
// Adds vertices on the edges and in the triangles of a dual mesh.
#include "extract/dual/edit.h"

#include <numeric>

namespace kdm {
namespace {

Index add_vertex(const Vec3& position, DualMesh& mesh) {
  mesh.position.push_back(position);
  mesh.leaf.push_back(kNone);
  return static_cast<Index>(mesh.leaf.size() - 1);
}

// Divides triangle (a, b, c) at a vertex m on a-b: half-edge `ab` becomes a-m. Returns the
// half-edge m-b of the new triangle (m, b, c). Neither of the two is linked.
HalfEdgeId cut_triangle(HalfEdgeId ab, VertexId m, DualMesh& mesh) {
  const HalfEdgeId bc = next_in_triangle(ab);
  const VertexId b = mesh.vertex[bc];
  const VertexId c = mesh.vertex[previous_in_triangle(ab)];
  const HalfEdgeId mbc = mesh.add_triangle(mesh.hit[ab / 3], m, b, c);
  mesh.link(mbc + 1, mesh.opposite[bc]);
  mesh.link(mbc + 2, bc);  // bc becomes m -> c
  mesh.vertex[bc] = m;
  // Vertex b may have been entered by a half-edge that starts elsewhere now.
  if (mesh.first_half_edge[b] == bc) mesh.first_half_edge[b] = mbc + 1;
  mesh.strip[ab / 3] = 0;
  return mbc;
}

}  // namespace

Index divide_edge(Index ab, const Vec3& position, DualMesh& mesh) {
  const Index ba = mesh.opposite[ab];
  const Index m = add_vertex(position, mesh);
  const Index mbc = cut_triangle(ab, m, mesh);
  const Index mad = cut_triangle(ba, m, mesh);
  mesh.link(mbc, ba);
  mesh.link(mad, ab);
  mesh.first_half_edge.push_back(next_in_triangle(ab));
  if (mesh.open) {  // edges b-c and a-d may be boundary
    mesh.set_first_half_edge(mesh.vertex[mbc + 2], mbc + 2);
    mesh.set_first_half_edge(mesh.vertex[mad + 2], mad + 2);
  }
  return m;
}

Index divide_boundary(Index ab, const Vec3& position, DualMesh& mesh) {
  const Index m = add_vertex(position, mesh);
  const Index mbc = cut_triangle(ab, m, mesh);
  mesh.first_half_edge.push_back(next_in_triangle(ab));
  mesh.set_first_half_edge(mesh.vertex[mbc + 2], mbc + 2);
  return m;
}

Index divide_triangle(Index triangle, const Vec3& position, DualMesh& mesh) {
  const Index ab = 3 * triangle;
  const Index a = mesh.vertex[ab];
  const Index b = mesh.vertex[ab + 1];
  const Index c = mesh.vertex[ab + 2];
  const Index m = add_vertex(position, mesh);
  const Index bcm = mesh.add_triangle(mesh.hit[triangle], b, c, m);
  const Index cam = mesh.add_triangle(mesh.hit[triangle], c, a, m);
  mesh.link(bcm, mesh.opposite[ab + 1]);
  mesh.link(cam, mesh.opposite[ab + 2]);
  mesh.link(ab + 1, bcm + 2);
  mesh.link(bcm + 1, cam + 2);
  mesh.link(cam + 1, ab + 2);
  mesh.vertex[ab + 2] = m;
  mesh.first_half_edge.push_back(ab + 2);
  if (mesh.first_half_edge[c] == ab + 2) mesh.first_half_edge[c] = cam;
  if (mesh.open) {
    mesh.set_first_half_edge(a, ab);
    mesh.set_first_half_edge(b, ab + 1);
    mesh.set_first_half_edge(c, cam);
  }
  mesh.strip[triangle] = 0;
  return m;
}

Division::Division(DualMesh& mesh, std::span<const OneSidedVertex> one_sided)
    : mesh_(mesh), where_(mesh.vertex.size()) {
  std::iota(where_.begin(), where_.end(), 0u);
  origin_ = where_;
  // Both sides may be numbered anew before they are linked.
  for (const OneSidedVertex& m : one_sided) {
    for (const HalfEdgeId h : {m.half_edge, m.from_end, m.to_start}) mesh_.opposite[h] = kNone;
  }
}

void Division::triangle(Index triangle, const Vec3& position) {
  divide_triangle(triangle, position, mesh_);
  for (const Index half_edge : {3 * triangle + 1, 3 * triangle + 2}) {
    const Index beside = mesh_.opposite[half_edge];  // within the triangle that took its edge
    moved(half_edge, beside - beside % 3);
  }
}

void Division::edge(Index half_edge, const Vec3& position) {
  const Index ab = where_[half_edge];
  const Index ba = mesh_.opposite[ab];
  divide_edge(ab, position, mesh_);
  moved(next_in_triangle(ab), next_in_triangle(mesh_.opposite[ba]));
  moved(next_in_triangle(ba), next_in_triangle(mesh_.opposite[ab]));
}

void Division::side(const OneSidedVertex& m) {
  const HalfEdgeId ab = where_[m.half_edge];
  const HalfEdgeId mbc = cut_triangle(ab, m.vertex, mesh_);
  mesh_.link(ab, where_[m.to_start]);
  mesh_.link(mbc, where_[m.from_end]);
  moved(next_in_triangle(ab), mbc + 1);
}

void Division::moved(Index from, Index to) {
  origin_.resize(mesh_.vertex.size(), kNone);
  const Index origin = origin_[from];
  origin_[from] = kNone;
  origin_[to] = origin;
  if (origin != kNone) where_[origin] = to;
}

}  // namespace kdm
