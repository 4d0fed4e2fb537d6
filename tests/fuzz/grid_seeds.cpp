// SPDX-License-Identifier: MIT
#include "grid_seeds.h"

#include "grid/saved/grid_format.h"
#include "kdmanifold/kdmanifold.h"
#include "support/sheets.h"

namespace kdm::fuzz {

std::vector<Bytes> grid_seeds() {
  std::vector<Bytes> seeds;
  const auto add = [&](const BuildOptions& options, const Mesh& mesh) {
    const Bytes file = save_grid(build_grid(mesh, options));
    seeds.emplace_back(file.begin() + grid_format::kHeaderBytes, file.end());
  };
  for (const BuildOptions& options :
       {BuildOptions{.relative_tolerance = 0.1},
        BuildOptions{.strategy = SplitStrategy::kUniform, .depth = 4},
        BuildOptions{.strategy = SplitStrategy::kMedian, .depth = 7}}) {
    for (const Mesh& mesh : {shapes::cube(), shapes::thin_walled_box(0.02), shapes::torus()}) {
      add(options, mesh);
    }
  }
  const auto wave = [](double x, double y) { return 0.2 * x * y; };
  for (const SplitStrategy strategy :
       {SplitStrategy::kAdaptive, SplitStrategy::kUniform, SplitStrategy::kMedian}) {
    for (const Mesh& mesh : {shapes::open(shapes::cubes_at_edge(), 5), shapes::moebius_band(12),
                             shapes::merged({shapes::grid_sheet(2, 2, wave), shapes::cube()})}) {
      BuildOptions options{.strategy = strategy, .inside = InsideRule::kSheet};
      if (strategy == SplitStrategy::kAdaptive) {
        options.relative_tolerance = 0.1;
      } else {
        options.depth = 5;
      }
      add(options, mesh);
    }
  }
  // What is repaired, with rims and a winding threshold.
  for (const Mesh& mesh : {shapes::open(shapes::cube(), 2), shapes::open(shapes::torus(), 9)}) {
    add({.relative_tolerance = 0.1}, mesh);
  }
  return seeds;
}

}  // namespace kdm::fuzz
