// SPDX-License-Identifier: MIT
// Checks the invariants of a grid, rule by rule.
#include "grid/validate.h"

#include <algorithm>

#include "grid/faces.h"
#include "grid/splitting_edges.h"
#include "kdmanifold/error.h"
#include "mesh/marks.h"
#include "mesh/topology.h"
#include "text/compose.h"

namespace kdm {
namespace {

void require(bool condition, const char* rule, std::size_t where) {
  if (!condition) {
    throw Error(ErrorCode::kInternal, compose("grid: {} (at {})", rule, where));
  }
}

// Checks the numbers of children and axes. To be called first: all other checks follow them.
void validate_cells(const GridData& grid) {
  require(grid.cells.size() % 2 == 1, "there is a root and two cells a split", grid.cells.size());
  Marks is_child(grid.cells.size());
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    const Cell& cell = grid.cells[c];
    if (cell.leaf()) continue;
    require(cell.below() > c && cell.below() < grid.cells.size() - 1, "children follow their cell",
            c);
    require(cell.below() % 2 == 1, "children are adjacent, the lower one odd", c);
    require(cell.axis() < 3, "a split has an axis", c);
    for (const CellId child : {cell.below(), cell.above()}) {
      require(!is_child.test_and_set(child), "a cell has one parent", child);
    }
  }
  for (std::size_t c = 1; c < is_child.size(); ++c) require(is_child.test(c), "no cell is lost", c);
  std::vector<int> depth(grid.cells.size(), 0);
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    require(depth[c] <= kMaxDepth, "no cell lies deeper than midpoints can", c);
    const Cell& cell = grid.cells[c];
    if (!cell.leaf()) depth[cell.below()] = depth[cell.above()] = depth[c] + 1;
  }
}

void validate_splits(const GridData& grid, const std::vector<LatticeBox>& boxes) {
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    const Cell& cell = grid.cells[c];
    if (cell.leaf()) continue;
    require(cell.value() > boxes[c].lo[cell.axis()] && cell.value() < boxes[c].hi[cell.axis()],
            "a split lies strictly inside its cell", c);
  }
}

// Hits ascend, lie on their edge, alternate, and carry the right flags.
void validate_edges(const GridData& grid, const std::vector<LatticeBox>& boxes) {
  require(grid.edge_begin.size() == 4 * std::size_t{grid.splits()} + 1 && grid.edge_begin[0] == 0 &&
              grid.edge_begin.back() == grid.hits.size(),
          "splitting edges cover all hits", grid.edge_begin.size());
  for_each_splitting_edge(grid, boxes, [&](const SplittingEdge& edge) {
    require(edge.hits.first <= edge.hits.beyond && edge.hits.beyond <= grid.hits.size(),
            "edges' hits are in order", edge.number);
    for (const HitId h : edge.hits) {
      const Hit& hit = grid.hits[h];
      require(floor_of(hit.position) >= edge.box.lo[edge.axis] &&
                  floor_of(hit.position) < edge.box.hi[edge.axis],
              "a hit lies on its edge", h);
      require(hit.reversed() == reversed_on_edge(edge.i, hit.leaving()), "a hit is turned rightly",
              h);
      require(hit.plane() < grid.planes.size(), "a hit has a plane", h);
      if (h == edge.hits.first) continue;
      if (grid.sheet) {  // two-sided walls and crossing sheets may be hit at one position
        require(grid.hits[h - 1].position <= hit.position, "hits ascend along an edge", h);
        continue;
      }
      require(grid.hits[h - 1].position < hit.position, "hits ascend along an edge", h);
      require(grid.hits[h - 1].leaving() != hit.leaving(), "hits alternate along an edge", h);
    }
  });
}

void validate_planes(const GridData& grid) {
  require(grid.source_faces.size() == grid.planes.size(), "a plane has a source face",
          grid.planes.size());
  Index met = 0;
  for (const Hit& hit : grid.hits) {
    require(hit.plane() <= met, "planes come in the order of their first hits", hit.plane());
    if (hit.plane() == met) ++met;
  }
  require(met == grid.planes.size(), "planes come in the order of their first hits", met);
}

// Checks half-edges and links, face by face: links join half-edges of one minimal face that run
// against each other. A solid's do not cross.
class FaceValidation {
 public:
  explicit FaceValidation(const GridData& grid)
      : grid_(grid), crosses_a_face_(3 * grid.hits.size()) {
    if (grid.sheet) face_of_.assign(3 * grid.hits.size(), 0);
  }

  void operator()(const MinimalFace& face) {
    require(grid_.cells[face.below].leaf() && grid_.cells[face.above].leaf(),
            "a minimal face lies between leaves", face.below);
    outline_.clear();
    for_each_hit(face, [&](const FaceEdge& edge, HitId hit, int) {
      const HalfEdgeId half_edge = 3 * hit + edge.slot;
      require(!crosses_a_face_.test_and_set(half_edge), "a half-edge crosses one minimal face",
              half_edge);
      outline_.push_back(half_edge);
      const CellId leaf = starts_below(edge, grid_.hits[hit].reversed()) ? face.below : face.above;
      require(grid_.start_leaf(half_edge) == leaf, "a half-edge starts in its leaf", half_edge);
      require(grid_.crosses_strip(half_edge) == face.strip(), "strips are marked", half_edge);
    });
    if (grid_.sheet) {
      ++faces_;
      for (const HalfEdgeId half_edge : outline_) face_of_[half_edge] = faces_;
    } else {
      validate_links();
    }
  }

  void finish() const {
    for (HalfEdgeId h = 0; h < crosses_a_face_.size(); ++h) {
      require(crosses_a_face_.test(h), "every half-edge crosses a minimal face", h);
    }
    if (grid_.sheet) validate_sheet_links();
  }

 private:
  // Links of a sheet may cross, where the input crosses itself, and may be missing, but not across
  // strips, whose two sides carry the same hits.
  void validate_sheet_links() const {
    for (HalfEdgeId h = 0; h < crosses_a_face_.size(); ++h) {
      const HalfEdgeId other = grid_.opposite[h];
      if (other == kNone) {
        require(!grid_.crosses_strip(h), "strips are linked", h);
        continue;
      }
      require(other < crosses_a_face_.size() && grid_.opposite[other] == h, "links are mutual", h);
      require(grid_.start_leaf(h) != grid_.start_leaf(other),
              "linked half-edges run against each other", h);
      require(face_of_[h] == face_of_[other], "links of a face join its own hits and do not cross",
              h);
    }
  }

  // Links of a solid nest like brackets round the face.
  void validate_links() {
    open_.clear();
    for (const HalfEdgeId half_edge : outline_) {
      const HalfEdgeId other = grid_.opposite[half_edge];
      require(other < crosses_a_face_.size() && grid_.opposite[other] == half_edge,
              "links are mutual", half_edge);
      require(grid_.start_leaf(half_edge) != grid_.start_leaf(other),
              "linked half-edges run against each other", half_edge);
      if (!open_.empty() && open_.back() == half_edge) {
        open_.pop_back();
      } else {
        open_.push_back(other);
      }
    }
    require(open_.empty(), "links of a face join its own hits and do not cross",
            outline_.empty() ? 0 : outline_[0]);
  }

  const GridData& grid_;
  Marks crosses_a_face_;        // per half-edge
  std::vector<Index> face_of_;  // per half-edge of a sheet: the number of the face it crosses
  Index faces_ = 0;             // that were visited
  std::vector<HalfEdgeId> outline_;
  std::vector<HalfEdgeId> open_;  // the ends, not met yet, of the links that have begun
};

void validate_rims(const GridData& grid) {
  for (std::size_t i = 0; i < grid.rims.size(); ++i) {
    const HalfEdgeId half_edge = grid.rims[i].half_edge;
    require(half_edge < grid.opposite.size(), "a rim is of a half-edge", i);
    require(!grid.sheet || grid.opposite[half_edge] == kNone,
            "a sheet's rim is of a half-edge on the boundary", i);
    require(i == 0 || grid.rims[i - 1].half_edge < half_edge, "rims ascend", i);
  }
}

void validate_corners(const GridData& grid) {
  for (std::size_t i = 0; i < grid.corners.size(); ++i) {
    const HalfEdgeId half_edge = grid.corners[i].half_edge;
    require(half_edge < grid.opposite.size(), "a corner is of a half-edge", i);
    require(i == 0 || grid.corners[i - 1].half_edge < half_edge, "corners ascend", i);
  }
}

void validate_exact(const GridData& grid) {
  const Mesh& exact = grid.exact;
  const std::size_t operands = grid.operands.empty() ? 0 : exact.triangles.size();
  require(exact.source_faces.size() == exact.triangles.size() &&
              exact.source_operands.size() == operands && exact.quads.empty(),
          "an exact triangle has a source face", exact.source_faces.size());
  for (std::size_t t = 0; t < exact.triangles.size(); ++t) {
    const auto& [a, b, c] = exact.triangles[t];
    require(std::max({a, b, c}) < exact.positions.size() && a != b && b != c && c != a,
            "an exact triangle has three vertices", t);
  }
  const Topology topology =
      build_topology(exact.triangles, static_cast<Index>(exact.positions.size()));
  require(topology.closed() && topology.non_manifold_edges == 0,
          "exact triangles meet in pairs along their edges", topology.unbalanced_edges);
}

}  // namespace

void validate(const GridData& grid) {
  validate_cells(grid);
  const std::vector<LatticeBox> boxes = cell_boxes(grid);
  validate_splits(grid, boxes);
  validate_edges(grid, boxes);
  require(grid.opposite.size() == 3 * grid.hits.size() && grid.start.size() == grid.opposite.size(),
          "a hit has three half-edges", grid.opposite.size());
  validate_planes(grid);
  validate_rims(grid);
  validate_corners(grid);
  validate_exact(grid);
  FaceValidation faces(grid);
  for_each_face(grid, boxes, faces);
  faces.finish();
}

}  // namespace kdm
