// SPDX-License-Identifier: MIT
// How far vertices that edges become would be from the planes of the triangles that there were.
#pragma once

#include <utility>
#include <vector>

#include "reduce/collapse_queue.h"
#include "reduce/error_quadric.h"
#include "reduce/workpiece.h"

namespace kdm {

/// A quadric for each vertex. Points are relative to a centre, by which quadrics are more exact.
struct VertexQuadrics {
  Vec3 centre;
  std::vector<ErrorQuadric> at;
};

/// Returns the quadrics of a mesh no triangle of which has been removed: planes hold vertices on
/// the surface, and on lines.
VertexQuadrics plane_quadrics(const Workpiece& piece);

/// The quadrics of a workpiece's vertices while edges are collapsed.
class EdgeErrors {
 public:
  /// `piece` must outlive this.
  EdgeErrors(const Workpiece& piece, VertexQuadrics quadrics)
      : piece_(piece), quadrics_(std::move(quadrics)) {}

  /// Returns the sum of both ends of the edge.
  ErrorQuadric quadric_of(SideId edge) const;
  /// Returns where the vertex would go; `sum` is the edge's quadric.
  Vec3 point_of(SideId edge, CollapsePlace place, const ErrorQuadric& sum) const;
  const VertexQuadrics& quadrics() const { return quadrics_; }
  /// Returns the error at a point.
  double error(const ErrorQuadric& sum, const Vec3& point) const {
    return sum.error(point - quadrics_.centre);
  }

  /// Makes known that a vertex has been joined to another one.
  void join(VertexId kept, VertexId removed) { quadrics_.at[kept] += quadrics_.at[removed]; }

 private:
  const Workpiece& piece_;
  VertexQuadrics quadrics_;
};

}  // namespace kdm
