// SPDX-License-Identifier: MIT
// Decides about parts as a whole by their volumes and by what can be seen of them. No ray is
// followed where the answer is known without: a single closed part needs none.
#include "prepare/orient.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "geometry/triangle.h"
#include "mesh/boxes.h"
#include "mesh/groups.h"
#include "mesh/scale.h"
#include "mesh/sort.h"
#include "prepare/neighbours.h"
#include "prepare/sight.h"
#include "threads/share_work.h"

namespace kdm {
namespace {

// A part is looked at along lines through points of it, with a ray to either side of the surface.
// All parts share `kLineBudget`, but each gets `kLeastLines` to `kMostLines`. Closed parts, most of
// which need a single ray, always get theirs; of open parts only the largest do.
constexpr Index kMostLines = 512;
constexpr Index kLeastLines = 8;
constexpr Index kLineBudget = 8192;
constexpr Index kLinesPerBatch = 16;  // after each batch it is seen whether they suffice

// Shares of the lines.
constexpr double kLeastSeenShare = 1.0 / 20;  // if fewer rays leave, the part is enclosed
constexpr double kClearDifference = 1.0 / 2;  // front and back differ by this: no further lines
constexpr double kLeastSheetLikeness = 0.85;  // of a sheet, less seen side to more seen side

// Volumes are given as fractions of area^(3/2); for a ball this is 0.09.
constexpr double kMostRoundingVolume = 1e-7;  // what rounding errors make of no volume at all
constexpr double kLeastTellingVolume = 0.01;  // the sign of a smaller volume says nothing

constexpr double kLeastAgreeingShare = 2.0 / 3;  // of an enclosed part's area, for it to stay

// What is measured of a part after its triangles were turned to agree; copies do not count.
struct Shape {
  double volume = 0;            // about the centroid
  double flatness = 1;          // length of the sum of its area vectors, divided by its area
  bool touches_bounds = false;  // reaches a side of the mesh's box, so it can be seen
};

// The shares of rays from the two sides of a part that leave the mesh.
struct Visibility {
  double front = 0;
  double back = 0;
};

class Orienter {
 public:
  Orienter(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
           const Topology& topology)
      : triangles_(triangles),
        scaled_(scale_to_one(points, triangles)),
        neighbours_(orient_neighbours(triangles, scaled_.positions, topology)),
        shapes_(neighbours_.parts.size()),
        turn_part_(neighbours_.parts.size()) {}

  Orientation run() {
    list_by_part();
    measure_parts();
    limit_parts();
    result_.parts.resize(shapes_.size());
    decide_by_themselves();
    decide_enclosed();
    report();
    return std::move(result_);
  }

 private:
  const Vec3& position(PointId point) const { return scaled_.positions[point]; }

  // Twice the triangle's area vector, once neighbours agree.
  Vec3 doubled_area(TriangleId t) const {
    const Triangle& c = triangles_[t];
    const Vec3 doubled = doubled_area_vector(position(c[0]), position(c[1]), position(c[2]));
    return neighbours_.must_turn.test(t) ? Vec3(-doubled) : doubled;
  }

  void list_by_part() {
    by_part_ = Groups(shapes_.size(), [&](const auto& put) {
      for (TriangleId t = 0; t < triangles_.size(); ++t) {
        if (neighbours_.copy_of[t] == kNone) put(neighbours_.part[t], t);
      }
    });
  }

  // Measures a part and returns its box.
  Box measure(Index p) {
    Shape& shape = shapes_[p];
    Vec3 centroid = Vec3::Zero();
    Vec3 area_vector = Vec3::Zero();
    double area = 0;
    Box box;
    for (const TriangleId t : by_part_.of(p)) {
      const Vec3 doubled = doubled_area(t);
      const double size = doubled.norm();
      area += size / 2;
      area_vector += doubled / 2;
      area_up_to_.push_back(area);
      for (const PointId corner : triangles_[t]) {
        centroid += position(corner) * (size / 6);
        grow(box, position(corner));
      }
    }
    if (!(area > 0)) return box;
    centroid /= area;
    for (const TriangleId t : by_part_.of(p)) {
      shape.volume += (position(triangles_[t][0]) - centroid).dot(doubled_area(t)) / 6;
    }
    shape.flatness = area_vector.norm() / area;
    return box;
  }

  void measure_parts() {
    area_up_to_.reserve(by_part_.items().size());
    std::vector<Box> boxes;
    for (Index p = 0; p < shapes_.size(); ++p) boxes.push_back(measure(p));
    if (boxes.empty()) return;
    Box all = boxes[0];
    for (const Box& box : boxes) grow(all, box);
    for (Index p = 0; p < shapes_.size(); ++p) {
      shapes_[p].touches_bounds = (boxes[p].min.array() == all.min.array()).any() ||
                                  (boxes[p].max.array() == all.max.array()).any();
    }
  }

  // The volume of a part is compared with its area to the power of 3/2.
  double volume_unit(Index p) const {
    const double area = neighbours_.parts[p].area;
    return area * std::sqrt(area);
  }

  bool has_negative_volume(Index p) const {
    return neighbours_.parts[p].orientable &&
           std::abs(shapes_[p].volume) > kLeastTellingVolume * volume_unit(p) &&
           shapes_[p].volume < 0;
  }

  // Tells whether a part is closed, but encloses nothing.
  bool is_hollow(Index p) const {
    return neighbours_.parts[p].closed &&
           std::abs(shapes_[p].volume) <= kMostRoundingVolume * volume_unit(p);
  }

  // Tells whether rays must be followed for a part.
  bool must_be_looked_at(Index p) const {
    if (lines_for(p) == 0) return false;
    return !neighbours_.parts[p].closed || !(is_hollow(p) || shapes_[p].touches_bounds);
  }

  void decide_by_themselves() {
    for (Index p = 0; p < shapes_.size() && !sight_; ++p) {
      if (must_be_looked_at(p)) prepare_sight();
    }
    share_work(shapes_.size(), workers(),
               [this](std::size_t p, int) { decide(static_cast<Index>(p)); });
  }

  // Decides about a part, unless it is enclosed: then it is only found that it is.
  void decide(Index p) {
    const Shape& shape = shapes_[p];
    OrientedPart& part = result_.parts[p];
    part.closed = neighbours_.parts[p].closed;
    if (is_hollow(p)) {
      part.sheet = true;
      return;
    }
    if (part.closed) {
      // The sign of the volume tells the outer side; rays only tell whether anybody sees it.
      part.enclosed = !shape.touches_bounds && !can_be_seen(p, shape.volume > 0);
      turn_part_.set(p, !part.enclosed && shape.volume < 0);
      return;
    }
    if (lines_for(p) == 0) {
      part.sheet = shape.flatness >= kLeastSheetLikeness;
      return;
    }
    const Visibility seen = look(p);
    part.enclosed = seen.front + seen.back < kLeastSeenShare;
    const double more = std::max(seen.front, seen.back);
    const double less = std::min(seen.front, seen.back);
    part.sheet = (part.enclosed ? shape.flatness : less / more) >= kLeastSheetLikeness;
    if (part.sheet) {
      turn_part_.set(p, has_negative_volume(p));
    } else if (!part.enclosed) {
      turn_part_.set(p, seen.back > seen.front);
    }
  }

  // Tells whether enough rays leave the mesh from one side of a part. Stops as soon as they do.
  bool can_be_seen(Index p, bool front) const {
    const Index lines = lines_for(p);
    const double enough = kLeastSeenShare * lines;
    Index seen = 0;
    for (Index i = 0; i < lines; ++i) {
      seen += sees_out(p, i, front) ? 1 : 0;
      if (seen > enough) return true;
    }
    return false;
  }

  // Follows rays from both sides of a part until the difference is clear or no line is left.
  Visibility look(Index p) const {
    const Index lines = lines_for(p);
    Index front = 0;
    Index back = 0;
    Index done = 0;
    while (done < lines) {
      for (const Index stop = std::min(done + kLinesPerBatch, lines); done < stop; ++done) {
        front += sees_out(p, done, true) ? 1 : 0;
        back += sees_out(p, done, false) ? 1 : 0;
      }
      const Index difference = front > back ? front - back : back - front;
      if (difference > kClearDifference * done) break;
    }
    const double total = done;
    return {front / total, back / total};
  }

  Index lines_for(Index p) const {
    const double area = neighbours_.parts[p].area;
    if (!(area > 0) || (!neighbours_.parts[p].closed && area < least_open_area_)) return 0;
    const auto share = kLineBudget / static_cast<Index>(shapes_.size());
    return std::clamp<Index>(share, kLeastLines, kMostLines);
  }

  // Finds the area below which open parts get no line, so that the others get enough.
  void limit_parts() {
    std::vector<double> areas;
    for (const PartDirection& part : neighbours_.parts) {
      if (!part.closed) areas.push_back(part.area);
    }
    constexpr std::size_t kMostParts = kLineBudget / kLeastLines;
    if (areas.size() <= kMostParts) return;
    sort_by(areas, std::greater<double>());
    least_open_area_ = areas[kMostParts - 1];
  }

  void prepare_sight() {
    Marks copies;
    copies.reserve(triangles_.size());
    for (const TriangleId first : neighbours_.copy_of) copies.push_back(first != kNone);
    sight_.emplace(triangles_, scaled_.positions, copies);
    directions_ = spread_directions(kMostLines);
  }

  struct SurfacePoint {
    TriangleId triangle;
    Vec3 position;
  };

  // Returns a point of a part, from a sequence in which points are spread evenly by area: a
  // sequence of low discrepancy in three dimensions, whose steps are the powers of 1/x for the root
  // x of x^4 = x + 1. The first dimension picks the triangle, the others the point on it.
  SurfacePoint point_of(Index p, Index number) const {
    constexpr double kStep[] = {0.8191725133961644, 0.6710436067037893, 0.5497004779019701};
    const auto fraction = [&](int k) {
      const double x = 0.5 + kStep[k] * (number + 1);
      return x - std::floor(x);
    };
    const std::span<const TriangleId> triangles = by_part_.of(p);
    const auto first = area_up_to_.begin() + by_part_.items_before(p);
    const auto last = first + static_cast<std::ptrdiff_t>(triangles.size()) - 1;
    const auto at = std::lower_bound(first, last, fraction(0) * *last);
    const TriangleId t = triangles[static_cast<std::size_t>(at - first)];
    double u = fraction(1);
    double v = fraction(2);
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const Triangle& c = triangles_[t];
    const Vec3& a = position(c[0]);
    return {t, a + u * (position(c[1]) - a) + v * (position(c[2]) - a)};
  }

  // Tells whether the ray along a part's line of this number leaves the mesh, on the front or the
  // back of the surface. Directions are spread by the cosine of their angle to the normal.
  bool sees_out(Index p, Index number, bool front) const {
    const SurfacePoint from = point_of(p, number);
    const Vec3 normal = doubled_area(from.triangle).normalized();
    const Vec3 direction = (front ? normal : Vec3(-normal)) + directions_[number];
    return sight_->escapes(from.position, direction, from.triangle);
  }

  // Turns enclosed parts as orient.h says: if most of the area that can be seen is inside out, the
  // whole mesh is.
  void decide_enclosed() {
    double kept = 0;
    double turned = 0;
    for (Index p = 0; p < shapes_.size(); ++p) {
      if (result_.parts[p].enclosed || result_.parts[p].sheet) continue;
      (turn_part_.test(p) ? turned : kept) += neighbours_.parts[p].area;
    }
    for (Index p = 0; p < shapes_.size(); ++p) {
      if (!result_.parts[p].enclosed) continue;
      const PartDirection& part = neighbours_.parts[p];
      const bool agrees = part.agreeing >= kLeastAgreeingShare * part.area;
      turn_part_.set(p, agrees ? turned > kept : has_negative_volume(p));
    }
  }

  void report() {
    result_.must_turn = std::move(neighbours_.must_turn);
    result_.part = std::move(neighbours_.part);
    result_.copy_of = std::move(neighbours_.copy_of);
    result_.contradictions = neighbours_.contradictions;
    for (TriangleId t = 0; t < triangles_.size(); ++t) {
      const bool turn = result_.must_turn.test(t) != turn_part_.test(result_.part[t]);
      result_.must_turn.set(t, turn);
      result_.flipped_triangles += turn ? 1 : 0;
      result_.copies += result_.copy_of[t] != kNone ? 1 : 0;
    }
    for (Index p = 0; p < shapes_.size(); ++p) {
      OrientedPart& part = result_.parts[p];
      part.first = neighbours_.parts[p].first;
      part.triangles = neighbours_.parts[p].triangles;
      part.area = std::ldexp(neighbours_.parts[p].area, 2 * scaled_.exponent);
      part.oriented = neighbours_.parts[p].oriented;
      part.flipped = turn_part_.test(p);  // neighbours keep the direction of most of its area
      result_.flipped_parts += part.flipped ? 1 : 0;
      result_.sheets += part.sheet ? 1 : 0;
    }
  }

  std::span<const Triangle> triangles_;
  ScaledPositions scaled_;
  NeighbourDirections neighbours_;
  std::vector<Shape> shapes_;
  Marks turn_part_;                 // parts to be turned once their neighbours agree
  Groups by_part_;                  // triangles without copies
  std::vector<double> area_up_to_;  // per item of by_part_: area of its part's items up to it
  double least_open_area_ = 0;      // smaller open parts are not looked at
  std::optional<Sight> sight_;
  std::vector<Vec3> directions_;
  Orientation result_;
};

}  // namespace

Orientation orient(std::span<const Triangle> triangles, const std::vector<Vec3>& points,
                   const Topology& topology) {
  return Orienter(triangles, points, topology).run();
}

}  // namespace kdm
