// SPDX-License-Identifier: MIT
// Words the warnings.
#include "extract/warnings.h"

#include <string>

#include "text/compose.h"
#include "text/rounded.h"

namespace kdm {
namespace {

// Tolerances that were asked for and used agree but for rounding.
constexpr double kWider = 1.001;

// "1 part", "3 parts".
std::string count(Index n, const char* one, const char* many) {
  return compose("{} {}", n, n == 1 ? one : many);
}

class Collector {
 public:
  void add(const char* code, std::string message) { found_.push_back({code, std::move(message)}); }
  std::vector<Warning> take() { return std::move(found_); }

 private:
  std::vector<Warning> found_;
};

void warn_of_losses(const InputReport& input, const GridStats& grid, const ExtractReport& report,
                    Collector& to) {
  if (input.lost_parts > 0) {
    to.add("PARTS_LOST",
           compose("parts of the input that bound nothing were left out: {}, an area of {}, the "
                   "largest {}; thicken keeps them",
                   input.lost_parts, rounded(input.lost_area), rounded(input.largest_lost)));
  }
  if (report.dropped_parts > 0) {
    to.add("PARTS_DROPPED",
           compose("parts of the result were left out, as the option parts says: {}",
                   report.dropped_parts));
  }
  if (grid.thin_area > 0) {
    to.add("THIN_REMOVED", compose("what is thinner than asked for was removed, with an area of {}",
                                   rounded(grid.thin_area)));
  }
  if (grid.narrow_area > 0) {
    to.add("GAPS_FILLED", compose("gaps narrower than asked for were filled, with an area of {}",
                                  rounded(grid.narrow_area)));
  }
  if (report.small_parts > 0) {
    to.add("PARTS_DROPPED", compose("{} left out as smaller than asked for, with a volume of {}",
                                    count(report.small_parts, "part was", "parts were"),
                                    rounded(report.small_parts_volume)));
  }
  if (report.small_cavities > 0) {
    to.add("CAVITIES_FILLED", compose("{} filled as smaller than asked for, with a volume of {}",
                                      count(report.small_cavities, "cavity was", "cavities were"),
                                      rounded(report.small_cavities_volume)));
  }
  if (report.small_handles > 0) {
    to.add("HANDLES_REMOVED", compose("{} closed or cut as smaller than asked for",
                                      count(report.small_handles, "handle was", "handles were")));
  }
  if (report.kept_handles > 0) {
    to.add("HANDLES_KEPT", compose("{} smaller than asked for, but nothing closes {} without "
                                   "meeting the surface",
                                   count(report.kept_handles, "handle is", "handles are"),
                                   report.kept_handles == 1 ? "it" : "them"));
  }
}

void warn_of_exactness(const InputReport& input, const GridStats& grid, const ExtractReport& report,
                       Collector& to) {
  if (grid.asked_tolerance > 0 && grid.tolerance > kWider * grid.asked_tolerance) {
    to.add(
        "TOLERANCE_WIDENED",
        compose("the tolerance was widened from {} to {}, since the surface crosses itself in too "
                "many places",
                rounded(grid.asked_tolerance), rounded(grid.tolerance)));
  }
  if (input.rebuilt_parts > 0 && input.rebuilding_tolerance > kWider * grid.asked_tolerance) {
    to.add("TOLERANCE_WIDENED",
           compose("the tolerance was widened from {} to {} for {}, which cross themselves or each "
                   "other in too many places",
                   rounded(grid.asked_tolerance), rounded(input.rebuilding_tolerance),
                   count(input.rebuilt_parts, "rebuilt part", "rebuilt parts")));
  }
  if (grid.thin_parts > 0) {
    to.add("THIN_PARTS",
           compose("{} not much thicker than the tolerance, and too near to others to be kept "
                   "exactly: the thickness may differ; take a smaller tolerance",
                   count(grid.thin_parts, "part is", "parts are")));
  }
  if (grid.exact_parts > 0) {
    to.add("THIN_PARTS_EXACT", compose("{} not much thicker than the tolerance, and taken over as "
                                       "given or as rebuilt, with {}",
                                       count(grid.exact_parts, "part is", "parts are"),
                                       count(grid.exact_triangles, "triangle", "triangles")));
  }
  if (grid.unresolved_leaves > 0) {
    to.add("TOPOLOGY_UNRESOLVED",
           compose("the topology was given up in {}: parts nearer to each other than the tolerance "
                   "may have been joined or separated there",
                   count(grid.unresolved_leaves, "cell", "cells")));
  }
  if (report.crossings.value_or(0) > 0) {
    to.add("TRIANGLES_CROSS",
           compose("{} pairs of triangles of the result cross", *report.crossings));
  }
}

void warn_of_repair(const InputReport& input, const GridStats& grid, const ExtractReport& report,
                    double area, Collector& to) {
  if (input.turned_parts > 0) {
    to.add("PARTS_TURNED",
           compose("closed parts that were inside out were turned: {}", input.turned_parts));
  }
  if (!input.nesting_known) {
    to.add("NESTING_UNKNOWN",
           "too many closed parts overlap to find out which lie in which; none of them was turned");
  }
  if (input.sewing_distance > kWider * grid.tolerance) {
    to.add("SEWN_FAR", compose("edges up to {} apart were sewn together, more than the tolerance",
                               rounded(input.sewing_distance)));
  }
  const bool cut = input.closed && grid.thin_area + grid.narrow_area > 0;
  if (report.invented_area > 0 && !cut) {
    const double percent = area > 0 ? 100 * report.invented_area / area : 0;
    to.add("HOLES_CLOSED",
           compose("holes were closed: {} % of the result's area is new", rounded(percent)));
  }
  if (grid.winding_threshold > 0) {
    to.add("WINDING_THRESHOLD", compose("inside is where the winding number is above {}",
                                        rounded(grid.winding_threshold)));
  }
  if (input.stray_parts > 0) {
    to.add("STRAY_PARTS",
           compose("small parts far from the rest did not count for the relative tolerance: {}",
                   input.stray_parts));
  }
}

}  // namespace

std::vector<Warning> collect_warnings(const InputReport& input, const GridStats& grid,
                                      const ExtractReport& report, double area) {
  Collector to;
  warn_of_losses(input, grid, report, to);
  warn_of_exactness(input, grid, report, to);
  warn_of_repair(input, grid, report, area, to);
  return to.take();
}

}  // namespace kdm
