// SPDX-License-Identifier: MIT
#include "simplify/thin_regions.h"

#include <utility>

#include "grid/compact.h"
#include "mesh/progress.h"
#include "simplify/solid_regions.h"
#include "simplify/thickness.h"

namespace kdm {
namespace {

Marks thin_regions(const SolidRegions& regions, double thickness, bool material,
                   const Progress& progress) {
  const std::vector<BoundingSurface>& surfaces = regions.surfaces();
  Marks thin(surfaces.size());
  for (Index r = 0; r < surfaces.size(); ++r) {
    if (surfaces[r].pillow || !surfaces[r].sure || regions.is_material(r) != material) continue;
    report_progress(progress, static_cast<double>(r) / static_cast<double>(surfaces.size()),
                    "simplify");
    thin.set(r, is_thin(regions.boundary_of(r), thickness));
  }
  return thin;
}

// The surfaces that bound the regions, and the pillows in these.
Marks surfaces_of(const SolidRegions& regions, const Marks& gone_regions, bool material) {
  Marks gone(regions.surfaces().size());
  for (Index s = 0; s < gone.size(); ++s) {
    const Index region = regions.region_beside(s, material);
    gone.set(s, region != kNone && gone_regions.test(region));
  }
  return gone;
}

// Drops the exact triangles of these surfaces, and the vertices that no other has.
void drop_exact(const SolidRegions& regions, const Marks& gone, GridData& grid) {
  Mesh kept;
  std::vector<Index> number(grid.exact.positions.size(), kNone);
  for (Index t = 0; t < grid.exact.triangles.size(); ++t) {
    if (gone.test(regions.surface_of_exact(t))) continue;
    Triangle triangle = grid.exact.triangles[t];
    for (Index& v : triangle) {
      if (number[v] == kNone) {
        number[v] = static_cast<Index>(kept.positions.size());
        kept.positions.push_back(grid.exact.positions[v]);
      }
      v = number[v];
    }
    kept.triangles.push_back(triangle);
    kept.source_faces.push_back(grid.exact.source_faces[t]);
    if (!grid.exact.source_operands.empty()) {
      kept.source_operands.push_back(grid.exact.source_operands[t]);
    }
  }
  grid.exact = std::move(kept);
  for (Index s = 0; s < gone.size(); ++s) {
    if (gone.test(s) && regions.is_exact(s) && regions.is_material(s)) --grid.stats.exact_parts;
  }
}

}  // namespace

GoneRegions take_thin_regions(GridData& grid, double thickness, bool material,
                              const Progress& progress) {
  const SolidRegions regions(grid);
  const Marks thin = thin_regions(regions, thickness, material, progress);
  GoneRegions out;
  out.regions = static_cast<Index>(thin.count());
  if (out.regions == 0) return out;
  const Marks gone = surfaces_of(regions, thin, material);
  for (Index s = 0; s < gone.size(); ++s) {
    if (regions.surfaces()[s].pillow) continue;
    if (!gone.test(s)) {
      ++out.left;
      continue;
    }
    ++out.surfaces;
    out.handles += regions.surfaces()[s].handles;
  }
  Marks hits(grid.hits.size());
  for (HitId h = 0; h < grid.hits.size(); ++h) hits.set(h, gone.test(regions.surface_of_hit(h)));
  drop_exact(regions, gone, grid);
  remove_hits(grid, hits);
  return out;
}

}  // namespace kdm
