// SPDX-License-Identifier: MIT
// Finds the best triangle on every chord of a polygon, shorter parts of the polygon first.
#include "prepare/least_area_patch.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/triangle.h"
#include "mesh/sort.h"

namespace kdm {
namespace {

// Polygons with more corners are divided.
constexpr std::size_t kMostCorners = 500;
// How many corners the patch has that divides a polygon: fewer once the work, in triangles looked
// at, is beyond a limit, which is reached within a second or two.
constexpr std::size_t kDividingCorners = 64;
constexpr std::size_t kFewCorners = 16;
constexpr std::uint64_t kMostWork = std::uint64_t{1} << 27;
// The cosine of 160 degrees.
constexpr double kFoldCosine = -0.9396926207859084;

// The height of a triangle, as a part of its longest side, below which it counts as a fold.
constexpr double kLeastHeight = 1e-4;

// How many triangles are looked at for a polygon, about.
std::uint64_t work_for(std::uint64_t corners) { return corners * corners * corners / 6; }

// `doubled` is twice the area vector of the triangle.
bool has_no_height(const Vec3& doubled, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double longest =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return !(doubled.norm() > kLeastHeight * longest);
}

bool is_fold(const Vec3& a, const Vec3& b) {
  return a.dot(b) < kFoldCosine * std::sqrt(a.squaredNorm() * b.squaredNorm());
}

}  // namespace

void LeastAreaPatch::make(std::span<const PointId> polygon, std::span<const Vec3> beyond,
                          std::vector<Triangle>& out) {
  const std::uint64_t corners = polygon.size();
  const bool affordable = corners <= kMostCorners && work_ + work_for(corners) <= kMostWork;
  if (affordable || corners <= kFewCorners) {
    run(polygon, beyond, out);
  } else {
    divide(polygon, beyond, out);
  }
}

bool LeastAreaPatch::is_little_work(std::span<const std::size_t> corners) {
  std::uint64_t work = 0;
  for (const std::size_t count : corners) {
    if (count > kMostCorners) return false;
    work += work_for(count);
  }
  return work <= kMostWork;
}

// Chooses corners, makes the patch over them, and then those between two chosen corners that follow
// each other.
void LeastAreaPatch::divide(std::span<const PointId> polygon, std::span<const Vec3> beyond,
                            std::vector<Triangle>& out) {
  const std::size_t parts = work_ < kMostWork ? kDividingCorners : kFewCorners;
  const auto place = [&](std::size_t part) { return part * polygon.size() / parts; };
  std::vector<PointId> corners;
  std::vector<Vec3> normals;
  for (std::size_t part = 0; part < parts; ++part) {
    const bool is_edge = place(part + 1) - place(part) == 1;
    corners.push_back(polygon[place(part)]);
    normals.push_back(is_edge ? beyond[place(part)] : Vec3(Vec3::Zero()));
  }
  run(corners, normals, out);
  for (std::size_t part = 0; part < parts; ++part) {
    corners.clear();
    normals.clear();
    for (std::size_t i = place(part); i < place(part + 1); ++i) {
      corners.push_back(polygon[i]);
      normals.push_back(beyond[i]);
    }
    corners.push_back(polygon[place(part + 1) % polygon.size()]);
    normals.emplace_back(Vec3::Zero());
    if (corners.size() > 2) make(corners, normals, out);
  }
}

void LeastAreaPatch::run(std::span<const PointId> polygon, std::span<const Vec3> beyond,
                         std::vector<Triangle>& out) {
  size_ = polygon.size();
  work_ += work_for(size_);
  corners_.clear();
  for (const PointId p : polygon) corners_.push_back(points_[p]);
  beyond_.assign(beyond.begin(), beyond.end());
  cost_.assign(size_ * size_, {});
  apex_.assign(size_ * size_, 0);
  find_used_chords(polygon);
  for (std::size_t length = 2; length < size_; ++length) {
    for (std::size_t low = 0; low + length < size_; ++low) find_best(low, low + length);
  }
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, size_ - 1}};
  while (!open.empty()) {
    const auto chord = open.back();
    open.pop_back();
    if (chord.second - chord.first < 2) continue;
    const std::size_t apex = apex_[at(chord.first, chord.second)];
    out.push_back({polygon[chord.first], polygon[apex], polygon[chord.second]});
    open.emplace_back(chord.first, apex);
    open.emplace_back(apex, chord.second);
  }
}

// Marks the chords that are edges of the mesh. The polygon's own edges are none.
void LeastAreaPatch::find_used_chords(std::span<const PointId> polygon) {
  used_.assign(size_ * size_, 0);
  std::vector<std::pair<PointId, std::size_t>> place;
  for (std::size_t i = 0; i < size_; ++i) place.emplace_back(polygon[i], i);
  sort_up(place);
  for (const auto& lower : place) {
    const std::uint64_t first = std::uint64_t{lower.first} << 32;
    auto edge = std::lower_bound(edges_.begin(), edges_.end(), first);
    for (; edge != edges_.end() && *edge >> 32 == lower.first; ++edge) {
      const auto upper = static_cast<PointId>(*edge & 0xffffffffu);
      const auto found =
          std::lower_bound(place.begin(), place.end(), std::pair<PointId, std::size_t>{upper, 0});
      if (found == place.end() || found->first != upper) continue;
      const std::size_t low = std::min(lower.second, found->second);
      const std::size_t high = std::max(lower.second, found->second);
      const bool own = high - low == 1 || (low == 0 && high == size_ - 1);
      if (!own) used_[at(low, high)] = 1;
    }
  }
}

// Twice the area vector of a triangle.
Vec3 LeastAreaPatch::normal(std::size_t a, std::size_t b, std::size_t c) const {
  return doubled_area_vector(corners_[a], corners_[b], corners_[c]);
}

// The normal of the triangle that a patch over the corners from `low` to `high` has on the chord
// between the two; of the mesh's triangle if the chord is an edge of the polygon.
Vec3 LeastAreaPatch::normal_below(std::size_t low, std::size_t high) const {
  return high - low == 1 ? beyond_[low] : normal(low, apex_[at(low, high)], high);
}

void LeastAreaPatch::find_best(std::size_t low, std::size_t high) {
  const bool is_last_edge = low == 0 && high == size_ - 1;
  Cost best;
  bool found = false;
  for (std::size_t apex = low + 1; apex < high; ++apex) {
    Cost cost = cost_[at(low, apex)] + cost_[at(apex, high)];
    if (found && !(cost < best)) continue;
    const Vec3 own = normal(low, apex, high);
    cost.area += 0.5 * own.norm();
    cost.folds += has_no_height(own, corners_[low], corners_[apex], corners_[high]) ? 1 : 0;
    cost.folds += is_fold(own, normal_below(low, apex)) ? 1 : 0;
    cost.folds += is_fold(own, normal_below(apex, high)) ? 1 : 0;
    if (is_last_edge) cost.folds += is_fold(own, beyond_[high]) ? 1 : 0;
    if (found && !(cost < best)) continue;
    best = cost;
    found = true;
    apex_[at(low, high)] = static_cast<std::uint16_t>(apex);
  }
  best.folds += used_[at(low, high)];
  cost_[at(low, high)] = best;
}

}  // namespace kdm
