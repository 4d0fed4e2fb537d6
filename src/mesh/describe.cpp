// SPDX-License-Identifier: MIT
// Counts what keeps an index mesh from being 2-manifold, and measures it.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <new>
#include <numeric>
#include <vector>

#include "kdmanifold/error.h"
#include "kdmanifold/mesh.h"
#include "mesh/check_indices.h"

namespace kdm {
namespace {

// Faces of either kind under one number: triangles first. Corner 4 * face + k.
class Faces {
 public:
  explicit Faces(const Mesh& mesh) : mesh_(mesh) {}
  std::size_t size() const { return mesh_.triangles.size() + mesh_.quads.size(); }
  std::size_t corners(std::size_t face) const { return face < mesh_.triangles.size() ? 3 : 4; }
  const Index* operator[](std::size_t face) const {
    const std::size_t triangles = mesh_.triangles.size();
    return face < triangles ? mesh_.triangles[face].data() : mesh_.quads[face - triangles].data();
  }

 private:
  const Mesh& mesh_;
};

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t find(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t i, std::size_t j) {
    i = find(i);
    j = find(j);
    if (i != j) parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::size_t> parent_;
};

// Items sorted into buckets by a key below `keys`: bucket k is [start[k], start[k + 1]).
template <typename Item, typename KeyOf>
std::vector<std::size_t> bucket_sort(std::vector<Item>& items, std::size_t keys, KeyOf key_of) {
  std::vector<std::size_t> start(keys + 1, 0);
  for (const Item& item : items) ++start[key_of(item) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<Item> sorted(items.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (const Item& item : items) sorted[next[key_of(item)]++] = item;
  items.swap(sorted);
  return start;
}

class Describer {
 public:
  explicit Describer(const Mesh& mesh)
      : mesh_(mesh),
        faces_(mesh),
        degenerate_(faces_.size()),
        vertex_faults_(mesh.positions.size()) {}

  MeshReport run() {
    report_.vertices = static_cast<Index>(mesh_.positions.size());
    report_.triangles = static_cast<Index>(mesh_.triangles.size());
    report_.quads = static_cast<Index>(mesh_.quads.size());
    check_indices(mesh_);
    find_degenerate();
    count_duplicates();
    count_edges();
    count_vertices();
    measure();
    report_.closed = report_.boundary_edges == 0 && faces_.size() > 0;
    report_.manifold = faces_.size() > 0 && report_.non_manifold_edges == 0 &&
                       report_.misoriented_edges == 0 && report_.non_manifold_vertices == 0 &&
                       report_.degenerate_faces == 0 && report_.duplicate_faces == 0;
    report_.two_manifold = report_.closed && report_.manifold;
    return report_;
  }

 private:
  struct EdgeUse {
    Index low, high;
    std::size_t face;
    std::uint8_t low_corner, high_corner;
    bool upwards;  // from the low to the high vertex
  };

  void find_degenerate() {
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      const Index* v = faces_[face];
      const std::size_t n = faces_.corners(face);
      for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < i; ++j) degenerate_[face] |= v[i] == v[j];
      }
      report_.degenerate_faces += degenerate_[face] != 0;
    }
  }

  void count_duplicates() {
    std::vector<Quad> sorted;
    sorted.reserve(faces_.size());
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      if (degenerate_[face]) continue;
      Quad key = {kNone, kNone, kNone, kNone};
      std::copy(faces_[face], faces_[face] + faces_.corners(face), key.begin());
      std::sort(key.begin(), key.end());
      sorted.push_back(key);
    }
    const auto start =
        bucket_sort(sorted, mesh_.positions.size(), [](const Quad& key) { return key[0]; });
    for (std::size_t v = 0; v + 1 < start.size(); ++v) {
      std::sort(sorted.data() + start[v], sorted.data() + start[v + 1]);
      for (std::size_t i = start[v] + 1; i < start[v + 1]; ++i) {
        report_.duplicate_faces += sorted[i] == sorted[i - 1];
      }
    }
  }

  void count_edges() {
    std::vector<EdgeUse> uses;
    uses.reserve(3 * mesh_.triangles.size() + 4 * mesh_.quads.size());
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      if (degenerate_[face]) continue;
      const std::size_t n = faces_.corners(face);
      for (std::size_t k = 0; k < n; ++k) {
        const std::size_t k2 = k + 1 == n ? 0 : k + 1;
        const Index from = faces_[face][k];
        const Index to = faces_[face][k2];
        const auto corner = static_cast<std::uint8_t>(k);
        const auto corner2 = static_cast<std::uint8_t>(k2);
        uses.push_back(from < to ? EdgeUse{from, to, face, corner, corner2, true}
                                 : EdgeUse{to, from, face, corner2, corner, false});
      }
    }
    const auto start =
        bucket_sort(uses, mesh_.positions.size(), [](const EdgeUse& use) { return use.low; });
    DisjointSets parts(faces_.size());
    DisjointSets fans(4 * faces_.size());
    for (std::size_t v = 0; v + 1 < start.size(); ++v) {
      std::sort(uses.data() + start[v], uses.data() + start[v + 1],
                [](const EdgeUse& a, const EdgeUse& b) {
                  return a.high != b.high ? a.high < b.high : a.face < b.face;
                });
      for (std::size_t i = start[v]; i < start[v + 1];) {
        std::size_t end = i + 1;
        while (end < start[v + 1] && uses[end].high == uses[i].high) ++end;
        count_edge(&uses[i], end - i, parts, fans);
        i = end;
      }
    }
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      report_.components += !degenerate_[face] && parts.find(face) == face;
    }
    find_split_fans(fans);
    count_boundary_loops();
  }

  void count_boundary_loops() {
    if (boundary_.empty()) return;
    DisjointSets parts(mesh_.positions.size());
    std::vector<char> on_boundary(mesh_.positions.size(), 0);
    for (const auto& [a, b] : boundary_) {
      parts.join(a, b);
      on_boundary[a] = on_boundary[b] = 1;
    }
    for (std::size_t v = 0; v < on_boundary.size(); ++v) {
      report_.boundary_loops += on_boundary[v] != 0 && parts.find(v) == v;
    }
  }

  void count_edge(const EdgeUse* uses, std::size_t count, DisjointSets& parts, DisjointSets& fans) {
    ++edges_;
    report_.boundary_edges += count == 1;
    if (count == 1) boundary_.emplace_back(uses->low, uses->high);
    report_.non_manifold_edges += count > 2;
    report_.misoriented_edges += count == 2 && uses[0].upwards == uses[1].upwards;
    if (count > 2) vertex_faults_[uses->low] = vertex_faults_[uses->high] = true;
    for (std::size_t i = 1; i < count; ++i) {
      const EdgeUse& a = uses[i - 1];
      const EdgeUse& b = uses[i];
      parts.join(a.face, b.face);
      fans.join(4 * a.face + a.low_corner, 4 * b.face + b.low_corner);
      fans.join(4 * a.face + a.high_corner, 4 * b.face + b.high_corner);
    }
  }

  // The corners at a vertex that edges join are a fan; a second one is a fault.
  void find_split_fans(DisjointSets& fans) {
    constexpr std::size_t kNoFan = ~std::size_t{0};
    std::vector<std::size_t> fan_of(mesh_.positions.size(), kNoFan);
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      if (degenerate_[face]) continue;
      for (std::size_t k = 0; k < faces_.corners(face); ++k) {
        const Index v = faces_[face][k];
        const std::size_t fan = fans.find(4 * face + k);
        if (fan_of[v] == kNoFan) fan_of[v] = fan;
        if (fan_of[v] != fan) vertex_faults_[v] = true;
      }
    }
    for (std::size_t v = 0; v < fan_of.size(); ++v) {
      used_vertices_ += fan_of[v] != kNoFan;
      report_.non_manifold_vertices += vertex_faults_[v] != 0;
    }
  }

  void count_vertices() {
    std::vector<bool> referenced(mesh_.positions.size());
    Box& box = report_.bounds;
    for (std::size_t face = 0; face < faces_.size(); ++face) {
      for (std::size_t k = 0; k < faces_.corners(face); ++k) {
        const Index v = faces_[face][k];
        const Vec3& p = mesh_.positions[v];
        const bool empty = box.min.x() > box.max.x();
        box.min = empty ? p : Vec3(box.min.cwiseMin(p));
        box.max = empty ? p : Vec3(box.max.cwiseMax(p));
        referenced[v] = true;
      }
    }
    report_.unreferenced_vertices =
        static_cast<Index>(std::count(referenced.begin(), referenced.end(), false));
    const std::size_t faces = faces_.size() - report_.degenerate_faces;
    report_.euler_characteristic = static_cast<std::int64_t>(used_vertices_) -
                                   static_cast<std::int64_t>(edges_) +
                                   static_cast<std::int64_t>(faces);
  }

  void measure() {
    if (faces_.size() == 0) return;
    // Seen from the middle of the box the terms are small, and so are their rounding errors.
    const Vec3 centre = report_.bounds.min + (report_.bounds.max - report_.bounds.min) / 2;
    const auto add = [&](Index i, Index j, Index k) {
      const Vec3 a = mesh_.positions[i] - centre;
      const Vec3 b = mesh_.positions[j] - centre;
      const Vec3 c = mesh_.positions[k] - centre;
      const Vec3 n = (b - a).cross(c - a);
      report_.area += std::sqrt(n.x() * n.x() + n.y() * n.y() + n.z() * n.z()) / 2;
      report_.volume += (a.x() * n.x() + a.y() * n.y() + a.z() * n.z()) / 6;
    };
    for (const Triangle& t : mesh_.triangles) add(t[0], t[1], t[2]);
    for (const Quad& q : mesh_.quads) {
      add(q[0], q[1], q[2]);
      add(q[0], q[2], q[3]);
    }
  }

  const Mesh& mesh_;
  Faces faces_;
  std::vector<char> degenerate_;
  std::vector<char> vertex_faults_;
  std::vector<std::pair<Index, Index>> boundary_;
  MeshReport report_;
  std::size_t edges_ = 0;
  std::size_t used_vertices_ = 0;
};

}  // namespace

MeshReport describe(const Mesh& mesh) {
  try {
    return Describer(mesh).run();
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::kOutOfMemory, "not enough memory to describe the mesh");
  }
}

}  // namespace kdm
