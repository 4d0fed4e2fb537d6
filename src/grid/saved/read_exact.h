// SPDX-License-Identifier: MIT
// Reads the exact parts of a saved grid.
#pragma once

#include <cmath>

#include "grid/saved/grid_format.h"
#include "io/bytes.h"
#include "kdmanifold/mesh.h"

namespace kdm {

/// Reads the number of an operand, of which there are so many; kNone stands for none of them.
inline Index take_operand(ByteReader& bytes, Index operands) {
  const auto operand = static_cast<Index>(bytes.take_varint(operands, "an operand's number"));
  return operand == operands ? kNone : operand;
}

/// Reads vertices and triangles of exact parts, and of several operands where each triangle comes
/// from; `operands` is 0 if there are none. Throws `kParseError` if the bytes are none; `validate`
/// checks the rest.
inline void read_exact(ByteReader& bytes, Index operands, Mesh& exact) {
  constexpr std::uint64_t kMostVertices = kNone - 1;
  constexpr std::uint64_t kMostTriangles = std::uint64_t{1} << 30;
  const auto vertices = bytes.take_varint(kMostVertices, "the number of exact vertices");
  bytes.require(vertices, 3 * sizeof(float), "exact vertex");
  exact.positions.reserve(static_cast<std::size_t>(vertices));
  for (std::uint64_t i = 0; i < vertices; ++i) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = bytes.take<float, std::uint32_t>();
    if (!p.allFinite()) bytes.fail("an exact vertex lies nowhere");
    exact.positions.push_back(p);
  }
  const auto triangles = bytes.take_varint(kMostTriangles, "the number of exact triangles");
  bytes.require(triangles, 4, "exact triangle");
  exact.triangles.reserve(static_cast<std::size_t>(triangles));
  exact.source_faces.reserve(static_cast<std::size_t>(triangles));
  std::int64_t source = 0;
  for (std::uint64_t i = 0; i < triangles; ++i) {
    Triangle t;
    for (Index& v : t) v = static_cast<Index>(bytes.take_varint(kNone, "an exact vertex"));
    exact.triangles.push_back(t);
    source += grid_format::to_signed(
        bytes.take_varint(std::uint64_t{1} << 33, "an exact triangle's source face"));
    if (source < 0 || source > kNone) bytes.fail("an exact triangle's source face is none");
    exact.source_faces.push_back(static_cast<Index>(source));
    if (operands > 0) exact.source_operands.push_back(take_operand(bytes, operands));
  }
}

}  // namespace kdm
