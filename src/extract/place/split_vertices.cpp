// SPDX-License-Identifier: MIT
// Splits vertices (paper 2.3.1).
//
// The ring of a vertex v is cut into sections of consecutive polygons whose planes one point meets:
// from a starting polygon forwards as long as the accumulated quadric allows it, then backwards.
// Each section but the last gets a vertex w of its own; two triangles beside the new edge v-w keep
// the surface closed, where f is the section's last polygon and g the one after it. The triangle
// lies in f's plane, so v must meet it too: that makes two corners of a cube in one leaf exact. But
// a section of one or two polygons hands no planes on, or v would stay as far from planes as
// before. The paper starts from any polygon. But any three planes meet somewhere, and if they do
// not belong to one feature, the new triangles turn over; then the next polygon is tried as the
// start.
//
//         u                    u
//         |                  /   \     .
//      f  |  g      ->    f /     \ g
//         v                w-------v
//         |                 \     /
//         |                  \   /
//         x                    x
#include "extract/place/split_vertices.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "extract/place/vertex_position.h"

namespace kdm {
namespace {

// Between a triangle beside a new edge and the plane it should lie in.
constexpr double kLeastCosine = 0.5;

class Splitting {
 public:
  Splitting(const GridView& view, const FaceSettings& settings, DualMesh& mesh, EditLog& log)
      : view_(view), settings_(settings), mesh_(mesh), log_(log), before_(mesh.triangles()) {}

  Index run(const Scope& vertices) {
    const Index before = mesh_.vertices();
    vertices.for_each(before, [&](VertexId v) {
      if (mesh_.on_boundary(v)) return;
      read_ring(v);
      limit_ = error_limit(settings_.split_error, view_, polygons_, mesh_.position[v]);
      split(v);
    });
    log_.note_added(AddedBy::kVertexSplits, before, mesh_);
    return mesh_.vertices() - before;
  }

 private:
  // Cuts sections off v until what is left to it fits, or no cut leaves sound triangles.
  void split(Index v) {
    while (!meets_planes(view_.grid, polygons_, mesh_.position[v], limit_)) {
      bool cut = false;
      for (std::size_t start = 0; start < polygons_.size() && !cut; ++start) {
        cut = cut_off(v, find_section(start, mesh_.leaf[v]));
      }
      if (!cut) return;
      read_ring(v);
    }
  }

  // Polygons first, first + 1, ... of the ring, cyclically.
  struct Section {
    std::size_t first = 0;
    std::size_t count = 0;
    Vec3 position = Vec3::Zero();
  };

  // Such triangles stand for no plane.
  bool filling(Index triangle) const {
    return triangle >= before_ && filling_[triangle - before_] != 0;
  }

  void read_ring(Index v) {
    ring_.clear();
    polygons_.clear();
    ring_index_.clear();
    for (const HalfEdgeId h : mesh_.ring(v)) {
      if (!filling(h / 3)) {
        ring_index_.push_back(ring_.size());
        polygons_.push_back(mesh_.hit[h / 3]);
      }
      ring_.push_back(h);
    }
  }

  // Tells whether one vertex can serve the section, and keeps the vertex's position if so.
  bool serve(Section& section, Index leaf) {
    hits_.clear();
    for (std::size_t i = 0; i < section.count; ++i) {
      hits_.push_back(polygons_[(section.first + i) % polygons_.size()]);
    }
    const Vec3 position = vertex_position(view_, hits_, view_.boxes[leaf], settings_.position);
    if (!meets_planes(view_.grid, hits_, position, limit_)) return false;
    section.position = position;
    return true;
  }

  Section find_section(std::size_t start, Index leaf) {
    Section section{start, 1};
    serve(section, leaf);  // the plane of a hit meets the leaf at the hit
    while (section.count < polygons_.size()) {
      Section longer{section.first, section.count + 1};
      if (!serve(longer, leaf)) break;
      section = longer;
    }
    while (section.count < polygons_.size()) {
      Section longer{(section.first + polygons_.size() - 1) % polygons_.size(), section.count + 1};
      if (!serve(longer, leaf)) break;
      section = longer;
    }
    return section;
  }

  // Returns the half-edge out of v between polygon i and the next one: if triangles fill the gap
  // between the two polygons, the half-edge in the middle of them.
  Index boundary_after(std::size_t i) const {
    const std::size_t from = ring_index_[i];
    const std::size_t to = ring_index_[(i + 1) % ring_index_.size()];
    const std::size_t gap = (to + ring_.size() - from - 1) % ring_.size();
    return ring_[(from + gap / 2) % ring_.size()];
  }

  bool cut_off(Index v, const Section& section) {
    const std::size_t n = polygons_.size();
    if (section.count == n) return false;
    const Index last = boundary_after((section.first + section.count - 1) % n);
    const Index before = boundary_after((section.first + n - 1) % n);
    // Both cuts along edges to one vertex would fold the new triangles onto each other.
    if (target(last) == target(before)) return false;
    const bool inherited = section.count >= 3;
    const Vec3 rest = position_of_rest(section, inherited, mesh_.leaf[v]);
    if (folded(polygons_[(section.first + section.count - 1) % n], target(last), section.position,
               rest) ||
        folded(polygons_[section.first], target(before), rest, section.position)) {
      return false;
    }
    for (const Index hit : polygons_) log_.note_edited(hit);
    log_.note_split(v);
    const auto w = mesh_.vertices();
    mesh_.position.push_back(section.position);
    mesh_.leaf.push_back(mesh_.leaf[v]);
    const Index first = next_in_triangle(mesh_.opposite[before]);
    mesh_.first_half_edge.push_back(first);
    const Index remaining = next_in_triangle(mesh_.opposite[last]);
    for (const HalfEdgeId h : mesh_.ring_from(first)) {
      if (h == remaining) break;
      mesh_.vertex[h] = w;
    }
    mesh_.first_half_edge[v] = remaining;
    const Index beyond = mesh_.opposite[last];
    const Index behind = mesh_.opposite[before];
    const Index one = mesh_.add_triangle(mesh_.hit[last / 3], mesh_.vertex[beyond], w, v);
    const Index other = mesh_.add_triangle(mesh_.hit[behind / 3], mesh_.vertex[behind], v, w);
    mesh_.link(one, last);
    mesh_.link(one + 1, other + 1);
    mesh_.link(one + 2, beyond);
    mesh_.link(other, before);
    mesh_.link(other + 2, behind);
    filling_.insert(filling_.end(), 2, inherited ? 0 : 1);
    mesh_.position[v] = rest;
    return true;
  }

  Vec3 position_of_rest(const Section& section, bool inherited, Index leaf) {
    const std::size_t n = polygons_.size();
    hits_.clear();
    const std::size_t shared = inherited ? 1 : 0;
    for (std::size_t i = section.count - shared; i < n + shared; ++i) {
      hits_.push_back(polygons_[(section.first + i) % n]);
    }
    return vertex_position(view_, hits_, view_.boxes[leaf], settings_.position);
  }

  // Tells whether the triangle beside the new edge would face away from the polygon that it
  // continues.
  bool folded(Index hit, Index u, const Vec3& from, const Vec3& to) const {
    const Vec3& apex = mesh_.position[u];
    const Vec3 normal = (from - apex).cross(to - apex);
    const Vec3& wanted = view_.grid.plane_of(hit).normal;
    return !(normal.dot(wanted) > kLeastCosine * normal.norm());
  }

  Index target(Index half_edge) const { return mesh_.end_vertex(half_edge); }

  GridView view_;
  const FaceSettings& settings_;
  DualMesh& mesh_;
  EditLog& log_;
  Index before_;               // triangles
  double limit_ = 0;           // of the vertex at hand
  std::vector<char> filling_;  // per triangle added
  // Of the vertex at hand: its half-edges, the hits of its polygons and their places in the ring.
  std::vector<Index> ring_;
  std::vector<Index> polygons_;
  std::vector<std::size_t> ring_index_;
  std::vector<Index> hits_;
};

}  // namespace

Index split_vertices(const GridView& view, const FaceSettings& settings, DualMesh& mesh,
                     EditLog& log, const Scope& vertices) {
  return Splitting(view, settings, mesh, log).run(vertices);
}

}  // namespace kdm
