// SPDX-License-Identifier: MIT
// Makes an object of what is wrong with a mesh.
#pragma once

#include <cmath>
#include <type_traits>
#include <vector>

#include "fields.h"

namespace kdm::wasm {

/// Sets `loopVertices`, the loops one after the other, and `loopEnds`, where each ends.
inline void set_loops(val& to, const std::vector<std::vector<Index>>& loops) {
  std::vector<Index> vertices;
  std::vector<Index> ends;
  for (const std::vector<Index>& loop : loops) {
    vertices.insert(vertices.end(), loop.begin(), loop.end());
    ends.push_back(static_cast<Index>(vertices.size()));
  }
  to.set("loopVertices", from_indices(vertices));
  to.set("loopEnds", from_indices(ends));
}

/// Sets `partNumbers`: all fields of each part as 64-bit numbers, in the order of the table; flags
/// are 0 or 1, what is missing is NaN.
inline void set_parts(val& to, const std::vector<MeshPart>& parts) {
  std::vector<double> numbers;
  const auto add = [&]<typename Value>(const Value& value) {
    if constexpr (std::is_same_v<Value, OrNone>) {
      numbers.push_back(value.number == kNone ? std::nan("") : value.number);
    } else {
      numbers.push_back(static_cast<double>(value));
    }
  };
  for (const MeshPart& part : parts) {
    for_each_field(part, [&](const ReportField&, const auto& value) { add(value); });
  }
  to.set("partNumbers", copy_out("Float64Array", numbers.size(), numbers.data()));
}

/// Makes an object of the defects. Loops and parts are flat arrays: there may be hundreds of
/// thousands, and the wrapper makes objects of them quicker than calls from here.
inline val from_defects(const MeshDefects& defects) {
  val to = val::object();
  for_each_field(defects, [&]<typename Value>(const ReportField& field, const Value& value) {
    if constexpr (std::is_same_v<Value, std::vector<std::vector<Index>>>) {
      set_loops(to, value);
    } else if constexpr (std::is_same_v<Value, std::vector<MeshPart>>) {
      set_parts(to, value);
    } else {
      set_field(to, field.name, value);
    }
  });
  return to;
}

}  // namespace kdm::wasm
