// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/stretches.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What a smoothing curve keeps small.
enum class Penalty {
  acceleration,  ///< ∫|α|² dt [rad²/s³]
  jerk,          ///< ∫|dα/dt|² dt [rad²/s⁵]
};

/// How samples that fit badly are treated.
enum class Loss {
  robust,  ///< every sample counts, but one or two farther than 5 σ from what those beside them predict are left out
  l2,      ///< squares: every sample counts in full
  huber,   ///< Huber's loss: far samples count less
  tukey,   ///< Tukey's loss, from Huber's fit: very far samples do not count
};

/// What is believed of the error that the rates of a gyro have in common.
enum class GyroBias {
  constant,  ///< the same at all times
  drifting,  ///< a random walk, whose size is found with the rest
};

/// The body rates that a gyro measured, which need not stand at the times of a recording.
struct GyroRates {
  std::vector<double> times{};           ///< [s] since the recording's epoch, increasing
  std::vector<Eigen::Vector3d> rates{};  ///< [rad/s], body frame
  enum class Clock {
    of_the_recording,  ///< they are rows of the recording, some of them perhaps without an orientation
    own,               ///< a recording by themselves
  } clock = Clock::of_the_recording;
  std::string name{};                  ///< of the file, where it is one by itself
  std::vector<Decimal> exact_times{};  ///< [s], as the file writes them; empty, or one for each
  std::vector<std::uint32_t> lines{};  ///< of the file, from 1; empty, or one for each
};

/// How a recording is to be smoothed. What is absent is estimated from it.
struct SmoothOptions {
  std::optional<Penalty> penalty{};    ///< absent: the acceleration, or the jerk with a gyro that does not count
                                       ///< turns, whose accelerations it carries on to an end without rates
  std::optional<double> noise{};       ///< σ of the orientations per axis [rad], 1e-7 to 0.5
  std::optional<double> noise_time{};  ///< within which the correlation of the noise of the orientations falls to 1/e
                                       ///< [s]; absent: white, or found with a gyro. Neither with one nor with
                                       ///< `smoothing_time`
  std::optional<double> smoothing_time{};  ///< τ [s]; not together with `noise`. A thousandth of the median interval to
                                           ///< ten durations, for the jerk 5000 intervals
  Loss loss = Loss::robust;
  std::optional<double> gap{};          ///< intervals longer than this [s] end a stretch, and the next one begins
  bool gyro = false;                    ///< the angular velocities of the recording are those of a gyro
  std::optional<double> gyro_noise{};   ///< σ per axis [rad/s], 1e-9 to 1e3
  std::optional<double> gyro_offset{};  ///< by which the stamps of the gyro are late [s]
  std::optional<GyroBias>
      gyro_bias{};  ///< absent: constant, unless the recording is clearly better explained by a walk
  std::optional<double> position_noise{};  ///< σ of the positions per axis [m], 1e-12 to 1e12
  bool adapt = true;  ///< let τ of the orientations vary in time where that predicts the samples clearly better; of no
                      ///< effect with `smoothing_time` or `gyro`, with which one τ serves the whole recording
  bool runs = true;   ///< bridge runs of frames in which joints of a skeleton jump away and back; one track has none
  std::vector<std::string> keep_contacts{};  ///< joints of a skeleton that stay where they stand on the ground; `auto`
                                             ///< alone: those that its legs end in; one track has none
  bool sigma = false;  ///< find the standard deviations of the smoothed orientations and rates too
};

/// How the weight of the penalty is chosen where nobody states it.
enum class SmoothingCriterion {
  gcv,   ///< generalised cross-validation (Craven and Wahba 1979): the noise may be unknown
  ubre,  ///< unbiased risk estimate (Mallows' C_p): the noise is what the weights say
  reml,  ///< restricted likelihood by Laplace's method: the noise, of the gyro too, is what the weights say
};

/// λ of least criterion.
struct LambdaChoice {
  double lambda = 0.0;
  enum class Edge {
    none,
    shortest,  ///< the least value stands at the shortest smoothing time: hardly any noise, or no motion to tell it
               ///< from
    longest,   ///< it stands at the longest one: as good as no motion
  } edge = Edge::none;
};

/// The unknowns: orientations and body rates, or positions, at the times of the recording.
struct SmoothedNodes {
  std::vector<Eigen::Quaterniond> orientations{};
  std::vector<Eigen::Vector3d> angular_velocities{};     ///< [rad/s]
  std::vector<Eigen::Vector3d> angular_accelerations{};  ///< [rad/s²]
  std::vector<Eigen::Vector3d> positions{};
  Eigen::Vector3d gyro_correction = Eigen::Vector3d::Zero();  ///< b [rad/s]: the gyro, b added, has no bias
  std::vector<Eigen::Vector3d> gyro_corrections{};            ///< those of a bias that drifts; b is their mean
  std::vector<Eigen::Vector3d> correlated_noises{};           ///< of orientations beside a gyro [rad], body frame
};

/// What the samples leave open of nodes: one standard deviation along each axis of the body.
struct NodeSigmas {
  static constexpr std::size_t within = 5;            ///< times within a step: its sixths
  std::vector<Eigen::Vector3d> orientations{};        ///< [rad], of a turn about that axis
  std::vector<Eigen::Vector3d> angular_velocities{};  ///< [rad/s]
  /// Of the turn on the way from each node to the next: the root of the mean square over the axes [rad]; of the last
  /// node of a stretch, its own.
  std::vector<std::array<double, within>> to_next{};
};

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
  std::vector<std::size_t> retained_outlier_runs{};   ///< as far away, and kept as motion
  SampleDistances distances{}, accepted_distances{};  ///< [m], to all samples, and to those that are not rejected

  /// The frequency at which the smoother's gain is one half [Hz].
  [[nodiscard]] std::optional<double> cutoff() const noexcept;
};

/// What became of a gyro.
struct GyroFinding {
  double noise = 0.0;                    ///< σ per axis [rad/s]
  double offset = 0.0;                   ///< by which its stamps are late [s], as stated or found
  std::optional<double> offset_sigma{};  ///< [s]; absent where it is stated, or the motion does not tell it
  std::optional<double> drift{};         ///< of a bias that drifts: σ per axis of its change in 1 s [rad/s]

  /// A value and its standard deviation.
  template <class Value>
  struct Found {
    Value value, sigma;
  };
  /// By which the rates of the axes are too large, as shares; absent where the recording does not tell.
  std::optional<Found<Eigen::Vector3d>> scale{};
  /// The turn of the sensor against the body [rad], a rotation vector; absent where the recording does not tell.
  std::optional<Found<Eigen::Vector3d>> mount{};
  /// Of the correction of the rates [rad/s²], which is that in the middle of the recording; absent where the recording
  /// does not tell, or the bias is stated to be constant.
  std::optional<Found<Eigen::Vector3d>> trend{};
  /// By which the clock runs fast, as a share; absent where the clock is that of the orientations or does not tell.
  std::optional<Found<double>> clock_rate{};

  /// The clock jumped ahead by so much at a rate, so that the stamps from there on were set back.
  struct ClockJump {
    std::size_t rate;
    double seconds;
  };
  std::vector<ClockJump> clock_jumps{};
  bool came_in_batches = false;         ///< its stamps, which were spread evenly
  std::array<bool, 3> unwound_axes{};   ///< whose counters came round
  std::array<bool, 3> dead_axes{};      ///< whose rates are all the same: the others count
  std::vector<std::size_t> rejected{};  ///< rates that do not count
  /// Root mean square of the error of the orientations that is to be expected [rad]: with the gyro, and without it.
  /// Absent where turns are counted, which nothing else can do.
  struct Risk {
    double with, without;
  };
  std::optional<Risk> risk{};
  bool used = false;  ///< else the orientations were smoothed without it, since they come out better so
  enum class Doubt {
    none,
    reach,                ///< too few orientations stand between its rates
    clock,                ///< its clock wanders or jumps
    rates,                ///< its rates are far noisier than neighbouring ones tell
    gain,                 ///< the orientations are hardly better known with it
  } doubt = Doubt::none;  ///< why it was left out
};

/// A smoothed recording.
struct ORISPLINE_EXPORT Smoothing {
  Track track{};  ///< the keys, with body rates ω and α, and smoothed positions
  Method method{smoothed_method};
  std::vector<std::size_t> keys{};     ///< of the recording, increasing: all but those left out
  std::vector<std::size_t> places{};   ///< of these keys in the track, where it has others too, of the gyro; else empty
  SmoothedNodes nodes{};               ///< at the times of these keys
  std::optional<NodeSigmas> sigmas{};  ///< of these nodes, where they were asked for
  std::vector<Stretch> stretches{};    ///< one, without gaps
  std::vector<std::size_t> samples_in_short_stretches{};  ///< keys of stretches too short to tell noise from motion
  double smoothing_time = 0.0;              ///< τ [s]; where it varies, its geometric mean over intervals
  std::vector<double> smoothing_times{};    ///< τ at every key [s], where it varies in time; else empty
  Penalty penalty = Penalty::acceleration;  ///< of the orientations
  double lambda = 0.0;                      ///< weight of the penalty against |r|²/σ²
  double noise = 0.0;        ///< σ of the orientations per axis [rad], estimated from the residuals, or as stated
  double local_noise = 0.0;  ///< estimated from neighbouring samples [rad]
  /// The noise of the orientations may be correlated in part: σ per axis of a first-order Markov process [rad], and the
  /// time within which its correlation falls to 1/e [s].
  struct CorrelatedNoise {
    double sigma, time;
  };
  std::optional<CorrelatedNoise> correlated_noise{};  ///< as stated, or found with a gyro or over the joints of a clip
  /// What could be hidden in the motion, where noise is taken for white and nothing but the motion could tell.
  std::optional<CorrelatedNoise> hidden_noise{};
  /// σ of every sample of the recording per axis [rad], by which they are weighed: as stated, or where it was found to
  /// change; else empty. `noise` is then that of a usual sample.
  std::vector<double> noises{};
  std::optional<double> degrees_of_freedom{};         ///< effective ones of the curve, 3 tr; absent with a gyro
  std::optional<GyroFinding> gyro{};                  ///< with a gyro
  std::vector<std::size_t> rejected{};                ///< samples that do not count
  std::vector<std::size_t> retained_outlier_runs{};   ///< samples as far away, kept as motion
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
  /// Where a key of the recording stands in the track, by its number in `keys`.
  [[nodiscard]] std::size_t place_of(std::size_t key) const { return places.empty() ? key : places[key]; }
  /// The shortest and the longest τ [s]; absent where it is the same everywhere.
  [[nodiscard]] std::optional<double> shortest_smoothing_time() const;
  [[nodiscard]] std::optional<double> longest_smoothing_time() const;
  /// The least and the largest of `noises` [rad]; absent where all samples count the same.
  [[nodiscard]] std::optional<double> least_noise_of_samples() const;
  [[nodiscard]] std::optional<double> largest_noise_of_samples() const;
  /// Root mean square over all keys and axes of the standard deviations of the orientations [rad]; absent without them.
  [[nodiscard]] std::optional<double> rms_sigma() const;
  /// Of the angular velocities [rad/s].
  [[nodiscard]] std::optional<double> rms_sigma_of_rates() const;
  /// Whether the curve through the keys is one through a stretch at this time [s], and neither over a gap nor beside
  /// all of them. Logarithmic time.
  [[nodiscard]] bool covers(double t) const;
};

/// Settings of a recording that state the noise of its samples one by one, per axis: `sigma` [rad] or `sigma_deg`, or
/// of the axes of the body `sigma_x`, … [rad] or `cov_xx`, … [rad²]. They weigh the samples.
inline constexpr std::array<std::string_view, 8> noise_columns{"sigma",   "sigma_deg", "sigma_x", "sigma_y",
                                                               "sigma_z", "cov_xx",    "cov_yy",  "cov_zz"};

/// Errors (bad_argument): numbers that are out of their range whatever the recording is, and options that contradict
/// each other: `noise` and `smoothing_time`, `gyro` and `gap`, `gyro_noise` without `gyro`.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const SmoothOptions& options);

/// Of the times that it is shown, the choice of τ sees about this many at most.
inline constexpr std::size_t most_times_for_choice = 10000;

/// A noisy recording as a smooth motion: orientations with body rates ω and α at its times, of which `hermite-c2` makes
/// a C2 curve; and positions, where it has some, by the smoothing spline of the same penalty.
///
/// The weight of the penalty follows from `smoothing_time`; else it is chosen: by GCV where nothing is known, by UBRE
/// where the noise is stated, by REML with a gyro. That of the positions is chosen in the same way, by themselves;
/// `position_noise` stands before `smoothing_time`. Errors: bad_data for too few samples (fewer than three in every
/// stretch, four for the jerk; so few beside the outliers), where no smooth motion is near to them or more than half of
/// them count as outliers, for a gyro without angular velocities and for one that contradicts the orientations, for a
/// noise of positions without any; those of check(); bad_argument for a smoothing time that does not suit the recording
/// and for a gap not longer than the median interval; not_converged; cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<Smoothing> smooth(const Track& recording, const SmoothOptions& options = {},
                                                          const Progress& progress = {});

/// The angular velocities of a recording, but for those that are free, as the rates of a gyro. Error (bad_data): there
/// are none.
[[nodiscard]] ORISPLINE_EXPORT Expected<GyroRates> gyro_rates_in(const Track& recording);

/// With the rates of a gyro that stand by themselves; those of the recording play no part. Keys of the result stand at
/// the times of the rates too, corrected where their clock is their own. Errors: those above, and bad_data for rates
/// that do not overlap the recording.
[[nodiscard]] ORISPLINE_EXPORT Expected<Smoothing> smooth(const Track& recording, const GyroRates& gyro,
                                                          const SmoothOptions& options, const Progress& progress = {});

template <>
inline constexpr std::array words<Penalty>{word("acceleration", Penalty::acceleration, "∫|α|² dt"),
                                           word("jerk", Penalty::jerk, "∫|dα/dt|² dt")};
template <>
inline constexpr std::array words<Loss>{word("robust", Loss::robust,
                                             "every sample counts, except that one or two are left out that lie "
                                             "farther than 5 σ from what those beside them predict"),
                                        word("l2", Loss::l2, "squares: every sample counts in full"),
                                        word("huber", Loss::huber, "Huber's loss: far samples count less"),
                                        word("tukey", Loss::tukey, "Tukey's loss: very far samples do not count")};
template <>
inline constexpr std::array words<GyroBias>{
    word("constant", GyroBias::constant, "the same at all times"),
    word("drifting", GyroBias::drifting, "a random walk, whose size is found with the rest")};
template <>
inline constexpr std::array words<SmoothingCriterion>{
    word("gcv", SmoothingCriterion::gcv, "generalised cross-validation"),
    word("ubre", SmoothingCriterion::ubre, "unbiased risk estimate from the given noise (UBRE)"),
    word("reml", SmoothingCriterion::reml, "restricted likelihood (REML)")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<SmoothOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Smoothing>() noexcept;

}}  // namespace orispline
