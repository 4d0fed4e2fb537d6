// SPDX-License-Identifier: MIT
// Measures how far a result and its input are apart.
#include "account/measure_error.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/marks.h"
#include "mesh/spread.h"

namespace kdm {
namespace {

constexpr double kPoints = 4096;
// Of so many points one counts for the mean. Of the others it is enough to know that they are not
// further away than one before, for which their guess or a short search does.
constexpr Index kPerMean = 2;

// Measures how far the points of one of the two surfaces are from the other.
class Measurement {
 public:
  Measurement(BothSurfaces& both, bool of_result)
      : both_(both),
        of_result_(of_result),
        from_(of_result ? both.result : both.input),
        to_(of_result ? both.input : both.result) {}

  Deviation take() {
    double area = 0;
    for (Index t = 0; t < from_.size(); ++t) area += from_.area_of(t);
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    if (!(area > 0) || to_.triangles.empty()) return {kInfinity, kInfinity};
    look_at_points(area);
    look_at_vertices();
    return {both_.unit * std::sqrt(largest_),
            in_mean_ > 0 ? both_.unit * std::sqrt(sum_ / in_mean_) : 0};
  }

 private:
  void look_at_points(double area) {
    Spread spread(area / kPoints);
    Index points = 0;
    for (Index t = 0; t < from_.size(); ++t) {
      spread.for_each_point(from_.corner(t, 0), from_.corner(t, 1), from_.corner(t, 2),
                            from_.area_of(t), [&](const Vec3& p) {
                              const bool for_mean = points++ % kPerMean == 0;
                              const double squared =
                                  to_.squared_distance(p, for_mean ? 0 : largest_, guess(t));
                              if (!counts(t, p, squared)) return;
                              largest_ = std::max(largest_, squared);
                              if (!for_mean) return;
                              sum_ += squared;
                              ++in_mean_;
                            });
    }
  }

  // Of the vertices only those count that are further away than all points before.
  void look_at_vertices() {
    Marks seen(from_.positions.size());
    for (Index t = 0; t < from_.size(); ++t) {
      const Vec3 middle = (from_.corner(t, 0) + from_.corner(t, 1) + from_.corner(t, 2)) / 3;
      for (const Index v : from_.triangles[t]) {
        if (seen.test_and_set(v)) continue;
        const Vec3& p = from_.positions[v];
        const double squared = to_.squared_distance(p, largest_, guess(t));
        if (squared <= largest_ || !counts(t, p + (middle - p) / 64, squared)) continue;
        largest_ = squared;
      }
    }
  }

  // A triangle of the other surface that may be near.
  Index guess(Index triangle) const {
    return of_result_ ? both_.in_input(triangle) : both_.in_result(triangle);
  }

  // What the inside rule drops does not count.
  bool counts(Index triangle, const Vec3& place, double squared) {
    return of_result_ || squared <= both_.told_apart * both_.told_apart ||
           !both_.is_inner(triangle, place);
  }

  BothSurfaces& both_;
  bool of_result_;
  const TriangleSet& from_;
  TriangleSet& to_;
  double largest_ = 0;
  double sum_ = 0;
  Index in_mean_ = 0;
};

}  // namespace

MeshError measure_error(BothSurfaces& both) {
  return {.to_input = Measurement(both, true).take(), .to_output = Measurement(both, false).take()};
}

}  // namespace kdm
