// SPDX-License-Identifier: MIT
#include "truth/tally.h"

#include <algorithm>
#include <iomanip>

namespace kdm::truth {
namespace {

constexpr int kWidth = 12;  // of a column

}  // namespace

void Tally::add(const std::string& kind, std::uint32_t seed, const Solid& solid,
                const Verdict& verdict) {
  Row& row = rows_[kind];
  ++row.tried;
  row.right += verdict.right() ? 1 : 0;
  row.manifold += verdict.manifold_right ? 1 : 0;
  row.resolved += verdict.topology_resolved ? 1 : 0;
  row.seconds += verdict.seconds;
  row.triangles.push_back(verdict.triangles);
  if (verdict.seconds > row.slowest.value) row.slowest = {seed, verdict.seconds};
  if (verdict.triangles > row.largest.value) row.largest = {seed, verdict.triangles};
  const auto note = [&](const std::string& what) {
    const std::string result = verdict.manifold_right ? ", only embedded" : "";
    Smallest& smallest = row.smallest[what + result + ", " + solid.variant + ", " + solid.pose];
    ++smallest.count;
    const std::size_t triangles = solid.input.triangles.size();
    if (smallest.count > 1 && triangles >= smallest.triangles) return;
    smallest.seed = seed;
    smallest.triangles = triangles;
  };
  for (std::size_t check = 0; check < kChecks; ++check) {
    if (!verdict.failed[check]) continue;
    ++row.failed[check];
    note(check_name(check));
  }
  if (verdict.failed.none() && !verdict.topology_right) {
    ++row.open;
    note("unresolved");
  }
}

void Tally::write_table(std::ostream& out) const {
  out << std::left << std::setw(kWidth) << "kind" << std::right;
  for (const char* head : {"tried", "right", "manifold", "resolved", "unresolved"}) {
    out << std::setw(kWidth) << head;
  }
  for (std::size_t check = 0; check < kChecks; ++check)
    out << std::setw(kWidth) << check_name(check);
  for (const char* head : {"seconds", "triangles", "worst"}) out << std::setw(kWidth) << head;
  out << '\n';
  for (const auto& [kind, row] : rows_) {
    out << std::left << std::setw(kWidth) << kind << std::right;
    for (const std::size_t n : {row.tried, row.right, row.manifold, row.resolved, row.open}) {
      out << std::setw(kWidth) << n;
    }
    for (const std::size_t n : row.failed) out << std::setw(kWidth) << n;
    std::vector<double> sorted = row.triangles;
    std::sort(sorted.begin(), sorted.end());
    out << std::fixed << std::setprecision(2);
    for (const double x : {row.seconds, sorted[sorted.size() / 2], sorted.back()}) {
      out << std::setw(kWidth) << x;
    }
    out << '\n';
  }
}

void Tally::write_failures(std::ostream& out) const {
  for (const auto& [kind, row] : rows_) {
    for (const auto& [what, smallest] : row.smallest) {
      out << kind << ": " << what << ": " << smallest.count << ", smallest --kind " << kind
          << " --seed " << smallest.seed << " (" << smallest.triangles << " triangles)\n";
    }
    out << kind << ": slowest --seed " << row.slowest.seed << " (" << row.slowest.value
        << " s), most triangles --seed " << row.largest.seed << " (" << row.largest.value
        << " times the input's)\n";
  }
}

std::size_t Tally::failed(Check check) const {
  std::size_t sum = 0;
  for (const auto& [kind, row] : rows_) sum += row.failed[check];
  return sum;
}

bool Tally::all_right() const {
  return std::all_of(rows_.begin(), rows_.end(),
                     [](const auto& row) { return row.second.right == row.second.tried; });
}

}  // namespace kdm::truth
