// SPDX-License-Identifier: MIT
// Where the checkout lies from which the tests were compiled.
#pragma once

#include <filesystem>

namespace kdm::paths {

/// The project's folder.
inline const std::filesystem::path kRoot =
    std::filesystem::path(__FILE__).parent_path().parent_path().parent_path().parent_path();

/// The folder of tests in it.
inline const std::filesystem::path kTests = kRoot / "tests";

}  // namespace kdm::paths
