// SPDX-License-Identifier: MIT
// Traces the curves through small triangles on the sides of the box.
#include "support/contours.h"

#include <map>

#include "mesh/marks.h"
#include "support/random.h"

namespace kdm::check {
namespace {

constexpr double kStep = 64;

using Place = std::array<int, 3>;

class Tracing {
 public:
  Tracing(int size, std::uint32_t seed) : size_(size), random_(seed) {
    contours_.lo = Vec3(100, 200, 300);
    contours_.hi = contours_.lo + Vec3::Constant(kStep * size);
  }

  Contours run() {
    for (int side = 0; side < 6; ++side) {
      for (int i = 0; i < size_; ++i) {
        for (int j = 0; j < size_; ++j) {
          cross(side, place(side, i, j), place(side, i + 1, j), place(side, i + 1, j + 1));
          cross(side, place(side, i, j), place(side, i + 1, j + 1), place(side, i, j + 1));
        }
      }
    }
    Marks seen(next_.size());
    for (Index start = 0; start < next_.size(); ++start) {
      if (seen.test(start)) continue;
      Curve curve;
      for (Index p = start; !seen.test_and_set(p); p = next_[p]) curve.push_back(p);
      contours_.curves.push_back(curve);
    }
    return contours_;
  }

 private:
  Place place(int side, int i, int j) const {
    Place p{};
    p[side % 3] = side < 3 ? 0 : size_;
    p[(side + 1) % 3] = i;
    p[(side + 2) % 3] = j;
    return p;
  }

  bool positive(const Place& p) {
    const auto [entry, is_new] = signs_.try_emplace(p, false);
    if (is_new) entry->second = random_.coin();
    return entry->second;
  }

  // Adds the piece of a curve that crosses a triangle. On high sides of the box, the triangle must
  // be counter-clockwise seen from outside, on low sides clockwise.
  void cross(int side, const Place& a, Place b, Place c) {
    if (side < 3) std::swap(b, c);
    const std::array<Place, 3> corners = {a, b, c};
    Index from = kNone;
    Index to = kNone;
    for (int i = 0; i < 3; ++i) {
      const Place& p = corners[i];
      const Place& q = corners[(i + 1) % 3];
      if (positive(p) == positive(q)) continue;
      (positive(p) ? from : to) = point(p, q);
    }
    if (from == kNone) return;
    next_[from] = to;
  }

  Index point(const Place& p, const Place& q) {
    const auto [entry, is_new] =
        numbers_.try_emplace(std::minmax(p, q), static_cast<Index>(next_.size()));
    if (is_new) {
      const double part = random_.between(0.2, 0.8);
      Vec3 position = contours_.lo;
      for (int i = 0; i < 3; ++i) {
        const auto [lo, hi] = std::minmax(p, q);
        // Whole steps come out exact on the sides.
        position[i] += kStep * lo[i];
        if (hi[i] != lo[i]) position[i] += kStep * part * (hi[i] - lo[i]);
      }
      contours_.points.push_back(position);
      next_.push_back(kNone);
    }
    return entry->second;
  }

  int size_;
  Random random_;
  Contours contours_;
  std::map<Place, bool> signs_;
  std::map<std::pair<Place, Place>, Index> numbers_;
  std::vector<Index> next_;  // per point: the next one on its curve
};

}  // namespace

Contours random_contours(int size, std::uint32_t seed) { return Tracing(size, seed).run(); }

}  // namespace kdm::check
