// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <orispline/curve/track.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/mean/mean.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// The setting of rows that is their weight.
inline constexpr std::string_view weight_name = "weight";

/// Where the rows of one of several files begin among all.
struct RowsOfFile {
  std::string name;
  std::size_t first;
};

struct MeanRequest {
  std::shared_ptr<const Track> rows;  ///< their setting `weight` weighs them, where they have it
  MeanOptions options{};
  bool has_times = true;            ///< of its own, else they are numbers of rows
  std::vector<RowsOfFile> files{};  ///< where the rows are of several; else they are of one
};

/// The mean of the rows of several files, one at least, which are one set without times.
///
/// Errors: bad_data for positions and weights that some have and others have not; bad_argument for windows in time.
[[nodiscard]] ORISPLINE_EXPORT Expected<MeanRequest> mean_of_all(std::span<const Track> files,
                                                                 const MeanOptions& options);

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
