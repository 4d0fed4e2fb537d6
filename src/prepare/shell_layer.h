// SPDX-License-Identifier: MIT
// One of the two layers of a shell: what lies on one side of the surface that gets a thickness.
#pragma once

#include <optional>
#include <vector>

#include "kdmanifold/types.h"
#include "mesh/numbers.h"
#include "prepare/fans.h"
#include "prepare/pieces_of_surface.h"

namespace kdm {

/// A layer is the sum of prisms, one a triangle, between the surface and a face before it. Fans
/// that share a vertex share its place on the surface; each has a vertex of its own on the layer's
/// face. No prism turns over, so that every prism counts positively: where the surface is too
/// curved for its triangles on this side, the layer is cut, and the prisms overlap.
class ShellLayer {
 public:
  /// The layer is `height` thick and lies where the normals lead to, or on the other side if
  /// `height` is below 0. The surface must stay as long as this is used.
  ShellLayer(const PiecesOfSurface& surface, double height);

  /// Whether the layer ends at a side.
  bool ends_at(SideId side) const { return opposite_[side] == kNone; }
  const Fans& fans() const { return *fans_; }
  /// Returns where a corner of the layer's face is; it is the same throughout a fan.
  Vec3 place(SideId corner) const { return surface_.place(corner) + outs_[fans_->of(corner)]; }

 private:
  // What a fan's triangles say: their normals' sum, weighted by the angles at the vertex, and the
  // sum of these angles.
  struct NormalSum {
    Vec3 normal = Vec3::Zero();
    double angle = 0;

    Vec3 direction() const;
  };

  void make_fans();
  NormalSum normal_sum(Index fan) const;
  double length_along(const Vec3& direction, Index fan) const;
  void even_out_turned();
  bool even_out(TriangleId t);
  bool turns_over(TriangleId t, double spare) const;
  Index cut_off_turned();

  const PiecesOfSurface& surface_;
  double height_;
  std::vector<SideId> opposite_;  // per side
  std::optional<Fans> fans_;
  std::vector<NormalSum> sums_;  // per fan
  std::vector<Vec3> outs_;       // per fan: from the surface to the layer's face
};

}  // namespace kdm
