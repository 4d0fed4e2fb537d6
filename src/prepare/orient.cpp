// SPDX-License-Identifier: MIT
// Parts as a whole: volumes and visibility. Nothing is looked at where the answer is known: one
// closed part needs no ray.
#include "prepare/orient.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>

#include "mesh/scale.h"
#include "prepare/neighbours.h"
#include "prepare/sight.h"

namespace kdm {
namespace {

// Lines through points of a part, a ray to either side of the surface. Many parts share the budget;
// closed ones, which mostly need one ray, all get some, of open ones only the largest.
constexpr Index kMostLines = 512;
constexpr Index kLeastLines = 8;
constexpr Index kBudget = 8192;
constexpr Index kBatch = 16;
// Shares of the lines.
constexpr double kSeen = 1.0 / 20;  // fewer rays that leave: enclosed
constexpr double kClear = 1.0 / 2;  // a difference that needs no further lines
constexpr double kSheet = 0.85;     // one side sees at least this share of what the other sees
// Of area^(3/2): a ball has 0.09.
constexpr double kNoVolume = 1e-7;
constexpr double kSomeVolume = 0.01;
constexpr double kDirected = 2.0 / 3;  // of the area

// What is known of a part beyond its report.
struct Shape {
  Index begin = 0;  // its triangles in the list by part, copies left out
  Index end = 0;
  double volume = 0;    // about the centroid
  double flatness = 1;  // length of the sum of its area vectors over its area
  bool touches_bounds = false;
};

struct Seen {
  double front = 0;  // share of rays that leave
  double back = 0;
};

class Orienter {
 public:
  Orienter(std::span<const Triangle> triangles, const std::vector<Vec3>& points)
      : triangles_(triangles),
        scaled_(scale_to_one(points, triangles)),
        neighbours_(orient_neighbours(triangles, scaled_.positions)),
        shapes_(neighbours_.parts.size()),
        turn_(neighbours_.parts.size(), 0) {}

  Orientation run() {
    list_by_part();
    measure();
    limit_parts();
    result_.parts.resize(shapes_.size());
    for (Index p = 0; p < shapes_.size(); ++p) decide(p);
    decide_enclosed();
    report();
    return std::move(result_);
  }

 private:
  bool is_copy(Index t) const { return neighbours_.copy_of[t] != kNone; }

  // Six times the area vector's third: the cross product of two sides, as turned by neighbours.
  Vec3 cross(Index t) const {
    const Triangle& c = triangles_[t];
    const Vec3 product = (scaled_.positions[c[1]] - scaled_.positions[c[0]])
                             .cross(scaled_.positions[c[2]] - scaled_.positions[c[0]]);
    return neighbours_.flip[t] != 0 ? Vec3(-product) : product;
  }

  void list_by_part() {
    for (Index t = 0; t < triangles_.size(); ++t) {
      if (!is_copy(t)) ++shapes_[neighbours_.part[t]].end;
    }
    Index total = 0;
    for (Shape& shape : shapes_) {
      const Index count = shape.end;
      shape.begin = shape.end = total;
      total += count;
    }
    by_part_.resize(total);
    for (Index t = 0; t < triangles_.size(); ++t) {
      if (!is_copy(t)) by_part_[shapes_[neighbours_.part[t]].end++] = t;
    }
  }

  void measure() {
    area_up_to_.reserve(by_part_.size());
    std::vector<Box> boxes;
    for (Shape& shape : shapes_) {
      Vec3 centroid = Vec3::Zero();
      Vec3 normal = Vec3::Zero();
      double area = 0;
      Box box{scaled_.positions[triangles_[by_part_[shape.begin]][0]],
              scaled_.positions[triangles_[by_part_[shape.begin]][0]]};
      for (Index i = shape.begin; i < shape.end; ++i) {
        const Index t = by_part_[i];
        const Vec3 product = cross(t);
        const double size = product.norm();
        area += size / 2;
        normal += product / 2;
        area_up_to_.push_back(area);
        for (const Index corner : triangles_[t]) {
          centroid += scaled_.positions[corner] * (size / 6);
          box.min = box.min.cwiseMin(scaled_.positions[corner]);
          box.max = box.max.cwiseMax(scaled_.positions[corner]);
        }
      }
      boxes.push_back(box);
      if (!(area > 0)) continue;
      centroid /= area;
      for (Index i = shape.begin; i < shape.end; ++i) {
        const Index t = by_part_[i];
        shape.volume += (scaled_.positions[triangles_[t][0]] - centroid).dot(cross(t)) / 6;
      }
      shape.flatness = normal.norm() / area;
    }
    if (boxes.empty()) return;
    Box all = boxes[0];
    for (const Box& box : boxes) {
      all.min = all.min.cwiseMin(box.min);
      all.max = all.max.cwiseMax(box.max);
    }
    for (Index p = 0; p < shapes_.size(); ++p) {
      shapes_[p].touches_bounds = (boxes[p].min.array() == all.min.array()).any() ||
                                  (boxes[p].max.array() == all.max.array()).any();
    }
  }

  double size_of(Index part) const {
    const double area = neighbours_.parts[part].area;
    return area * std::sqrt(area);
  }

  bool has_volume(Index p) const {
    return neighbours_.parts[p].orientable &&
           std::abs(shapes_[p].volume) > kSomeVolume * size_of(p);
  }

  void decide(Index p) {
    const Shape& shape = shapes_[p];
    OrientedPart& part = result_.parts[p];
    part.closed = neighbours_.parts[p].closed;
    if (part.closed && std::abs(shape.volume) <= kNoVolume * size_of(p)) {
      part.sheet = true;
      return;
    }
    if (part.closed) {
      // The sign of the volume tells the outer side; rays only tell whether anybody sees it.
      part.enclosed = !shape.touches_bounds && !can_be_seen(p, shape.volume > 0);
      turn_[p] = !part.enclosed && shape.volume < 0 ? 1 : 0;
      return;
    }
    if (lines_for(p) == 0) {
      part.sheet = shape.flatness >= kSheet;
      return;
    }
    const Seen seen = look(p);
    part.enclosed = seen.front + seen.back < kSeen;
    const double more = std::max(seen.front, seen.back);
    const double less = std::min(seen.front, seen.back);
    part.sheet = (part.enclosed ? shape.flatness : less / more) >= kSheet;
    if (part.sheet) {
      turn_[p] = has_volume(p) && shape.volume < 0 ? 1 : 0;
    } else if (!part.enclosed) {
      turn_[p] = seen.back > seen.front ? 1 : 0;
    }
  }

  // Whether as many lines as can be had see out on that side.
  bool can_be_seen(Index p, bool front) {
    const Index lines = lines_for(p);
    const double enough = kSeen * lines;
    Index seen = 0;
    for (Index i = 0; i < lines; ++i) {
      seen += sees_out(p, i, front) ? 1 : 0;
      if (seen > enough) return true;
    }
    return false;
  }

  Seen look(Index p) {
    const Index lines = lines_for(p);
    Index front = 0;
    Index back = 0;
    Index done = 0;
    while (done < lines) {
      for (const Index stop = std::min(done + kBatch, lines); done < stop; ++done) {
        front += sees_out(p, done, true) ? 1 : 0;
        back += sees_out(p, done, false) ? 1 : 0;
      }
      const Index difference = front > back ? front - back : back - front;
      if (difference > kClear * done) break;
    }
    const double total = done;
    return {front / total, back / total};
  }

  Index lines_for(Index p) const {
    const double area = neighbours_.parts[p].area;
    if (!(area > 0) || (!neighbours_.parts[p].closed && area < least_area_)) return 0;
    const auto share = kBudget / static_cast<Index>(shapes_.size());
    return std::clamp<Index>(share, kLeastLines, kMostLines);
  }

  // Open parts below this area get no line.
  void limit_parts() {
    std::vector<double> areas;
    for (const PartDirection& part : neighbours_.parts) {
      if (!part.closed) areas.push_back(part.area);
    }
    constexpr std::size_t kMostParts = kBudget / kLeastLines;
    if (areas.size() <= kMostParts) return;
    const auto last = areas.begin() + kMostParts - 1;
    std::nth_element(areas.begin(), last, areas.end(), std::greater<double>());
    least_area_ = *last;
  }

  // The `number`-th line of a part: points by area in a sequence of low discrepancy (powers of the
  // root of x^4 = x + 1), directions by the cosine to the normal.
  bool sees_out(Index p, Index number, bool front) {
    constexpr double kStep[] = {0.8191725133961644, 0.6710436067037893, 0.5497004779019701};
    if (!sight_) {
      std::vector<char> copies;
      for (const Index first : neighbours_.copy_of) copies.push_back(first != kNone ? 1 : 0);
      sight_.emplace(triangles_, scaled_.positions, copies);
      directions_ = spread_directions(kMostLines);
    }
    const auto fraction = [&](int k) {
      const double x = 0.5 + kStep[k] * (number + 1);
      return x - std::floor(x);
    };
    const Shape& shape = shapes_[p];
    const auto first = area_up_to_.begin() + shape.begin;
    const auto last = area_up_to_.begin() + shape.end - 1;
    const auto at = std::lower_bound(first, last, fraction(0) * *last);
    const Index t = by_part_[static_cast<std::size_t>(at - area_up_to_.begin())];
    double u = fraction(1);
    double v = fraction(2);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Triangle& c = triangles_[t];
    const Vec3& a = scaled_.positions[c[0]];
    const Vec3 origin = a + u * (scaled_.positions[c[1]] - a) + v * (scaled_.positions[c[2]] - a);
    const Vec3 normal = cross(t).normalized();
    Vec3 direction = (front ? normal : Vec3(-normal)) + directions_[number];
    return sight_->escapes(origin, direction, t);
  }

  // If most of what shows is inside out, all is.
  void decide_enclosed() {
    double kept = 0;
    double turned = 0;
    for (Index p = 0; p < shapes_.size(); ++p) {
      if (result_.parts[p].enclosed || result_.parts[p].sheet) continue;
      (turn_[p] != 0 ? turned : kept) += neighbours_.parts[p].area;
    }
    for (Index p = 0; p < shapes_.size(); ++p) {
      if (!result_.parts[p].enclosed) continue;
      const PartDirection& part = neighbours_.parts[p];
      if (part.agreeing >= kDirected * part.area) {
        turn_[p] = turned > kept ? 1 : 0;
      } else {
        turn_[p] = has_volume(p) && shapes_[p].volume < 0 ? 1 : 0;
      }
    }
  }

  void report() {
    result_.flip = std::move(neighbours_.flip);
    result_.part = std::move(neighbours_.part);
    result_.copy_of = std::move(neighbours_.copy_of);
    result_.contradictions = neighbours_.contradictions;
    for (Index t = 0; t < triangles_.size(); ++t) {
      result_.flip[t] ^= turn_[result_.part[t]];
      result_.flipped_triangles += result_.flip[t] != 0 ? 1 : 0;
      result_.copies += result_.copy_of[t] != kNone ? 1 : 0;
    }
    for (Index p = 0; p < shapes_.size(); ++p) {
      OrientedPart& part = result_.parts[p];
      part.first = neighbours_.parts[p].first;
      part.triangles = neighbours_.parts[p].triangles;
      part.area = std::ldexp(neighbours_.parts[p].area, 2 * scaled_.exponent);
      part.oriented = neighbours_.parts[p].oriented;
      part.flipped = turn_[p] != 0;  // neighbours keep the direction of most of it
      result_.flipped_parts += part.flipped ? 1 : 0;
      result_.sheets += part.sheet ? 1 : 0;
    }
  }

  std::span<const Triangle> triangles_;
  ScaledPositions scaled_;
  NeighbourDirections neighbours_;
  std::vector<Shape> shapes_;
  std::vector<char> turn_;          // of each part, beyond what neighbours ask for
  std::vector<Index> by_part_;      // triangles without copies, part after part
  std::vector<double> area_up_to_;  // of the part's triangles up to each of these
  double least_area_ = 0;
  std::optional<Sight> sight_;
  std::vector<Vec3> directions_;
  Orientation result_;
};

}  // namespace

Orientation orient(std::span<const Triangle> triangles, const std::vector<Vec3>& points) {
  return Orienter(triangles, points).run();
}

}  // namespace kdm
