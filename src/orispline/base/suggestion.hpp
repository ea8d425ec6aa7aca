// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Letters to insert, remove, replace or exchange with their neighbour so that one word becomes the other; capitals
/// count as small letters.
[[nodiscard]] ORISPLINE_EXPORT std::size_t edit_distance(std::string_view one, std::string_view other);

/// The word that a misspelt one probably stands for, the first of the nearest; nothing where none is near: no more than
/// one letter of three may be wrong.
[[nodiscard]] ORISPLINE_EXPORT std::optional<std::string_view> nearest_word(std::string_view typed,
                                                                            std::span<const std::string_view> words);

/// What is said of a word that a vocabulary lacks: `unknown method 'squadd'; did you mean 'squad'?`, or, where no word
/// is near, `unknown method 'x', wanted one of auto, squad`.
[[nodiscard]] ORISPLINE_EXPORT std::string unknown_word(std::string_view kind, std::string_view typed,
                                                        std::span<const std::string_view> words);

}}  // namespace orispline
