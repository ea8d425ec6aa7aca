// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// What EXT_meshopt_compression does to the elements of a view once they are decoded.
enum class MeshoptFilter { none, octahedral, quaternion, exponential };

/// Elements of a view: their number, the bytes of each, and the filter. Of meshoptimizer, a library that a build may
/// be without.
struct MeshoptElements {
  std::size_t count = 0, stride = 0;
  MeshoptFilter filter = MeshoptFilter::none;
};

/// The elements of compressed bytes in the mode ATTRIBUTES; nothing where these are damaged, of a version that the
/// library does not know, or where there is no library. Precondition: strides are as the extension has them.
[[nodiscard]] std::optional<std::string> from_meshopt(std::string_view compressed, const MeshoptElements& elements);

/// Elements in the mode ATTRIBUTES, to which their filter was applied before; empty where there is no library.
[[nodiscard]] std::string to_meshopt(std::string_view bytes, std::size_t stride);

}}}  // namespace orispline::scenes::gltf
