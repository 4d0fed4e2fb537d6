// SPDX-License-Identifier: MIT
// Where the checkout lies that the tests were compiled from.
#pragma once

#include <filesystem>

namespace kdm::paths {

/// The project's folder.
inline const std::filesystem::path kRoot =
    std::filesystem::path(__FILE__).parent_path().parent_path().parent_path().parent_path();

/// Its folder of tests.
inline const std::filesystem::path kTests = kRoot / "tests";

}  // namespace kdm::paths
