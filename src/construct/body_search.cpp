// SPDX-License-Identifier: MIT
// Compares the volumes of parts with their areas.
#include "construct/body_search.h"

#include <cmath>

#include "construct/wall_share.h"
#include "mesh/boxes.h"
#include "mesh/disjoint_sets.h"
#include "mesh/groups.h"
#include "mesh/joined.h"
#include "mesh/measure.h"
#include "mesh/scale.h"

namespace kdm {
namespace {

// A thin body has less than this mean thickness, in tolerances, which is its volume divided by half
// its area: the thickness of a plate, the radius of a rod.
constexpr double kThickest = 4;
// And its diagonal is at least so many times its mean thickness. Of a ball or a cube it is five
// times; small balls are no thin walls, and cells serve them well.
constexpr double kLeastLength = 8;
// A thicker one may have thin walls, unless its mean thickness is above this.
constexpr double kThickestWithWalls = 16;
// It does if that share of its surface is nearer than four tolerances to the opposite wall.
constexpr double kLeastShare = 0.25;
// Cavities are looked for in parts round them only if there are no more pairs of both.
constexpr std::size_t kMostPairs = 1 << 20;
// A part whose volume is at most this share of the sum of its terms' absolute values encloses
// nothing, but for rounding errors.
constexpr double kMostRoundingVolume = 1e-10;

struct Part {
  Measure measure;
  Shell shell;
};

class BodySearch {
 public:
  BodySearch(const Surface& surface, double tolerance)
      : surface_(surface), part_of_(surface.part_of), tolerance_(tolerance) {
    if (part_of_.empty()) part_of_.assign(surface.triangles.size(), 0);
    measure();
  }

  std::optional<Bodies> run() {
    DisjointSets bodies(parts_.size());
    join_cavities(bodies);
    Bodies result;
    result.body_of_part = number_sets(bodies, parts_.size());
    result.thin = find_thin(result.body_of_part, bodies.count());
    if (!result.thin.any()) return std::nullopt;
    for (const Part& part : parts_) result.sign.push_back(sign_of(part.measure));
    if (parts_.size() > 1) {
      const auto enclosures = find_pairs();
      if (!enclosures) return std::nullopt;
      result.enclosures = *enclosures;
    }
    result.part_of = std::move(part_of_);
    return result;
  }

 private:
  void measure() {
    Index parts = 0;
    for (const Index part : part_of_) parts = std::max(parts, part + 1);
    parts_.resize(parts);
    for (TriangleId t = 0; t < part_of_.size(); ++t) {
      for (const PointId p : surface_.corners[t]) {
        grow(parts_[part_of_[t]].shell.bounds, surface_.points[p]);
      }
    }
    for (Part& part : parts_) {
      part.measure.centre = centre_of(part.shell.bounds);
      part.shell.closed = true;
    }
    for (TriangleId t = 0; t < part_of_.size(); ++t) {
      const Triangle& c = surface_.corners[t];
      parts_[part_of_[t]].measure.add(surface_.points[c[0]], surface_.points[c[1]],
                                      surface_.points[c[2]]);
    }
  }

  static int sign_of(const Measure& measure) {
    const bool encloses = std::abs(measure.volume) > kMostRoundingVolume * measure.absolute_volume;
    return encloses ? (measure.volume < 0 ? -1 : 1) : 0;
  }

  // Tells whether a part may have thin walls, though it is not thin all over.
  bool may_have_walls(Index p) const {
    const double thickness = 2 * parts_[p].measure.volume / parts_[p].measure.area;
    return thickness >= kThickest * tolerance_ && thickness < kThickestWithWalls * tolerance_;
  }

  // Marks bodies of which much is a thin wall.
  void find_walls(const std::vector<Index>& body_of_part, Marks& thin) const {
    std::vector<Index> wanted;
    for (Index p = 0; p < parts_.size(); ++p) {
      if (!thin.test(body_of_part[p]) && may_have_walls(p)) wanted.push_back(p);
    }
    if (wanted.empty()) return;
    const Groups triangles_of(parts_.size(), [&](const auto& put) {
      for (TriangleId t = 0; t < part_of_.size(); ++t) put(part_of_[t], t);
    });
    std::vector<Triangle> triangles;
    for (const Index p : wanted) {
      triangles.clear();
      for (const TriangleId t : triangles_of.of(p)) triangles.push_back(surface_.corners[t]);
      if (share_of_walls(triangles, surface_.points, tolerance_) >= kLeastShare) {
        thin.set(body_of_part[p]);
      }
    }
  }

  // Joins cavities to the parts round them where the wall between them is thin.
  void join_cavities(DisjointSets& bodies) const {
    std::vector<Index> cavities;
    for (Index p = 0; p < parts_.size(); ++p) {
      if (parts_[p].measure.volume < 0) cavities.push_back(p);
    }
    if (cavities.size() * parts_.size() > kMostPairs) return;
    for (const Index cavity : cavities) {
      for (Index p = 0; p < parts_.size(); ++p) {
        const Part& inner = parts_[cavity];
        const Part& outer = parts_[p];
        if (outer.measure.volume <= 0 || !holds(outer.shell.bounds, inner.shell.bounds)) continue;
        if (is_thin(outer.measure.volume + inner.measure.volume,
                    outer.measure.area + inner.measure.area, outer.shell.bounds, tolerance_)) {
          bodies.join(cavity, p);
        }
      }
    }
  }

  static bool holds(const Box& a, const Box& b) {
    return (a.min.array() <= b.min.array()).all() && (a.max.array() >= b.max.array()).all();
  }

  Marks find_thin(const std::vector<Index>& body_of_part, Index bodies) const {
    std::vector<Part> sums(bodies);
    for (Index p = 0; p < parts_.size(); ++p) {
      Part& sum = sums[body_of_part[p]];
      sum.measure.volume += parts_[p].measure.volume;
      sum.measure.area += parts_[p].measure.area;
      grow(sum.shell.bounds, parts_[p].shell.bounds.min);
      grow(sum.shell.bounds, parts_[p].shell.bounds.max);
    }
    Marks thin;
    for (const Part& sum : sums) {
      thin.push_back(is_thin(sum.measure.volume, sum.measure.area, sum.shell.bounds, tolerance_));
    }
    find_walls(body_of_part, thin);
    return thin;
  }

  std::optional<std::vector<Enclosure>> find_pairs() const {
    Mesh mesh;
    mesh.triangles = surface_.corners;
    const ScaledPositions scaled = scale_to_one(surface_.points, surface_.corners);
    std::vector<Shell> shells;
    for (const Part& part : parts_) {
      shells.push_back(part.shell);
      for (Vec3* corner : {&shells.back().bounds.min, &shells.back().bounds.max}) {
        for (int i = 0; i < 3; ++i) (*corner)[i] = std::ldexp((*corner)[i], -scaled.exponent);
      }
    }
    return find_enclosures(Polygons(mesh), scaled.positions, part_of_, shells);
  }

  const Surface& surface_;
  std::vector<Index> part_of_;  // per triangle
  std::vector<Part> parts_;
  double tolerance_;
};

}  // namespace

bool is_thin(double volume, double area, const Box& bounds, double tolerance) {
  const double thickness = 2 * volume / area;
  return thickness > 0 && thickness < kThickest * tolerance &&
         (bounds.max - bounds.min).norm() >= kLeastLength * thickness;
}

std::optional<Bodies> find_thin_bodies(const Surface& surface, double tolerance) {
  return BodySearch(surface, tolerance).run();
}

}  // namespace kdm
