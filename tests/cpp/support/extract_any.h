// SPDX-License-Identifier: MIT
// Results of sweeps over grids of any depth, where nothing may be left.
#pragma once

#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"

namespace kdm::check {

/// Extracts, but returns an empty mesh without a report where nothing of the surface is left.
inline ExtractedMesh extract_any(const Grid& grid, const ExtractOptions& options = {}) {
  try {
    return extract(grid, options);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::kEmptyResult) throw;
    return {};
  }
}

}  // namespace kdm::check
