// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/families/key_findings.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

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

}}}  // namespace orispline::jobs
