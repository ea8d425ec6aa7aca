// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/scenes/gltf_json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// Where a buffer begins in the merged one. One without data is there for an extension to fill.
struct BufferPlace {
  std::size_t offset = 0, length = 0;
  bool has_data = true;
};

struct Buffers {
  std::string bytes{};
  std::vector<BufferPlace> places{};
};

/// The buffers of a document, one behind the other, each at a multiple of 8.
///
/// `binary`: the chunk of a GLB. Errors: bad_data; bad_access for a file that is not beside `path` or cannot be read.
[[nodiscard]] Expected<Buffers> buffers_of(const Object& root, std::optional<std::string_view> binary,
                                           const std::string& path);

}}}  // namespace orispline::scenes::gltf
