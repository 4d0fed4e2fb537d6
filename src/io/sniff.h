// SPDX-License-Identifier: MIT
// Tells what a file is by its content: names lie.
#pragma once

#include <optional>
#include <string_view>

#include "kdmanifold/mesh_io.h"

namespace kdm {

/// What the content of a file says. At most one of the two is there; if neither is, the content
/// fits no format for certain.
struct Content {
  std::optional<MeshFormat> format;  ///< a format that is read here
  std::string_view foreign;          ///< what else it is, to complete "the file is ..."
};

/// Looks at the beginning of a file, which is not UTF-16.
Content sniff(std::string_view bytes);

/// Tells whether a file is a binary STL file, exactly as long as its count of facets asks for.
bool is_whole_binary_stl(std::string_view bytes);

}  // namespace kdm
