// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/scenes/gltf/json.hpp>
#include <orispline/scenes/gltf/packing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// Numbers of several accessors in one view, as meshoptimizer takes them: of equal size, with the same filter.
struct KeyStream {
  std::size_t stride = 0;
  std::string_view filter{};  ///< the word of EXT_meshopt_compression; empty where there is none
  std::string bytes{};
};

/// The new keys of a file in such streams, and the accessor of each entry without its view.
struct KeyStreams {
  std::vector<KeyStream> streams{};
  std::vector<std::size_t> stream_of{};  ///< of each entry
  std::vector<Json> accessors{};
};

/// No number becomes another one: rotations that the filter QUATERNION holds have it, other numbers EXPONENTIAL where
/// it holds them, all others and times have none.
[[nodiscard]] KeyStreams streams_of(const KeyStore& store);

}}}  // namespace orispline::scenes::gltf
