// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/scenes/bvh_source.hpp>
#include <orispline/scenes/bvh_text.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// The joints of a file, in its order.
struct Hierarchy {
  std::vector<Joint> joints{};
  std::vector<WrittenJoint> written{};  ///< one per joint
  std::vector<std::size_t> lines{};     ///< where each begins
};

/// Reads up to the word MOTION, and that. Errors (bad_data) name the line.
[[nodiscard]] Expected<Hierarchy> read_hierarchy(Text& text);

}}}  // namespace orispline::scenes::bvh
