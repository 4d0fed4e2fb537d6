// SPDX-License-Identifier: MIT
// Streets of many thin closed parts that do not touch, after the city of the paper's Fig. 9.
#pragma once

#include "kdmanifold/mesh.h"

namespace kdm::bench {

/// Houses with walls, window frames, doors, roofs and chimneys, lamps on thin poles, fences. Units
/// are metres; parts keep at least 1 cm apart, the thinnest are 2 cm thick. Whole plots are added
/// until there are at least `triangles`. Deterministic.
Mesh street_apart(Index triangles = 88000);

}  // namespace kdm::bench
