// SPDX-License-Identifier: MIT
#include "make/step_shares.h"

#include "mesh/progress.h"

namespace kdm {

StepProgress shares_of(const Progress& progress) {
  // Shares of the whole time, measured on models of 10,000 to 200,000 triangles.
  return [progress](MakeStep step) {
    switch (step) {
      case MakeStep::kBuild:
        return part_of_progress(progress, 0.0, 0.3);
      case MakeStep::kSimplify:
        return part_of_progress(progress, 0.3, 0.35);
      case MakeStep::kExtract:
        return part_of_progress(progress, 0.35, 0.5);
      case MakeStep::kReduce:
        break;
    }
    return part_of_progress(progress, 0.5, 1.0);
  };
}

}  // namespace kdm
