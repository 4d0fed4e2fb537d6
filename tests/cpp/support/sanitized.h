// SPDX-License-Identifier: MIT
// Tells whether this build has sanitizers, which make it twenty times slower. Tests that try many
// combinations try fewer then; the optimised build tries them all.
#pragma once

namespace kdm::check {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace kdm::check
