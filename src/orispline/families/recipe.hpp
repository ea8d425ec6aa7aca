// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/base/warning.hpp>
#include <orispline/curve/track.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The recipe of keys whose curve is this method's, but for the settings that the track states key by key; their signs
/// are those of the track's own recipe.
[[nodiscard]] ORISPLINE_EXPORT Recipe recipe_for(const Method& method, const Track& track);

/// The method that the keys are for; absent where the recipe names none. Error (bad_data): a method or a setting that
/// there is not, with the line of `file`.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::optional<Method>> method_of(const Recipe& recipe, std::string_view file);

/// `recipe_set_aside`: the keys are for the curve of another method than this one, which was asked for.
[[nodiscard]] ORISPLINE_EXPORT std::optional<Warning> recipe_set_aside(const Recipe& recipe, const Method& used,
                                                                       std::string_view file);

}}  // namespace orispline
