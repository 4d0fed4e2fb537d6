// SPDX-License-Identifier: MIT
// Lines on the mesh that collapses go along, never across: rims of sheets, and borders between
// groups of faces.
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "reduce/collapse_queue.h"
#include "reduce/ring.h"
#include "reduce/workpiece.h"

namespace kdm {

/// The lines of a workpiece. Which edges are on them follows from the mesh as it is: those with one
/// triangle, and those between triangles of two groups.
class KeptLines {
 public:
  /// Where a new vertex would cut the border along an edge and beside it.
  struct Cut {
    std::vector<Vec3> points;  ///< that the border had
    std::size_t at = 0;        ///< which of them the new vertex comes for
  };

  /// Remembers where borders run, if a distance is kept. `piece` must outlive this.
  explicit KeptLines(const Workpiece& piece);

  bool is_line(SideId edge) const { return piece_.is_line(edge); }

  /// Returns where the vertex goes first that the edge becomes: where the error is least, unless
  /// one end is to stay. None: both ends are to stay, or lie on lines that the edge is not part of.
  std::optional<CollapsePlace> place_of(SideId edge) const;

  /// Tells whether two lines would become one: those beside a triangle that goes.
  bool would_merge(SideId edge) const;

  /// Tells whether borders would be within the distance kept of what they were, both ways, if the
  /// edge became the ring's new vertex. Sets `cut` if the edge is on a border.
  bool stay_near(SideId edge, const CollapseRing& ring, double distance, Cut& cut) const;
  /// Makes known that the edge is about to be collapsed; `cut` is what `stay_near` set.
  void collapsing(SideId edge, const CollapseRing& ring, const Cut& cut);

 private:
  // The vertices that a stretch of border had, from the lower to the higher one of its ends.
  using Ends = std::pair<VertexId, VertexId>;
  using Stretch = std::vector<Vec3>;
  // How many lines of which kind run through a vertex.
  enum class Place { kFree, kOnLine, kCorner };

  Place place_at(VertexId v) const;
  Stretch stretch(VertexId from, VertexId to) const;
  void put(VertexId from, VertexId to, Stretch points);
  VertexId next_on_border(VertexId from, VertexId not_to) const;

  const Workpiece& piece_;
  bool any_ = false;
  std::map<Ends, Stretch> stretches_;
};

}  // namespace kdm
