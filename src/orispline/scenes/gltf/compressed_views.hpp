// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>
#include <orispline/scenes/gltf/document.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// The names of the extension by which views are compressed: the usual one, its successor, and one from before it.
inline constexpr std::string_view meshopt_extension = "EXT_meshopt_compression";
inline constexpr std::array meshopt_extensions{meshopt_extension, std::string_view("KHR_meshopt_compression"),
                                               std::string_view("MESHOPT_compression")};
[[nodiscard]] bool is_meshopt(std::string_view extension) noexcept;

/// What tells that a file comes from gltf-transform or gltfpack, or goes through what they write: its generator, or the
/// extension. Empty where nothing does.
[[nodiscard]] std::string compressing_tool(const Document& document);

/// Where the compressed bytes of a view lie in the binary.
struct CompressedView {
  std::string_view extension;
  std::size_t offset = 0, length = 0;
};

/// Nothing of a view that is not compressed. Errors (bad_data) name the view: no such buffer, or bytes beyond it.
[[nodiscard]] Expected<std::optional<CompressedView>> compressed_view(const Document& document, std::size_t view);

/// The document with the data of its animations decoded, as far as they are compressed: of the times of all channels,
/// and of the values of those that are ours. Their views are then like any others; all others stay as they are.
///
/// Errors (bad_data) name the view: data that are damaged or not of animations, and a build without meshoptimizer.
[[nodiscard]] Expected<Document> with_animations_decoded(Document document);

}}}  // namespace orispline::scenes::gltf
