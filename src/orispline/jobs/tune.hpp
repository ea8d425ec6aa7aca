// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <orispline/fields/json.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/tune/tune.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

[[nodiscard]] ORISPLINE_EXPORT bool has_tensions(const FamilyInfo& family);
inline constexpr UsualMethod usual_tuned{"timed-c2", has_tensions};

struct TuneRequest {
  std::shared_ptr<const Track> keys;
  ChosenMethod method{};
  std::shared_ptr<const Track> reference{};  ///< a dense recording, for the objective `fit`
  TuneOptions options{};                     ///< their reference is the one above
};

/// Keys with the best tensions, and what was asked for.
struct ORISPLINE_EXPORT TuneOutcome {
  TuneRequest request;
  Tuning tuning;
  std::vector<Warning> warnings{};  ///< of the request's method and of the tuning

  /// At the keys, of a parameter that was varied.
  [[nodiscard]] const std::vector<double>& values(const std::string& parameter) const;
};

/// Errors: those of orispline::tune(), with their places.
[[nodiscard]] ORISPLINE_EXPORT Expected<TuneOutcome> tune(TuneRequest request, const Progress& progress = {});

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const TuneOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const TuneOutcome& outcome);

}}}  // namespace orispline::jobs
