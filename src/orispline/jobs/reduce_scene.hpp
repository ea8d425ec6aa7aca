// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/reduce/clip_totals.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct SkeletonPage;
}
namespace pages {
struct PageHead;
}

namespace jobs {

/// Where clips come from, as far as it tells what their numbers are.
struct ClipFile {
  std::string name{};              ///< for people
  std::string_view format{};       ///< with its article: `a BVH file`
  bool has_no_unit = false;        ///< of length; else it is the metre
  bool is_single_precise = false;  ///< times and values are in single precision
};

/// Clips that are to go into a glTF file.
struct ReduceSceneRequest {
  ClipFile file{};
  Skeleton skeleton{};
  std::vector<Clip> clips{};
  ClipReduceOptions options{};             ///< lengths in metres; the precisions follow from the file
  std::optional<double> position_scale{};  ///< metres in the unit of length of the file; absent: 1
  unsigned threads = 0;                    ///< at most so many at work; 0: one per core
};

/// Clips with fewer keys, and what was asked for.
struct ORISPLINE_EXPORT ReduceSceneOutcome {
  ReduceSceneRequest request;
  ClipReduceOptions options{};  ///< as they were used: lengths in the unit of the file
  std::vector<ClipReduction> reductions{};
  std::vector<Warning> warnings{};

  [[nodiscard]] ClipTotals totals() const;
  /// The clips, in their order.
  [[nodiscard]] std::vector<Clip> clips() const;
  /// In the unit of length of the file; lengths are shown in metres.
  [[nodiscard]] double metres() const;
  /// Whether lengths are; else they are shown in the unit of the file, which is not known.
  [[nodiscard]] bool knows_metres() const;
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
/// The same in one, without an end.
[[nodiscard]] ORISPLINE_EXPORT std::string line_of(const ReduceSceneOutcome& outcome);
/// With ORISPLINE_PAGE. `after`: what the page calls the clips with fewer keys, such as the name of a file.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage page_of(const ReduceSceneOutcome& outcome, std::string after,
                                                            const pages::PageHead& head);

}  // namespace jobs

}}  // namespace orispline
