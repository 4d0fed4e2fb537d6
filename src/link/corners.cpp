// SPDX-License-Identifier: MIT
// Finds corners of the surface that cannot be found from the planes of the hits round them.
//
// Paper 2.2.1 places a vertex by the planes of its hits. A face of the input may reach into a leaf,
// form a corner with other faces there, and meet none of the leaf's edges. Then its plane is
// missing among the planes of the hits, and the minimiser may lie anywhere along the crease of the
// other faces. So the grid keeps a mesh vertex for a loop if all planes of the loop pass near it,
// and a triangle at the vertex has a plane that differs from all of them. It keeps the tip of a
// wedge as well whose sides are so nearly one plane that the minimiser may lie anywhere between
// them. The tip of a corner may also reach through a side of the leaf into a neighbouring leaf none
// of whose edges is hit. Then the corner is kept for the loop in the leaf that the tip comes from.
#include "link/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/quadric.h"
#include "geometry/triangle_box.h"
#include "mesh/marks.h"
#include "mesh/sort.h"
#include "prepare/crease_vertices.h"

namespace kdm {
namespace {

// Planes that differ by 30 degrees count as different: the cosines of this angle and of its half.
// At 18 degrees, by which scans bend where they are merely rough, the Armadillo at a tolerance of
// 0.05 % has 1,946 corners in place of 339, and 47 more pairs of triangles that cross.
constexpr double kBendCosine = 0.866;
constexpr double kBendHalfAngleCosine = 0.966;
// How far from a corner the planes of its loop may pass, as a fraction of the leaf's shortest side.
// If one passes much further off, the leaf holds a detail too small for a vertex of its own, and
// the loop's vertex belongs elsewhere.
constexpr double kMaxPlaneOffset = 0.05;

class CornerSearch {
 public:
  CornerSearch(const Surface& surface, std::span<const TriangleId> triangle_of_hit, GridData& grid)
      : surface_(surface),
        triangle_of_hit_(triangle_of_hit),
        grid_(grid),
        crease_vertices_(surface, surface.planes, kBendHalfAngleCosine) {}

  void run() {
    if (crease_vertices_.all().empty()) return;
    boxes_ = cell_boxes(grid_);
    find_leaves();
    part_.assign(surface_.triangles.size(), kNone);
    for (CellId leaf = 0; leaf < grid_.cells.size(); ++leaf) {
      if (!crease_vertices_in_.of(leaf).empty()) search_leaf(leaf);
    }
    sort_by(grid_.corners,
            [](const KeptCorner& a, const KeptCorner& b) { return a.half_edge < b.half_edge; });
    grid_.corners.shrink_to_fit();
  }

 private:
  const CreaseVertex& crease_vertex(Index number) const { return crease_vertices_.all()[number]; }
  const Vec3& normal(TriangleId triangle) const { return surface_.planes[triangle].normal; }
  // Returns the box of the leaf that the crease vertex lies in.
  const LatticeBox& home_of(Index number) const { return boxes_[home_[number]]; }

  CellId leaf_at(const LatticePoint& p) const {
    CellId c = 0;
    while (!grid_.cells[c].leaf()) {
      const Cell& cell = grid_.cells[c];
      c = below_plane(p[cell.axis()], cell.value()) ? cell.below() : cell.above();
    }
    return c;
  }

  // Assigns crease vertices to the leaves whose loops may have them as corners, and finds the
  // half-edges that start in these leaves.
  void find_leaves() {
    Marks has_loops(grid_.cells.size());
    for (HalfEdgeId h = 0; h < grid_.start.size(); ++h) has_loops.set(grid_.start_leaf(h));
    Marks wanted(grid_.cells.size());
    std::vector<CellId> leaf_of;
    for (Index i = 0; i < crease_vertices_.all().size(); ++i) {
      home_.push_back(leaf_at(crease_vertex(i).at));
      leaf_of.push_back(has_loops.test(home_[i]) ? home_[i] : leaf_behind(i));
      wanted.set(leaf_of[i]);
    }
    crease_vertices_in_ = Groups(grid_.cells.size(), [&](const auto& put) {
      for (Index i = 0; i < leaf_of.size(); ++i) put(leaf_of[i], i);
    });
    half_edges_in_ = Groups(grid_.cells.size(), [&](const auto& put) {
      for (HalfEdgeId h = 0; h < grid_.start.size(); ++h) {
        const CellId leaf = grid_.start_leaf(h);
        if (wanted.test(leaf)) put(leaf, h);
      }
    });
  }

  // Finds the leaf from which the surface reaches into the one that the crease vertex lies in: the
  // leaf beyond the side that is met on the way back from the crease vertex, in the mean direction
  // of the mesh edges that lead away from it.
  CellId leaf_behind(Index number) const {
    const LatticeBox& box = home_of(number);
    const Vec3 tip = to_vec3(crease_vertex(number).at);
    Vec3 back = Vec3::Zero();
    for (const TriangleId t : crease_vertices_.triangles_round(crease_vertex(number))) {
      for (const LatticePoint& p : surface_.triangles[t]) {
        const Vec3 along = to_vec3(p) - tip;
        const double length = along.norm();
        if (length > 0) back += along / length;
      }
    }
    int axis = 0;
    double nearest = std::numeric_limits<double>::infinity();  // side, in lengths of `back`
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

  void search_leaf(CellId leaf) {
    const std::span<const HalfEdgeId> half_edges = half_edges_in_.of(leaf);
    walked_.assign(half_edges.size());
    first_part_ = parts_;
    for (std::size_t i = 0; i < half_edges.size(); ++i) {
      if (!walked_.test(i) && walk(half_edges, half_edges[i])) search_loop(leaf, half_edges[i]);
    }
  }

  // Collects the triangles that make the hits of a half-edge's loop. Returns false if the loop ends
  // at a boundary or has no such triangles.
  bool walk(std::span<const HalfEdgeId> half_edges, HalfEdgeId from) {
    hit_triangles_.clear();
    HalfEdgeId half_edge = from;
    do {
      const auto place = std::lower_bound(half_edges.begin(), half_edges.end(), half_edge);
      walked_.set(static_cast<std::size_t>(place - half_edges.begin()));
      // The planes of invented hits are no planes of the input.
      const TriangleId triangle = triangle_of_hit_[half_edge / 3];
      if (triangle != kNone) hit_triangles_.push_back(triangle);
      const HalfEdgeId other = grid_.opposite[half_edge];
      if (other == kNone) return false;
      half_edge = next_half_edge(other, grid_.hits[other / 3].reversed());
    } while (half_edge != from);
    return !hit_triangles_.empty();
  }

  // Finds the corner of a loop, if it has one, from `hit_triangles_`.
  void search_loop(CellId leaf, HalfEdgeId half_edge) {
    const LatticeBox& box = boxes_[leaf];
    const double max_offset = kMaxPlaneOffset * (to_vec3(box.hi) - to_vec3(box.lo)).minCoeff();
    candidates_.clear();
    for (const Index i : crease_vertices_in_.of(leaf)) {
      if (!all_planes_pass(to_vec3(crease_vertex(i).at), max_offset)) continue;
      if (home_[i] == leaf && !plane_is_missing(crease_vertex(i)) && !is_tip_of_wedge(i)) continue;
      if (on_same_part(i, box)) candidates_.push_back(i);
    }
    if (candidates_.empty()) return;
    grid_.corners.push_back({half_edge, exact_position(middle_corner())});
  }

  // Tells whether the planes of all hits pass within the distance of the point.
  bool all_planes_pass(const Vec3& p, double within) const {
    return std::all_of(hit_triangles_.begin(), hit_triangles_.end(), [&](TriangleId triangle) {
      return surface_.planes[triangle].distance(p) <= within;
    });
  }

  // Tells whether the plane of a triangle at the crease vertex differs from the planes of all hits.
  // At the tip of a wedge, planes that face away from each other differ however sharp it is.
  bool plane_is_missing(const CreaseVertex& corner) const {
    const std::span<const TriangleId> round = crease_vertices_.triangles_round(corner);
    return std::any_of(round.begin(), round.end(), [&](TriangleId t) {
      return std::all_of(hit_triangles_.begin(), hit_triangles_.end(), [&](TriangleId hit) {
        const double cosine = normal(hit).dot(normal(t));
        return (surface_.sheet ? std::abs(cosine) : cosine) < kBendCosine;
      });
    });
  }

  // Tells whether the crease vertex is the tip of a wedge, with two sides that face away from each
  // other. Though all its planes are there, those of its sides are so nearly the same that the
  // usual cutoff may leave open how far it reaches. Creases that merely bend have such planes, too,
  // but they face the same way.
  bool is_tip_of_wedge(Index number) const {
    const CreaseVertex& corner = crease_vertex(number);
    const std::span<const TriangleId> round = crease_vertices_.triangles_round(corner);
    const bool faces_away = std::any_of(round.begin(), round.end(), [&](TriangleId s) {
      return std::any_of(round.begin(), round.end(),
                         [&](TriangleId t) { return normal(s).dot(normal(t)) < -kBendCosine; });
    });
    if (surface_.sheet || !faces_away) return false;
    PrimalQuadric quadric(to_vec3(corner.at));
    add_planes(corner, quadric);
    return quadric.rank(PrimalQuadric::kFineCutoff) == 3;
  }

  // Tells whether the surface leads from the crease vertex to all hits without leaving two leaves:
  // the leaf of the hits, which has the given box, and the leaf that the crease vertex lies in.
  bool on_same_part(Index number, const LatticeBox& box) {
    const std::span<const TriangleId> round =
        crease_vertices_.triangles_round(crease_vertex(number));
    if (part_[round[0]] == kNone || part_[round[0]] < first_part_) {
      label_part(round, box, home_of(number));
    }
    const Index part = part_[round[0]];
    return std::all_of(hit_triangles_.begin(), hit_triangles_.end(),
                       [&](TriangleId t) { return part_[t] == part; });
  }

  // Gives a new number to the part of the surface in the two boxes that is connected with `from`.
  void label_part(std::span<const TriangleId> from, const LatticeBox& box, const LatticeBox& home) {
    const Index part = parts_++;
    stack_.clear();
    const auto visit = [&](TriangleId triangle) {
      if (part_[triangle] == part) return;
      part_[triangle] = part;
      stack_.push_back(triangle);
    };
    for (const TriangleId triangle : from) visit(triangle);
    while (!stack_.empty()) {
      const TriangleId triangle = stack_.back();
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

  // Chooses among the candidates, of which there are several where a curved crease bends through
  // the leaf: the one with the least error against the planes of all.
  Index middle_corner() const {
    if (candidates_.size() == 1) return candidates_[0];
    PrimalQuadric quadric(to_vec3(crease_vertex(candidates_[0]).at));
    for (const Index i : candidates_) add_planes(crease_vertex(i), quadric);
    Index best = kNone;
    double least = std::numeric_limits<double>::infinity();
    for (const Index i : candidates_) {
      const double error = quadric.error(to_vec3(crease_vertex(i).at));
      if (best != kNone && error >= least) continue;
      best = i;
      least = error;
    }
    return best;
  }

  void add_planes(const CreaseVertex& corner, PrimalQuadric& quadric) const {
    for (const TriangleId t : crease_vertices_.triangles_round(corner))
      quadric.add(surface_.planes[t]);
  }

  // Finds the point where the planes at the crease vertex met before it was rounded to the lattice.
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
  std::vector<CellId> home_;   // per crease vertex: the leaf that it lies in
  Groups crease_vertices_in_;  // by the leaf whose loops may have them as corners
  Groups half_edges_in_;       // by the leaf in which they start, only where crease vertices are
  Marks walked_;               // per half-edge of the leaf at hand
  std::vector<TriangleId> hit_triangles_;  // of the loop at hand
  std::vector<Index> candidates_;          // crease vertices that may be its corner
  std::vector<Index> part_;  // per triangle: the last part of the surface it was counted to, kNone
  Index parts_ = 0;          // how many parts were numbered
  Index first_part_ = 0;     // the first one of the leaf at hand
  std::vector<TriangleId> stack_;
};

}  // namespace

void keep_corners(const Surface& surface, std::span<const TriangleId> triangle_of_hit,
                  GridData& grid) {
  CornerSearch(surface, triangle_of_hit, grid).run();
}

}  // namespace kdm
