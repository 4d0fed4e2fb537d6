// SPDX-License-Identifier: MIT
// Crossings of one stretch of a grid edge that contradict each other or its ends, made to fit.
#pragma once

#include <vector>

#include "inside/winding.h"
#include "inside/winding_field.h"

namespace kdm {

/// Part of a grid line with a grid vertex at either end; whether these are inside is known.
struct Segment {
  int axis;
  LatticePoint low;
  std::int32_t high;  ///< coordinate of the upper end
  bool inside_low;
  bool inside_high;
};

class SegmentResolver {
 public:
  /// Invented crossings are exact to `precision`, lattice units.
  SegmentResolver(const WindingField& field, double precision)
      : field_(field), precision_(precision) {}

  /// Sorts the crossings. Those that alternate and fit the ends are all kept, and the field is not
  /// asked. Otherwise it is, beside each crossing, and the crossings across which it changes are
  /// kept, turned where they run against the change. Where it changes between two of them, at a
  /// hole, the list may `invent` a crossing without triangle (kNone); the kept ones of the result
  /// then alternate and fit the ends.
  void resolve(const Segment& segment, std::vector<Crossing>& crossings, bool invent,
               std::vector<WalkedCrossing>& walked);

 private:
  // Crossings that lie so close together that the field cannot tell what is between them.
  struct Cluster {
    std::size_t begin;
    std::size_t end;
    bool inside_before;
    bool inside_after;
  };

  void find_clusters(const Segment& segment, const std::vector<Crossing>& crossings);
  LinePosition change_between(const Segment& segment, LinePosition low, LinePosition high,
                              bool inside_low) const;
  bool inside(const Segment& segment, double position) const;

  const WindingField& field_;
  double precision_;
  std::vector<Cluster> clusters_;
};

/// Do the crossings alternate and fit both ends? They are in order.
bool consistent(const Segment& segment, const std::vector<Crossing>& crossings);

}  // namespace kdm
