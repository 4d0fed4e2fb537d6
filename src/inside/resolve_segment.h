// SPDX-License-Identifier: MIT
// Decides which crossings of a segment of a grid edge are hits where they contradict each other or
// the states of the segment's ends.
#pragma once

#include <vector>

#include "inside/point_field.h"
#include "inside/winding.h"

namespace kdm {

/// A part of a grid line between two grid vertices; of each vertex it is known whether it is
/// inside.
struct Segment {
  int axis;
  LatticePoint low;
  std::int32_t high;  ///< coordinate of the upper end
  bool inside_low;
  bool inside_high;
};

/// Decides which crossings of a segment are hits where they contradict each other or its ends.
class SegmentResolver {
 public:
  /// The positions of invented crossings are exact to `precision`, in lattice units.
  SegmentResolver(const PointField& field, double precision)
      : field_(field), precision_(precision) {}
  double precision() const { return precision_; }

  /// Sorts the crossings of a segment and appends them to `classified`; their states are 1 inside
  /// and 0 outside. Crossings that alternate and fit the segment's ends are all kept, and the field
  /// is not asked, if it follows the surface there. Otherwise the field is asked on both sides of
  /// each crossing; a crossing is kept if the state changes across it, and turned if it runs
  /// against the change. With `invent`, a crossing without triangle (kNone) is added where the
  /// state changes between two crossings, at a hole; then the crossings that are kept alternate and
  /// fit the ends.
  void resolve(const Segment& segment, std::vector<Crossing>& crossings, bool invent,
               std::vector<ClassifiedCrossing>& classified);

 private:
  // Crossings so close together that the field cannot tell what lies between them.
  struct Cluster {
    std::size_t begin;  // its crossings
    std::size_t end;
    bool inside_before;  // states just below the first one and above the last one
    bool inside_after;
  };

  void find_clusters(const Segment& segment, const std::vector<Crossing>& crossings);
  LinePosition change_between(const Segment& segment, LinePosition low, LinePosition high,
                              bool inside_low) const;
  bool inside(const Segment& segment, double position) const;
  bool follows(const Segment& segment, const std::vector<Crossing>& crossings) const;

  const PointField& field_;
  double precision_;
  std::vector<Cluster> clusters_;
};

/// Returns whether the crossings, which ascend, alternate and fit both ends of the segment.
bool consistent(const Segment& segment, const std::vector<Crossing>& crossings);

}  // namespace kdm
