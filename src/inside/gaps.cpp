// SPDX-License-Identifier: MIT
#include "inside/gaps.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <bit>
#include <cmath>
#include <vector>

#include "grid/faces.h"
#include "grid/splitting_edges.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Within one part, lattice units: what rounding does to two faces that lie on each other.
constexpr double kNarrow = 4;
// The greatest cosine between the normals of sides that face each other.
constexpr double kFacing = -0.9;

// Of a gap on a grid line: the line, the lattice planes that the gap reaches across, and the first
// of its two crossings.
struct Gap {
  std::uint64_t line;  // axis and the two coordinates across it
  std::int32_t first;  // the first and the last lattice plane in the gap
  std::int32_t last;
  Index crossing;
};

std::uint64_t line_of(const LatticePoint& p, int axis) {
  return static_cast<std::uint64_t>(axis) << 60 |
         static_cast<std::uint64_t>(p[next_axis(axis)]) << 30 |
         static_cast<std::uint64_t>(p[previous_axis(axis)]);
}

// Tells at once of most lines that they have no gap: a gap's line marks one of some numbers.
class LineFilter {
 public:
  explicit LineFilter(const std::vector<Gap>& gaps)
      : bits_(static_cast<int>(std::bit_width(kNumbersPerGap * gaps.size()))),
        marked_(std::size_t{1} << bits_) {
    for (const Gap& gap : gaps) marked_.set(number_of(gap.line));
  }
  bool may_have_gap(std::uint64_t line) const { return marked_.test(number_of(line)); }

 private:
  static constexpr std::size_t kNumbersPerGap = 8;

  std::size_t number_of(std::uint64_t line) const {
    constexpr std::uint64_t kMix = 0x9e3779b97f4a7c15;  // odd, its bits look random
    return static_cast<std::size_t>(line * kMix >> (64 - bits_));
  }

  int bits_;
  Marks marked_;
};

// Returns the gaps in which a grid vertex may lie, sorted by their lines.
std::vector<Gap> find_gaps(const GridData& grid, const std::vector<LatticeBox>& boxes,
                           const EdgeCrossings& planned) {
  std::vector<Gap> gaps;
  const bool some = std::any_of(planned.all.begin(), planned.all.end(), begins_gap);
  if (!some) return gaps;
  for_each_splitting_edge(grid, boxes, [&](const SplittingEdge& edge) {
    const Index end = planned.edge_begin[edge.number + 1];
    for (Index c = planned.edge_begin[edge.number]; c < end; ++c) {
      if (!begins_gap(planned.all[c])) continue;
      const Index other = end_of_gap(planned.all, c);
      // A crossing lies above the plane of its floor.
      const std::int32_t first = floor_of(planned.all[c].position()) + 1;
      const std::int32_t last = floor_of(planned.all[other].position());
      if (first <= last) gaps.push_back({line_of(edge.low(), edge.axis), first, last, c});
    }
  });
  sort_by(gaps, [](const Gap& a, const Gap& b) {
    return a.line != b.line ? a.line < b.line : a.first < b.first;
  });
  return gaps;
}

}  // namespace

GapRule::GapRule(const Surface& surface, double tolerance, bool turns_count)
    : surface_(surface), part_of_(surface.part_of), widest_(widest_gap(tolerance)) {
  if (turns_count && !part_of_.empty()) find_inward_parts();
}

void GapRule::find_inward_parts() {
  std::vector<double> volumes(1 + *std::max_element(part_of_.begin(), part_of_.end()), 0);
  for (TriangleId t = 0; t < part_of_.size(); ++t) {
    const auto& [a, b, c] = surface_.triangles[t];
    volumes[part_of_[t]] += to_vec3(a).dot(to_vec3(b).cross(to_vec3(c)));
  }
  if (*std::min_element(volumes.begin(), volumes.end()) >= 0) return;
  for (const double volume : volumes) inward_.push_back(volume < 0);
}

// Tells whether what lies between two triangles is what one solid or part leaves of another.
bool GapRule::cut_off(TriangleId a, TriangleId b) const {
  if (surface_.several_solids() && surface_.solid_of[a] != surface_.solid_of[b]) return true;
  return !inward_.empty() && inward_.test(part_of_[a]) != inward_.test(part_of_[b]);
}

// Of crossings at one position, between which there is a sliver without thickness, parts of the
// solid seem to touch.
void GapRule::drop_what_is_cut_off(std::span<ClassifiedCrossing> edge) const {
  for (std::size_t first = 0; first < edge.size();) {
    std::size_t last = first + 1;
    bool cut = false;
    for (; last < edge.size() && edge[last].position() == edge[first].position(); ++last) {
      cut = cut || cut_off(edge[first].triangle(), edge[last].triangle());
    }
    for (; first < last; ++first) {
      if (cut && edge[first].role() == CrossingRole::kTouching) {
        edge[first].set_role(CrossingRole::kInner);
      }
    }
  }
}

void GapRule::close(int axis, std::span<ClassifiedCrossing> edge) const {
  if (!inward_.empty()) drop_what_is_cut_off(edge);
  ClassifiedCrossing* leaving = nullptr;   // where the solid was left last
  ClassifiedCrossing* entering = nullptr;  // where it was entered last; only if there are slivers
  const auto pair_off = [&](ClassifiedCrossing& first, ClassifiedCrossing& second,
                            CrossingRole role) {
    first.set_role(role);
    second.set_role(role);
    leaving = entering = nullptr;
  };
  for (ClassifiedCrossing& crossing : edge) {
    if (!crossing.kept()) continue;
    if (crossing.leaving()) {
      if (entering != nullptr && leaves_out(axis, *entering, crossing)) {
        pair_off(*entering, crossing, CrossingRole::kSliver);
      } else {
        leaving = &crossing;
      }
    } else if (leaving != nullptr && closes(axis, *leaving, crossing)) {
      pair_off(*leaving, crossing, CrossingRole::kGap);
    } else if (leaves_slivers_out()) {
      entering = &crossing;
    }
  }
}

bool GapRule::closes(int axis, const ClassifiedCrossing& leaving,
                     const ClassifiedCrossing& entering) const {
  if (normal_out(axis, leaving).dot(normal_out(axis, entering)) > kFacing) return false;
  const bool two_parts =
      !part_of_.empty() && part_of_[leaving.triangle()] != part_of_[entering.triangle()];
  return width_between(axis, leaving, entering) <= (two_parts ? widest_ : kNarrow);
}

bool GapRule::leaves_out(int axis, const ClassifiedCrossing& entering,
                         const ClassifiedCrossing& leaving) const {
  return cut_off(entering.triangle(), leaving.triangle()) &&
         normal_out(axis, entering).dot(normal_out(axis, leaving)) <= kFacing &&
         width_between(axis, entering, leaving) <= kNarrow;
}

// Of one solid, the normal is taken as the triangle's: it points out of it but for some triangles
// that other inside rules than `kPositive` turn.
Vec3 GapRule::normal_out(int axis, const ClassifiedCrossing& crossing) const {
  const TriangleId triangle = crossing.triangle();
  const Vec3& normal = surface_.planes[triangle].normal;
  const bool turned = surface_.several_solids() &&
                      points_up(surface_.triangles[triangle], axis) != crossing.leaving();
  return turned ? Vec3(-normal) : normal;
}

// Measures across, not along the edge, which may be nearly parallel to both sides.
double GapRule::width_between(int axis, const ClassifiedCrossing& low,
                              const ClassifiedCrossing& high) const {
  const double along = (high.position() - low.position()) * kFractionUnit;
  return along * std::abs(surface_.planes[low.triangle()].normal[axis]);
}

Marks find_open_gaps(const GridData& grid, const std::vector<LatticeBox>& boxes,
                     const EdgeCrossings& planned) {
  Marks open;
  const std::vector<Gap> gaps = find_gaps(grid, boxes, planned);
  if (gaps.empty()) return open;
  const LineFilter filter(gaps);
  const auto open_at = [&](const LatticePoint& vertex, int axis) {
    const std::uint64_t line = line_of(vertex, axis);
    if (!filter.may_have_gap(line)) return;
    auto gap = std::lower_bound(gaps.begin(), gaps.end(), line,
                                [](const Gap& g, std::uint64_t l) { return g.line < l; });
    for (; gap != gaps.end() && gap->line == line; ++gap) {
      if (gap->first > vertex[axis] || gap->last < vertex[axis]) continue;
      if (open.empty()) open.assign(planned.all.size());
      open.set(gap->crossing);
      open.set(end_of_gap(planned.all, gap->crossing));
    }
  };
  for_each_face_or_empty(grid, boxes, [&](const MinimalFace& face) {
    for_each_corner(face, [&](const LatticePoint& p) {
      for (int axis = 0; axis < 3; ++axis) open_at(p, axis);
    });
  });
  return open;
}

}  // namespace kdm
