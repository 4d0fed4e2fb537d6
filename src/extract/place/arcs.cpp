// SPDX-License-Identifier: MIT
// Places links between two hits that lie on the same side of their minimal face.
#include "extract/place/arcs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mesh/sort.h"

namespace kdm {
namespace {

// How far an arc leaves the side of its hits, as a fraction of their distance. 5 % kept fans of
// neighbouring leaves from coinciding on all models of a first trial.
constexpr double kArcHeight = 0.05;
// An arc leaves the side by at least this where there is room, in lattice units, so that its height
// is not lost when coordinates are rounded to 32 bits.
constexpr double kMinArcHeight = 0.375;

// Returns the axis across the side of the face that both points lie on, or -1 if there is none.
int common_side(const LinkFace& face, const Vec3& p, const Vec3& q) {
  for (int i = 0; i < 3; ++i) {
    if (i != face.axis && p[i] == q[i] && (p[i] == face.lo[i] || p[i] == face.hi[i])) return i;
  }
  return -1;
}

// The links of a face that join two hits of one of its sides (arcs), and the lines of links that
// pass over them. Coordinates: along the side, and above it, which is into the face.
class Arcs {
 public:
  Arcs(std::span<const Vec3> hit_points, const LinkFace& face, int side, bool low)
      : hit_points_(hit_points),
        side_(side),
        along_(3 - side - face.axis),
        base_(low ? face.lo[side] : face.hi[side]),
        up_(low ? 1 : -1),
        width_(face.hi[side] - face.lo[side]),
        slope_(kArcHeight * std::min(1.0, width_ / (face.hi[along_] - face.lo[along_]))) {}

  // Returns the links with longer arcs first, because these pass over shorter ones. Links that are
  // no arcs of this side come before all arcs.
  std::vector<HitPair> sorted(std::vector<HitPair> links) const {
    sort_by(links, [&](const HitPair& a, const HitPair& b) {
      const double first = is_arc(a) ? length(a) : std::numeric_limits<double>::infinity();
      const double second = is_arc(b) ? length(b) : std::numeric_limits<double>::infinity();
      if (first != second) return first > second;
      return std::pair(a.hit, a.other) < std::pair(b.hit, b.other);
    });
    return links;
  }

  bool is_arc(const HitPair& link) const {
    return hit_points_[link.hit][side_] == base_ && hit_points_[link.other][side_] == base_;
  }

  double usual_height(const HitPair& link) const { return slope_ * length(link); }

  // How far an arc leaves the side: by 5 % of its length, but by kMinArcHeight where there is room,
  // and at most half as far as the lines that were added before and pass over it.
  double height(const HitPair& link) const {
    double limit = 2 * std::max(usual_height(link), std::min(kMinArcHeight, width_ / 4));
    for (const Line& line : lines_) limit = std::min(limit, least_over(line, link));
    return limit / 2;
  }

  // Adds the line of a link, which arcs that come later must stay below. An arc has this height.
  void add(const HitPair& link, double height) {
    const Vec3& p = hit_points_[link.hit];
    const Vec3& q = hit_points_[link.other];
    const double middle = is_arc(link) ? height : 0.5 * (above(p) + above(q));
    const double half = 0.5 * (p[along_] + q[along_]);
    lines_.push_back({{p[along_], half, q[along_]}, {above(p), middle, above(q)}});
  }

 private:
  struct Line {
    std::array<double, 3> along;
    std::array<double, 3> above;
  };

  double length(const HitPair& link) const {
    return std::abs(hit_points_[link.hit][along_] - hit_points_[link.other][along_]);
  }
  double above(const Vec3& p) const { return up_ * (p[side_] - base_); }

  // The least height of the line above the stretch between the arc's hits; infinite if it does not
  // pass over it.
  double least_over(const Line& line, const HitPair& arc) const {
    const auto [lo, hi] = std::minmax(hit_points_[arc.hit][along_], hit_points_[arc.other][along_]);
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 2; ++i) {
      const double from = line.along[i];
      const double to = line.along[i + 1];
      if (std::max(from, to) < lo || std::min(from, to) > hi) continue;
      for (const double x : {lo, hi}) {
        const double part = from == to ? 0 : std::clamp((x - from) / (to - from), 0.0, 1.0);
        least = std::min(least, line.above[i] + part * (line.above[i + 1] - line.above[i]));
      }
      if (from == to) least = std::min(least, line.above[i + 1]);
    }
    return least;
  }

  std::span<const Vec3> hit_points_;
  int side_;      // the axis on which the side has one coordinate
  int along_;     // the axis along the side
  double base_;   // the side's coordinate
  double up_;     // 1 or -1: into the face
  double width_;  // of the face above the side
  double slope_;  // usual height of an arc by its length
  std::vector<Line> lines_;
};

}  // namespace

Vec3 lift_off_side(const GridView& view, const LinkFace& face, HitPair link,
                   const std::vector<HitPair>& links, Vec3 point) {
  const int side = common_side(face, view.hit_points[link.hit], view.hit_points[link.other]);
  if (side < 0) return point;
  const bool low = view.hit_points[link.hit][side] == face.lo[side];
  Arcs arcs(view.hit_points, face, side, low);
  for (const HitPair& other : arcs.sorted(links)) {
    if (other.hit == link.hit || other.hit == link.other) break;
    arcs.add(other, arcs.is_arc(other) ? arcs.height(other) : 0);
  }
  const double height = links.empty() ? arcs.usual_height(link) : arcs.height(link);
  point[side] = low ? std::max(point[side], face.lo[side] + height)
                    : std::min(point[side], face.hi[side] - height);
  return point;
}

}  // namespace kdm
