// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/track.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A method from its text form `NAME:SETTING=VALUE:…`, such as `quintic:tension=0.6:ends=natural`.
///
/// A value is a number, numbers with commas between them (one per key), or the word of a choice. `ends=RULE` or
/// `ends=START,END` names the end rules, `start_rate=WX,WY,WZ` and `end_rate=…` give the body rates [rad/s] of clamped
/// ends, `closed` makes a loop whose last key is its first one, `period=T` one that returns after T seconds.
/// A name may be one of `own`, families of one's own. Errors: bad_argument for a method, setting, rule or number that
/// there is not, and for a setting that stands twice.
[[nodiscard]] ORISPLINE_EXPORT Expected<Method> method_from_text(
    std::string_view text, std::span<const std::shared_ptr<const OwnFamily>> own = {});

/// The text form, which method_from_text() reads back as the same method bit for bit; defaults are left out.
[[nodiscard]] ORISPLINE_EXPORT std::string text_of(const Method& method);

/// The texts of the methods in a list with commas between them: all of it where that is one method, whose settings may
/// have commas, else its pieces. Whether a piece is a method is left to its reader. A name may be one of `own`.
///
/// Error (bad_argument): a piece that can only be the value of a setting.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<std::string>> method_texts_in(
    std::string_view list, std::span<const std::shared_ptr<const OwnFamily>> own = {});

/// What tells these methods from each other: the name, or the text form where another one has the name too.
[[nodiscard]] ORISPLINE_EXPORT std::vector<std::string> labels_of(std::span<const Method> methods);

/// The method with one more setting, numbers for a parameter and a word for a choice. Errors: bad_argument for a
/// setting that the method does not have or has been given already, and for a text that is no value of it.
[[nodiscard]] ORISPLINE_EXPORT Expected<Method> with_setting(Method method, std::string_view setting,
                                                             std::string_view value);

/// The method with the rules for both ends that `RULE` or `START,END` names. Error: bad_argument.
[[nodiscard]] ORISPLINE_EXPORT Expected<Method> with_ends(Method method, std::string_view rules);

/// At the first key, or at the last one.
enum class CurveEnd { start, end };

/// The method with a body rate [rad/s] at one end, which is clamped. Error: bad_argument for a method without clamped
/// ends and for another rule at that end.
[[nodiscard]] ORISPLINE_EXPORT Expected<Method> with_end_rate(Method method, CurveEnd end, const Eigen::Vector3d& rate);

/// The method as a loop. Errors: bad_argument for a method without loops and a period that is not greater than 0.
[[nodiscard]] ORISPLINE_EXPORT Expected<Method> with_loop(Method method, Loop loop);

/// The method as far as these do not speak of it, which are names of settings, `ends`, `start_rate`, `end_rate`,
/// `closed` or `period`: what others say of them can then be added. With other `ends` a rate that is stated stays.
[[nodiscard]] ORISPLINE_EXPORT Method without(Method method, std::span<const std::string> names);

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
