// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/analysis/distance.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/stretches.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/fields/field_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far a curve may be from every sample of a recording.
struct Tolerance {
  double angle;                                               ///< of the rotation from one to the other [rad]
  double position = std::numeric_limits<double>::infinity();  ///< distance [m]

  [[nodiscard]] bool bounds_positions() const noexcept { return position < std::numeric_limits<double>::infinity(); }
};

/// How far a curve is from the samples of a recording, at the worst of them.
struct Deviation {
  double angle = 0.0;                ///< [rad]
  std::size_t angle_at = 0;          ///< index of the sample
  std::optional<double> position{};  ///< [m]; absent where the recording has no positions
  std::size_t position_at = 0;       ///< index of the sample
};

/// What may become of the keys that are chosen among the samples.
enum class KeyValues {
  sampled,  ///< they are samples
  refitted  ///< they are moved where that saves keys; their times are those of samples
};

/// How keys are sought.
struct ReduceOptions {
  Tolerance tolerance;
  KeyValues values = KeyValues::sampled;
};

/// Keys whose curve reproduces a recording.
struct Reduction {
  Track track{};                       ///< the keys, at times of the recording
  Method method{};                     ///< of the curve through them, with its settings for these keys
  std::vector<std::size_t> samples{};  ///< the recording's, at whose times the keys stand
  Deviation deviation{};               ///< of the curve from all samples: not above the tolerance
  std::vector<Stretch> stretches{};    ///< of the keys, where the recording states gaps; empty: one
};

/// The methods that are tried where none is asked for; of equally few keys the first one's are taken.
inline constexpr std::array<std::string_view, 3> reducing_methods{"auto", "timed-c2", "slerp"};

/// The fewest keys found whose curve is within the tolerance of every sample, the first and the last sample's times
/// among theirs. Settings of the method or of the recording that have a value per sample are those of the keys chosen.
///
/// `slerp` by breadth-first search: no chain of geodesics through fewer samples will do. `hermite-c1` with the rates of
/// its keys, which are sought too and are part of them. Its rates are estimated instead where positions are bounded,
/// where keys are refitted, and in its cumulative form. Other local methods by insertion of the worst samples and
/// pruning, which is near to the optimum but has no bound. The deviation is taken anew from the finished keys by the
/// curve's own evaluator at every sample. Positions without a tolerance are carried along. Source: docs/reduce.md.
/// Errors: bad_argument for a method that is unknown, not local, does not pass through its keys, is a loop or needs
/// more than two keys, and for a tolerance that is not greater than the rounding of orientations (1e-12 rad) or of
/// positions; bad_data for fewer than two samples; cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<Reduction> reduce(const Track& recording, const Method& method,
                                                          const ReduceOptions& options, const Progress& progress = {});

/// Every one of the tracks by each of the methods, in their order, on up to that many threads; 0 means one per core.
/// The results are the same on any number of them.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Expected<std::vector<Reduction>>> reduce_tracks(
    std::span<const Track> tracks, std::span<const Method> methods, const ReduceOptions& options, unsigned threads = 0,
    const Progress& progress = {});

/// The curve through the keys, in their stretches. Errors: those of make_pose_curve().
[[nodiscard]] ORISPLINE_EXPORT Expected<PoseCurve> curve_of(const Reduction& reduction);

/// How far the curve through the keys is from samples at times of its own, such as those of the recording before it was
/// smoothed: the full angle of the rotation from one to the other [rad]. Those at the rising indices `left_out` do not
/// count; `largest_at` is an index of the samples.
[[nodiscard]] ORISPLINE_EXPORT Expected<DistanceStatistics> distance_of(const Reduction& reduction,
                                                                        const Keyframes& samples,
                                                                        std::span<const std::size_t> left_out = {});

/// The same of positions: how far the curve is from those of samples [m]. Precondition: keys and samples have some.
[[nodiscard]] ORISPLINE_EXPORT Expected<DistanceStatistics> position_distance_of(
    const Reduction& reduction, const Keyframes& samples, std::span<const std::size_t> left_out = {});

/// What tells their methods from each other: labels_of() these.
[[nodiscard]] ORISPLINE_EXPORT std::vector<std::string> labels_of(std::span<const Reduction> reductions);

/// The index of the one with the fewest keys, of equals the first.
[[nodiscard]] ORISPLINE_EXPORT std::size_t smallest(std::span<const Reduction> reductions);

template <>
inline constexpr std::array words<KeyValues>{
    word("sampled", KeyValues::sampled, "Every key is a sample"),
    word("refit", KeyValues::refitted, "Keys are moved off the samples where that saves keys")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<ReduceOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Reduction>() noexcept;

}}  // namespace orispline
