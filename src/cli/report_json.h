// SPDX-License-Identifier: MIT
// The account of one run as JSON, with the keys that the Node command line uses too.
#pragma once

#include <string>

#include "cli/report.h"
#include "cli/report_fields.h"

namespace kdm::cli {

/// Returns `input`, with --stats `defects`, then `grid`, `output` (with --check also its
/// `selfIntersections`), if anything was reduced `reduce`, with --target-triangles `levels`, with
/// --check `check`, then `seconds` and `peakBytes`. With --stats alone there is neither `grid` nor
/// what follows it but the last two.
Json report_as_json(const RunReport& report, const Command& command);

/// Returns what `output` holds: the counts of the result, and the account of how it was made.
Json output_json(const MeshReport& output, const ExtractReport& extracted);

/// Returns what `check` holds: whether the result is a manifold, and the counts that say why not.
Json check_json(const MeshReport& output);

/// Returns what `defects` holds: the lists' lengths, and sums over the parts.
Json defects_json(const MeshDefects& defects);

}  // namespace kdm::cli
