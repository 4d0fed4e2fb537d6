// SPDX-License-Identifier: MIT
// What a reader tells beside the mesh: which faces it skipped, and what it had to assume.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "kdmanifold/warnings.h"

namespace kdm {

/// A place in a file, in words such as "line 12" or "byte 96".
struct Place {
  std::string_view unit;
  std::uint64_t number = 0;
};

/// Why a face is skipped.
enum class Skip { kNotFinite, kFewCorners };

/// Collects the warnings about one file. Skipped faces are counted, and of each kind the first
/// place is kept, so that a file full of them takes no memory.
class Warnings {
 public:
  void skip(Skip why, Place place, std::uint64_t count = 1) {
    Skipped& kind = kinds_[static_cast<std::size_t>(why)];
    if (kind.count == 0) kind.first = place;
    kind.count += count;
  }
  /// Adds a warning of another kind.
  void add(const char* code, std::string message) { others_.push_back({code, std::move(message)}); }

  /// Hands all warnings out.
  std::vector<Warning> take();
  /// Throws `kParseError` if any face was skipped: call it if none is left. `name` is what messages
  /// call the file.
  void fail_if_skipped(std::string_view name) const;

 private:
  struct Skipped {
    std::uint64_t count = 0;
    Place first;
  };
  static std::string count_text(Skip why, std::uint64_t count);

  std::array<Skipped, 2> kinds_;
  std::vector<Warning> others_;
};

}  // namespace kdm
