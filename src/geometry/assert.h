// SPDX-License-Identifier: MIT
// KDM_ASSERT: internal rules, checked in debug builds and in all tests.
#pragma once

#ifdef NDEBUG
#define KDM_ASSERT(condition, rule) static_cast<void>(0)
#else
#include <string>

#include "kdmanifold/error.h"
#define KDM_ASSERT(condition, rule)                                                        \
  do {                                                                                     \
    if (!(condition)) {                                                                    \
      throw ::kdm::Error(::kdm::ErrorCode::kInternal,                                      \
                         std::string("broken rule: ") + (rule) + " (" + #condition + ")"); \
    }                                                                                      \
  } while (false)
#endif
