// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/key_compression.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

std::string without_meshopt() {
  return "this build is without meshoptimizer, which EXT_meshopt_compression takes; gltf-transform copy IN.glb OUT.glb "
         "decodes a file, and gltf-transform meshopt compresses one";
}

Expected<KeyCompression> key_compression_in(std::string_view text) {
  const auto found = std::ranges::find(words<KeyCompression>, text, &Word::word);
  if (found == words<KeyCompression>.end())
    return bad_option("compress", formatted("found '{}', wanted {}", text, one_of(words<KeyCompression>)));
  return static_cast<KeyCompression>(found->value);
}

Expected<void> check(KeyCompression compression) {
  if (compression == KeyCompression::none || has_meshopt()) return {};
  return bad_option("compress", formatted("found meshopt, but {}", without_meshopt()));
}

}}  // namespace orispline
