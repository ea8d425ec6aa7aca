// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

/// Named tolerances with their reasons. Errors are relative to max(1, size of the expected value) unless said
/// otherwise.
namespace orispline::tolerance {

/// 4 ulp: a handful of correctly rounded operations.
inline constexpr double exact = 4.0 * std::numeric_limits<double>::epsilon();
/// The promise for log: a relative error, everywhere.
inline constexpr double log_relative = 4e-16;
/// The closed forms of the series functions lose up to four bits just above their thresholds.
inline constexpr double four_bits = 16.0 * std::numeric_limits<double>::epsilon();
/// Chains of tens of operations without cancellation.
inline constexpr double algebra = 1e-13;
/// Derivatives, up to order 3, of functions with a series and a closed form.
inline constexpr double series = 1e-12;
/// Rates on knots with spacing ratios up to 10: the jerk holds 1/h³, so that rounding grows by a thousand and more.
inline constexpr double rates = 1e-9;
/// A derivative that should be continuous: relative to its largest size at the knots.
inline constexpr double continuity = 1e-9;
/// A derivative that does jump, jumps by more than this: far above rounding, far below the O(1) that theory gives.
inline constexpr double visible_jump = 1e-4;
/// Central differences with the step below, a fraction of the segment: truncation (step)²/6 of the derivative two
/// orders up, rounding 1e-16/step of the value.
inline constexpr double difference = 1e-7;
inline constexpr double difference_step = 1e-5;

/// One tolerance per order of a motion.
struct MotionTolerance {
  double orientation, angular_velocity, angular_acceleration, angular_jerk;
};

/// Golden data: the contract of the project for doubles against 60 digits.
inline constexpr MotionTolerance golden{1e-12, 1e-11, 1e-9, 1e-7};
/// The wider field: the reference's own formulas in double precision lose a hundredth of it at most.
inline constexpr MotionTolerance golden_wider{1e-12, 1e-11, 1e-10, 1e-9};
/// Hermite polynomials up to degree 7 from key rates: the jerk divides the rounding of the chart by h³.
inline constexpr MotionTolerance golden_hermite{1e-11, 1e-10, 1e-9, 1e-8};

}  // namespace orispline::tolerance
