// SPDX-License-Identifier: MIT
// One timed run of the whole path: parse, build_grid, extract.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "kdmanifold/kdmanifold.h"
#include "models.h"

namespace kdm::bench {

/// Seconds of processor time by stage: "read", the phases that the library's progress callback
/// names ("prepare", "build", "link", "loops", "vertices", "strict", ...), and "total".
using StageSeconds = std::map<std::string, double>;

struct Run {
  StageSeconds seconds;
  InputReport input;
  GridStats grid;
  ExtractedMesh output;
  std::size_t peak_bytes = 0;  ///< most memory the process ever held during the run; 0: unknown
};

Run run_once(const Model& model, const BuildOptions& build, const ExtractOptions& extract = {});

/// Per stage the median of `repeat` runs; everything else is of the last run.
Run run_median(const Model& model, const BuildOptions& build, int repeat);

const char* strategy_name(SplitStrategy strategy);
SplitStrategy strategy_from_name(const std::string& name);  ///< throws kInvalidOption

}  // namespace kdm::bench
