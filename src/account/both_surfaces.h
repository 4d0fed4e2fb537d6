// SPDX-License-Identifier: MIT
// An input and its result side by side.
#pragma once

#include "account/triangle_set.h"
#include "grid/grid_data.h"
#include "kdmanifold/account.h"

namespace kdm {

/// Both surfaces, scaled by one power of two so that coordinates are about 1.
class BothSurfaces {
 public:
  /// Throws `kInvalidMesh` if one of the meshes has an index or a coordinate that is none.
  BothSurfaces(const Mesh& input, const GridData& grid, const Mesh& result);

  TriangleSet input;   ///< triangles without area left out
  TriangleSet result;  ///< all triangles
  double input_area = 0;
  double unit = 1;        ///< length of a scaled unit in model units
  double reach = 0;       ///< what is further from the result is missing from it; scaled
  double allowed = 0;     ///< how far the surfaces may be apart before one is told; scaled
  double told_apart = 0;  ///< from so far on it can be told what lies within the solid; scaled

  /// Return a triangle of the other surface that may be near one of the input, of the result, or
  /// kNone.
  Index in_result(Index triangle) const { return at(result_of_face_, input_key(triangle)); }
  Index in_input(Index triangle) const { return at(input_of_key_, result_key(triangle)); }

  /// Says whether the input alone tells what is inside: not where faces were turned or holes
  /// closed.
  bool input_tells() const { return grid_.input.closed && grid_.input.turned_faces == 0; }

  /// Says whether the inside rule drops a place on a triangle of the input, as there is solid on
  /// both sides. To be asked for places that are further than `told_apart` from the result.
  bool is_inner(Index triangle, const Vec3& place);
  /// Says whether there is no solid on either side of a place on a triangle of the input, as where
  /// a notch ends at the side of what it is taken off: nothing is lost there.
  bool is_cut_off(Index triangle, const Vec3& place);

 private:
  static Index at(const std::vector<Index>& list, Index i) {
    return i < list.size() ? list[i] : kNone;
  }
  Index input_key(Index triangle) const {
    const Index face = input.faces[triangle];
    return keys_.empty() ? face : keys_[face];
  }
  Index result_key(Index triangle) const { return at(sources_, result.faces[triangle]); }
  void leave_out_flat();
  void match();
  bool inside(int winding) const;
  bool input_inside(const Vec3& place) { return inside(input.winding(place)); }

  const GridData& grid_;
  const std::vector<Index>& keys_;     // what the result calls the input's faces; empty: numbers
  const std::vector<Index>& sources_;  // of the result's faces
  std::vector<Index> result_of_face_;  // per key
  std::vector<Index> input_of_key_;    // per key
};

}  // namespace kdm
