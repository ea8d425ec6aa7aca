// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// The parts of a file: a GLB has both, a .gltf is all document.
struct Container {
  std::string_view json{};
  std::optional<std::string_view> binary{};
};

/// Views of the bytes, told apart by their first four. Errors (bad_data): a header or a chunk that is not whole.
[[nodiscard]] Expected<Container> container_of(std::string_view bytes);

/// A GLB. Errors (bad_data): more bytes than it can state.
[[nodiscard]] Expected<std::string> glb_of(std::string_view json, std::string_view binary);

/// Nothing for text that is not base64.
[[nodiscard]] std::optional<std::string> from_base64(std::string_view text);
[[nodiscard]] std::string base64_of(std::string_view bytes);

}}}  // namespace orispline::scenes::gltf
