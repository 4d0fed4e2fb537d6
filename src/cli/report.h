// SPDX-License-Identifier: MIT
// The account of one run: as JSON, with the keys that the Node command line uses too, or as text.
#pragma once

#include <cstdint>
#include <string>

#include "cli/options.h"
#include "kdmanifold/kdmanifold.h"

namespace kdm::cli {

struct Seconds {
  double read = 0, analyze = 0, build = 0, extract = 0, write = 0;
};

struct RunReport {
  MeshDefects defects;  ///< of the input; with --stats only
  InputReport input;    ///< this and what follows: unless --stats is all that is asked for
  GridStats grid;
  MeshReport output;
  ExtractReport extracted;
  std::uint64_t self_intersections = 0;  ///< of the output; with --check only
  Seconds seconds;
  std::uint64_t peak_bytes = 0;  ///< most memory the process held; 0: unknown
};

/// What --check asks: closed and 2-manifold; of a sheet, a manifold that may have a boundary.
bool passes_check(const MeshReport& output, bool sheet);

/// `input`, with --stats `defects`, then `grid`, `output` (with --check also its
/// `selfIntersections`), with --check `check`, then `seconds` and `peakBytes`; indented, with a
/// line end. With --stats alone there is neither `grid` nor `output`.
std::string report_as_json(const RunReport& report, const Command& command);
/// A few lines for people.
std::string report_as_text(const RunReport& report, const Command& command);

}  // namespace kdm::cli
