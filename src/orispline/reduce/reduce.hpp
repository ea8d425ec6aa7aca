// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/analysis/distance.hpp>
#include <orispline/reduce/tolerance_check.hpp>

namespace orispline {

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
  std::string_view method{};           ///< of the curve
  std::vector<std::size_t> samples{};  ///< the recording's, at whose times the keys stand
  Keyframes keys;
  Deviation deviation{};  ///< of the curve from all samples: not above the tolerance
};

/// The methods that are tried where none is asked for; of equally few keys the first one's are taken.
inline constexpr std::array<std::string_view, 3> reducing_methods{"auto", "timed-c2", "slerp"};

/// The fewest keys found whose curve, with the method's default parameters, is within the tolerance of every sample;
/// the first and the last sample's times among theirs.
///
/// `slerp` by breadth-first search: no chain of geodesics through fewer samples will do. Other local methods by
/// insertion of the worst samples and pruning, which is near to the optimum but has no bound. The deviation is taken
/// anew from the finished keys by the curve's own evaluator at every sample. Positions without a tolerance are carried
/// along. Source: docs/reduce.md.
/// Errors: bad_argument for a method that is unknown, not local or does not pass through its keys, and for a tolerance
/// that is not greater than the rounding of orientations (1e-12 rad) or of positions; bad_data for fewer than two
/// samples.
[[nodiscard]] Expected<Reduction> reduce(std::string_view method, const Keyframes& recording,
                                         const ReduceOptions& options);

/// The same by each of the methods, in their order, on as many threads.
[[nodiscard]] Expected<std::vector<Reduction>> reduce_by_each(std::span<const std::string_view> methods,
                                                              const Keyframes& recording, const ReduceOptions& options);

/// Every one of the tracks by each of the methods, in their order, on up to that many threads; 0 means one per core.
/// The results are the same on any number of them.
[[nodiscard]] std::vector<Expected<std::vector<Reduction>>> reduce_tracks(std::span<const std::string_view> methods,
                                                                          std::span<const Keyframes> tracks,
                                                                          const ReduceOptions& options,
                                                                          unsigned threads = 0);

/// How far the curve through the keys is from samples at times of its own, such as those of the recording before it was
/// smoothed: the full angle of the rotation from one to the other [rad]. Those at the rising indices `left_out` do not
/// count; `largest_at` is an index of the samples.
[[nodiscard]] Expected<DistanceStatistics> distance_of(const Reduction& reduction, const Keyframes& samples,
                                                       std::span<const std::size_t> left_out = {});

/// The index of the one with the fewest keys, of equals the first.
[[nodiscard]] std::size_t smallest(std::span<const Reduction> reductions);

}  // namespace orispline
