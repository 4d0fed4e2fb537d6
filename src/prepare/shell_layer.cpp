// SPDX-License-Identifier: MIT
#include "prepare/shell_layer.h"

#include <cstddef>
#include <deque>

#include "geometry/triangle.h"
#include "mesh/marks.h"

namespace kdm {
namespace {

// Limits how far a vertex goes at sharp edges: as a multiple of the layer's height.
constexpr double kLongestMitre = 2;
// Vectors are evened out where a prism's cross-section has less than this part of its triangle's
// area somewhere: some more than none, so that faces keep an area.
constexpr double kSpareArea = 1.0 / 8;
// A fan's vector is not turned further away from the mean normal than to this cosine.
constexpr double kLeastEvenedCosine = 0.75;
// How often triangles are evened out, as a multiple of how many need it at first.
constexpr std::size_t kMostEvenedOut = 64;

}  // namespace

ShellLayer::ShellLayer(const PiecesOfSurface& surface, double height)
    : surface_(surface),
      height_(height),
      opposite_(surface.opposite().begin(), surface.opposite().end()) {
  do {
    make_fans();
    even_out_turned();
  } while (cut_off_turned() > 0);
}

Vec3 ShellLayer::NormalSum::direction() const { return normalized_or_zero(normal); }

void ShellLayer::make_fans() {
  fans_.emplace(opposite_);
  sums_.clear();
  outs_.clear();
  for (Index fan = 0; fan < fans_->size(); ++fan) {
    sums_.push_back(normal_sum(fan));
    const Vec3 direction = sums_.back().direction();
    outs_.push_back(direction * length_along(direction, fan));
  }
}

ShellLayer::NormalSum ShellLayer::normal_sum(Index fan) const {
  NormalSum sum;
  fans_->for_each_corner(fan, opposite_, [&](SideId corner) {
    const Vec3& normal = surface_.normal(triangle_of(corner));
    if (normal == Vec3::Zero()) return;
    const double angle = surface_.angle(corner);
    sum.normal += angle * normal;
    sum.angle += angle;
  });
  return sum;
}

// Returns how far a fan's vertex goes in a direction, of length 1, to lie `height_` before the
// fan's triangles: the inverse of their normals' mean cosine to it, times the height.
double ShellLayer::length_along(const Vec3& direction, Index fan) const {
  const double sum = sums_[fan].normal.dot(direction);
  return height_ *
         (sums_[fan].angle < kLongestMitre * sum ? sums_[fan].angle / sum : kLongestMitre);
}

// Turns the vectors of fans towards each other where prisms turn over: the normals of needles say
// little, and short sides cannot bear that their ends go different ways. Ends when no prism turns
// over any more, or where the surface itself is too curved.
void ShellLayer::even_out_turned() {
  std::deque<TriangleId> turned;
  Marks waits(surface_.size());
  const auto look_at = [&](TriangleId t) {
    if (waits.test(t) || !turns_over(t, kSpareArea)) return;
    waits.set(t);
    turned.push_back(t);
  };
  for (TriangleId t = 0; t < surface_.size(); ++t) look_at(t);
  for (std::size_t left = kMostEvenedOut * turned.size(); left > 0 && !turned.empty(); --left) {
    const TriangleId t = turned.front();
    turned.pop_front();
    waits.clear(t);
    if (!turns_over(t, kSpareArea) || !even_out(t)) continue;
    for (SideId corner = 3 * t; corner < 3 * t + 3; ++corner) {
      fans_->for_each_corner(fans_->of(corner), opposite_,
                             [&](SideId other) { look_at(triangle_of(other)); });
    }
  }
}

// Gives the fans of a triangle one vector, whose direction is the mean of theirs, and returns
// whether all of them can take it.
bool ShellLayer::even_out(TriangleId t) {
  Vec3 sum = Vec3::Zero();
  for (SideId corner = 3 * t; corner < 3 * t + 3; ++corner) sum += outs_[fans_->of(corner)];
  const Vec3 direction = (height_ < 0 ? -1 : 1) * normalized_or_zero(sum);
  double length = 0;
  for (SideId corner = 3 * t; corner < 3 * t + 3; ++corner) {
    const Index fan = fans_->of(corner);
    if (!(direction.dot(sums_[fan].direction()) > kLeastEvenedCosine)) return false;
    length += length_along(direction, fan) / 3;
  }
  for (SideId corner = 3 * t; corner < 3 * t + 3; ++corner) {
    outs_[fans_->of(corner)] = length * direction;
  }
  return true;
}

// Tells whether somewhere in a triangle's prism too little is left of its cross-section. From the
// surface (s = 0) to the layer's face (s = 1) its area, doubled and seen along the normal, is
// a + b s + c s^2, which must be above `spare` times a.
bool ShellLayer::turns_over(TriangleId t, double spare) const {
  const Vec3& n = surface_.normal(t);
  if (n == Vec3::Zero()) return false;
  const Vec3& p = outs_[fans_->of(3 * t)];
  const Vec3 u = surface_.place(3 * t + 1) - surface_.place(3 * t);
  const Vec3 v = surface_.place(3 * t + 2) - surface_.place(3 * t);
  const Vec3 du = outs_[fans_->of(3 * t + 1)] - p;
  const Vec3 dv = outs_[fans_->of(3 * t + 2)] - p;
  const double a = (1 - spare) * u.cross(v).dot(n);
  const double b = (u.cross(dv) + du.cross(v)).dot(n);
  const double c = du.cross(dv).dot(n);
  if (!(a > 0 && a + b + c > 0)) return true;
  return b < 0 && -b < 2 * c && !(4 * a * c > b * b);
}

// Cuts the layer round triangles whose prisms turn over, and returns how many sides were cut. The
// prism of a triangle by itself has parallel edges and does not turn over.
Index ShellLayer::cut_off_turned() {
  Index cuts = 0;
  for (TriangleId t = 0; t < surface_.size(); ++t) {
    if (turns_over(t, 0)) cuts += cut_round(t, opposite_);
  }
  return cuts;
}

}  // namespace kdm
