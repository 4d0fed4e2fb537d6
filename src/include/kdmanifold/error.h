// SPDX-License-Identifier: MIT
// The one exception type of the library.
#pragma once

#include <stdexcept>
#include <string>

namespace kdm {

/// What went wrong, for programs; the message says it for people.
enum class ErrorCode {
  kInvalidMesh,    ///< an array of the mesh is unusable: the message names it, the index and the
                   ///< value
  kInvalidOption,  ///< an option is out of its range: the message names it and the range
  kNotClosed,  ///< the inside rule wants the input closed and consistently oriented, and it is not:
               ///< the message has the count and the first edge at fault; or a hole is too wide, or
               ///< the surface encloses nothing
  kEmptyResult,  ///< nothing of the surface is left at this tolerance or depth
  kParseError,   ///< a file's content is malformed: the message names line, byte or rule
  kIoError,      ///< a file cannot be opened, read or written
  kOutOfMemory,  ///< an allocation failed; nothing was kept
  kAborted,      ///< the progress callback asked to stop
  kInternal      ///< an invariant of the library failed: please report it
};

/// Returns the code as users of every language see it, e.g. `NOT_CLOSED`.
const char* error_code_name(ErrorCode code);

/// Thrown by every public function; `what()` says what is wrong, where, and what to do.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ErrorCode code() const { return code_; }

 private:
  ErrorCode code_;
};

}  // namespace kdm
