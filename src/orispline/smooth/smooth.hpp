// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/base/progress.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/smooth/smoothing_result.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How samples that fit badly are treated.
enum class Loss {
  robust,  ///< every sample counts, but one or two farther than 5 σ from what those beside them predict are left out
  l2,      ///< squares: every sample counts in full
  huber,   ///< Huber's loss: far samples count less
  tukey,   ///< Tukey's loss, from Huber's fit: very far samples do not count
};

/// How a recording is to be smoothed. What is absent is estimated from it.
struct SmoothOptions {
  Penalty penalty = Penalty::acceleration;
  std::optional<double> noise{};           ///< σ of the orientations per axis [rad], 1e-7 to 0.5
  std::optional<double> smoothing_time{};  ///< τ [s]; not together with `noise`. A thousandth of the median interval to
                                           ///< ten durations, for the jerk 5000 intervals
  Loss loss = Loss::robust;
  std::optional<double> gap{};  ///< intervals longer than this [s] end a stretch, and the next one begins
  bool gyro = false;            ///< the angular velocities of the recording are those of a gyro with a constant bias
  std::optional<double> gyro_noise{};      ///< σ per axis [rad/s], 1e-9 to 1e3
  std::optional<double> position_noise{};  ///< σ of the positions per axis [m], 1e-12 to 1e12
  bool adapt = true;  ///< let τ of the orientations vary in time where that predicts the samples clearly better; of no
                      ///< effect with `smoothing_time` or `gyro`, with which one τ serves the whole recording
  bool sigma = false;  ///< find the standard deviations of the smoothed orientations and rates too
};

/// Errors (bad_argument): numbers that are out of their range whatever the recording is, and options that contradict
/// each other: `noise` and `smoothing_time`, `gyro` and `gap`, `gyro_noise` without `gyro`.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const SmoothOptions& options);

/// Of the times that it is shown, the choice of τ sees about this many at most.
inline constexpr std::size_t most_times_for_choice = 10000;

/// A noisy recording as a smooth motion: orientations with body rates ω and α at its times, of which `hermite-c2` makes
/// a C2 curve; and positions, where it has some, by the smoothing spline of the same penalty.
///
/// The weight of the penalty follows from `smoothing_time`; else it is chosen: by GCV where nothing is known, by UBRE
/// where the noise is stated, by REML with a gyro. That of the positions likewise, for themselves; `position_noise`
/// stands before `smoothing_time`. Errors: bad_data for too few samples (fewer than three in every
/// stretch, four for the jerk; so few beside the outliers), where no smooth motion is near to them or more than half of
/// them count as outliers, for a gyro without angular velocities and for one that contradicts the orientations, for a
/// noise of positions without any; those of check(); bad_argument for a smoothing time that does not suit the recording
/// and for a gap not longer than the median interval; not_converged; cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<Smoothing> smooth(const Track& recording, const SmoothOptions& options = {},
                                                          const Progress& progress = {});

}}  // namespace orispline
