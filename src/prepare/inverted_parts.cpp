// SPDX-License-Identifier: MIT
// Compares the sign of each part's volume with the signs of the parts that it lies in.
#include "prepare/inverted_parts.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "mesh/boxes.h"
#include "mesh/groups.h"
#include "mesh/joined.h"
#include "mesh/measure.h"
#include "mesh/nesting.h"
#include "mesh/scale.h"
#include "mesh/sides.h"
#include "mesh/sort.h"
#include "prepare/outside_in.h"

namespace kdm {
namespace {

// A part whose volume is at most this share of the sum of its terms' absolute values encloses
// nothing, but for rounding errors.
constexpr double kMostRoundingShare = 1e-10;

class PartTurner {
 public:
  PartTurner(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
             const Topology& topology)
      : triangles_(triangles), scaled_(scale_to_one(points, triangles)) {
    find_parts(topology.opposite);
    shares_edges_.assign(shells_.size());
    for (const SideId side : topology.non_manifold_sides) {
      shares_edges_.set(part_of_[triangle_of(side)]);
    }
    measure();
  }

  InvertedParts run() {
    InvertedParts result;
    const auto turned_inwards = [](int sign) { return sign < 0; };
    if (std::none_of(sign_.begin(), sign_.end(), turned_inwards)) return result;
    const auto enclosures = enclosing_parts();
    if (!enclosures) {
      result.nesting_known = false;
      return result;
    }
    const Marks turned = decide(*enclosures);
    result.parts = static_cast<Index>(turned.count());
    if (result.parts == 0) return result;
    const auto enclosing =
        static_cast<std::ptrdiff_t>(sign_.size()) - std::count(sign_.begin(), sign_.end(), 0);
    result.all = result.parts == static_cast<Index>(enclosing);
    for (const Index part : part_of_) result.must_turn.push_back(turned.test(part));
    return result;
  }

 private:
  void find_parts(std::span<const SideId> opposite) {
    DisjointSets sets = join_triangles(opposite);
    part_of_ = number_sets(sets, triangles_.size());
    shells_.resize(sets.count());
    for (Shell& shell : shells_) shell.closed = true;
    for (SideId side = 0; side < opposite.size(); ++side) {
      if (opposite[side] == kNone) shells_[part_of_[triangle_of(side)]].closed = false;
    }
  }

  void measure() {
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      for (const PointId p : triangles_[t]) grow(shells_[part_of_[t]].bounds, scaled_.positions[p]);
    }
    std::vector<Measure> measures(shells_.size());
    for (Index p = 0; p < shells_.size(); ++p) measures[p].centre = centre_of(shells_[p].bounds);
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      const Triangle& c = triangles_[t];
      measures[part_of_[t]].add(scaled_.positions[c[0]], scaled_.positions[c[1]],
                                scaled_.positions[c[2]]);
    }
    for (Index p = 0; p < shells_.size(); ++p) {
      const Measure& m = measures[p];
      size_.push_back(std::abs(m.volume));
      const bool encloses =
          shells_[p].closed && std::abs(m.volume) > kMostRoundingShare * m.absolute_volume;
      sign_.push_back(!encloses ? 0 : (m.volume > 0 ? 1 : -1));
    }
  }

  std::optional<std::vector<Enclosure>> enclosing_parts() const {
    Mesh mesh;
    mesh.triangles.assign(triangles_.begin(), triangles_.end());
    return find_enclosures(Polygons(mesh), scaled_.positions, part_of_, shells_);
  }

  // Tells whether the faces of a part that is turned inwards bound what they should as they are.
  // Where parts share edges, they may be pieces of one surface: a notch counts as such a part, but
  // what it is taken off need not be a part that holds it.
  bool bounds_something(Index part) {
    if (!shares_edges_.test(part)) return false;
    constexpr Index kSamples = 32;
    constexpr double kLeastShare = 0.9;
    if (!sight_) {
      sight_.emplace(triangles_, scaled_.positions, Marks(triangles_.size()));
      triangles_of_ = Groups(shells_.size(), [&](const auto& put) {
        for (TriangleId t = 0; t < triangles_.size(); ++t) put(part_of_[t], t);
      });
    }
    return share_that_bounds(triangles_, scaled_.positions, *sight_, triangles_of_.of(part),
                             kSamples) >= kLeastShare;
  }

  // Tells which parts must be turned. Larger parts are decided before smaller ones.
  Marks decide(const std::vector<Enclosure>& enclosures) {
    const auto larger = [&](Index a, Index b) { return size_[a] > size_[b]; };
    const std::vector<Index> order = in_order(shells_.size(), Order(larger));
    std::vector<std::size_t> first(shells_.size() + 1, 0);  // per inner part, among the enclosures
    for (const Enclosure& pair : enclosures) ++first[pair.inner + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    Marks turned(shells_.size());
    for (const Index part : order) {
      if (sign_[part] == 0) continue;
      int winding = 0;  // round the part, once the parts that hold it are turned
      Index smallest = kNone;
      for (std::size_t i = first[part]; i < first[part + 1]; ++i) {
        const Index outer = enclosures[i].outer;
        winding += turned.test(outer) ? -sign_[outer] : sign_[outer];
        if (smallest == kNone || size_[outer] < size_[smallest]) smallest = outer;
      }
      turned.set(part,
                 winding > 0 ? turned.test(smallest) : sign_[part] < 0 && !bounds_something(part));
    }
    return turned;
  }

  std::span<const Triangle> triangles_;
  ScaledPositions scaled_;
  std::vector<Index> part_of_;  // per triangle
  std::vector<Shell> shells_;   // per part
  Marks shares_edges_;          // per part
  std::vector<double> size_;    // per part: its volume without sign
  std::vector<int> sign_;       // per part: of its volume; 0 if it is open or encloses nothing
  std::optional<Sight> sight_;  // these two only if a part may have to be turned
  Groups triangles_of_;         // per part
};

}  // namespace

InvertedParts find_inverted_parts(std::span<const Triangle> triangles,
                                  const std::vector<Vec3>& points, const Topology& topology) {
  return PartTurner(triangles, points, topology).run();
}

}  // namespace kdm
