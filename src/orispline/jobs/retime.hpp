// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <orispline/clip/motion_file.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/retime/clip_retiming.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct Page;
struct SkeletonPage;
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

struct RetimeClipsRequest {
  MotionFile file{};
  Method method{default_method};
  RetimeOptions options{};
  unsigned threads = 0;  ///< at most so many at work; 0: one per core
};

/// Clips of a skeleton at later times, each on a clock that all its joints share, and what was asked for.
struct ORISPLINE_EXPORT RetimeClipsOutcome {
  RetimeClipsRequest request;
  std::vector<ClipRetiming> clips{};
  std::vector<Warning> warnings{};

  [[nodiscard]] std::vector<Certificate> certificates(std::size_t clip) const;
};

/// What is wrong before there is a clip. Errors (bad_argument): those of check_for_clips(), and limits of lengths for a
/// file without a unit.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const RetimeClipsRequest& request);

/// Errors: those of check() and of retime_clip(), with the name of the file; bad_data for a file without clips.
[[nodiscard]] ORISPLINE_EXPORT Expected<RetimeClipsOutcome> retime_clips(RetimeClipsRequest request,
                                                                         const Progress& progress = {});

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const RetimeClipsOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const RetimeClipsOutcome& outcome);
/// With ORISPLINE_PAGE: the clips as they are now. `after`: what the page calls them, such as the name of a file.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage page_of(const RetimeClipsOutcome& outcome, std::string after,
                                                            pages::PageHead head);

}  // namespace jobs

}}  // namespace orispline
