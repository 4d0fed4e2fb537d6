// SPDX-License-Identifier: MIT
#include "merge/grid_vertices.h"

#include <algorithm>

#include "geometry/assert.h"
#include "grid/faces.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

constexpr int kKeyBits = 21;

std::uint64_t key_of(int axis, const LatticePoint& p) {
  const auto bits = [&](int i) { return static_cast<std::uint64_t>(p[i]); };
  return bits(next_axis(axis)) << 2 * kKeyBits | bits(previous_axis(axis)) << kKeyBits | bits(axis);
}

}  // namespace

GridVertices::GridVertices(const GridData& grid, const std::vector<LatticeBox>& boxes,
                           const std::function<int(const LatticePoint&)>& state_at) {
  std::vector<LatticePoint> vertices;
  for_each_face_or_empty(grid, boxes, [&](const MinimalFace& face) {
    for_each_corner(face, [&](const LatticePoint& p) { vertices.push_back(p); });
  });
  sort_up(vertices);
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  for (std::vector<Vertex>& all : on_lines_) all.reserve(vertices.size());
  for (const LatticePoint& p : vertices) {
    const int state = state_at(p);
    for (int axis = 0; axis < 3; ++axis) on_lines_[axis].push_back({key_of(axis, p), state});
  }
  for (std::vector<Vertex>& all : on_lines_) {
    sort_by(all, [](const Vertex& a, const Vertex& b) { return a.key < b.key; });
  }
}

std::span<const GridVertices::Vertex> GridVertices::between(int axis, const LatticePoint& low,
                                                            std::int32_t high) const {
  LatticePoint end = low;
  end[axis] = high;
  const std::vector<Vertex>& all = on_lines_[axis];
  const auto at = [&](const LatticePoint& p) {
    return std::lower_bound(all.begin(), all.end(), key_of(axis, p),
                            [](const Vertex& v, std::uint64_t key) { return v.key < key; });
  };
  const auto first = at(low);
  const auto last = at(end);
  KDM_ASSERT(last != all.end() && last->key == key_of(axis, end), "an edge ends at a grid vertex");
  return std::span(all).subspan(static_cast<std::size_t>(first - all.begin()),
                                static_cast<std::size_t>(last + 1 - first));
}

}  // namespace kdm
