// SPDX-License-Identifier: MIT
#include "simplify/thickness.h"

#include <algorithm>
#include <cmath>

#include "geometry/triangle.h"
#include "inside/winding_field.h"
#include "mesh/boxes.h"
#include "reduce/reference.h"

namespace kdm {
namespace {

using Corners = std::array<Vec3, 3>;

// How many triangles are taken for directions, and to look below.
constexpr std::size_t kMostTries = 64;
constexpr std::size_t kMostBoxes = std::size_t{1} << 18;
// Further than anything within the root cell.
constexpr double kBeyond = 4.0 * kLatticeSize;

std::vector<LatticeTriangle> rounded(const std::vector<Corners>& triangles) {
  const auto round = [](const Vec3& p) {
    LatticePoint at;
    for (int i = 0; i < 3; ++i) at[i] = static_cast<std::int32_t>(std::floor(p[i] + 0.5));
    return at;
  };
  std::vector<LatticeTriangle> out;
  out.reserve(triangles.size());
  for (const Corners& c : triangles) out.push_back({round(c[0]), round(c[1]), round(c[2])});
  return out;
}

class ThicknessTest {
 public:
  ThicknessTest(const std::vector<Corners>& boundary, double thickness)
      : boundary_(boundary),
        radius_(thickness / 2),
        reference_(boundary),
        rounded_(rounded(boundary)),
        field_(rounded_, kHalf, thickness) {}

  // Looks for a point below some triangle that is too far from all.
  bool is_thick_somewhere() {
    constexpr double kDeeper = 1 + 1e-6;
    for (std::size_t t = 0; t < boundary_.size(); t += step()) {
      const auto& [a, b, c] = boundary_[t];
      const Vec3 middle = (a + b + c) / 3;
      if (is_thick_at(middle - kDeeper * radius_ * unit_normal(a, b, c))) return true;
    }
    return false;
  }

  bool is_thin_everywhere() {
    Box all;
    for (const Corners& c : boundary_) {
      for (const Vec3& p : c) grow(all, p);
    }
    std::vector<Cube> open{{centre_of(all), (all.max - all.min).maxCoeff() / 2}};
    for (std::size_t looked_at = 0; !open.empty(); ++looked_at) {
      if (looked_at == kMostBoxes) return false;
      const Cube cube = open.back();
      open.pop_back();
      const double distance = distance_at(cube.centre);
      const double reach = std::sqrt(3.0) * cube.half;
      if (distance + cube.half <= radius_ && is_near_all_over(cube)) continue;
      if (distance > radius_ || distance > reach) {
        const bool inside = field_.winding(cube.centre) > kHalf;
        if (inside && distance > radius_) return false;
        if (!inside && distance > reach) continue;
      }
      for (int i = 0; i < 8; ++i) open.push_back({corner(cube, i, 0.5), cube.half / 2});
    }
    return true;
  }

  // Tells whether all lies between two planes that are upright on an axis or along a triangle.
  bool fits_between_planes() const {
    for (int i = 0; i < 3; ++i) {
      if (width_along(Vec3::Unit(i)) <= 2 * radius_) return true;
    }
    for (std::size_t t = 0; t < boundary_.size(); t += step()) {
      const auto& [a, b, c] = boundary_[t];
      const Vec3 normal = unit_normal(a, b, c);
      if (normal.squaredNorm() > kHalf && width_along(normal) <= 2 * radius_) return true;
    }
    return false;
  }

 private:
  struct Cube {
    Vec3 centre;
    double half;  // of its side
  };
  static constexpr double kHalf = 0.5;

  // Returns corner `i` of the cube, made smaller by this factor.
  static Vec3 corner(const Cube& cube, int i, double factor) {
    return cube.centre + factor * cube.half * Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }

  // Tells whether one triangle, that at the centre, is near enough to the whole cube: it is if it
  // is near to the corners, as the distance from a triangle is convex.
  bool is_near_all_over(const Cube& cube) const {
    for (int i = 0; i < 8; ++i) {
      if (reference_.squared_distance(near_, corner(cube, i, 1)) > radius_ * radius_) return false;
    }
    return true;
  }

  std::size_t step() const { return (boundary_.size() + kMostTries - 1) / kMostTries; }

  double width_along(const Vec3& direction) const {
    double least = boundary_[0][0].dot(direction);
    double most = least;
    for (const Corners& c : boundary_) {
      for (const Vec3& p : c) {
        least = std::min(least, p.dot(direction));
        most = std::max(most, p.dot(direction));
      }
    }
    return most - least;
  }

  double distance_at(const Vec3& p) {
    near_ = reference_.nearest(p, kBeyond, near_);
    return std::sqrt(reference_.squared_distance(near_, p));
  }

  bool is_thick_at(const Vec3& p) { return distance_at(p) > radius_ && field_.winding(p) > kHalf; }

  const std::vector<Corners>& boundary_;
  double radius_;
  Reference reference_;
  std::vector<LatticeTriangle> rounded_;
  WindingField field_;
  TriangleId near_ = kNone;  // the triangle that was found last
};

}  // namespace

bool is_thin(const std::vector<Corners>& boundary, double thickness) {
  // Where corners that are rounded to the lattice matter, nobody knows.
  constexpr double kLeast = 4;
  if (thickness < kLeast) return false;
  ThicknessTest test(boundary, thickness);
  if (test.fits_between_planes()) return true;
  return !test.is_thick_somewhere() && test.is_thin_everywhere();
}

}  // namespace kdm
