// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/curve/track.hpp>
#include <orispline/smooth/smoothing_choice.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Successive keys without a gap.
struct Stretch {
  std::size_t first, count;
};

/// The method whose curve through smoothed keys is the smooth motion: C2, through their orientations and rates.
inline constexpr std::string_view smoothed_method = "hermite-c2";

/// How far the smooth motion is from samples [rad], of positions [m].
struct SampleDistances {
  double rms = 0.0, largest = 0.0;
};

/// What became of the positions of a recording.
struct ORISPLINE_EXPORT PositionSmoothing {
  /// τ [s]; absent where hardly any noise was found beside the motion: what is not rejected is as it was.
  std::optional<double> smoothing_time{};
  std::optional<SmoothingCriterion> criterion{};  ///< by which τ was chosen; absent: as stated, or nothing to choose by
  LambdaChoice::Edge edge = LambdaChoice::Edge::none;
  std::size_t chosen_on = 0;  ///< times that the choice of τ saw
  double noise = 0.0;         ///< σ per axis [m], from the residuals
  double local_noise = 0.0;   ///< from neighbouring samples [m]; 0 where they lie on straight lines to rounding
  std::vector<std::size_t> rejected{};                ///< samples whose positions do not count
  std::vector<std::size_t> retained_outlier_runs{};   ///< as far away, with neighbours that are far too: motion
  SampleDistances distances{}, accepted_distances{};  ///< [m], to all samples, and to those that are not rejected

  /// The frequency at which the smoother's gain is one half [Hz].
  [[nodiscard]] std::optional<double> cutoff() const noexcept;
};

/// A smoothed recording.
struct ORISPLINE_EXPORT Smoothing {
  Track track{};  ///< the keys, with body rates ω and α, and smoothed positions
  Method method{smoothed_method};
  std::vector<std::size_t> keys{};                        ///< of the recording, increasing: all but those left out
  SmoothedNodes nodes{};                                  ///< at the times of these keys
  std::optional<NodeSigmas> sigmas{};                     ///< of these nodes, where they were asked for
  std::vector<Stretch> stretches{};                       ///< one, without gaps
  std::vector<std::size_t> samples_in_short_stretches{};  ///< keys of stretches too short to tell noise from motion
  double smoothing_time = 0.0;            ///< τ [s]; where it varies, its geometric mean over intervals
  std::vector<double> smoothing_times{};  ///< τ at every key [s], where it varies in time; else empty
  double lambda = 0.0;                    ///< weight of the penalty against |r|²/σ²
  double noise = 0.0;        ///< σ of the orientations per axis [rad], estimated from the residuals, or as stated
  double local_noise = 0.0;  ///< estimated from neighbouring samples [rad]
  std::optional<double> degrees_of_freedom{};         ///< effective ones of the curve, 3 tr; absent with a gyro
  std::optional<double> gyro_noise{};                 ///< σ per axis [rad/s], with a gyro
  std::vector<std::size_t> rejected{};                ///< samples that do not count
  std::vector<std::size_t> rejected_gyro{};           ///< samples whose rates do not count
  std::vector<std::size_t> retained_outlier_runs{};   ///< samples as far away whose neighbours are far too: motion
  SampleDistances distances{}, accepted_distances{};  ///< to all samples, and to those that are not rejected
  std::optional<PositionSmoothing> positions{};       ///< where the recording has some
  std::optional<SmoothingCriterion> criterion{};      ///< by which τ was chosen; absent: as stated
  LambdaChoice::Edge edge = LambdaChoice::Edge::none;
  std::size_t chosen_on = 0;        ///< times that the choice of τ saw
  double interval = 0.0;            ///< median one between samples [s]
  double last_step = 0.0;           ///< largest turn of a node in the last step of the iteration [rad]
  int iterations = 0;               ///< of the last fit
  std::vector<Warning> warnings{};  ///< none, or the likely cause of the others first

  /// The frequency at which the smoother's gain is one half [Hz].
  [[nodiscard]] double cutoff() const noexcept;
  /// The shortest and the longest τ [s]; absent where it is the same everywhere.
  [[nodiscard]] std::optional<double> shortest_smoothing_time() const;
  [[nodiscard]] std::optional<double> longest_smoothing_time() const;
  /// Root mean square over all keys and axes of the standard deviations of the orientations [rad]; absent without them.
  [[nodiscard]] std::optional<double> rms_sigma() const;
  /// Of the angular velocities [rad/s].
  [[nodiscard]] std::optional<double> rms_sigma_of_rates() const;
  /// Whether the curve through the keys is one through a stretch at this time [s], and neither over a gap nor beside
  /// all of them. Logarithmic time.
  [[nodiscard]] bool covers(double t) const;
};

/// What is to be said about it; `warnings` themselves play no part.
///
/// `least_smoothing`: hardly any noise beside the motion; `most_smoothing`: no change of the rates beside the noise;
/// `rejected_run`: so many `samples` in a row do not count, which is rather motion than outliers; `many_rejected`: so
/// many `samples` in all, more than one in a hundred; `many_positions_rejected`: likewise of positions; `unfinished`:
/// the last step of the iteration still moved by `step_rad`.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Warning> warnings_of(const Smoothing& smoothing);

/// From the nodes to the recording that they smooth: to all samples, or to those that are not rejected.
enum class CountedSamples { all, accepted };
[[nodiscard]] ORISPLINE_EXPORT SampleDistances distances_of(const Smoothing& smoothing, const Keyframes& recording,
                                                            CountedSamples which);
/// Of the positions [m]. Precondition: there are some.
[[nodiscard]] ORISPLINE_EXPORT SampleDistances position_distances_of(const Smoothing& smoothing,
                                                                     const Keyframes& recording, CountedSamples which);

}}  // namespace orispline
