// SPDX-License-Identifier: MIT
// Sums over the parts of a mesh.
#include "cli/report.h"

namespace kdm::cli {

PartSums sum_parts(const MeshDefects& defects) {
  PartSums sums;
  for (const MeshPart& part : defects.parts) {
    sums.open += part.closed ? 0 : 1;
    sums.inside_out += part.inside_out ? 1 : 0;
    sums.cavities += part.cavity ? 1 : 0;
    sums.genus += part.genus == kNone ? 0 : part.genus;
    sums.area += part.area;
    sums.volume += part.volume;
  }
  return sums;
}

}  // namespace kdm::cli
