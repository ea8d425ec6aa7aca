// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <orispline/curve/track.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/mean/mean.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// The setting of rows that is their weight.
inline constexpr std::string_view weight_name = "weight";

struct MeanRequest {
  std::shared_ptr<const Track> rows;  ///< their setting `weight` weighs them, where they have it
  MeanOptions options{};
  bool has_times = true;  ///< of its own, else they are numbers of rows
};

/// The mean of rows, or of each window in time, and what was asked for.
struct ORISPLINE_EXPORT MeanOutcome {
  MeanRequest request;
  std::vector<MeanWindow> windows;  ///< one at least
  std::string mended{};             ///< what was mended in the rows, in words
  std::vector<Warning> warnings{};  ///< of a kind that several windows have, that of the first one

  [[nodiscard]] bool is_weighted() const;
  /// The means at the middles of their windows, with positions where the rows have them.
  [[nodiscard]] Track track() const;
};

/// Errors: those of orispline::mean_in_windows(), with their places.
[[nodiscard]] ORISPLINE_EXPORT Expected<MeanOutcome> mean(MeanRequest request);

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const MeanOutcome& outcome);
/// A few lines for people; of several windows one for each.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const MeanOutcome& outcome);
/// In one line, without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const MeanOutcome& outcome);

}}}  // namespace orispline::jobs
