// SPDX-License-Identifier: MIT
// Copies rings on smaller boxes, and closes the copies with caps.
#include "extract/embed/nested_loops.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "extract/embed/box_surface.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// How far the smallest box shrinks: a part of the way from the sides of the leaf to its middle.
constexpr double kGreatestShrinkage = 0.5;

// Least extent of a leaf, in lattice units: in a smaller one boxes within each other would be so
// near to each other that rounding to 32 bits could make them meet.
constexpr double kLeastExtent = 16;

class Nesting {
 public:
  Nesting(const LatticeBox& box, std::span<const LoopId> loops, DualMesh& mesh, EditLog& log)
      : lo_(to_vec3(box.lo)), hi_(to_vec3(box.hi)), loops_(loops), mesh_(mesh), log_(log) {}

  bool run() {
    if ((hi_ - lo_).minCoeff() < kLeastExtent) return false;
    for (const LoopId v : loops_) {
      if (!read_ring(v)) return false;
    }
    std::vector<Vec3> points;
    for (const VertexId v : ring_vertices_) points.push_back(mesh_.position[v]);
    surface_ = triangulate_box(lo_, hi_, std::move(points), curves_);
    if (!surface_) return false;
    for (std::size_t i = 0; i < loops_.size(); ++i) replace_fan(i);
    return true;
  }

 private:
  // A half-edge without opposite yet, with its ends.
  struct OpenSide {
    std::array<VertexId, 2> ends;
    HalfEdgeId half_edge;
    bool operator<(const OpenSide& other) const {
      return ends != other.ends ? ends < other.ends : half_edge < other.half_edge;
    }
  };

  // Reads the loop's triangles (v, a, b) in such an order that each b is the next one's a.
  bool read_ring(LoopId v) {
    if (mesh_.on_boundary(v)) return false;
    std::vector<HalfEdgeId> fan;
    for (const HalfEdgeId h : mesh_.ring(v)) fan.push_back(h);
    std::reverse(fan.begin(), fan.end());
    Curve curve;
    for (const HalfEdgeId h : fan) {
      const VertexId a = mesh_.end_vertex(h);
      if (mesh_.leaf[a] != kNone) return false;  // the vertex of a loop: level below kLinksApart
      curve.push_back(static_cast<Index>(ring_vertices_.size()));
      ring_vertices_.push_back(a);
    }
    curves_.push_back(std::move(curve));
    fans_.push_back(std::move(fan));
    return true;
  }

  // Each triangle (v, a, b) of the fan becomes (a', a, b), with a' the copy of a, and gets a
  // triangle (a', b, b') beside it. Then the cap is added. Vertex v becomes the first copy.
  void replace_fan(std::size_t loop) {
    const std::vector<HalfEdgeId>& fan = fans_[loop];
    const Curve& curve = curves_[loop];
    const BoxSurface::Cap& cap = surface_->caps[loop];
    const double scale = 1 - kGreatestShrinkage * cap.level / surface_->levels;
    copies_.assign(surface_->points.size(), kNone);
    copies_[curve[0]] = loops_[loop];
    mesh_.position[loops_[loop]] = scaled(curve[0], scale);
    for (const Index p : curve) copy_of(p, scale);
    std::vector<OpenSide> open;
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const std::size_t next = i + 1 == fan.size() ? 0 : i + 1;
      const VertexId from = copies_[curve[i]];
      const VertexId to = copies_[curve[next]];
      const HalfEdgeId h = fan[i];
      log_.note_edited(mesh_.hit[h / 3]);
      mesh_.vertex[h] = from;
      mesh_.first_half_edge[from] = h;
      const VertexId b = mesh_.vertex[previous_in_triangle(h)];
      const HalfEdgeId beside = mesh_.add_triangle(mesh_.hit[h / 3], from, b, to);
      mesh_.link(beside, previous_in_triangle(h));
      open.push_back({{to, from}, beside + 2});
    }
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const std::size_t next = i + 1 == fan.size() ? 0 : i + 1;
      // From b to its copy in the triangle beside this one, and back in the next triangle.
      mesh_.link(mesh_.opposite[previous_in_triangle(fan[i])] + 1, fan[next]);
    }
    add_cap(cap, scale, mesh_.hit[fan[0] / 3], open);
  }

  // Adds the triangles of the cap on the smaller box, and links all open sides with each other.
  void add_cap(const BoxSurface::Cap& cap, double scale, HitId hit, std::vector<OpenSide>& open) {
    for (const Index t : cap.triangles) {
      Triangle corners = surface_->triangles[t];
      if (!cap.left) std::swap(corners[1], corners[2]);
      for (Index& corner : corners) corner = copy_of(corner, scale);
      const HalfEdgeId first = mesh_.add_triangle(hit, corners[0], corners[1], corners[2]);
      for (Index i = 0; i < 3; ++i) {
        mesh_.first_half_edge[corners[i]] = first + i;
        open.push_back({{corners[i], corners[(i + 1) % 3]}, first + i});
      }
    }
    sort_up(open);
    for (const auto& [ends, half_edge] : open) {
      const auto opposite =
          std::lower_bound(open.begin(), open.end(), OpenSide{{ends[1], ends[0]}, 0});
      mesh_.opposite[half_edge] = opposite->half_edge;
    }
  }

  // Returns the copy of a point on the smaller box, which is made if there is none yet.
  VertexId copy_of(Index point, double scale) {
    if (copies_[point] == kNone) {
      copies_[point] = mesh_.vertices();
      mesh_.position.push_back(scaled(point, scale));
      mesh_.leaf.push_back(kNone);
      mesh_.first_half_edge.push_back(kNone);
    }
    return copies_[point];
  }

  // Returns the point, drawn towards the middle of the leaf.
  Vec3 scaled(Index point, double scale) const {
    const Vec3 middle = 0.5 * (lo_ + hi_);
    return middle + scale * (surface_->points[point] - middle);
  }

  Vec3 lo_;
  Vec3 hi_;
  std::span<const LoopId> loops_;
  DualMesh& mesh_;
  EditLog& log_;
  std::vector<VertexId> ring_vertices_;        // of all loops
  std::vector<Curve> curves_;                  // per loop: its ring, numbers in `ring_vertices_`
  std::vector<std::vector<HalfEdgeId>> fans_;  // per loop: the half-edges that start in its vertex
  std::optional<BoxSurface> surface_;          // of the leaf's box; its points: the rings', corners
  std::vector<VertexId> copies_;  // per point of the surface: its copy for the current loop
};

}  // namespace

bool nest_loops(const LatticeBox& box, std::span<const LoopId> loops, DualMesh& mesh,
                EditLog& log) {
  const VertexId first_added = mesh.vertices();
  const bool nested = Nesting(box, loops, mesh, log).run();
  log.note_added(AddedBy::kLinks, first_added, mesh);
  return nested;
}

}  // namespace kdm
