// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which joints of two skeletons are the same ones.
struct Counterparts {
  std::vector<std::size_t> joints{};  ///< per joint of the first skeleton that of the second; `no_parent` for none
  std::size_t only_in_first = 0, only_in_second = 0;
  /// Joints of the first skeleton that the second has elsewhere in the tree, found by their names.
  std::vector<std::size_t> by_name{};
  /// Joints of the first skeleton that could have been others of the same name; the order in the files decided.
  std::vector<std::size_t> guessed{};
};

/// By the path in the tree: from the roots down, those below counterparts that have the same name. Of several of one
/// name there, those with the same rest pose and the same joints below. What is left is found by its name alone.
///
/// The order of joints in the skeletons says nothing, unless nothing else tells some of them apart.
[[nodiscard]] ORISPLINE_EXPORT Counterparts counterparts_of(const Skeleton& first, const Skeleton& second);

}}  // namespace orispline
