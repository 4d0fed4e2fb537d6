// SPDX-License-Identifier: MIT
// Corners of the surface that the hits round them do not show.
//
// Paper 2.2.1 places a vertex by the planes of its hits. A face that is cut off by the corner of a
// leaf may have a corner of the surface in that leaf and meet none of its edges; then its plane is
// missing, and the vertex may be anywhere along the crease of the others. So where planes at a mesh
// vertex differ from all planes of a loop that all pass through it, the grid keeps the vertex.
// The tip of a corner may also reach through a side into a leaf none of whose edges is hit: then
// the loop on the other side has it.
#include "link/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/quadric.h"
#include "geometry/triangle_box.h"
#include "prepare/crease_vertices.h"

namespace kdm {
namespace {

// Cosines of 30 degrees, beyond which a plane counts as another one, and of half of that. Scans
// bend by 18 where they are merely rough: 1,946 corners in place of 339 on the Armadillo at 0.05 %,
// and 47 more crossings.
constexpr double kOtherPlane = 0.866;
constexpr double kHalfOfThat = 0.966;
// How far from a corner its loop's planes may pass, as a fraction of the leaf's shortest side: much
// more, and the leaf holds a detail that no vertex of its own stands for.
constexpr double kPassing = 0.05;

class CornerSearch {
 public:
  CornerSearch(const Surface& surface, std::span<const TriangleId> triangle_of_hit, GridData& grid)
      : surface_(surface),
        triangle_of_hit_(triangle_of_hit),
        grid_(grid),
        crease_vertices_(surface, surface.planes, kHalfOfThat) {}

  void run() {
    if (crease_vertices_.all().empty()) return;
    boxes_ = cell_boxes(grid_);
    find_leaves();
    part_.assign(surface_.triangles.size(), kNone);
    for (Index leaf = 0; leaf < grid_.cells.size(); ++leaf) {
      if (!crease_vertices_in_.of(leaf).empty()) search_leaf(leaf);
    }
    std::sort(grid_.corners.begin(), grid_.corners.end(),
              [](const KeptCorner& a, const KeptCorner& b) { return a.half_edge < b.half_edge; });
    grid_.corners.shrink_to_fit();
  }

 private:
  const CreaseVertex& crease_vertex(Index number) const { return crease_vertices_.all()[number]; }
  const Vec3& normal(Index triangle) const { return surface_.planes[triangle].normal; }
  const LatticeBox& home_of(Index number) const { return boxes_[home_[number]]; }

  Index leaf_at(const LatticePoint& p) const {
    Index c = 0;
    while (!grid_.cells[c].leaf()) {
      const Cell& cell = grid_.cells[c];
      c = below_plane(p[cell.axis()], cell.value()) ? cell.below() : cell.above();
    }
    return c;
  }

  // Which crease vertices and half-edges each leaf has.
  void find_leaves() {
    std::vector<char> has_loops(grid_.cells.size(), 0);
    for (Index h = 0; h < grid_.start.size(); ++h) has_loops[grid_.start_leaf(h)] = 1;
    std::vector<char> wanted(grid_.cells.size(), 0);
    std::vector<Index> leaf_of;
    for (Index i = 0; i < crease_vertices_.all().size(); ++i) {
      home_.push_back(leaf_at(crease_vertex(i).at));
      leaf_of.push_back(has_loops[home_[i]] != 0 ? home_[i] : leaf_behind(i));
      wanted[leaf_of[i]] = 1;
    }
    crease_vertices_in_ = Groups(grid_.cells.size(), [&](const auto& put) {
      for (Index i = 0; i < leaf_of.size(); ++i) put(leaf_of[i], i);
    });
    half_edges_in_ = Groups(grid_.cells.size(), [&](const auto& put) {
      for (Index h = 0; h < grid_.start.size(); ++h) {
        const Index leaf = grid_.start_leaf(h);
        if (wanted[leaf] != 0) put(leaf, h);
      }
    });
  }

  // The leaf from which the surface reaches into the crease vertex's own: where the middle of what
  // leads to the crease vertex comes in.
  Index leaf_behind(Index number) const {
    const LatticeBox& box = home_of(number);
    const Vec3 tip = to_vec3(crease_vertex(number).at);
    Vec3 back = Vec3::Zero();
    for (const Index t : crease_vertices_.triangles_round(crease_vertex(number))) {
      for (const LatticePoint& p : surface_.triangles[t]) {
        const Vec3 along = to_vec3(p) - tip;
        const double length = along.norm();
        if (length > 0) back += along / length;
      }
    }
    int axis = 0;
    double nearest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
      if (back[i] == 0) continue;
      const double way = ((back[i] > 0 ? box.hi[i] : box.lo[i]) - tip[i]) / back[i];
      if (way >= nearest) continue;
      nearest = way;
      axis = i;
    }
    if (!(nearest < std::numeric_limits<double>::infinity())) return home_[number];
    LatticePoint beyond;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::int32_t>(std::floor(tip[i] + nearest * back[i]));
      beyond[i] = std::clamp(at, box.lo[i] + 1, box.hi[i]);
    }
    beyond[axis] = back[axis] > 0 ? box.hi[axis] + 1 : box.lo[axis];
    return leaf_at(beyond);
  }

  void search_leaf(Index leaf) {
    const std::span<const Index> half_edges = half_edges_in_.of(leaf);
    walked_.assign(half_edges.size(), 0);
    first_part_ = parts_;
    for (std::size_t i = 0; i < half_edges.size(); ++i) {
      if (walked_[i] == 0 && walk(half_edges, half_edges[i])) search_loop(leaf, half_edges[i]);
    }
  }

  // Collects the hits of the half-edge's loop; false if that ends at a boundary.
  bool walk(std::span<const Index> half_edges, Index from) {
    hits_.clear();
    Index half_edge = from;
    do {
      const auto place = std::lower_bound(half_edges.begin(), half_edges.end(), half_edge);
      walked_[static_cast<std::size_t>(place - half_edges.begin())] = 1;
      // What closes a hole has no plane that counts.
      const TriangleId triangle = triangle_of_hit_[half_edge / 3];
      if (triangle != kNone) hits_.push_back(triangle);
      const Index other = grid_.opposite[half_edge];
      if (other == kNone) return false;
      half_edge = next_half_edge(other, grid_.hits[other / 3].reversed());
    } while (half_edge != from);
    return !hits_.empty();
  }

  void search_loop(Index leaf, Index half_edge) {
    const LatticeBox& box = boxes_[leaf];
    const double passing = kPassing * (to_vec3(box.hi) - to_vec3(box.lo)).minCoeff();
    corners_.clear();
    for (const Index i : crease_vertices_in_.of(leaf)) {
      if (!planes_pass(to_vec3(crease_vertex(i).at), passing)) continue;
      if (home_[i] == leaf && !plane_missing(crease_vertex(i))) continue;
      if (on_same_part(i, box)) corners_.push_back(i);
    }
    if (corners_.empty()) return;
    grid_.corners.push_back({half_edge, exact_position(middle_corner())});
  }

  bool planes_pass(const Vec3& p, double within) const {
    return std::all_of(hits_.begin(), hits_.end(), [&](Index triangle) {
      return surface_.planes[triangle].distance(p) <= within;
    });
  }

  bool plane_missing(const CreaseVertex& corner) const {
    const std::span<const Index> round = crease_vertices_.triangles_round(corner);
    return std::any_of(round.begin(), round.end(), [&](Index t) {
      return std::all_of(hits_.begin(), hits_.end(), [&](Index hit) {
        return std::abs(normal(hit).dot(normal(t))) < kOtherPlane;
      });
    });
  }

  // Does the surface lead from the crease vertex to all hits, through the leaf and the one that it
  // lies in?
  bool on_same_part(Index number, const LatticeBox& box) {
    const std::span<const Index> round = crease_vertices_.triangles_round(crease_vertex(number));
    if (part_[round[0]] == kNone || part_[round[0]] < first_part_) {
      spread(round, box, home_of(number));
    }
    const Index part = part_[round[0]];
    return std::all_of(hits_.begin(), hits_.end(), [&](Index hit) { return part_[hit] == part; });
  }

  void spread(std::span<const Index> from, const LatticeBox& box, const LatticeBox& home) {
    const Index part = parts_++;
    stack_.clear();
    const auto visit = [&](Index triangle) {
      if (part_[triangle] == part) return;
      part_[triangle] = part;
      stack_.push_back(triangle);
    };
    for (const Index triangle : from) visit(triangle);
    while (!stack_.empty()) {
      const Index triangle = stack_.back();
      stack_.pop_back();
      const LatticeTriangle& t = surface_.triangles[triangle];
      for (int i = 0; i < 3; ++i) {
        const SideId opposite = surface_.topology.opposite[3 * triangle + static_cast<Index>(i)];
        if (opposite == kNone) continue;
        const LatticePoint& a = t[i];
        const LatticePoint& b = t[next_corner(i)];
        if (edge_meets_box(a, b, box) || edge_meets_box(a, b, home)) visit(opposite / 3);
      }
    }
  }

  // Where a curved crease bends through the leaf there are several.
  Index middle_corner() const {
    if (corners_.size() == 1) return corners_[0];
    PrimalQuadric quadric(to_vec3(crease_vertex(corners_[0]).at));
    for (const Index i : corners_) add_planes(crease_vertex(i), quadric);
    Index best = kNone;
    double least = std::numeric_limits<double>::infinity();
    for (const Index i : corners_) {
      const double error = quadric.error(to_vec3(crease_vertex(i).at));
      if (best != kNone && error >= least) continue;
      best = i;
      least = error;
    }
    return best;
  }

  void add_planes(const CreaseVertex& corner, PrimalQuadric& quadric) const {
    for (const Index t : crease_vertices_.triangles_round(corner)) quadric.add(surface_.planes[t]);
  }

  // Where the planes met before rounding.
  Vec3 exact_position(Index number) const {
    const Vec3 rounded = to_vec3(crease_vertex(number).at);
    PrimalQuadric quadric(rounded);
    add_planes(crease_vertex(number), quadric);
    const Vec3 exact = quadric.minimiser(PrimalQuadric::kFineCutoff);
    if ((exact - rounded).squaredNorm() > 1) return rounded;
    const LatticeBox& box = home_of(number);
    return exact.cwiseMax(to_vec3(box.lo)).cwiseMin(to_vec3(box.hi));
  }

  const Surface& surface_;
  std::span<const TriangleId> triangle_of_hit_;
  GridData& grid_;
  CreaseVertices crease_vertices_;
  std::vector<LatticeBox> boxes_;
  std::vector<Index> home_;     // per crease vertex: the leaf it lies in
  Groups crease_vertices_in_;   // by the leaf whose loops may have them
  Groups half_edges_in_;        // by leaf, of those with crease vertices
  std::vector<char> walked_;    // per half-edge of the leaf at hand
  std::vector<Index> hits_;     // triangles of the loop at hand
  std::vector<Index> corners_;  // crease vertices that it may have
  std::vector<Index> part_;  // per triangle: the part of the surface in a leaf it was last seen in
  Index parts_ = 0;
  Index first_part_ = 0;  // of the leaf at hand
  std::vector<Index> stack_;
};

}  // namespace

void keep_corners(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                  GridData& grid) {
  CornerSearch(surface, triangle_of_hit, grid).run();
}

}  // namespace kdm
