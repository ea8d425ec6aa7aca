// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/analysis/continuity.hpp>
#include <orispline/analysis/curve_measures.hpp>
#include <orispline/analysis/distance.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/stretches.hpp>
#include <orispline/fields/field_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A motion known densely. The caller's memory.
struct RecordedMotion {
  std::span<const double> times;                             ///< [s], they do not decrease
  std::span<const Eigen::Quaterniond> orientations;          ///< body to world, one per time
  std::span<const Eigen::Vector3d> angular_velocities = {};  ///< [rad/s], body frame; empty where none were logged
};

/// A method at keys: one curve to be measured.
struct Candidate {
  Method method;
  Keyframes keys;
  std::vector<Stretch> stretches{};  ///< of the keys, each with a curve of its own; empty: one curve
};

/// Its curve, in stretches where there are some. Errors: those of make_pose_curve().
[[nodiscard]] ORISPLINE_EXPORT Expected<PoseCurve> curve_of(const Candidate& candidate);

enum class LeaveOut { no, yes };

/// What is measured.
struct MeasureOptions {
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Identity();  ///< J [kg m²], body frame
  LeaveOut leave_out = LeaveOut::no;
  bool least_energy =
      true;  ///< look for the least energy through the keys, which takes 0.25 ms a key; in compare() only
};

/// Error (bad_argument): an inertia that is not symmetric and positive definite.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const MeasureOptions& options);

/// How one curve follows a recording, how smooth it is, and what it costs.
struct Measures {
  DistanceStatistics distance{};                   ///< full rotation angles to the recording [rad]
  std::optional<DistanceStatistics> rate_error{};  ///< ω against the logged one [rad/s]; absent where none is
  std::optional<double> inside_band{};             ///< share of the recording in the 90 % band of a method that has one
  Continuity continuity{};                         ///< in time, at the keys
  ShapeContinuity shape{};                         ///< of the shape, at the keys
  Energies energies{};
  std::optional<double> least_energy{};  ///< the least ∫|α|² [rad²/s³] through these keys; compare() finds it
  Peaks peaks{};
  double angle_travelled = 0.0;                   ///< ∫|ω| dt [rad]
  std::optional<DistanceStatistics> leave_out{};  ///< at keys that were left out [rad], where asked for and possible
  double build_seconds = 0.0;                     ///< from keys to the curve, wall clock
  double seconds = 0.0;  ///< that and the samples at the recording's times, wall clock on one thread
};

/// Builds the curve and measures it. Errors: those of make_curve(); bad_data where no time of the recording lies
/// between the first and the last key; cancelled where a stop is asked for meanwhile.
[[nodiscard]] ORISPLINE_EXPORT Expected<Measures> measure(const Candidate& candidate, const RecordedMotion& recording,
                                                          const MeasureOptions& options = {},
                                                          const Progress& progress = {});

/// The measures of each candidate, or why it has none: one that fails does not hinder the others.
struct ORISPLINE_EXPORT Comparison {
  std::vector<Expected<Measures>> measures;  ///< one per candidate, in their order
  std::vector<Warning> warnings{};           ///< of the inertia

  /// False where all failed.
  [[nodiscard]] bool any() const noexcept;
};

/// Measures the candidates, and the least energy through their keys where one could be measured, on up to `threads`
/// threads (0: one per core). Those that a stop came before are cancelled.
[[nodiscard]] ORISPLINE_EXPORT Comparison compare(std::span<const Candidate> candidates,
                                                  const RecordedMotion& recording, const MeasureOptions& options = {},
                                                  unsigned threads = 1, const Progress& progress = {});

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<MeasureOptions>() noexcept;

}}  // namespace orispline
