// SPDX-License-Identifier: MIT
// The generalised winding number of triangles, whether they form a closed surface or not (Jacobson
// et al. 2013): the fraction of its surroundings in which a point sees triangles from behind, minus
// the fraction in which it sees them from the front.
#pragma once

#include <memory>
#include <span>

#include "inside/point_field.h"
#include "inside/winding_boxes.h"
#include "inside/winding_tree.h"
#include "threads/share_work.h"

namespace kdm {

/// Winding numbers of points, and which of them are inside. Near a closed surface the number is 0
/// outside and 1 inside; at a hole it passes smoothly from one to the other. Points are in lattice
/// units.
class WindingField final : public PointField {
 public:
  /// Builds the tree, in time n log n. Points with a winding number above `threshold` will be
  /// inside; 0 stands for a threshold that suits the triangles (see choose_winding_threshold).
  /// Points will be asked for about `spacing` lattice units apart: it decides about time, not about
  /// what is inside. The triangles must outlive the field. It remembers what many points have in
  /// common, so that only one thread may ask it.
  WindingField(std::span<const LatticeTriangle> triangles, double threshold, double spacing);

  double threshold() const override { return threshold_; }

  /// Returns the winding number of a point, exact to about 0.02. It is meant for few points that
  /// are far apart.
  double winding(const Vec3& p) const;

  /// Returns the winding number less the threshold, exact to about 0.02. If the two are closer to
  /// each other than that, `inside` may be wrong. That happens at holes only: beside a triangle,
  /// winding numbers are about one half away from the threshold.
  double excess(const Vec3& p) const override;
  bool inside(const Vec3& p) const override { return excess(p) > 0; }
  /// On which side of each triangle close by the vertex lies is decided exactly.
  bool inside(const LatticePoint& p) const override;
  /// Returns the gradient of the winding number, per lattice unit. It points towards the inside.
  /// The triangles close to the point count exactly, those far away as for the winding number.
  Vec3 gradient(const Vec3& p) const override;

  /// Returns how much was summed so far, in triangles. Four tree nodes seen from afar count as one
  /// triangle: they take as long.
  std::size_t work() const override { return work_; }

  std::shared_ptr<const PointField> fork() const override {
    return kHasThreads ? std::make_shared<WindingField>(*this) : nullptr;
  }

 private:
  template <typename AddNear>
  double sum(const Vec3& p, std::span<const Index> roots, const AddNear& add_near) const;
  template <typename AddNear>
  double excess_with(const Vec3& p, const AddNear& add_near) const;

  std::shared_ptr<const WindingTree> tree_;
  mutable WindingBoxes boxes_;
  double threshold_;
  mutable std::size_t work_ = 0;
};

/// Chooses the threshold above which winding numbers are to be inside: one of 0.5, 0.45, ..., 0.1.
/// A threshold keeps a point of a triangle if the winding number is above it behind the triangle
/// and not above it in front. Returns the highest threshold that keeps as much of the triangles'
/// area as the best one does, up to a hundredth of the whole area. Thresholds above 0.5 are no
/// candidates: they would keep more of what lies inside a body, and open the body instead. Looks at
/// 1024 points, spread evenly; the result depends on nothing but the triangles.
double choose_winding_threshold(const WindingField& field,
                                std::span<const LatticeTriangle> triangles);

}  // namespace kdm
