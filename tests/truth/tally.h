// SPDX-License-Identifier: MIT
// Counts verdicts by kind, and remembers the smallest solids that failed.
#pragma once

#include <cstdint>
#include <map>
#include <ostream>
#include <string>
#include <vector>

#include "truth/judge.h"

namespace kdm::truth {

class Tally {
 public:
  void add(const std::string& kind, std::uint32_t seed, const Solid& solid, const Verdict& verdict);

  /// The table by kind.
  void write_table(std::ostream& out) const;
  /// For each kind, check that failed, result, variant and pose, the seed of the fewest triangles;
  /// then the seeds that took longest and got most triangles.
  void write_failures(std::ostream& out) const;
  bool all_right() const;
  /// How often a check failed over all kinds.
  std::size_t failed(Check check) const;

 private:
  struct Smallest {
    std::uint32_t seed = 0;
    std::size_t triangles = 0;
    std::size_t count = 0;
  };
  struct Worst {
    std::uint32_t seed = 0;
    double value = 0;
  };
  struct Row {
    std::size_t tried = 0;
    std::size_t right = 0;
    std::size_t manifold = 0;  ///< right but for `embedded`
    std::size_t open = 0;      ///< the topology is another, and not said to be resolved
    std::size_t resolved = 0;
    std::array<std::size_t, kChecks> failed = {};
    double seconds = 0;
    std::vector<double> triangles;
    Worst slowest;
    Worst largest;                             ///< most triangles, by those of the input
    std::map<std::string, Smallest> smallest;  ///< by check, result, variant and pose
  };

  std::map<std::string, Row> rows_;
};

}  // namespace kdm::truth
