// SPDX-License-Identifier: MIT
// KDM_ASSERT(condition, rule) throws `kInternal`, with the rule in words, if the condition does not
// hold. It checks rules that hold by construction, and does nothing where NDEBUG is defined.
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
