// SPDX-License-Identifier: MIT
// What a person who waits at a terminal sees.
#pragma once

#include <cstdio>
#include <string>
#include <string_view>

#include "kdmanifold/progress.h"

namespace kdm::cli {

/// One line on standard error that is written over and over, and is gone at the end.
class ProgressLine {
 public:
  /// If it is not `shown`, nothing is ever written.
  explicit ProgressLine(bool shown) : shown_(shown) {}
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;
  ~ProgressLine() { clear(); }

  /// What stands before all that follows, e.g. "2 of 5: ".
  void begin(std::string prefix) { prefix_ = std::move(prefix); }

  /// Shows a step whose end nobody can foresee.
  void show(std::string_view step) { write(prefix_ + std::string(step)); }

  /// Returns what shows how far a step is, with the phase of it.
  Progress of(std::string_view step) {
    show(step);
    return [this, step = std::string(step)](double fraction, std::string_view phase) {
      const int percent = static_cast<int>(100 * fraction);
      write(prefix_ + step + ' ' + std::to_string(percent) + " %, " + std::string(phase));
      return true;
    };
  }

  /// Takes the line away.
  void clear() {
    if (!text_.empty()) std::fputs("\r\x1b[K", stderr);
    text_.clear();
  }

 private:
  void write(const std::string& text) {
    if (!shown_ || text == text_) return;
    std::fprintf(stderr, "\r%s\x1b[K", text.c_str());
    text_ = text;
  }

  bool shown_;
  std::string prefix_;
  std::string text_;  // what stands there
};

}  // namespace kdm::cli
