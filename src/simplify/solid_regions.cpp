// SPDX-License-Identifier: MIT
#include "simplify/solid_regions.h"

#include "extract/dual/dual_mesh.h"
#include "extract/place/place.h"
#include "grid/faces.h"
#include "mesh/boxes.h"
#include "mesh/measure.h"
#include "mesh/nesting.h"
#include "mesh/polygons.h"

namespace kdm {

SolidRegions::SolidRegions(const GridData& grid) : hits_(static_cast<Index>(grid.hits.size())) {
  place_triangles(grid);
  find_surfaces(grid);
  measure();
  find_enclosing();
  group();
  find_beside(grid);
}

void SolidRegions::place_triangles(const GridData& grid) {
  const std::vector<LatticeBox> boxes = cell_boxes(grid);
  const std::vector<Vec3> hit_at = hit_points(grid, boxes);
  DualMesh mesh = dual_mesh_of(grid);
  drop_pillows(mesh);
  find_loops(grid, mesh);
  place_vertices({grid, boxes, hit_at}, {.split_error = standard_split_error(grid)}, mesh);
  mesh_.positions = mesh.position;
  const auto loops = static_cast<Index>(mesh_.positions.size());
  for (HitId h = 0; h < hits_; ++h) {
    // A pillow has no vertices.
    mesh_.triangles.push_back({mesh.vertex[3 * h], mesh.vertex[3 * h + 1], mesh.vertex[3 * h + 2]});
  }
  for (const Vec3& p : grid.exact.positions) {
    mesh_.positions.push_back(grid.lattice.to_lattice(p));
  }
  for (const Triangle& t : grid.exact.triangles) {
    mesh_.triangles.push_back({loops + t[0], loops + t[1], loops + t[2]});
  }
}

void SolidRegions::find_surfaces(const GridData& grid) {
  DisjointSets sets(mesh_.triangles.size());
  for (HalfEdgeId h = 0; h < grid.opposite.size(); ++h) sets.join(h / 3, grid.opposite[h] / 3);
  std::vector<Index> at_vertex(mesh_.positions.size(), kNone);
  for (Index t = hits_; t < mesh_.triangles.size(); ++t) {
    for (const Index v : mesh_.triangles[t]) {
      if (at_vertex[v] == kNone) at_vertex[v] = t;
      sets.join(t, at_vertex[v]);
    }
  }
  surface_of_.resize(mesh_.triangles.size());
  for (Index t = 0; t < mesh_.triangles.size(); ++t) {
    if (t == hits_) exact_ = static_cast<Index>(surfaces_.size());
    const Index first = sets.find(t);  // the lowest number of the set
    if (first != t) {
      surface_of_[t] = surface_of_[first];
      continue;
    }
    surface_of_[t] = static_cast<Index>(surfaces_.size());
    surfaces_.emplace_back();
    surfaces_.back().pillow = mesh_.triangles[t][0] == kNone;
  }
  if (hits_ == mesh_.triangles.size()) exact_ = static_cast<Index>(surfaces_.size());
}

void SolidRegions::measure() {
  std::vector<Measure> measures(surfaces_.size());
  std::vector<Index> triangles(surfaces_.size(), 0);
  std::vector<Index> vertices(surfaces_.size(), 0);
  Marks seen(mesh_.positions.size());
  for (Index t = 0; t < mesh_.triangles.size(); ++t) {
    BoundingSurface& surface = surfaces_[surface_of_[t]];
    if (surface.pillow) continue;
    ++triangles[surface_of_[t]];
    for (const Index v : mesh_.triangles[t]) {
      grow(surface.bounds, mesh_.positions[v]);
      if (!seen.test_and_set(v)) ++vertices[surface_of_[t]];
    }
  }
  for (Index s = 0; s < surfaces_.size(); ++s) {
    if (!surfaces_[s].pillow) measures[s].centre = centre_of(surfaces_[s].bounds);
  }
  for (Index t = 0; t < mesh_.triangles.size(); ++t) {
    if (surfaces_[surface_of_[t]].pillow) continue;
    const Triangle& c = mesh_.triangles[t];
    measures[surface_of_[t]].add(mesh_.positions[c[0]], mesh_.positions[c[1]],
                                 mesh_.positions[c[2]]);
  }
  for (Index s = 0; s < surfaces_.size(); ++s) {
    surfaces_[s].volume = measures[s].volume;
    // Three edges for two triangles.
    if (!surfaces_[s].pillow) surfaces_[s].handles = (2 + triangles[s] / 2 - vertices[s]) / 2;
  }
}

void SolidRegions::find_enclosing() {
  constexpr double kScale = 1.0 / kLatticeSize;
  std::vector<Vec3> positions = mesh_.positions;
  for (Vec3& p : positions) p *= kScale;
  std::vector<Shell> shells(surfaces_.size());
  for (Index s = 0; s < surfaces_.size(); ++s) {
    if (surfaces_[s].pillow) continue;
    const Box& bounds = surfaces_[s].bounds;
    shells[s] = {{kScale * bounds.min, kScale * bounds.max}, true};
  }
  std::vector<Index> part_of = surface_of_;
  for (Index& part : part_of) {
    if (surfaces_[part].pillow) part = kNone;
  }
  const auto pairs = find_enclosures(Polygons(mesh_), positions, part_of, shells);
  std::vector<Index> depth(surfaces_.size(), 0);
  if (pairs) {
    for (const Enclosure& pair : *pairs) ++depth[pair.inner];
    for (const Enclosure& pair : *pairs) {
      if (depth[pair.outer] + 1 == depth[pair.inner]) surfaces_[pair.inner].around = pair.outer;
    }
  }
  for (Index s = 0; s < surfaces_.size(); ++s) {
    BoundingSurface& surface = surfaces_[s];
    const bool found = pairs && (surface.around == kNone) == (depth[s] == 0);
    if (!found || surface.volume == 0 || (surface.volume > 0) != (depth[s] % 2 == 0)) {
      surface.sure = false;
      if (surface.around != kNone) surfaces_[surface.around].sure = false;
    }
  }
}

void SolidRegions::group() {
  triangles_of_ = Groups(surfaces_.size(), [&](const auto& put) {
    for (Index t = 0; t < surface_of_.size(); ++t) put(surface_of_[t], t);
  });
  within_ = Groups(surfaces_.size(), [&](const auto& put) {
    for (Index s = 0; s < surfaces_.size(); ++s) {
      if (surfaces_[s].around != kNone) put(surfaces_[s].around, s);
    }
  });
}

// Between two hits that follow each other round a minimal face there is one region.
void SolidRegions::find_beside(const GridData& grid) {
  std::array<DisjointSets, 2> same{DisjointSets(surfaces_.size()), DisjointSets(surfaces_.size())};
  struct Passed {
    Index surface;
    bool into;  // going on round the face leads into material
  };
  std::vector<Passed> outline;
  for_each_face(grid, cell_boxes(grid), [&](const MinimalFace& face) {
    outline.clear();
    for_each_hit(face, [&](const FaceEdge&, HitId hit, int side) {
      const bool up = side < 2;
      outline.push_back({surface_of_[hit], grid.hits[hit].leaving() != up});
    });
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Index next = outline[i + 1 == outline.size() ? 0 : i + 1].surface;
      same[outline[i].into ? 1 : 0].join(outline[i].surface, next);
    }
  });
  compare(false, same[0]);
  compare(true, same[1]);
}

void SolidRegions::compare(bool material, DisjointSets& same) {
  std::vector<Index>& beside = beside_[material ? 1 : 0];
  beside.assign(surfaces_.size(), kNone);
  std::vector<Index> first(surfaces_.size(), kNone);  // per set: one that is no pillow
  for (Index s = 0; s < surfaces_.size(); ++s) {
    if (surfaces_[s].pillow) continue;
    beside[s] = is_material(s) == material ? s : surfaces_[s].around;
    Index& one = first[same.find(s)];
    if (one == kNone) one = s;
    if (beside[s] == beside[one]) continue;
    for (const Index region : {beside[s], beside[one]}) {
      if (region != kNone) surfaces_[region].sure = false;
    }
  }
  for (Index s = 0; s < surfaces_.size(); ++s) {
    const Index one = first[same.find(s)];
    if (surfaces_[s].pillow && one != kNone) beside[s] = beside[one];
  }
}

std::vector<std::array<Vec3, 3>> SolidRegions::boundary_of(Index region) const {
  std::vector<std::array<Vec3, 3>> boundary;
  const auto add = [&](Index surface) {
    for (const Index t : triangles_of_.of(surface)) {
      const auto& [a, b, c] = mesh_.triangles[t];
      const auto& p = mesh_.positions;
      boundary.push_back(is_material(region) ? std::array{p[a], p[b], p[c]}
                                             : std::array{p[a], p[c], p[b]});
    }
  };
  add(region);
  for (const Index surface : within_.of(region)) add(surface);
  return boundary;
}

}  // namespace kdm
