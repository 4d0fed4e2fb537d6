// SPDX-License-Identifier: MIT
// The value types that the public interface is made of.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace kdm {

/// Number of a vertex, face, cell or hit, counted from 0, or how many of these there are:
/// everything refers to everything else by number.
using Index = std::uint32_t;

/// "No such thing", wherever an Index may be missing.
inline constexpr Index kNone = 0xffffffffu;

/// A point or direction, in the model's own units.
using Vec3 = Eigen::Vector3d;

/// The vertices of a face, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;
using Quad = std::array<Index, 4>;

/// The two vertices of an edge.
using Edge = std::array<Index, 2>;

/// An axis-aligned box; empty while `min` exceeds `max`.
struct Box {
  Vec3 min = Vec3::Constant(1);
  Vec3 max = Vec3::Constant(0);
};

}  // namespace kdm
