// SPDX-License-Identifier: MIT
// Reports the progress of construction now and then.
#pragma once

#include <cstdint>

#include "mesh/progress.h"

namespace kdm {

/// Counts cells, and reports every few thousand of them.
class CellProgress {
 public:
  /// Keeps a reference to `progress`.
  explicit CellProgress(const Progress& progress) : progress_(progress) {}

  /// To be called for every cell, with the fraction of the construction that is done before it.
  void count_cell(double fraction) {
    constexpr std::uint32_t kInterval = 4096;  // cells between two calls
    if (++cells_since_report_ < kInterval) return;
    cells_since_report_ = 0;
    report_progress(progress_, fraction, "build");
  }

 private:
  const Progress& progress_;
  std::uint32_t cells_since_report_ = 0;
};

}  // namespace kdm
