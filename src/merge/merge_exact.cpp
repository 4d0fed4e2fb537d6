// SPDX-License-Identifier: MIT
#include "merge/merge_exact.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kdmanifold/error.h"
#include "mesh/boxes.h"
#include "mesh/topology.h"

namespace kdm {
namespace {

// The boxes of a grid's thin parts, and the part of each of their triangles.
struct BoxedParts {
  std::vector<Index> of;
  std::vector<LatticeBox> boxes;
};

BoxedParts parts_of(const GridData& grid) {
  const Mesh& mesh = grid.exact;
  BoxedParts parts;
  parts.of = find_parts(build_topology(mesh.triangles, static_cast<Index>(mesh.positions.size())));
  if (parts.of.empty()) parts.of.assign(mesh.triangles.size(), 0);
  std::vector<Box> boxes;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (parts.of[t] >= boxes.size()) boxes.resize(parts.of[t] + 1);
    for (const Index v : mesh.triangles[t]) {
      grow(boxes[parts.of[t]], grid.lattice.to_lattice(mesh.positions[v]));
    }
  }
  for (const Box& box : boxes) {
    LatticeBox& rounded = parts.boxes.emplace_back();
    for (int i = 0; i < 3; ++i) {
      rounded.lo[i] = static_cast<std::int32_t>(std::floor(box.min[i])) - 1;
      rounded.hi[i] = static_cast<std::int32_t>(std::ceil(box.max[i])) + 1;
    }
  }
  return parts;
}

// Also if the boxes only touch.
bool overlap(const LatticeBox& a, const LatticeBox& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.hi[i] < b.lo[i] || b.hi[i] < a.lo[i]) return false;
  }
  return true;
}

LatticeBox box_of(const LatticeTriangle& triangle) {
  LatticeBox box{triangle[0], triangle[0]};
  for (const LatticePoint& p : triangle) {
    for (int i = 0; i < 3; ++i) {
      box.lo[i] = std::min(box.lo[i], p[i]);
      box.hi[i] = std::max(box.hi[i], p[i]);
    }
  }
  return box;
}

// Tells whether the box of a triangle of the solid's surface overlaps a box.
bool meets_surface(const GridSolid& solid, CellId cell, const LatticeBox& box) {
  if (!solid.has_surface(cell) || !overlap(solid.boxes()[cell], box)) return false;
  const Cell& split = solid.grid().cells[cell];
  if (!split.leaf()) {
    return meets_surface(solid, split.below(), box) || meets_surface(solid, split.above(), box);
  }
  const std::span<const Index> triangles = solid.triangles_in(cell);
  return std::any_of(triangles.begin(), triangles.end(),
                     [&](Index t) { return overlap(box_of(solid.triangle(t)), box); });
}

}  // namespace

Mesh merge_exact(const std::array<const GridSolid*, 2>& solids, const MergeFunction& function,
                 const std::array<Index, 2>& first_operand) {
  const std::array<BoxedParts, 2> parts{parts_of(solids[0]->grid()), parts_of(solids[1]->grid())};
  Mesh merged;
  for (int i = 0; i < 2; ++i) {
    const Mesh& exact = solids[i]->grid().exact;
    const GridSolid& other = *solids[1 - i];
    std::vector<int> turn(parts[i].boxes.size());  // 1: as it is, -1: turned, 0: bounds nothing
    for (std::size_t part = 0; part < turn.size(); ++part) {
      const LatticeBox& box = parts[i].boxes[part];
      const auto& others = parts[1 - i].boxes;
      if (meets_surface(other, 0, box) ||
          std::any_of(others.begin(), others.end(),
                      [&](const LatticeBox& b) { return overlap(b, box); })) {
        throw Error(ErrorCode::kInvalidOption,
                    "a thin part that one grid keeps as it is, without cells, lies at surface of "
                    "the other grid; build it with a smaller tolerance, so that it has cells");
      }
      const int without = other.inside(box.lo) ? 2 >> i : 0;
      turn[part] = (function.inside(without | 1 << i) ? 1 : 0) - (function.inside(without) ? 1 : 0);
    }
    std::vector<Index> number(exact.positions.size(), kNone);
    for (std::size_t t = 0; t < exact.triangles.size(); ++t) {
      const int way = turn[parts[i].of[t]];
      if (way == 0) continue;
      Triangle triangle = exact.triangles[t];
      for (Index& v : triangle) {
        if (number[v] == kNone) {
          number[v] = static_cast<Index>(merged.positions.size());
          merged.positions.push_back(exact.positions[v]);
        }
        v = number[v];
      }
      if (way < 0) std::swap(triangle[1], triangle[2]);
      merged.triangles.push_back(triangle);
      merged.source_faces.push_back(exact.source_faces[t]);
      const Index own = exact.source_operands.empty() ? 0 : exact.source_operands[t];
      merged.source_operands.push_back(own == kNone ? kNone : first_operand[i] + own);
    }
  }
  return merged;
}

}  // namespace kdm
