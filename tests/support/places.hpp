// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace orispline::testing_support {

/// A file of the project: `tests/data/golden.csv`.
[[nodiscard]] std::string in_project(std::string_view path);
/// A file of the recordings and references beside the project, which may be missing: `data/gltf`.
[[nodiscard]] std::string beside_project(std::string_view path);

}  // namespace orispline::testing_support
