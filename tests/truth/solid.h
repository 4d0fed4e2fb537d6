// SPDX-License-Identifier: MIT
// A random small solid as an input mesh, with the exact account of what has to come out.
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kdmanifold/expression.h"
#include "truth/account.h"

namespace kdm::truth {

struct Solid {
  std::string variant;  ///< which of the ways to make its kind
  Mesh input;           ///< whatever state its kind is in; of an expression all operands together
  /// Of Boolean operations: the solids, and what is made of them.
  std::vector<Mesh> operands;
  std::optional<Expression> expression;
  Account account;  ///< of the solid that it stands for
  /// What the topology may be besides if it is turned: rounded, sides that lie on each other and
  /// have no corners in common are up to a step of the lattice apart or in each other.
  std::set<Topology> apart;
  double tolerance = 0;  ///< to build it with, in its units
  double slack = 0;      ///< how far the input itself is off the account's boundary
  std::string pose;      ///< `plain` (integers where the kind has them), `moved` or `turned`
};

/// The kinds of solids, by name.
const std::vector<std::string>& kinds();

/// Makes the solid of a kind that belongs to a seed: the same on every platform. Throws
/// std::out_of_range for a kind that is none.
Solid make_solid(const std::string& kind, std::uint32_t seed);

}  // namespace kdm::truth
