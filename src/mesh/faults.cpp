// SPDX-License-Identifier: MIT
// Gathers the sides of faces edge by edge, and joins corners at a vertex across the edges there.
#include "mesh/faults.h"

#include <algorithm>
#include <numeric>

#include "kdmanifold/error.h"
#include "mesh/check_indices.h"
#include "mesh/disjoint_sets.h"
#include "mesh/edge_sides.h"
#include "mesh/marks.h"
#include "mesh/polygons.h"
#include "mesh/sort.h"
#include "text/compose.h"

namespace kdm {
namespace {

// Sorts items into one bucket a key; keys are below `keys`. Returns where the buckets begin: bucket
// k is [begin[k], begin[k + 1]).
template <typename Item, typename KeyOf>
std::vector<std::size_t> bucket_sort(std::vector<Item>& items, std::size_t keys, KeyOf key_of) {
  std::vector<std::size_t> begin(keys + 1, 0);
  for (const Item& item : items) ++begin[key_of(item) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Item> sorted(items.size());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (const Item& item : items) sorted[next[key_of(item)]++] = item;
  items.swap(sorted);
  return begin;
}

class Inspector {
 public:
  explicit Inspector(const Mesh& mesh)
      : faces_(mesh),
        vertices_(mesh.positions.size()),
        degenerate_(faces_.size()),
        vertex_at_fault_(vertices_),
        edges_of_(faces_.size()),
        parts_(faces_.size()),
        fans_(4 * std::size_t{faces_.size()}) {}

  MeshFaults run() {
    find_degenerate();
    find_duplicates();
    find_edges();
    number_parts();
    find_split_fans();
    return std::move(faults_);
  }

 private:
  // Returns the number of corner k of a face, and of the side that starts there. Triangles leave
  // every fourth number unused.
  static Index corner(Index face, Index k) { return 4 * face + k; }

  void find_degenerate() {
    for (Index face = 0; face < faces_.size(); ++face) {
      const Index* v = faces_[face];
      const Index n = faces_.corners(face);
      for (Index i = 0; i < n; ++i) {
        for (Index j = 0; j < i; ++j) {
          if (v[i] == v[j]) degenerate_.set(face);
        }
      }
      if (degenerate_.test(face)) faults_.degenerate_faces.push_back(face);
    }
  }

  void find_duplicates() {
    struct Key {
      Quad vertices;  // ascending
      Index face;
    };
    std::vector<Key> keys;
    keys.reserve(faces_.size());
    for (Index face = 0; face < faces_.size(); ++face) {
      if (degenerate_.test(face)) continue;
      Key key = {{kNone, kNone, kNone, kNone}, face};
      std::copy(faces_[face], faces_[face] + faces_.corners(face), key.vertices.begin());
      sort_numbers(key.vertices);
      keys.push_back(key);
    }
    const auto begin = bucket_sort(keys, vertices_, [](const Key& key) { return key.vertices[0]; });
    for (std::size_t v = 0; v < vertices_; ++v) {
      const auto bucket = std::span(keys).subspan(begin[v], begin[v + 1] - begin[v]);
      sort_by(bucket, [](const Key& a, const Key& b) {
        return a.vertices != b.vertices ? a.vertices < b.vertices : a.face < b.face;
      });
      for (std::size_t i = begin[v] + 1; i < begin[v + 1]; ++i) {
        if (keys[i].vertices == keys[i - 1].vertices) {
          faults_.duplicate_faces.push_back(keys[i].face);
        }
      }
    }
    sort_numbers(faults_.duplicate_faces);
  }

  void find_edges() {
    const EdgeSides edges(static_cast<Index>(vertices_), [&](const auto& visit) {
      for (Index face = 0; face < faces_.size(); ++face) {
        if (degenerate_.test(face)) continue;
        const Index* v = faces_[face];
        const Index last = faces_.corners(face) - 1;
        for (Index k = 0; k < last; ++k) visit(v[k], v[k + 1], corner(face, k));
        visit(v[last], v[0], corner(face, last));
      }
    });
    edges.for_each_edge([&](Index low, std::span<const EdgeSide> sides) { add_edge(low, sides); });
    for (BoundaryEdge& edge : faults_.boundary_edges) {
      for (Index& fan : edge.fans) fan = fans_.find(fan);
    }
  }

  static Index face_of(const EdgeSide& side) { return side.side / 4; }
  Index end_of(const EdgeSide& side) const {
    const Index k = side.side % 4;
    return k + 1 == faces_.corners(face_of(side)) ? side.side - k : side.side + 1;
  }
  Index low_corner(const EdgeSide& side) const { return side.forward ? side.side : end_of(side); }
  Index high_corner(const EdgeSide& side) const { return side.forward ? end_of(side) : side.side; }

  // Counts an edge, given all sides along it, and joins what it joins.
  void add_edge(Index low, std::span<const EdgeSide> sides) {
    const EdgeSide& first = sides[0];
    const Edge ascending = {low, first.upper};
    std::uint8_t& found = edges_of_[face_of(first)].found;
    ++edges_of_[face_of(first)].count;
    ++faults_.edges;
    std::size_t upwards = 0;
    for (const EdgeSide& side : sides) upwards += side.forward ? 1 : 0;
    if (2 * upwards != sides.size()) found |= kUnbalanced;
    if (sides.size() == 1) {
      const Edge along = first.forward ? ascending : Edge{first.upper, low};
      faults_.boundary_edges.push_back({along, {first.side, end_of(first)}, face_of(first)});
    } else if (sides.size() == 2 && upwards != 1) {
      found |= kMisoriented;
      faults_.misoriented_edges.push_back(ascending);
    } else if (sides.size() > 2) {
      found |= kNonManifold;
      faults_.non_manifold_edges.push_back(ascending);
      vertex_at_fault_.set(low);
      vertex_at_fault_.set(first.upper);
    }
    for (std::size_t i = 1; i < sides.size(); ++i) {
      parts_.join(face_of(sides[i - 1]), face_of(sides[i]));
      fans_.join(low_corner(sides[i - 1]), low_corner(sides[i]));
      fans_.join(high_corner(sides[i - 1]), high_corner(sides[i]));
    }
  }

  // Numbers the parts, for which their lowest faces stood until now.
  void number_parts() {
    faults_.part_of.assign(faces_.size(), kNone);
    for (Index face = 0; face < faces_.size(); ++face) {
      if (degenerate_.test(face)) continue;
      const Index first = parts_.find(face);
      if (first == face) {
        faults_.part_of[face] = static_cast<Index>(faults_.parts.size());
        faults_.parts.push_back({.first_face = face});
      }
      faults_.part_of[face] = faults_.part_of[first];
      PartTopology& part = faults_.parts[faults_.part_of[face]];
      const Edges& edges = edges_of_[face];
      ++part.faces;
      part.edges += edges.count;
      part.manifold = part.manifold && (edges.found & kNonManifold) == 0;
      part.balanced = part.balanced && (edges.found & kUnbalanced) == 0;
      part.agreeing = part.agreeing && (edges.found & kMisoriented) == 0;
    }
  }

  // Counts fans, and finds vertices with several.
  void find_split_fans() {
    std::vector<Index> fan_of(vertices_, kNone);
    for (Index face = 0; face < faces_.size(); ++face) {
      if (degenerate_.test(face)) continue;
      for (Index k = 0; k < faces_.corners(face); ++k) {
        const Index v = faces_[face][k];
        const Index fan = fans_.find(corner(face, k));
        if (fan == corner(face, k)) ++faults_.parts[faults_.part_of[face]].fans;
        if (fan_of[v] == kNone) fan_of[v] = fan;
        if (fan_of[v] != fan) vertex_at_fault_.set(v);
      }
    }
    for (Index v = 0; v < vertices_; ++v) {
      faults_.vertices += fan_of[v] != kNone;
      if (vertex_at_fault_.test(v)) faults_.non_manifold_vertices.push_back(v);
    }
  }

  // What was found on the edges whose lowest side belongs to a face.
  struct Edges {
    std::uint8_t count = 0;
    std::uint8_t found = 0;  // bits as below
  };
  static constexpr std::uint8_t kUnbalanced = 1, kMisoriented = 2, kNonManifold = 4;

  Polygons faces_;
  std::size_t vertices_;
  Marks degenerate_;             // faces
  Marks vertex_at_fault_;        // vertices
  std::vector<Edges> edges_of_;  // per face
  DisjointSets parts_;           // of faces
  DisjointSets fans_;            // of corners
  MeshFaults faults_;
};

}  // namespace

MeshFaults find_faults(const Mesh& mesh) {
  const std::size_t faces = mesh.triangles.size() + mesh.quads.size();
  if (faces >= (std::size_t{1} << 29)) {
    throw Error(ErrorCode::kInvalidMesh, compose("{} faces; 2^29 is the limit", faces));
  }
  check_indices(mesh);
  return Inspector(mesh).run();
}

}  // namespace kdm
