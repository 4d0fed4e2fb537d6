// SPDX-License-Identifier: MIT
// Vertices at hits and links.
#include "extract/refine.h"

#include <algorithm>
#include <cmath>

#include "extract/edit.h"
#include "extract/link_point.h"
#include "geometry/distance.h"

namespace kdm {
namespace {

class Refinement {
 public:
  Refinement(const GridData& grid, const std::vector<LatticeBox>& boxes,
             const std::vector<Vec3>& points, const Details& details, double distance,
             const DualMesh& mesh)
      : grid_(grid),
        boxes_(boxes),
        points_(points),
        details_(details),
        distance_(distance),
        mesh_(mesh) {}

  // All is found before anything is divided, so half-edge h is still that of hit h / 3.
  void find() {
    const auto hits = static_cast<Index>(points_.size());
    for (Index h = 0; h < 3 * hits; ++h) {
      const Index other = mesh_.opposite[h];
      if (mesh_.dropped(h / 3) || other < h || other >= 3 * hits) continue;
      if ((mesh_.strip[h / 3] >> (h % 3) & 1) != 0) {
        // Two hits at one point: one vertex, on the edge between their triangles.
        if (level(h / 3, other / 3) != Detail::kPlain) strips_.push_back(h);
      } else {
        look_at_link(h, other);
      }
    }
    for (Index t = 0; t < hits; ++t) {
      if (mesh_.strip[t] == 0 && !mesh_.dropped(t) && details_.of_hit(t) != Detail::kPlain) {
        triangles_.push_back(t);
      }
    }
  }

  void divide(DualMesh& mesh) const {
    Division division(mesh);
    // Hits first: what is divided later is joined to them.
    for (const Index t : triangles_) division.triangle(t, points_[t]);
    for (const Index h : strips_) division.edge(h, points_[h / 3]);
    for (const auto& [half_edge, position] : links_) division.edge(half_edge, position);
  }

  Index vertices() const {
    return static_cast<Index>(triangles_.size() + strips_.size() + links_.size());
  }

 private:
  Detail level(Index hit, Index other) const {
    return std::max(details_.of_hit(hit), details_.of_hit(other));
  }

  void look_at_link(Index h, Index other) {
    const Index hit = h / 3;
    const Index other_hit = other / 3;
    const Detail detail = level(hit, other_hit);
    const Index a = mesh_.vertex[h];
    const Index b = mesh_.vertex[other];
    const std::optional<LinkFace> face = face_between(boxes_[mesh_.leaf[a]], boxes_[mesh_.leaf[b]]);
    if (!face) return;
    const Vec3 crossing = crossing_point(*face, mesh_.position[a], mesh_.position[b]);
    if (detail == Detail::kPlain && fits_chord(*face, hit, other_hit, crossing)) return;
    if (detail >= Detail::kApart) {
      links_.emplace_back(h, chord_point(points_, *face, hit, other_hit));
      return;
    }
    const Vec3 corner = crease_point(grid_, points_, *face, hit, other_hit);
    if (detail == Detail::kFull || misses(hit, corner, other_hit, crossing)) {
      links_.emplace_back(h, corner);
    }
  }

  static Vec3 crossing_point(const LinkFace& face, const Vec3& p, const Vec3& q) {
    const double across = q[face.axis] - p[face.axis];
    if (across == 0) return 0.5 * (p + q);
    return p + std::clamp((face.lo[face.axis] - p[face.axis]) / across, 0.0, 1.0) * (q - p);
  }

  // Is the surface flat between the hits, and the edge near it? Cheap, and true of most.
  bool fits_chord(const LinkFace& face, Index hit, Index other, const Vec3& crossing) const {
    const double half = distance_ / 2;
    return grid_.plane_of(other).distance(points_[hit]) <= half &&
           grid_.plane_of(hit).distance(points_[other]) <= half &&
           grid_.plane_of(hit).distance(crossing) <= half &&
           (crossing.array() >= face.lo.array() - distance_).all() &&
           (crossing.array() <= face.hi.array() + distance_).all();
  }

  // Is the crossing too far from the line hit - corner - other?
  bool misses(Index hit, const Vec3& corner, Index other, const Vec3& crossing) const {
    return std::min(squared_distance(crossing, points_[hit], corner),
                    squared_distance(crossing, corner, points_[other])) > distance_ * distance_;
  }

  const GridData& grid_;
  const std::vector<LatticeBox>& boxes_;
  const std::vector<Vec3>& points_;
  const Details& details_;
  double distance_;
  const DualMesh& mesh_;
  std::vector<Index> triangles_;  // of hits that become vertices
  std::vector<Index> strips_;     // half-edges between two hits that become one
  std::vector<std::pair<Index, Vec3>> links_;
};

}  // namespace

Index refine(const GridData& grid, const std::vector<LatticeBox>& boxes,
             const std::vector<Vec3>& points, const Details& details, double distance,
             DualMesh& mesh) {
  Refinement refinement(grid, boxes, points, details, distance, mesh);
  refinement.find();
  if (refinement.vertices() > 0) refinement.divide(mesh);
  return refinement.vertices();
}

}  // namespace kdm
