// SPDX-License-Identifier: MIT
// Results of sweeps over grids of any depth, where nothing may be left.
#pragma once

#include "kdmanifold/error.h"
#include "kdmanifold/extract.h"
#include "support/sanitized.h"

namespace kdm::check {

/// How strict results of sweeps over many grids are: what meets itself in thousands of places takes
/// minutes to be embedded with sanitizers on.
inline constexpr Strict kSweepStrict = kSanitized ? Strict::kManifold : Strict::kEmbedded;

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
