// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <orispline/base/expected.hpp>
#include <orispline/curve/track.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// Whether a comment is one that states a recipe.
[[nodiscard]] bool is_recipe_line(std::string_view comment) noexcept;

/// The comment that states a recipe, with the end of its line: `# orispline: method=timed-c2:ends=rest`, and
/// `signs=as-given` where the signs of the keys mean something, `gap=0.5` where longer intervals are gaps, `jumps`
/// where two keys may have one time, and `blending={…}` with the blending functions of a method of one's own. Nothing
/// for an empty recipe.
[[nodiscard]] ORISPLINE_EXPORT std::string recipe_line(const Recipe& recipe);

/// The recipe that a comment states, from its `#` on; nothing for comments of others. Error (bad_data): a word that is
/// not understood, or stands twice; no method.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::optional<Recipe>> recipe_in(std::string_view comment);

}}}  // namespace orispline::io
