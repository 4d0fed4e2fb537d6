// SPDX-License-Identifier: MIT
// The names by which users of every language know error codes.
#include "kdmanifold/error.h"

namespace kdm {

const char* error_code_name(ErrorCode code) {
  switch (code) {
    case ErrorCode::kInvalidMesh:
      return "INVALID_MESH";
    case ErrorCode::kInvalidOption:
      return "INVALID_OPTION";
    case ErrorCode::kNotClosed:
      return "NOT_CLOSED";
    case ErrorCode::kEmptyResult:
      return "EMPTY_RESULT";
    case ErrorCode::kParseError:
      return "PARSE_ERROR";
    case ErrorCode::kIoError:
      return "IO_ERROR";
    case ErrorCode::kOutOfMemory:
      return "OUT_OF_MEMORY";
    case ErrorCode::kAborted:
      return "ABORTED";
    case ErrorCode::kInternal:
      return "INTERNAL";
  }
  return "INTERNAL";
}

}  // namespace kdm
