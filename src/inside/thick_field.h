// SPDX-License-Identifier: MIT
// Opening and closing: what is inside of a solid that has lost what is thinner than some thickness,
// or whose gaps that are narrower than it are filled.
//
// A ball as wide as the thickness is rolled along the boundary, within the solid or outside of it.
// Where it fits, the solid, or the space outside, is thick enough. A point is thick if such a ball
// has its centre within 2.2 radii of it, so that corners and edges of more than 54 degrees, into
// which no ball fits, count as thick; or if it lies deeper than a radius.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include "inside/point_field.h"
#include "mesh/box_tree.h"

namespace kdm {

/// A field without the thin parts of its inside, or of its outside.
class ThickField final : public PointField {
 public:
  enum class Side { kInside, kOutside };
  using Corners = std::array<Vec3, 3>;

  /// `boundary` are the triangles that bound the inside of `base`, turned outwards. `thickness` is
  /// the diameter of the balls, which may reach `slack` beyond the boundary. Takes time that grows
  /// with the boundary's area, in squares of the thickness.
  ThickField(std::shared_ptr<const PointField> base, std::vector<Corners> boundary, Side side,
             double thickness, double slack);
  ThickField(const ThickField&) = delete;
  ThickField& operator=(const ThickField&) = delete;

  /// Tells whether no ball fits anywhere.
  bool nothing_is_thick() const { return centres_.empty(); }
  /// Returns the area of the boundary that is thin; 0 if the field is the same as its base.
  double thin_area() const { return thin_area_; }

  bool inside(const Vec3& p) const override;
  bool inside(const LatticePoint& p) const override;
  Vec3 gradient(const Vec3& p) const override;
  bool follows_surface(const Vec3& p) const override;
  bool must_split(const LatticeBox& box) const override;
  std::size_t work() const override { return base_->work(); }

 private:
  template <typename Visit>
  void for_each_sample(const Visit& visit) const;
  void find_centres(double slack);
  void find_thin();
  bool fits(const Vec3& centre, double radius) const;
  bool is_on_side(const Vec3& centre) const;
  bool is_thick(const Vec3& p) const;
  bool some_centre_near(const Box& box) const;

  std::shared_ptr<const PointField> base_;
  std::vector<Corners> boundary_;
  Side side_;
  double thickness_;
  double reach_;
  std::vector<Box> triangle_boxes_;
  Box bounds_;
  std::unique_ptr<BoxTree> triangles_;
  std::vector<Box> centres_;  // points where balls fit
  std::unique_ptr<BoxTree> centre_tree_;
  std::vector<Box> thin_;  // points of the boundary that no ball is near
  std::unique_ptr<BoxTree> thin_tree_;
  double thin_area_ = 0;
};

}  // namespace kdm
