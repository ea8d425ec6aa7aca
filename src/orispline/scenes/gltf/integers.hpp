// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>

#include <orispline/scenes/gltf/document.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// The bytes of numbers as normalised integers of 8 or 16 bits with a sign; nothing where one of them would be read as
/// another number than this in single precision, and for other types.
[[nodiscard]] std::optional<std::string> bytes_in(ComponentType type, std::span<const float> numbers);

}}}  // namespace orispline::scenes::gltf
