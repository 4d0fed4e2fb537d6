// SPDX-License-Identifier: MIT
// The progress of a whole conversion from that of its steps.
#pragma once

#include "kdmanifold/make_manifold.h"

namespace kdm {

/// Returns progress functions for the steps, each of which tells its share of the whole.
StepProgress shares_of(const Progress& progress);

}  // namespace kdm
