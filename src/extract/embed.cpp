// SPDX-License-Identifier: MIT
// A result that does not meet itself.
//
// Fully refined, every hit is a vertex, every link one within its face, every loop one within its
// leaf, and each triangle (hit, link, loop) lies in one leaf: the surface in a leaf is the fan of
// an inner point over a closed curve on the leaf's sides. The idea goes back to T. Ju and T.
// Udeshi, Intersection-free contouring on an octree grid, 2006. That takes six triangles a hit, so
// it is done only where the plain mesh fails; each round adds detail, and full detail bounds them.
#include "extract/embed.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "extract/emit.h"

namespace kdm {
namespace {

class Search {
 public:
  Search(const GridData& grid, const DualMesh& loops) : grid_(grid), loops_(loops) {}

  // Triangles of the mesh that cross others or have no area.
  std::vector<Index> faulty(const DualMesh& mesh, std::uint64_t& crossings) const {
    std::vector<Index> numbers;  // in the dual mesh, of those that are handed out
    for (Index t = 0; t < mesh.triangles(); ++t) {
      if (!mesh.dropped(t)) numbers.push_back(t);
    }
    const Mesh out = emit(grid_, mesh, {}, false, true);
    const SelfIntersections found = find_self_intersections(out);
    crossings = found.pairs;
    std::vector<Index> faulty;
    for (const Index face : found.faces) faulty.push_back(numbers[face]);
    for (Index face = 0; face < out.triangles.size(); ++face) {
      if (without_area(out, out.triangles[face])) faulty.push_back(numbers[face]);
    }
    return faulty;
  }

  // Adds detail to the hits of these triangles, and to their loops; false if there is none to add.
  bool add(const DualMesh& mesh, const std::vector<Index>& faulty, Details& details) const {
    std::vector<Index> hits;
    for (const Index t : faulty) hits.push_back(mesh.hit[t]);
    std::sort(hits.begin(), hits.end());
    hits.erase(std::unique(hits.begin(), hits.end()), hits.end());
    bool any = false;
    for (const Index hit : hits) {
      const Detail detail = more(details.hits[hit]);
      any = any || detail != details.hits[hit];
      details.hits[hit] = detail;
      for (int i = 0; i < 3; ++i) {
        Detail& loop = details.loops[loops_.vertex[3 * hit + i]];
        any = any || loop < detail;
        loop = std::max(loop, detail);
      }
    }
    return any;
  }

 private:
  static Detail more(Detail detail) {
    return detail == Detail::kCentred ? detail : static_cast<Detail>(static_cast<int>(detail) + 1);
  }

  static bool without_area(const Mesh& mesh, const Triangle& t) {
    const Vec3 u = mesh.positions[t[1]] - mesh.positions[t[0]];
    const Vec3 v = mesh.positions[t[2]] - mesh.positions[t[0]];
    return u.cross(v).isZero(0);
  }

  const GridData& grid_;
  const DualMesh& loops_;
};

}  // namespace

Embedding embed(const GridData& grid, const DualMesh& loops,
                const std::function<DualMesh(const Details&)>& make) {
  const Search search(grid, loops);
  Embedding result;
  result.mesh = make({});
  std::vector<Index> faulty = search.faulty(result.mesh, result.crossings);
  Details details;
  details.hits.assign(grid.hits.size(), Detail::kPlain);
  details.loops.assign(loops.first.size(), Detail::kPlain);
  while (!faulty.empty() && search.add(result.mesh, faulty, details)) {
    result.mesh = make(details);
    faulty = search.faulty(result.mesh, result.crossings);
  }
  result.refined_hits =
      static_cast<Index>(std::count_if(details.hits.begin(), details.hits.end(),
                                       [](Detail detail) { return detail != Detail::kPlain; }));
  return result;
}

}  // namespace kdm
