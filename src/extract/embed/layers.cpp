// SPDX-License-Identifier: MIT
// Surfaces of several loops, drawn inwards from the sides of their leaf.
#include "extract/embed/layers.h"

#include <algorithm>
#include <optional>

#include "extract/embed/box_surface.h"

namespace kdm {
namespace {

// How much of the way to the middle the innermost goes.
constexpr double kInwards = 0.5;

// Of the leaf, lattice units; less leaves no room for layers in 32 bits.
constexpr double kLeastExtent = 16;

class Layers {
 public:
  Layers(const LatticeBox& box, std::span<const Index> loops, DualMesh& mesh, EditLog& log)
      : lo_(to_vec3(box.lo)), hi_(to_vec3(box.hi)), loops_(loops), mesh_(mesh), log_(log) {}

  bool run() {
    if ((hi_ - lo_).minCoeff() < kLeastExtent) return false;
    for (const Index v : loops_) {
      if (!read_ring(v)) return false;
    }
    std::vector<Vec3> points;
    for (const Index v : ring_vertices_) points.push_back(mesh_.position[v]);
    surface_ = triangulate_box(lo_, hi_, std::move(points), curves_);
    if (!surface_) return false;
    for (std::size_t i = 0; i < loops_.size(); ++i) replace(i);
    return true;
  }

 private:
  // The loop's triangles (v, a, b), each b the next one's a.
  bool read_ring(Index v) {
    if (mesh_.on_boundary(v)) return false;
    std::vector<HalfEdgeId> fan;
    for (const HalfEdgeId h : mesh_.ring(v)) fan.push_back(h);
    std::reverse(fan.begin(), fan.end());
    Curve curve;
    for (const Index h : fan) {
      const Index a = mesh_.end_vertex(h);
      if (mesh_.leaf[a] != kNone) return false;
      curve.push_back(static_cast<Index>(ring_vertices_.size()));
      ring_vertices_.push_back(a);
    }
    curves_.push_back(std::move(curve));
    fans_.push_back(std::move(fan));
    return true;
  }

  void replace(std::size_t loop) {
    const std::vector<Index>& fan = fans_[loop];
    const Curve& curve = curves_[loop];
    const BoxSurface::Cap& cap = surface_->caps[loop];
    const double scale = 1 - kInwards * cap.level / surface_->levels;
    inner_.assign(surface_->points.size(), kNone);
    inner_[curve[0]] = loops_[loop];
    mesh_.position[loops_[loop]] = drawn(curve[0], scale);
    for (const Index p : curve) inner(p, scale);
    std::vector<std::pair<std::array<Index, 2>, Index>> open;  // half-edges, by their vertices
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const std::size_t next = i + 1 == fan.size() ? 0 : i + 1;
      const Index from = inner_[curve[i]];
      const Index to = inner_[curve[next]];
      const Index h = fan[i];
      log_.note_edited(mesh_.hit[h / 3]);
      mesh_.vertex[h] = from;
      mesh_.first_half_edge[from] = h;
      const Index b = mesh_.vertex[previous_in_triangle(h)];
      const Index beside = mesh_.add_triangle(mesh_.hit[h / 3], from, b, to);
      mesh_.link(beside, previous_in_triangle(h));
      open.push_back({{to, from}, beside + 2});
    }
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const std::size_t next = i + 1 == fan.size() ? 0 : i + 1;
      // b -> its inner one, in the new triangle, and back in the next triangle of the fan.
      mesh_.link(mesh_.opposite[previous_in_triangle(fan[i])] + 1, fan[next]);
    }
    close(cap, scale, mesh_.hit[fan[0] / 3], open);
  }

  void close(const BoxSurface::Cap& cap, double scale, Index hit,
             std::vector<std::pair<std::array<Index, 2>, Index>>& open) {
    for (const Index t : cap.triangles) {
      Triangle corners = surface_->triangles[t];
      if (!cap.left) std::swap(corners[1], corners[2]);
      for (Index& corner : corners) corner = inner(corner, scale);
      const Index first = mesh_.add_triangle(hit, corners[0], corners[1], corners[2]);
      for (Index i = 0; i < 3; ++i) {
        mesh_.first_half_edge[corners[i]] = first + i;
        open.push_back({{corners[i], corners[(i + 1) % 3]}, first + i});
      }
    }
    std::sort(open.begin(), open.end());
    for (const auto& [ends, half_edge] : open) {
      const std::array<Index, 2> back = {ends[1], ends[0]};
      const auto other = std::lower_bound(open.begin(), open.end(), std::pair{back, Index{0}});
      mesh_.opposite[half_edge] = other->second;
    }
  }

  // The vertex for a point drawn inwards.
  Index inner(Index point, double scale) {
    if (inner_[point] == kNone) {
      inner_[point] = mesh_.vertices();
      mesh_.position.push_back(drawn(point, scale));
      mesh_.leaf.push_back(kNone);
      mesh_.first_half_edge.push_back(kNone);
    }
    return inner_[point];
  }

  Vec3 drawn(Index point, double scale) const {
    const Vec3 middle = 0.5 * (lo_ + hi_);
    return middle + scale * (surface_->points[point] - middle);
  }

  Vec3 lo_;
  Vec3 hi_;
  std::span<const Index> loops_;
  DualMesh& mesh_;
  EditLog& log_;
  std::vector<Index> ring_vertices_;      // of all loops
  std::vector<Curve> curves_;             // per loop: its part of these
  std::vector<std::vector<Index>> fans_;  // per loop: half-edges from it, in that order
  std::optional<BoxSurface> surface_;
  std::vector<Index> inner_;  // per point of the surface
};

}  // namespace

bool draw_inwards(const LatticeBox& box, std::span<const Index> loops, DualMesh& mesh,
                  EditLog& log) {
  const Index before = mesh.vertices();
  const bool drawn = Layers(box, loops, mesh, log).run();
  log.note_added(AddedBy::kLinks, before, mesh);
  return drawn;
}

}  // namespace kdm
