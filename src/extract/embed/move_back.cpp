// SPDX-License-Identifier: MIT
#include "extract/embed/move_back.h"

#include <algorithm>
#include <array>
#include <optional>

#include "extract/place/link_face.h"
#include "extract/place/link_point.h"
#include "mesh/marks.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Where a link's vertex lies: between two hits, in the minimal face between two leaves.
struct LinkPlace {
  HitPair hits;
  LinkFace face;
  std::array<LoopId, 2> loops;
};

// Puts a number into the next free place of two, unless it is there already. Returns false if there
// is none.
bool put(Index number, std::array<Index, 2>& two) {
  for (Index& place : two) {
    if (place == number) return true;
    if (place != kNone) continue;
    place = number;
    return true;
  }
  return false;
}

// Returns nothing for vertices that are not those of links, or if loops were joined. A link leads
// between its loops from one of its hits to the other.
std::optional<LinkPlace> place_of(const GridView& view, VertexId loops, const DualMesh& mesh,
                                  VertexId v) {
  std::array<Index, 2> its_loops{kNone, kNone};
  std::array<Index, 2> hits{kNone, kNone};
  for (const HalfEdgeId h : mesh.ring(v)) {
    const HitId hit = mesh.hit[h / 3];
    if (!put(hit, hits)) return std::nullopt;
    const HalfEdgeId opposite = mesh.opposite[h];
    if (opposite == kNone || mesh.hit[opposite / 3] == hit) continue;
    if (mesh.end_vertex(h) >= loops || !put(mesh.end_vertex(h), its_loops)) return std::nullopt;
  }
  if (its_loops[1] == kNone || hits[1] == kNone) return std::nullopt;
  const auto face =
      face_between(view.boxes[mesh.leaf[its_loops[0]]], view.boxes[mesh.leaf[its_loops[1]]]);
  if (!face) return std::nullopt;
  return LinkPlace{{hits[0], hits[1]}, *face, its_loops};
}

}  // namespace

void move_unless_crossing(const std::vector<MovedVertex>& moved, CrossingPairs& crossing_pairs,
                          DualMesh& mesh) {
  Marks stays(moved.size());  // where it was
  std::vector<HitId> changed;
  const auto put = [&](VertexId v, const Vec3& position) {
    mesh.position[v] = position;
    for (const HalfEdgeId h : mesh.ring(v)) changed.push_back(mesh.hit[h / 3]);
  };
  for (const MovedVertex& m : moved) put(m.vertex, m.better);
  while (!changed.empty()) {
    make_set(changed);
    crossing_pairs.update(mesh, changed);
    changed.clear();
    Marks crossing(mesh.vertices());
    for (const TriangleId t : crossing_pairs.triangles()) {
      for (HalfEdgeId h = 3 * t; h < 3 * t + 3; ++h) crossing.set(mesh.vertex[h]);
    }
    for (std::size_t i = 0; i < moved.size(); ++i) {
      if (stays.test(i) || !crossing.test(moved[i].vertex)) continue;
      stays.set(i);
      put(moved[i].vertex, moved[i].position);
    }
  }
}

double furthest_plane(const GridView& view, const DualMesh& mesh, VertexId v, const Vec3& point) {
  double furthest = 0;
  for (const HalfEdgeId h : mesh.ring(v)) {
    furthest = std::max(furthest, view.grid.plane_of(mesh.hit[h / 3]).distance(point));
  }
  return furthest;
}

std::vector<MovedVertex> find_links_off_planes(const GridView& view, const DualMesh& loops,
                                               double distance, const DualMesh& mesh) {
  std::vector<MovedVertex> off;
  std::vector<HitId> beside;
  for (VertexId v = loops.vertices(); v < mesh.vertices(); ++v) {
    if (mesh.first_half_edge[v] == kNone) continue;
    const Vec3& position = mesh.position[v];
    const double furthest = furthest_plane(view, mesh, v, position);
    if (furthest <= distance) continue;
    const std::optional<LinkPlace> place = place_of(view, loops.vertices(), mesh, v);
    if (!place) continue;
    beside.clear();
    for (const LoopId loop : place->loops) {
      for (const HalfEdgeId h : loops.ring(loop)) beside.push_back(loops.hit[h / 3]);
    }
    const Vec3 crease = crease_point(view, place->face, place->hits, beside, distance);
    const Vec3 better = off_sides(place->face, crease, distance);
    if (furthest_plane(view, mesh, v, better) < furthest) off.push_back({v, position, better});
  }
  return off;
}

}  // namespace kdm
