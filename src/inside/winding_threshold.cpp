// SPDX-License-Identifier: MIT
// Chooses the threshold for winding numbers.
//
// The winding number grows by one from the front of a face to its back. In an open vessel, such as
// a tub, a face sees holes in much of its surroundings; then the numbers on both of its sides are
// below one half, and only a lower threshold, between the two, keeps the face.
#include "inside/winding_field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace kdm {
namespace {

constexpr int kSamples = 1024;
constexpr double kInFront = 0.5;  // distance of the samples from the surface, lattice units
constexpr std::array<double, 9> kThresholds{0.5, 0.45, 0.4, 0.35, 0.3, 0.25, 0.2, 0.15, 0.1};
// The fraction of the whole area by which a threshold may keep less than the best one and still be
// chosen, if it is higher.
constexpr double kNegligibleArea = 0.01;

// Returns the triangle's normal with a length of twice its area.
Vec3 twice_area(const LatticeTriangle& t) {
  return (to_vec3(t[1]) - to_vec3(t[0])).cross(to_vec3(t[2]) - to_vec3(t[0]));
}

// Points spread evenly over the triangles, a little in front of them.
class Samples {
 public:
  explicit Samples(std::span<const LatticeTriangle> triangles) : triangles_(triangles) {
    area_sums_.reserve(triangles.size());
    double sum = 0;
    for (const LatticeTriangle& t : triangles) area_sums_.push_back(sum += twice_area(t).norm());
  }

  bool empty() const { return area_sums_.empty() || area_sums_.back() <= 0; }

  // Returns point `number` of kSamples.
  Vec3 point(int number) const {
    const double at = (number + 0.5) / kSamples * area_sums_.back();
    const auto found = std::upper_bound(area_sums_.begin(), area_sums_.end(), at);
    const auto i = std::min<std::size_t>(static_cast<std::size_t>(found - area_sums_.begin()),
                                         area_sums_.size() - 1);
    const LatticeTriangle& t = triangles_[i];
    // Multiples of the powers of the inverse plastic number fill a square evenly.
    double u = fraction(0.7548776662466927 * number);
    double v = fraction(0.5698402909980532 * number);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Vec3 origin = to_vec3(t[0]);
    const Vec3 on_triangle = origin + u * (to_vec3(t[1]) - origin) + v * (to_vec3(t[2]) - origin);
    const Vec3 normal = twice_area(t);
    const double length = normal.norm();
    return length > 0 ? Vec3(on_triangle + kInFront / length * normal) : on_triangle;
  }

 private:
  static double fraction(double x) { return x - std::floor(x); }

  std::span<const LatticeTriangle> triangles_;
  std::vector<double> area_sums_;  // per triangle: twice the area of it and all before it
};

}  // namespace

double choose_winding_threshold(const WindingField& field,
                                std::span<const LatticeTriangle> triangles) {
  const Samples samples(triangles);
  std::array<int, kThresholds.size()> kept{};
  for (int n = 0; n < kSamples && !samples.empty(); ++n) {
    const double front = field.winding(samples.point(n));
    for (std::size_t i = 0; i < kept.size(); ++i) {
      if (front <= kThresholds[i] && kThresholds[i] < front + 1) ++kept[i];
    }
  }
  const int enough =
      *std::max_element(kept.begin(), kept.end()) - static_cast<int>(kNegligibleArea * kSamples);
  const auto chosen =
      std::find_if(kept.begin(), kept.end(), [&](int number) { return number >= enough; });
  return kThresholds[static_cast<std::size_t>(chosen - kept.begin())];
}

}  // namespace kdm
