// SPDX-License-Identifier: MIT
// Collects what one should know before one trusts a result.
#pragma once

#include <vector>

#include "kdmanifold/extract.h"
#include "kdmanifold/grid.h"

namespace kdm {

/// Returns the warnings that follow from the reports of the input, the grid and the extraction, the
/// gravest first. `area` is that of the result, in square model units.
std::vector<Warning> collect_warnings(const InputReport& input, const GridStats& grid,
                                      const ExtractReport& report, double area);

}  // namespace kdm
