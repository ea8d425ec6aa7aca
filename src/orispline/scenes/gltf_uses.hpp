// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <orispline/scenes/gltf_document.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// Which samplers of each animation stay as they are.
using KeptSamplers = std::vector<std::vector<bool>>;

/// What becomes of a view when the keys of animations are taken out of a document.
struct ViewUse {
  bool is_whole = true;                  ///< else only what `accessors` refer to stays; nothing where there are none
  std::vector<std::size_t> accessors{};  ///< that lie in it and stay
};

/// What else a document refers to.
struct Uses {
  std::vector<std::size_t> free_accessors{};  ///< that nothing but samplers that go refers to, rising
  std::vector<ViewUse> views{};
};

[[nodiscard]] Uses uses_of(const Document& document, const KeptSamplers& kept);

}}}  // namespace orispline::scenes::gltf
