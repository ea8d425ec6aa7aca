// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include <orispline/align/rate_alignment.hpp>
#include <orispline/fields/json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// A recording of orientations, or of a gyro.
using Recording = std::variant<std::shared_ptr<const Track>, std::shared_ptr<const GyroTrack>>;

/// One of the two at least is of a gyro.
struct RateAlignRequest {
  Recording moved, fixed;
  AlignOptions options{};
};

/// What brings one recording onto the other by rates, and the recording there.
struct RateAlignOutcome {
  RateAlignRequest request;
  RateAlignment alignment;
  std::variant<Track, GyroTrack> aligned;
  std::vector<Warning> warnings{};
};

/// Errors: those of orispline::align(); bad_argument for two recordings of orientations.
[[nodiscard]] ORISPLINE_EXPORT Expected<RateAlignOutcome> align_rates(RateAlignRequest request,
                                                                      const Progress& progress = {});

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const RateAlignOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const RateAlignOutcome& outcome);
/// What summary_of() says, in one line without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const RateAlignOutcome& outcome);

}}}  // namespace orispline::jobs
