// SPDX-License-Identifier: MIT
// The account of one run, and what both of its forms, JSON and text, need.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/plan.h"
#include "kdmanifold/kdmanifold.h"

namespace kdm::cli {

/// Wall-clock seconds of the steps.
struct Seconds {
  double read = 0, analyze = 0, build = 0, simplify = 0, extract = 0, reduce = 0, write = 0;
};

/// One level of detail of the result.
struct Level {
  Index triangles = 0;
  std::string file;  ///< empty: none was written
  MeshError error;   ///< as measured (see `ReducedLevel`)
};

/// What is known at the end of a run.
struct RunReport {
  MeshDefects defects;  ///< of the input; with --stats only
  InputReport input;    ///< this and what follows: unless --stats is all that is asked for
  std::vector<InputReport> operands;  ///< of a Boolean operation: INPUT and the others
  GridStats grid;
  MeshReport output;
  ExtractReport extracted;
  std::optional<SimplifyReport> simplified;  ///< empty: the grid was not simplified
  std::optional<ReduceReport> reduced;       ///< empty: nothing was reduced
  std::vector<Level> levels;                 ///< one for each of --target-triangles
  std::vector<Warning> warnings;             ///< of the file, then of the result
  std::optional<LostArea> lost;              ///< only of one mesh that was the input
  std::optional<MeshError> error;            ///< likewise, with --check
  std::uint64_t self_intersections = 0;      ///< of the output; with --check only
  Seconds seconds;
  std::uint64_t peak_bytes = 0;  ///< most memory the process held; 0: unknown
};

/// What the parts of a mesh have together.
struct PartSums {
  std::uint64_t open = 0;        ///< parts that are not closed
  std::uint64_t inside_out = 0;  ///< parts
  std::uint64_t cavities = 0;    ///< parts
  std::uint64_t genus = 0;       ///< handles, of the parts whose genus is known
  double area = 0;
  double volume = 0;  ///< of closed parts; cavities count as negative
};

/// Adds the parts up.
PartSums sum_parts(const MeshDefects& defects);

/// Says whether the output is what --check asks for: closed and 2-manifold; of a sheet, a manifold
/// that may have a boundary.
inline bool passes_check(const MeshReport& output, bool sheet) {
  return sheet ? output.manifold : output.two_manifold;
}

}  // namespace kdm::cli
