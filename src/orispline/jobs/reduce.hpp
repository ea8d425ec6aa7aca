// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/clip/motion_file.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct SkeletonPage;
}
namespace pages {
struct PageHead;
}

namespace jobs {

struct ReduceRequest {
  std::vector<std::shared_ptr<const Track>> recordings;
  std::vector<Method> methods{reducing_methods.begin(), reducing_methods.end()};  ///< of which the best is taken
  ReduceOptions options{};
  std::optional<SmoothOptions> smoothing{};  ///< of every recording before; absent: they are reduced as they are
  unsigned threads = 0;                      ///< at most so many at work; 0: one per core
};

/// What was done to a recording before, and how far the chosen curve is from it as it was [rad] and its path [m],
/// samples that were rejected apart.
struct SmoothedFirst : SmoothOutcome {
  DistanceStatistics raw{};
  std::optional<DistanceStatistics> raw_positions{};  ///< where there are positions
};

/// A recording with the reductions by each of the methods.
struct ORISPLINE_EXPORT ReduceOutcome {
  std::shared_ptr<const Track> recording;
  ReduceOptions options{};
  std::vector<Reduction> reductions{};
  std::optional<SmoothedFirst> smoothed{};
  std::vector<Warning> warnings{};
  std::string mended{};  ///< what reading mended, as clauses: only the reader knows

  /// The one with the fewest keys.
  [[nodiscard]] const Reduction& chosen() const;
  /// The recording that was reduced: the smoothed one, where that was asked for.
  [[nodiscard]] const Track& reduced() const;
};

/// Of each recording. Errors: those of orispline::smooth() and orispline::reduce(), with their places, the recording's
/// number among several in `curve`; bad_data for a tolerance of positions without any.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Expected<ReduceOutcome>> reduce(const ReduceRequest& request,
                                                                           const Progress& progress = {});

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const ReduceOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const ReduceOutcome& outcome);
/// What summary_of() says, in one line without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const ReduceOutcome& outcome);
/// With ORISPLINE_PAGE.
[[nodiscard]] ORISPLINE_EXPORT report::Page page_of(const ReduceOutcome& outcome, const pages::PageHead& head);

/// Where clips come from, as far as it tells what their numbers are.
struct ClipFile {
  std::string name{};  ///< for people
  ClipFormat format{};
  std::string next_tool{};  ///< that it comes from or goes through, where that compresses keys; else empty
};

/// Clips that are to go into a glTF file.
struct ReduceSceneRequest {
  ClipFile file{};
  Skeleton skeleton{};
  std::vector<Clip> clips{};
  ClipReduceOptions options{};             ///< lengths in metres; the precisions follow from the file
  std::optional<double> position_scale{};  ///< metres in the unit of length of the file, which is taken to metres
  unsigned threads = 0;                    ///< at most so many at work; 0: one per core
};

/// Clips with fewer keys, and what was asked for.
struct ORISPLINE_EXPORT ReduceSceneOutcome {
  ReduceSceneRequest request;   ///< with lengths in metres where a scale was stated
  ClipReduceOptions options{};  ///< as they were used
  std::vector<ClipReduction> reductions{};
  std::vector<Warning> warnings{};

  [[nodiscard]] ClipTotals totals() const;
  /// The clips, in their order.
  [[nodiscard]] std::vector<Clip> clips() const;
};

/// What is wrong before there is a clip. Errors (bad_argument): those of orispline::check(), and tolerances of lengths
/// for a file without a unit.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const ReduceSceneRequest& request);

/// Errors: those of check() and of reduce_clips(), with the name of the file.
[[nodiscard]] ORISPLINE_EXPORT Expected<ReduceSceneOutcome> reduce_scene(ReduceSceneRequest request);

/// Described in docs/skeletons.md, but for the names and sizes of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const ReduceSceneOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const ReduceSceneOutcome& outcome);
/// What summary_of() says, in one line without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const ReduceSceneOutcome& outcome);
/// With ORISPLINE_PAGE. `after`: what the page calls the clips with fewer keys, such as the name of a file.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage page_of(const ReduceSceneOutcome& outcome, std::string after,
                                                            const pages::PageHead& head);

}  // namespace jobs

}}  // namespace orispline
