// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/families/key_findings.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// The curve of a complete method through keys, in stretches where their recipe states a gap, with the path through
/// positions that stand apart. Errors: those of make_pose_curve(); of `gap`, one that does not suit the keys.
[[nodiscard]] ORISPLINE_EXPORT Expected<PoseCurve> curve_through(const Method& method, const Track& keys);

/// The curve of a method through the keys of a file, with the settings of their columns where the method is silent.
///
/// What the user's words are to blame for is bad_argument; what the columns are, or the recipe, is bad_data and names
/// the line.
[[nodiscard]] ORISPLINE_EXPORT Expected<PoseCurve> shaped_curve(const Method& method, const Track& keys);

/// That curve, and what is to be said of it.
struct CurveOfKeys {
  PoseCurve curve;
  Method method{};                        ///< with what was found as settings, so that it is not found again
  std::optional<KeyFindings> findings{};  ///< by the method `measured`
  std::vector<Warning> warnings{};
};

/// Errors: those of shaped_curve().
[[nodiscard]] ORISPLINE_EXPORT Expected<CurveOfKeys> curve_of_keys(const Method& method, const Track& keys);

/// What a task takes where neither its user nor the keys name a method that fits.
struct UsualMethod {
  std::string_view name{default_method};
  bool (*fits)(const FamilyInfo&) = nullptr;  ///< which methods of the keys do; null: all
};

enum class NamedBy { user, keys, nobody };

/// The method whose curve a task is about.
struct ChosenMethod {
  Method method{};
  NamedBy by = NamedBy::user;
  std::vector<Warning> warnings{};  ///< `recipe_set_aside`; those that are left here are told by the outcome
};

/// What a user says of a method besides its name.
using Shaping = std::function<Expected<Method>(Method method, NamedBy by)>;

/// The method that the user names, as it is; else the one that the keys are for, where it fits, or the usual one,
/// shaped. Errors: a recipe that cannot be read, and those of the shaping.
[[nodiscard]] ORISPLINE_EXPORT Expected<ChosenMethod> chosen_method(const std::optional<Method>& named,
                                                                    const Recipe& recipe, std::string_view file,
                                                                    const UsualMethod& usual,
                                                                    const Shaping& shaping = {});
[[nodiscard]] ORISPLINE_EXPORT Expected<ChosenMethod> chosen_method(const std::optional<Method>& named,
                                                                    const Track& keys, const UsualMethod& usual);

/// Error (bad_argument): the keys state gaps, and the task is about one curve through all of them.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_without_gaps(const Track& keys);

/// The family of the method that the keys of a file are for; null where they name none. Error (bad_data): a recipe that
/// cannot be read.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::shared_ptr<const FamilyInfo>> family_named(const Recipe& recipe,
                                                                                        std::string_view file);

/// The family of a method that was understood.
[[nodiscard]] ORISPLINE_EXPORT const FamilyInfo& family_of(const Method& method);

/// The error with its place in the file of the keys, unless the user alone is at fault.
[[nodiscard]] ORISPLINE_EXPORT Error placed(const Track& keys, Error error);

}}}  // namespace orispline::jobs
