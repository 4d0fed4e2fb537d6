// SPDX-License-Identifier: MIT
// The functions of the module of tools: see module.h.
#pragma once

#include <string>
#include <vector>

#include "defects.h"
#include "fields.h"
#include "kdmanifold/kdmanifold.h"
#include "marshal.h"

namespace kdm::wasm {

// Positions stay 64-bit, as the native command line has them: both make the same grid.
inline val parse_mesh(val bytes, val format, std::string name) {
  return guard([&] {
    std::vector<Warning> warnings;
    val mesh = from_mesh(
        kdm::parse_mesh(to_bytes(bytes), to_choice<MeshFormat>(format, "format"), name, &warnings),
        "Float64Array");
    mesh.set("warnings", from_warnings(warnings));
    return mesh;
  });
}

inline val format_mesh(val mesh, val format, bool exact) {
  return guard([&] {
    return from_bytes(kdm::format_mesh(to_mesh(mesh), to_choice<MeshFormat>(format, "format"),
                                       exact ? Digits::kExact : Digits::kShortest));
  });
}

inline val analyze(val mesh, val options) {
  return guard([&] {
    return from_defects(kdm::analyze(to_mesh(mesh), to_options<AnalyzeOptions>(options)));
  });
}

}  // namespace kdm::wasm
