// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <orispline/fields/json.hpp>
#include <orispline/smooth/clip_smoothing.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct Page;
struct SkeletonPage;
}
namespace pages {
struct PageHead;
}

namespace jobs {

struct SmoothRequest {
  std::shared_ptr<const Track> recording;
  SmoothOptions options{};
  std::shared_ptr<const GyroRates> gyro{};  ///< null: with `gyro` they are the angular velocities of the recording
};

/// A smooth motion, and what was asked for.
struct ORISPLINE_EXPORT SmoothOutcome {
  SmoothRequest request;
  Smoothing smoothing;
  std::vector<Warning> warnings{};       ///< of the smoothing, with their places in the recording
  std::string mended{};                  ///< what was mended in the recording, in words
  std::optional<std::size_t> samples{};  ///< of the curve that are the result; absent: its keys are

  /// `5 keys`, or of samples so many.
  [[nodiscard]] std::string result() const;
};

/// Errors: those of orispline::smooth(), with their places.
[[nodiscard]] ORISPLINE_EXPORT Expected<SmoothOutcome> smooth(SmoothRequest request, const Progress& progress = {});

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const SmoothOutcome& outcome);
/// A page for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const SmoothOutcome& outcome);
/// In one line, without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const SmoothOutcome& outcome);
/// With ORISPLINE_PAGE; the warnings stand above all else that it says.
[[nodiscard]] ORISPLINE_EXPORT report::Page page_of(const SmoothOutcome& outcome, pages::PageHead head);

struct SmoothClipsRequest {
  std::string name{};  ///< of their file
  Skeleton skeleton{};
  std::vector<Clip> clips{};
  SmoothOptions options{};
  unsigned threads = 0;      ///< 0: one per core
  bool has_no_unit = false;  ///< of length, the file; else it is the metre
};

/// Clips of a skeleton with their joints smoothed, and what was asked for.
struct SmoothClipsOutcome {
  SmoothClipsRequest request;
  std::vector<ClipSmoothing> clips;
  std::vector<Warning> warnings{};  ///< one of all rotations that cannot be smoothed
};

/// Errors: those of orispline::smooth_clips(), with the name of the file.
[[nodiscard]] ORISPLINE_EXPORT Expected<SmoothClipsOutcome> smooth_clips(SmoothClipsRequest request);

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const SmoothClipsOutcome& outcome);
/// A few lines for people; of a single clip one for every joint.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const SmoothClipsOutcome& outcome);
/// With ORISPLINE_PAGE; the warnings stand above all else that it says. `after`: what the page calls the smoothed
/// clips, such as the name of a file.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage page_of(const SmoothClipsOutcome& outcome, std::string after,
                                                            pages::PageHead head);

}  // namespace jobs

}}  // namespace orispline
