// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include <orispline/math/eigen.hpp>

// The lists of numbers of a page as JSON: short ones as arrays, with `null` for what is not finite, others as a typed
// array in base64. studio/report/README.md states both forms.

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// A number with 7 significant digits, what a line on a screen can show; `null` where it is not finite.
[[nodiscard]] std::string number_json(double value);

/// In 64 bits, or as the shortest decimals that read back to the same numbers.
[[nodiscard]] std::string doubles_json(std::span<const double> values);
/// In 32 bits.
[[nodiscard]] std::string floats_json(std::span<const double> values);
[[nodiscard]] std::string floats_json(std::span<const Eigen::Vector3d> values);
/// Scalar first.
[[nodiscard]] std::string floats_json(std::span<const Eigen::Quaterniond> values);
/// In 16 bits, in a unit of their own.
[[nodiscard]] std::string halves_json(std::span<const double> values);
[[nodiscard]] std::string halves_json(std::span<const Eigen::Vector3d> values);
/// Times that do not decrease, in whole steps of a part in 2³² of all.
[[nodiscard]] std::string steps_json(std::span<const double> times);

}}}  // namespace orispline::report
