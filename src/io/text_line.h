// SPDX-License-Identifier: MIT
// Writes lines of numbers to text.
#pragma once

#include <string>

#include "kdmanifold/mesh_io.h"
#include "text/numbers.h"

namespace kdm {

/// A line while it is written: a keyword and numbers, with blanks between them. There is room for a
/// face of four corners, each with its normal.
class TextLine {
 public:
  explicit TextLine(std::string_view keyword = "") { put(keyword); }

  template <typename Number>
  void add(Number number) {
    if (end_ != text_) put(" ");
    end_ = write_number(end_, number);
  }
  /// Adds two numbers of a pair, which is a vertex and its normal in OBJ.
  template <typename Number>
  void add(Number first, std::string_view separator, Number second) {
    add(first);
    put(separator);
    end_ = write_number(end_, second);
  }
  /// Adds the coordinates of a point, rounded to 32-bit floats. With `Digits::kShortest` each has
  /// as few digits as tell it from all other floats, else as few as tell it from all other doubles.
  void add(const Vec3& point, Digits digits) {
    for (int axis = 0; axis < 3; ++axis) {
      const float coordinate = static_cast<float>(point[axis]);
      if (digits == Digits::kShortest) {
        add(coordinate);
      } else {
        add(double{coordinate});
      }
    }
  }

  void append_to(std::string& text) {
    put("\n");
    text.append(text_, end_);
  }

 private:
  void put(std::string_view text) { end_ += text.copy(end_, text.size()); }

  char text_[16 + 8 * (kLongestNumber + 2)];
  char* end_ = text_;
};

}  // namespace kdm
