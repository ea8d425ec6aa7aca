// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <orispline/align/align.hpp>
#include <orispline/fields/json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

struct AlignRequest {
  std::shared_ptr<const Track> moved, fixed;
  AlignOptions options{};
};

/// What brings one recording onto the other, and the recording there.
struct AlignOutcome {
  AlignRequest request;
  Alignment alignment;
  Track aligned;
  std::vector<Warning> warnings{};
};

/// Errors: those of orispline::align().
[[nodiscard]] ORISPLINE_EXPORT Expected<AlignOutcome> align(AlignRequest request, const Progress& progress = {});

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const AlignOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const AlignOutcome& outcome);
/// What summary_of() says, in one line without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const AlignOutcome& outcome);

}}}  // namespace orispline::jobs
