// SPDX-License-Identifier: MIT
// Whether a step makes a crease where the reference is smooth.
#pragma once

#include <vector>

#include "reduce/true_creases.h"
#include "reduce/workpiece.h"

namespace kdm {

/// Looks at the angles by which triangles turn against their neighbours.
class SmoothTest {
 public:
  /// `creases` are those of the reference. Both must outlive this.
  SmoothTest(const Workpiece& piece, const TrueCreases& creases)
      : piece_(piece), creases_(creases) {}

  /// Tells whether no edge of the ring would be a false crease, or fewer than now.
  bool stays_smooth(const CollapseRing& ring);
  /// Tells whether fewer edges of the ring would be false creases than now.
  bool smooths(const CollapseRing& ring);

  /// Tells whether the two triangles beside the edge turn by more than 30 degrees against each
  /// other where no edge of the reference turns by more than 15.
  bool is_false_crease(SideId h) const;

  /// Tells whether the worst of the five edges of the two triangles beside the edge turns less if
  /// the edge is flipped.
  bool flip_smooths(SideId h) const;

 private:
  struct Turn {
    double cosine;  // of the angle between the normals
    Vec3 middle;    // of the edge
  };

  const Vec3& normal_of(TriangleId t) const { return piece_.faces[t].normal; }
  void find_turns(const CollapseRing& ring);
  std::ptrdiff_t false_creases(const std::vector<Turn>& turns) const;

  const Workpiece& piece_;
  const TrueCreases& creases_;
  std::vector<Turn> before_;  // what turns by more than 30 degrees in the ring
  std::vector<Turn> after_;
};

}  // namespace kdm
