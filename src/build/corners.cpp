// SPDX-License-Identifier: MIT
// Corners of the surface that the hits round them do not show.
//
// Paper 2.2.1 places a vertex by the planes of its hits. A face that is cut off by the corner of a
// leaf may have a corner of the surface in that leaf and meet none of its edges; then its plane is
// missing, and the vertex may be anywhere along the crease of the others. So where planes at a mesh
// vertex differ from all planes of a loop that all pass through it, the grid keeps the vertex.
#include "build/corners.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "geometry/quadric.h"
#include "geometry/triangle_box.h"

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

// A mesh vertex at which the surface bends.
struct Bend {
  Index leaf;
  Index point;
  LatticePoint at;
};

class CornerSearch {
 public:
  CornerSearch(const Surface& surface, GridData& grid) : surface_(surface), grid_(grid) {}

  void run() {
    find_bends();
    if (bends_.empty()) return;
    find_leaf_half_edges();
    boxes_ = cell_boxes(grid_);
    part_.assign(surface_.triangles.size(), kNone);
    for (std::size_t begin = 0; begin < bends_.size();) {
      std::size_t end = begin;
      while (end < bends_.size() && bends_[end].leaf == bends_[begin].leaf) ++end;
      search_leaf(std::span(bends_).subspan(begin, end - begin));
      begin = end;
    }
    std::sort(grid_.corners.begin(), grid_.corners.end(),
              [](const KeptCorner& a, const KeptCorner& b) { return a.half_edge < b.half_edge; });
    grid_.corners.shrink_to_fit();
  }

 private:
  const Vec3& normal(Index triangle) const { return grid_.planes[triangle].normal; }

  // Two normals of which one is bent off the first one seen by half the angle at least.
  void find_bends() {
    Index points = 0;
    for (const Triangle& t : surface_.corners) points = std::max({points, t[0], t[1], t[2]});
    std::vector<Index> first(std::size_t{points} + 1, kNone);
    std::vector<char> bent(first.size(), 0);
    const auto triangles = static_cast<Index>(surface_.triangles.size());
    for (Index t = 0; t < triangles; ++t) {
      if (surface_.degenerate[t] != 0) continue;
      for (const Index p : surface_.corners[t]) {
        if (first[p] == kNone) first[p] = t;
        if (normal(t).dot(normal(first[p])) < kHalfOfThat) bent[p] = 1;
      }
    }
    // Now `first` leads to the beginning of what is round the bent ones.
    Index count = 0;
    std::fill(first.begin(), first.end(), kNone);
    for (Index t = 0; t < triangles; ++t) {
      for (int i = 0; i < 3; ++i) {
        const Index p = surface_.corners[t][i];
        if (bent[p] == 0) continue;
        ++count;
        if (first[p] != kNone) continue;
        first[p] = 0;
        const LatticePoint& at = surface_.triangles[t][i];
        bends_.push_back({leaf_of(at), p, at});
      }
    }
    std::sort(bends_.begin(), bends_.end(), [](const Bend& a, const Bend& b) {
      return a.leaf != b.leaf ? a.leaf < b.leaf : a.point < b.point;
    });
    round_begin_.assign(first.size() + 1, 0);
    for (const Triangle& t : surface_.corners) {
      for (const Index p : t) round_begin_[p + 1] += bent[p] != 0 ? 1 : 0;
    }
    for (std::size_t p = 0; p < first.size(); ++p) round_begin_[p + 1] += round_begin_[p];
    round_.resize(count);
    std::copy(round_begin_.begin(), round_begin_.end() - 1, first.begin());
    for (Index t = 0; t < triangles; ++t) {
      for (const Index p : surface_.corners[t]) {
        if (bent[p] != 0) round_[first[p]++] = t;
      }
    }
  }

  std::span<const Index> triangles_round(Index point) const {
    return std::span(round_).subspan(round_begin_[point],
                                     round_begin_[point + 1] - round_begin_[point]);
  }

  Index leaf_of(const LatticePoint& p) const {
    Index c = 0;
    while (!grid_.cells[c].leaf()) {
      const Cell& cell = grid_.cells[c];
      c = below_plane(p[cell.axis()], cell.value()) ? cell.below() : cell.above();
    }
    return c;
  }

  // Of the leaves that hold bends, in the order of leaves and half-edges.
  void find_leaf_half_edges() {
    std::vector<char> wanted(grid_.cells.size(), 0);
    for (const Bend& bend : bends_) wanted[bend.leaf] = 1;
    for (Index h = 0; h < grid_.start.size(); ++h) {
      const Index leaf = grid_.start_leaf(h);
      if (wanted[leaf] != 0) half_edges_.push_back({leaf, h});
    }
    std::sort(half_edges_.begin(), half_edges_.end());
    next_half_edge_ = 0;
  }

  void search_leaf(std::span<const Bend> bends) {
    const Index leaf = bends[0].leaf;
    while (next_half_edge_ < half_edges_.size() && half_edges_[next_half_edge_].first < leaf) {
      ++next_half_edge_;
    }
    const std::size_t begin = next_half_edge_;
    while (next_half_edge_ < half_edges_.size() && half_edges_[next_half_edge_].first == leaf) {
      ++next_half_edge_;
    }
    const auto own = std::span(half_edges_).subspan(begin, next_half_edge_ - begin);
    walked_.assign(own.size(), 0);
    first_part_ = parts_;
    for (std::size_t i = 0; i < own.size(); ++i) {
      if (walked_[i] == 0 && walk(own, own[i].second)) search_loop(bends, own[i].second);
    }
  }

  // Collects the hits of the half-edge's loop; false if that ends at a boundary.
  bool walk(std::span<const std::pair<Index, Index>> own, Index from) {
    hits_.clear();
    Index half_edge = from;
    do {
      const auto place =
          std::lower_bound(own.begin(), own.end(), std::pair(own[0].first, half_edge));
      walked_[static_cast<std::size_t>(place - own.begin())] = 1;
      // What closes a hole has no plane that counts.
      const Index hit = half_edge / 3;
      if (grid_.hits[hit].plane() < surface_.triangles.size()) {
        hits_.push_back(grid_.hits[hit].plane());
      }
      const Index other = grid_.opposite[half_edge];
      if (other == kNone) return false;
      half_edge = next_half_edge(other, grid_.hits[other / 3].reversed());
    } while (half_edge != from);
    return !hits_.empty();
  }

  void search_loop(std::span<const Bend> bends, Index half_edge) {
    const LatticeBox& box = boxes_[bends[0].leaf];
    const double passing = kPassing * (real(box.hi) - real(box.lo)).minCoeff();
    corners_.clear();
    for (const Bend& bend : bends) {
      if (planes_pass(real(bend.at), passing) && plane_missing(bend) && on_same_part(bend, box)) {
        corners_.push_back(&bend);
      }
    }
    if (corners_.empty()) return;
    grid_.corners.push_back({half_edge, exact_position(middle_corner(), box)});
  }

  bool planes_pass(const Vec3& p, double within) const {
    return std::all_of(hits_.begin(), hits_.end(), [&](Index triangle) {
      return grid_.planes[triangle].distance(p) <= within;
    });
  }

  bool plane_missing(const Bend& bend) const {
    const std::span<const Index> round = triangles_round(bend.point);
    return std::any_of(round.begin(), round.end(), [&](Index t) {
      return surface_.degenerate[t] == 0 && std::all_of(hits_.begin(), hits_.end(), [&](Index hit) {
               return std::abs(normal(hit).dot(normal(t))) < kOtherPlane;
             });
    });
  }

  // Does the surface lead from the bend to all hits within the leaf?
  bool on_same_part(const Bend& bend, const LatticeBox& box) {
    const std::span<const Index> round = triangles_round(bend.point);
    if (part_[round[0]] == kNone || part_[round[0]] < first_part_) spread(round, box);
    const Index part = part_[round[0]];
    return std::all_of(hits_.begin(), hits_.end(), [&](Index hit) { return part_[hit] == part; });
  }

  void spread(std::span<const Index> from, const LatticeBox& box) {
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
        const Index twin = surface_.topology.twin[3 * triangle + static_cast<Index>(i)];
        if (twin != kNone && edge_meets_box(t[i], t[next_corner(i)], box)) visit(twin / 3);
      }
    }
  }

  // Where a curved crease bends through the leaf there are several.
  const Bend& middle_corner() const {
    if (corners_.size() == 1) return *corners_[0];
    PrimalQuadric quadric(real(corners_[0]->at));
    for (const Bend* corner : corners_) add_planes(*corner, quadric);
    const Bend* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Bend* corner : corners_) {
      const double error = quadric.error(real(corner->at));
      if (best != nullptr && error >= least) continue;
      best = corner;
      least = error;
    }
    return *best;
  }

  void add_planes(const Bend& bend, PrimalQuadric& quadric) const {
    for (const Index t : triangles_round(bend.point)) {
      if (surface_.degenerate[t] == 0) quadric.add(grid_.planes[t]);
    }
  }

  // Where the planes met before rounding.
  Vec3 exact_position(const Bend& bend, const LatticeBox& box) const {
    const Vec3 rounded = real(bend.at);
    PrimalQuadric quadric(rounded);
    add_planes(bend, quadric);
    const Vec3 exact = quadric.minimiser(PrimalQuadric::kFineCutoff);
    if ((exact - rounded).squaredNorm() > 1) return rounded;
    return exact.cwiseMax(real(box.lo)).cwiseMin(real(box.hi));
  }

  const Surface& surface_;
  GridData& grid_;
  std::vector<LatticeBox> boxes_;
  std::vector<Bend> bends_;         // by leaf
  std::vector<Index> round_begin_;  // per point: into `round_`, the triangles round bent points
  std::vector<Index> round_;
  std::vector<std::pair<Index, Index>> half_edges_;  // with their leaves
  std::size_t next_half_edge_ = 0;
  std::vector<char> walked_;  // per half-edge of the leaf at hand
  std::vector<Index> hits_;   // triangles of the loop at hand
  std::vector<const Bend*> corners_;
  std::vector<Index> part_;  // per triangle: the connected part within a leaf that it was seen in
  Index parts_ = 0;
  Index first_part_ = 0;  // of the leaf at hand
  std::vector<Index> stack_;
};

}  // namespace

void keep_corners(const Surface& surface, GridData& grid) { CornerSearch(surface, grid).run(); }

}  // namespace kdm
