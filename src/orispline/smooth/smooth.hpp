// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/smooth/smoothing_choice.hpp>

namespace orispline {

/// How samples that fit badly are treated.
enum class Loss {
  robust,  ///< Huber's loss; samples farther than 5 σ are left out and the rest is fitted anew
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
  std::optional<double> gyro_noise{};  ///< σ per axis [rad/s], 1e-9 to 1e3
};

/// Successive keys without a gap.
struct Stretch {
  std::size_t first, count;
};

/// The method whose curve through smoothed keys is the smooth motion: C2, through their orientations and rates.
inline constexpr std::string_view smoothed_method = "hermite-c2";

/// A smoothed recording.
struct Smoothing {
  Track track{};  ///< the keys, with body rates ω and α; positions as they were
  Method method{smoothed_method};
  std::vector<std::size_t> keys{};      ///< of the recording, increasing: all but those left out
  SmoothedNodes nodes{};                ///< at the times of these keys
  std::vector<Stretch> stretches{};     ///< one, without gaps
  std::vector<std::size_t> samples_in_short_stretches{};  ///< keys of stretches too short to tell noise from motion
  double smoothing_time = 0.0;          ///< τ [s]
  double lambda = 0.0;                  ///< weight of the penalty against |r|²/σ²
  double noise = 0.0;        ///< σ of the orientations per axis [rad], estimated from the residuals, or as stated
  double local_noise = 0.0;  ///< estimated from neighbouring samples [rad]
  std::optional<double> degrees_of_freedom{};  ///< effective ones of the curve, 3 tr; absent with a gyro
  std::optional<double> gyro_noise{};          ///< σ per axis [rad/s], with a gyro
  std::vector<std::size_t> rejected{};         ///< samples that do not count
  std::vector<std::size_t> rejected_gyro{};    ///< samples whose rates do not count
  std::vector<std::size_t> retained_outlier_runs{};  ///< samples as far away, but three or more in a row: rather motion than faults
  std::optional<SmoothingCriterion> criterion{};  ///< by which τ was chosen; absent: as stated
  LambdaChoice::Edge edge = LambdaChoice::Edge::none;
  std::size_t chosen_on = 0;  ///< times that the choice of τ saw
  double interval = 0.0;      ///< median one between samples [s]
  double last_step = 0.0;     ///< largest turn of a node in the last step of the iteration [rad]
  int iterations = 0;         ///< of the last fit
};

/// Of the times that it is shown, the choice of τ sees about this many at most.
inline constexpr std::size_t most_times_for_choice = 10000;

/// A noisy recording as a smooth motion: orientations with body rates ω and α at its times, of which `hermite-c2` makes
/// a C2 curve.
///
/// The weight of the penalty follows from `smoothing_time`; else it is chosen: by GCV where nothing is known, by UBRE
/// where the noise is stated, by REML with a gyro. Errors: bad_data for too few samples (fewer than three in every
/// stretch, four for the jerk; so few beside the outliers), where no smooth motion is near to them or more than half of
/// them count as outliers, for a gyro without angular velocities and for one that contradicts the orientations;
/// bad_argument for numbers out of their range, for a gap not longer than the median interval, and for options that
/// contradict each other: `noise` and `smoothing_time`, `gyro` and `gap`, `gyro_noise` without `gyro`; not_converged; cancelled.
[[nodiscard]] Expected<Smoothing> smooth(const Track& recording, const SmoothOptions& options = {},
                                         const Progress& progress = {});

}  // namespace orispline
