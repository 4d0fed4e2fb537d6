// SPDX-License-Identifier: MIT
// Helpers for tests of readers and writers.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <string_view>

#include "kdmanifold/error.h"
#include "kdmanifold/mesh_io.h"

namespace kdm::io_test {

/// Returns the message of the `kParseError` that these bytes must provoke.
inline std::string parse_fault(std::string_view bytes, MeshFormat format) {
  try {
    parse_mesh(bytes, format, "in");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::kParseError);
    const std::string message = error.what();
    EXPECT_EQ(message.find_first_of("\r\n"), std::string::npos) << message;
    EXPECT_TRUE(message.rfind("in: line ", 0) == 0 || message.rfind("in: byte ", 0) == 0)
        << message;
    return message;
  }
  ADD_FAILURE() << "no error for: " << bytes.substr(0, 200);
  return "";
}

/// Reads every beginning of a file. Each must be refused with a `kParseError`, or give a mesh whose
/// indices are in range. Returns how many were refused.
inline std::size_t refused_beginnings(std::string_view bytes, MeshFormat format) {
  std::size_t refused = 0;
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    // A copy of its own, so that AddressSanitizer sees a read behind the end.
    const std::string beginning(bytes.substr(0, length));
    try {
      describe(parse_mesh(beginning, format, "in"));
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::kParseError) << error.what() << " at length " << length;
      ++refused;
    }
  }
  return refused;
}

/// Reads a file with every byte changed to several others. Each must be refused with a
/// `kParseError`, or give a mesh whose indices are in range.
inline void try_changed_bytes(std::string_view bytes, MeshFormat format) {
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (const char value : std::string_view("\0\n -/9\\\xff", 8)) {
      std::string changed(bytes);
      changed[i] = value;
      try {
        describe(parse_mesh(changed, format, "in"));
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::kParseError) << error.what() << " at byte " << i;
      }
    }
  }
}

/// Returns a pyramid of four triangles and a quad. Among its coordinates are fractions, a negative
/// number and one that is written with an exponent.
inline Mesh pyramid() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1.5, 0}, {0, 1.5, 0}, {0.25, 0.1, -1e-7}},
          {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
          {{3, 2, 1, 0}},
          {},
          {}};
}

}  // namespace kdm::io_test
