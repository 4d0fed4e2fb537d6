// SPDX-License-Identifier: MIT
#include "inside/thick_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/distance.h"
#include "geometry/triangle.h"
#include "mesh/boxes.h"

namespace kdm {
namespace {

// How far thick points are from the centre of a ball, in diameters.
constexpr double kReach = 1.1;
// How far points on the boundary are apart at most, in diameters.
constexpr double kSpacing = 1.0 / 3;
// Leaves at the border between thick and thin are no larger than this many diameters.
constexpr double kLeaf = 0.25;

// Calls `visit(point, normal, area)` for points of a triangle, no two of which are further apart
// than `spacing` if they are neighbours: the triangle's longest side is halved until it is shorter.
template <typename Visit>
void visit_samples(const std::array<Vec3, 3>& corners, const Vec3& normal, double area,
                   double spacing, const Visit& visit) {
  int longest = 0;
  double length = -1;
  for (int i = 0; i < 3; ++i) {
    const double here = (corners[(i + 1) % 3] - corners[i]).squaredNorm();
    if (here > length) {
      length = here;
      longest = i;
    }
  }
  if (length <= spacing * spacing) {
    visit(Vec3((corners[0] + corners[1] + corners[2]) / 3), normal, area);
    return;
  }
  const int end = (longest + 1) % 3;
  const Vec3 middle = 0.5 * (corners[longest] + corners[end]);
  std::array<Vec3, 3> half = corners;
  half[end] = middle;
  visit_samples(half, normal, area / 2, spacing, visit);
  half = corners;
  half[longest] = middle;
  visit_samples(half, normal, area / 2, spacing, visit);
}

}  // namespace

ThickField::ThickField(std::shared_ptr<const PointField> base, std::vector<Corners> boundary,
                       Side side, double thickness, double slack)
    : base_(std::move(base)),
      boundary_(std::move(boundary)),
      side_(side),
      thickness_(thickness),
      reach_(kReach * thickness) {
  triangle_boxes_.reserve(boundary_.size());
  for (const auto& [a, b, c] : boundary_) {
    triangle_boxes_.push_back(box_of(a, b, c));
    for (const Vec3& corner : {a, b, c}) grow(bounds_, corner);
  }
  triangles_ = std::make_unique<BoxTree>(triangle_boxes_);
  find_centres(slack);
  find_thin();
}

template <typename Visit>
void ThickField::for_each_sample(const Visit& visit) const {
  for (const Corners& t : boundary_) {
    const Vec3 doubled = doubled_area_vector(t[0], t[1], t[2]);
    const double length = doubled.norm();
    if (!(length > 0)) continue;
    visit_samples(t, doubled / length, length / 2, kSpacing * thickness_, visit);
  }
}

void ThickField::find_centres(double slack) {
  const double radius = thickness_ / 2;
  const double clear = radius - slack;
  for_each_sample([&](const Vec3& p, const Vec3& normal, double) {
    const Vec3 centre = p + (side_ == Side::kInside ? -radius : radius) * normal;
    if (!fits(centre, clear)) return;
    // No boundary passes through the ball about the last centre.
    const bool beside =
        !centres_.empty() && (centre - centres_.back().min).squaredNorm() < clear * clear;
    if (beside || is_on_side(centre)) centres_.push_back({centre, centre});
  });
  centre_tree_ = std::make_unique<BoxTree>(centres_);
}

void ThickField::find_thin() {
  for_each_sample([&](const Vec3& p, const Vec3&, double area) {
    if (some_centre_near({p, p})) return;
    thin_.push_back({p, p});
    thin_area_ += area;
  });
  thin_tree_ = std::make_unique<BoxTree>(thin_);
}

// Tells whether the boundary is further than a radius from a point.
bool ThickField::fits(const Vec3& centre, double radius) const {
  const double square = radius * radius;
  const auto distance = [&](Index t) {
    return squared_distance(centre, boundary_[t][0], boundary_[t][1], boundary_[t][2]);
  };
  return triangles_->least(centre, std::numeric_limits<double>::infinity(), square, distance) >
         square;
}

// Tells whether a centre is where the balls are to fit: normals of triangles that are folded over,
// or of slivers, lead to the other side. The base knows of no points beyond the boundary's box.
bool ThickField::is_on_side(const Vec3& centre) const {
  const bool within = (centre.array() >= bounds_.min.array()).all() &&
                      (centre.array() <= bounds_.max.array()).all();
  return (within && base_->inside(centre)) == (side_ == Side::kInside);
}

// Tells whether a centre is within reach of some point of the box.
bool ThickField::some_centre_near(const Box& box) const {
  const Box near{box.min - Vec3::Constant(reach_), box.max + Vec3::Constant(reach_)};
  return centre_tree_->any_meeting(near, [&](Index i) {
    const Vec3& centre = centres_[i].min;
    return (centre - centre.cwiseMax(box.min).cwiseMin(box.max)).squaredNorm() <= reach_ * reach_;
  });
}

bool ThickField::is_thick(const Vec3& p) const {
  return some_centre_near({p, p}) || fits(p, thickness_ / 2);
}

bool ThickField::inside(const Vec3& p) const {
  const bool before = base_->inside(p);
  if (before != (side_ == Side::kInside)) return before;
  return is_thick(p) == before;
}

bool ThickField::inside(const LatticePoint& p) const {
  const bool before = base_->inside(p);
  if (before != (side_ == Side::kInside)) return before;
  return is_thick(to_vec3(p)) == before;
}

// Thick and thin meet at some distance from the nearest centre.
Vec3 ThickField::gradient(const Vec3& p) const {
  constexpr double kNear = 1.0 / 16;  // diameters
  const Vec3* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  centre_tree_->least(p, least, 0, [&](Index i) {
    const double square = (centres_[i].min - p).squaredNorm();
    if (square < least) {
      least = square;
      nearest = &centres_[i].min;
    }
    return square;
  });
  if (nearest == nullptr || std::abs(std::sqrt(least) - reach_) > kNear * thickness_) {
    return base_->gradient(p);
  }
  return side_ == Side::kInside ? Vec3(*nearest - p) : Vec3(p - *nearest);
}

bool ThickField::follows_surface(const Vec3& p) const {
  return base_->follows_surface(p) && some_centre_near({p, p});
}

bool ThickField::must_split(const LatticeBox& box) const {
  if (base_->must_split(box)) return true;
  const Box real{to_vec3(box.lo), to_vec3(box.hi)};
  if ((real.max - real.min).maxCoeff() <= kLeaf * thickness_) return false;
  return thin_tree_->any_meeting(real, [](Index) { return true; }) && some_centre_near(real);
}

}  // namespace kdm
