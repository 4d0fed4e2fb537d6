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

}  // namespace

Index divide_edge(Index ab, const Vec3& position, DualMesh& mesh) {
  const Index ba = mesh.opposite[ab];
  const Index bc = next_in_triangle(ab);
  const Index ad = next_in_triangle(ba);
  const Index a = mesh.vertex[ab];
  const Index b = mesh.vertex[ba];
  const Index c = mesh.vertex[previous_in_triangle(ab)];
  const Index d = mesh.vertex[previous_in_triangle(ba)];
  const Index m = add_vertex(position, mesh);
  const Index mbc = mesh.add_triangle(mesh.hit[ab / 3], m, b, c);
  const Index mad = mesh.add_triangle(mesh.hit[ba / 3], m, a, d);
  mesh.link(mbc + 1, mesh.opposite[bc]);
  mesh.link(mad + 1, mesh.opposite[ad]);
  mesh.link(mbc, ba);
  mesh.link(mad, ab);
  mesh.link(mbc + 2, bc);  // bc becomes m -> c
  mesh.link(mad + 2, ad);
  mesh.vertex[bc] = m;
  mesh.vertex[ad] = m;
  mesh.first_half_edge.push_back(bc);
  // Vertices a and b may have been entered by half-edges that start elsewhere now.
  if (mesh.first_half_edge[b] == bc) mesh.first_half_edge[b] = mbc + 1;
  if (mesh.first_half_edge[a] == ad) mesh.first_half_edge[a] = mad + 1;
  if (mesh.open) {  // edges b-c and a-d may be boundary
    mesh.set_first_half_edge(c, mbc + 2);
    mesh.set_first_half_edge(d, mad + 2);
  }
  mesh.strip[ab / 3] = mesh.strip[ba / 3] = 0;
  return m;
}

Index divide_boundary(Index ab, const Vec3& position, DualMesh& mesh) {
  const Index bc = next_in_triangle(ab);
  const Index b = mesh.vertex[bc];
  const Index c = mesh.vertex[previous_in_triangle(ab)];
  const Index m = add_vertex(position, mesh);
  const Index mbc = mesh.add_triangle(mesh.hit[ab / 3], m, b, c);
  mesh.link(mbc + 1, mesh.opposite[bc]);
  mesh.link(mbc + 2, bc);  // bc becomes m -> c
  mesh.vertex[bc] = m;
  mesh.first_half_edge.push_back(bc);
  mesh.first_half_edge[b] = mbc + 1;
  mesh.set_first_half_edge(c, mbc + 2);
  mesh.strip[ab / 3] = 0;
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
  const HalfEdgeId bc = next_in_triangle(ab);
  const VertexId b = mesh_.vertex[bc];
  const VertexId c = mesh_.vertex[previous_in_triangle(ab)];
  const HalfEdgeId mbc = mesh_.add_triangle(mesh_.hit[ab / 3], m.vertex, b, c);
  mesh_.link(mbc + 1, mesh_.opposite[bc]);
  mesh_.link(mbc + 2, bc);  // bc becomes m -> c
  mesh_.vertex[bc] = m.vertex;
  mesh_.link(ab, where_[m.to_start]);
  mesh_.link(mbc, where_[m.from_end]);
  if (mesh_.first_half_edge[b] == bc) mesh_.first_half_edge[b] = mbc + 1;
  mesh_.strip[ab / 3] = 0;
  moved(bc, mbc + 1);
}

void Division::moved(Index from, Index to) {
  origin_.resize(mesh_.vertex.size(), kNone);
  const Index origin = origin_[from];
  origin_[from] = kNone;
  origin_[to] = origin;
  if (origin != kNone) where_[origin] = to;
}

}  // namespace kdm
