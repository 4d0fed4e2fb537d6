// SPDX-License-Identifier: MIT
// What says of any point whether it is inside, for surfaces that do not say so by themselves.
#pragma once

#include <memory>

#include "geometry/lattice.h"

namespace kdm {

/// Tells inside from outside. Points are in lattice units.
class PointField {
 public:
  virtual ~PointField() = default;

  virtual bool inside(const Vec3& p) const = 0;
  /// Returns how far inside a point is, in a measure of the field's own that changes smoothly where
  /// there is no surface: positive inside. A field without one returns 1 and -1.
  virtual double excess(const Vec3& p) const { return inside(p) ? 1 : -1; }
  /// Tells whether a grid vertex is inside. The vertex is read as shifted by (e, e^2, e^3), e
  /// infinitesimal (see geometry/predicates.h).
  virtual bool inside(const LatticePoint& p) const = 0;
  /// Returns a vector that points towards the inside where the field changes at a point.
  virtual Vec3 gradient(const Vec3& p) const = 0;

  /// Tells whether a point of the surface bounds what is inside wherever crossings say so, so that
  /// the field need not be asked.
  virtual bool follows_surface(const Vec3& p) const {
    static_cast<void>(p);
    return true;
  }
  /// Tells whether the field changes within the box where the surface does not, so that a leaf must
  /// be smaller.
  virtual bool must_split(const LatticeBox& box) const {
    static_cast<void>(box);
    return false;
  }

  /// Returns the winding number above which points are inside; 0 if none decides.
  virtual double threshold() const { return 0; }
  /// Returns how much was computed so far, in triangles summed up.
  virtual std::size_t work() const = 0;

  /// Returns a field that gives the same answers, for another thread to ask. Its work begins with
  /// that of this field. Null: only one thread may ask.
  virtual std::shared_ptr<const PointField> fork() const { return nullptr; }
};

}  // namespace kdm
