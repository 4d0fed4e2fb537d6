// SPDX-License-Identifier: MIT
// How far vertices that edges become would be from the planes of the triangles that there were.
#pragma once

#include <vector>

#include "reduce/collapse_queue.h"
#include "reduce/error_quadric.h"
#include "reduce/kept_lines.h"
#include "reduce/workpiece.h"

namespace kdm {

/// The quadrics of a workpiece's vertices. Points are relative to a centre, by which quadrics are
/// more exact.
class EdgeErrors {
 public:
  /// Planes hold vertices on the surface, and on lines. `piece` must outlive this.
  EdgeErrors(const Workpiece& piece, const KeptLines& lines);

  /// Returns the sum of both ends of the edge.
  ErrorQuadric quadric_of(SideId edge) const;
  /// Returns where the vertex would go; `sum` is the edge's quadric.
  Vec3 point_of(SideId edge, CollapsePlace place, const ErrorQuadric& sum) const;
  /// Returns the error at a point.
  double error(const ErrorQuadric& sum, const Vec3& point) const {
    return sum.error(point - centre_);
  }

  /// Makes known that a vertex has been joined to another one.
  void join(VertexId kept, VertexId removed) { quadric_[kept] += quadric_[removed]; }

 private:
  void add_triangles();
  void add_lines(const KeptLines& lines);

  const Workpiece& piece_;
  Vec3 centre_;
  std::vector<ErrorQuadric> quadric_;  // per vertex
};

}  // namespace kdm
