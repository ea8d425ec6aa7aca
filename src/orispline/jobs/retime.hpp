// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <orispline/fields/json.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct Page;
}
namespace pages {
struct PageHead;
}

namespace jobs {

/// Rates at the keys would change with the times.
[[nodiscard]] ORISPLINE_EXPORT bool takes_no_rates(const FamilyInfo& family) noexcept;
inline constexpr UsualMethod usual_retimed{default_method, takes_no_rates};

struct RetimeRequest {
  std::shared_ptr<const Track> keys;
  ChosenMethod method{};  ///< where nobody names one, the body stands still between equal keys
  RetimeOptions options{};
};

/// Keys at later times, and what was asked for.
struct ORISPLINE_EXPORT RetimeOutcome {
  RetimeRequest request;
  Retiming retiming;
  std::vector<Warning> warnings{};  ///< of the request's method and of the retiming

  [[nodiscard]] double duration_before() const;  ///< [s]
  [[nodiscard]] std::vector<Certificate> certificates() const;
};

/// Errors: those of orispline::retime(), with their places.
[[nodiscard]] ORISPLINE_EXPORT Expected<RetimeOutcome> retime(RetimeRequest request, const Progress& progress = {});

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const RetimeOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const RetimeOutcome& outcome);
/// What summary_of() says, in one line without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const RetimeOutcome& outcome);
/// With ORISPLINE_PAGE.
[[nodiscard]] ORISPLINE_EXPORT report::Page page_of(const RetimeOutcome& outcome, const pages::PageHead& head);

}  // namespace jobs

}}  // namespace orispline
