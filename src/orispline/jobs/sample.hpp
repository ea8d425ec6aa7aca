// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/analysis/distance.hpp>
#include <orispline/curve/extrapolation.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/jobs/align.hpp>
#include <orispline/jobs/curve_of_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// How far a curve is from a recording of the true motion, between the first key and the last.
struct TruthDistance {
  std::string recording;
  DistanceStatistics distance;
  Decimal largest_time;                     ///< in the recording's own time [s], where it is not aligned
  std::optional<AlignOutcome> alignment{};  ///< of the recording with the keys
};
[[nodiscard]] ORISPLINE_EXPORT TruthDistance distance_to_truth(const PoseCurve& curve, const Track& keys,
                                                               const Track& truth);
/// To the recording as align() brings it onto the keys. Errors: of align().
[[nodiscard]] ORISPLINE_EXPORT Expected<TruthDistance> distance_to_aligned_truth(const PoseCurve& curve,
                                                                                 std::shared_ptr<const Track> keys,
                                                                                 std::shared_ptr<const Track> truth);

/// What was sampled, of keys in memory, of keys that came in pieces, or of a joint; the samples are elsewhere.
struct SampleOutcome {
  std::string source{};  ///< name of the keys' file
  std::string method{}, method_text{};
  std::size_t keys = 0;
  KeyframeReport keyframes{};
  std::size_t rate_orders = 0;                ///< of the keys' own rates that the curve has
  bool inner_quaternions = false;             ///< whether it has the keys' own
  Decimal start{}, end{};                     ///< of the curve, in the file's own time [s]
  std::size_t samples = 0, held_samples = 0;  ///< in all, and outside the curve
  bool leaves_out = false;                    ///< samples outside the curve, which are not among `samples`
  std::size_t gap_samples = 0;                ///< in gaps of the keys
  bool marks_gaps = false;                    ///< these have empty rows; else they are not among `samples`
  Extrapolation extrapolation = Extrapolation::hold;
  std::optional<KeyFindings> findings{};  ///< by the method `measured`
  std::optional<double> band{};           ///< the share of the true motion that it is meant to hold
  std::size_t without_band = 0;           ///< samples at which it is infinite, since the keys say nothing
  std::optional<TruthDistance> truth{};
  std::string mended{};      ///< what was mended in the keys, in words
  std::string written_to{};  ///< where the samples are, in words; empty: in memory
};

/// Whether the method `measured` could say how noisy the keys are, which are sampled with the usual one.
[[nodiscard]] ORISPLINE_EXPORT bool could_be_measured(const SampleOutcome& outcome);

/// All but the samples.
[[nodiscard]] ORISPLINE_EXPORT SampleOutcome outcome_of(const Track& keys, const Method& method,
                                                        const CurveOfKeys& shaped);

/// Described in docs/inspect-json.md, but for the names of files and the warnings. Members that only the reader knows
/// go to their places: those of the columns that samples have, and of what was mended.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const SampleOutcome& outcome, Json of_columns, Json of_repairs);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const SampleOutcome& outcome);
/// What summary_of() says, in one line without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const SampleOutcome& outcome);

}}}  // namespace orispline::jobs
