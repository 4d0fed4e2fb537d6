// SPDX-License-Identifier: MIT
#include "merge/kept_hits.h"

#include <algorithm>

#include "grid/links.h"
#include "grid/splitting_edges.h"
#include "link/outline.h"
#include "link/rim_hits.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// The line on which each hit lies: its axis, and its coordinates across it.
struct HitLine {
  int axis = 0;
  std::array<std::int32_t, 2> across{};

  bool operator==(const HitLine&) const = default;
};

std::vector<HitLine> lines_of_hits(const GridData& grid, const std::vector<LatticeBox>& boxes) {
  std::vector<HitLine> lines(grid.hits.size());
  for_each_splitting_edge(grid, boxes, [&](const SplittingEdge& edge) {
    const LatticePoint low = edge.low();
    for (const HitId h : edge.hits) {
      lines[h] = {edge.axis, {low[next_axis(edge.axis)], low[previous_axis(edge.axis)]}};
    }
  });
  return lines;
}

class LinkKeeper {
 public:
  LinkKeeper(const std::array<const GridSolid*, 2>& solids, const std::vector<HitOrigin>& origins,
             GridData& merged)
      : solids_(solids), origins_(origins), merged_(merged), boxes_(cell_boxes(merged)) {
    for (int i = 0; i < 2; ++i) {
      now_[i].assign(3 * solids[i]->grid().hits.size(), kNone);
    }
  }

  void run() {
    for_each_face(merged_, boxes_, [&](const MinimalFace& face) { look_at(face); });
    for (const auto& [a, b] : pairs_) relink(merged_, a, b);
    for (int i = 0; i < 2; ++i) take_rims(i);
    sort_rims(merged_);
    take_corners();
  }

 private:
  // Notes which half-edges of one solid the face has, if they are all of it, and how they were
  // linked.
  void look_at(const MinimalFace& face) {
    collect_outline(merged_, face, outline_);
    const int solid = origins_[outline_.front().hit].solid;
    const GridData& grid = solids_[solid]->grid();
    const CellId below = cell_around(grid, boxes_[face.below]);
    const CellId above = cell_around(grid, boxes_[face.above]);
    if (below == above || !grid.cells[below].leaf() || !grid.cells[above].leaf()) return;
    before_.clear();
    for (const OutlineHit& h : outline_) {
      const HitOrigin& origin = origins_[h.hit];
      if (!origin.kept || origin.solid != solid) return;
      const HalfEdgeId was = half_edge_between(grid, origin.hit, below, above);
      if (was == kNone || grid.crosses_strip(was) != face.strip()) return;
      before_.push_back(was);
    }
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      now_[solid][before_[i]] = outline_[i].half_edge;
    }
    if (!is_ambiguous(face)) return;
    for (std::size_t i = 0; i < outline_.size(); ++i) {
      const HalfEdgeId partner = now_[solid][grid.opposite[before_[i]]];
      if (partner != kNone && partner > outline_[i].half_edge) {
        pairs_.push_back({outline_[i].half_edge, partner});
      }
    }
  }

  // Finds the half-edge between two leaves of a hit, or of one that it is the same as across
  // strips.
  static HalfEdgeId half_edge_between(const GridData& grid, HitId hit, CellId a, CellId b,
                                      HitId from = kNone) {
    for (HalfEdgeId h = 3 * hit; h < 3 * hit + 3; ++h) {
      const CellId start = grid.start_leaf(h);
      const CellId end = end_leaf(grid, h);
      if ((start == a && end == b) || (start == b && end == a)) return h;
    }
    for (HalfEdgeId h = 3 * hit; h < 3 * hit + 3; ++h) {
      const HitId same = grid.opposite[h] / 3;
      if (!grid.crosses_strip(h) || same == from) continue;
      const HalfEdgeId found = half_edge_between(grid, same, a, b, hit);
      if (found != kNone) return found;
    }
    return kNone;
  }

  void take_rims(int solid) {
    for (const RimHit& rim : solids_[solid]->grid().rims) {
      const HalfEdgeId now = now_[solid][rim.half_edge];
      if (now != kNone) merged_.rims.push_back({now, rim.point, rim.normal});
    }
  }

  // A corner stays where its leaf is one of the result and the other solid has no surface in it;
  // then its loop is one of the result too.
  void take_corners() {
    for (int solid = 0; solid < 2; ++solid) {
      for (const KeptCorner& corner : solids_[solid]->grid().corners) {
        const HalfEdgeId now = half_edge_now(solid, corner.half_edge);
        if (now == kNone) continue;
        const CellId leaf = merged_.start_leaf(now);
        const CellId was = solids_[solid]->grid().start_leaf(corner.half_edge);
        const CellId other = cell_around(solids_[1 - solid]->grid(), boxes_[leaf]);
        if (solids_[solid]->boxes()[was] != boxes_[leaf]) continue;
        if (solids_[1 - solid]->has_surface(other)) continue;
        merged_.corners.push_back({lowest_of_loop(now), corner.point, corner.joined});
      }
    }
    sort_by(merged_.corners,
            [](const KeptCorner& a, const KeptCorner& b) { return a.half_edge < b.half_edge; });
  }

  // Of a loop, half-edges start in its leaf; a solid that is turned has those that ended there.
  HalfEdgeId half_edge_now(int solid, HalfEdgeId was) const {
    const HalfEdgeId now = now_[solid][was];
    if (now == kNone || !origins_[now / 3].turned) return now;
    return next_half_edge(now, merged_.hits[now / 3].reversed());
  }

  HalfEdgeId lowest_of_loop(HalfEdgeId first) const {
    HalfEdgeId lowest = first;
    HalfEdgeId h = first;
    do {
      lowest = std::min(lowest, h);
      const HalfEdgeId other = merged_.opposite[h];
      h = next_half_edge(other, merged_.hits[other / 3].reversed());
    } while (h != first);
    return lowest;
  }

  const std::array<const GridSolid*, 2>& solids_;
  const std::vector<HitOrigin>& origins_;
  GridData& merged_;
  std::vector<LatticeBox> boxes_;
  std::array<std::vector<HalfEdgeId>, 2>
      now_;  // per half-edge of a solid: what it is now, or kNone
  std::vector<OutlineHit> outline_;
  std::vector<HalfEdgeId> before_;
  std::vector<std::array<HalfEdgeId, 2>> pairs_;
};

}  // namespace

std::vector<HitOrigin> find_origins(const std::array<const GridSolid*, 2>& solids,
                                    const Surface& surface,
                                    std::span<const TriangleId> triangle_of_hit,
                                    const GridData& merged) {
  const std::vector<HitLine> lines = lines_of_hits(merged, cell_boxes(merged));
  std::array<std::vector<HitLine>, 2> lines_before;
  for (int i = 0; i < 2; ++i)
    lines_before[i] = lines_of_hits(solids[i]->grid(), solids[i]->boxes());
  const auto of_second = static_cast<TriangleId>(solids[0]->surface().corners.size());
  std::vector<HitOrigin> origins(merged.hits.size());
  for (HitId h = 0; h < merged.hits.size(); ++h) {
    const TriangleId triangle = triangle_of_hit[h];
    HitOrigin& origin = origins[h];
    origin.solid = static_cast<int>(surface.solid_of[triangle]);
    origin.hit =
        solids[origin.solid]->surface().hit[triangle - (origin.solid == 1 ? of_second : 0)];
    const Hit& before = solids[origin.solid]->grid().hits[origin.hit];
    origin.kept = before.position == merged.hits[h].position &&
                  lines[h] == lines_before[origin.solid][origin.hit];
    const bool leaving =
        origin.kept ? before.leaving() : points_up(surface.triangles[triangle], lines[h].axis);
    origin.turned = leaving != merged.hits[h].leaving();
  }
  return origins;
}

void take_planes(const std::array<const GridSolid*, 2>& solids, const Surface& surface,
                 std::span<const TriangleId> triangle_of_hit, const std::vector<HitOrigin>& origins,
                 GridData& merged) {
  std::array<std::vector<PlaneId>, 2> numbers;  // per plane of a solid two: as it is, and turned
  for (int i = 0; i < 2; ++i) numbers[i].assign(2 * solids[i]->grid().planes.size(), kNone);
  const std::size_t operands = solids[0]->grid().operands.size();
  const std::array<Index, 2> first_operand{0, operands == 0 ? 1 : static_cast<Index>(operands)};
  merged.planes.clear();
  merged.source_faces.clear();
  merged.source_operands.clear();
  for (HitId h = 0; h < merged.hits.size(); ++h) {
    const HitOrigin& origin = origins[h];
    const GridData& grid = solids[origin.solid]->grid();
    const PlaneId before = grid.hits[origin.hit].plane();
    const Plane& of_triangle = surface.planes[triangle_of_hit[h]];
    const bool shared = origin.kept || of_triangle == grid.planes[before];
    PlaneId own = kNone;
    PlaneId& number =
        shared ? numbers[origin.solid][2 * std::size_t{before} + (origin.turned ? 1 : 0)] : own;
    if (number == kNone) {
      number = static_cast<PlaneId>(merged.planes.size());
      const Plane& plane = shared ? grid.planes[before] : of_triangle;
      merged.planes.push_back(origin.turned ? Plane{-plane.normal, -plane.offset} : plane);
      merged.source_faces.push_back(grid.source_faces[before]);
      const Index of_grid = grid.source_operands.empty() ? 0 : grid.source_operands[before];
      merged.source_operands.push_back(of_grid == kNone ? kNone
                                                        : first_operand[origin.solid] + of_grid);
    }
    const Hit& hit = merged.hits[h];
    merged.hits[h] = Hit(hit.position, number, hit.leaving(), hit.reversed());
  }
}

void take_links(const std::array<const GridSolid*, 2>& solids,
                const std::vector<HitOrigin>& origins, GridData& merged) {
  LinkKeeper(solids, origins, merged).run();
}

}  // namespace kdm
