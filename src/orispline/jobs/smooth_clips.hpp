// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/fields/json.hpp>
#include <orispline/smooth/clip_smoothing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

struct SmoothClipsRequest {
  std::string name{};  ///< of their file
  Skeleton skeleton{};
  std::vector<Clip> clips{};
  SmoothOptions options{};
  unsigned threads = 0;  ///< 0: one per core
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

}}}  // namespace orispline::jobs
