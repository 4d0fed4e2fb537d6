// SPDX-License-Identifier: MIT
#include "geometry/segment_box.h"

namespace kdm {
namespace {

// How far grid points are shifted, in lattice units.
constexpr double kShift = 1e-6;
const Vec3 kGridShift(4 * kShift, 2 * kShift, kShift);

// A bound of the part of a line that lies in a box: the line's parameter there.
struct Bound {
  double at;
  double unsure = 0;
  int face = -1;
};

// Tells whether a bound surely lies before another.
bool comes_before(const Bound& a, const Bound& b) { return a.at + a.unsure < b.at - b.unsure; }

// The part of a segment between the planes of a box's faces.
class PartInside {
 public:
  // Cuts off what lies beyond a face: `towards` is the line's speed across it, inwards, and
  // `outside` how far the line's start lies beyond.
  void cut(int face, double outside, double towards) {
    if (towards == 0) {
      empty_ = empty_ || outside > kUnsure;
      sure_ = sure_ && (outside > kUnsure || outside < -kUnsure);
      return;
    }
    const Bound bound{outside / towards, kUnsure / std::abs(towards), face};
    Bound& former = towards > 0 ? from_ : to_;
    const bool narrower = towards > 0 ? bound.at > former.at : bound.at < former.at;
    // Which of the two is the narrower one matters if both are bounds of a part that is left.
    const bool apart = comes_before(bound, former) || comes_before(former, bound);
    unclear_ends_ = unclear_ends_ || !apart;
    if (narrower) former = bound;
  }

  std::optional<SegmentInBox> of_segment(const Vec3& a, const Vec3& b) const {
    if (empty_ || comes_before(to_, from_)) return SegmentInBox{};
    if (!sure_ || unclear_ends_ || !comes_before(from_, to_)) return std::nullopt;
    SegmentInBox part{true, {from_.face < 0, to_.face < 0}, {from_.face, to_.face}};
    part.ends = {a + from_.at * (b - a), a + to_.at * (b - a)};
    return part;
  }

 private:
  Bound from_{0};
  Bound to_{1};
  bool empty_ = false;
  bool sure_ = true;
  bool unclear_ends_ = false;
};

}  // namespace

std::optional<SegmentInBox> segment_in_box(const Vec3& a, const Vec3& b, const LatticeBox& box) {
  PartInside part;
  const Vec3 start = a - kGridShift;
  const Vec3 way = b - a;
  for (int axis = 0; axis < 3; ++axis) {
    part.cut(2 * axis, box.lo[axis] - start[axis], way[axis]);
    part.cut(2 * axis + 1, start[axis] - box.hi[axis], -way[axis]);
  }
  return part.of_segment(a, b);
}

}  // namespace kdm
