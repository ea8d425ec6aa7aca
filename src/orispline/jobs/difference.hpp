// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/clip/clip_difference.hpp>
#include <orispline/fields/json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct SkeletonPage;
}
namespace pages {
struct PageHead;
}

namespace jobs {

/// The clips of a skeleton, and the file that they are from.
struct MotionFile {
  std::string name{};  ///< for people
  Skeleton skeleton{};
  std::vector<Clip> clips{};
  bool has_no_unit = false;        ///< of length; else it is the metre
  std::string_view format{};       ///< with its article: `a BVH file`; empty where it is not known
  std::string_view title{};        ///< of the format: `glTF`
  std::string next_tool{};         ///< that the file comes from or goes through, where that compresses keys; else empty
  bool is_single_precise = false;  ///< times and values are in single precision
  bool is_sampled = false;         ///< the keys are frames of a motion: the file does not say what lies between them
};

/// Clips that have the same name are the same, and so is the only clip of both files; joints go by counterparts_of().
struct DifferenceRequest {
  MotionFile first{}, second{};
  double shell = default_shell;  ///< in the unit of the files
  std::optional<double> rate{};  ///< look between keys too: at so many times per second [Hz], and beside the largest
                                 ///< differences until nothing rises; absent: at the keys of the first only
  unsigned threads = 0;          ///< at most so many at work; 0: one per core
};

/// How far two motions of a clip are from each other.
struct ClipDifference {
  std::size_t first = 0, second = 0;     ///< which of the clips of each file
  std::vector<double> times{};           ///< of keys and of the rate, at which they were compared [s]
  std::vector<std::size_t> joints{};     ///< of the first skeleton, those that are in both files
  std::vector<JointDifference> worst{};  ///< of each of them
};

/// How far the motions of two files are from each other, and what was asked for.
struct ORISPLINE_EXPORT DifferenceOutcome {
  DifferenceRequest request;
  std::vector<ClipDifference> clips{};
  std::vector<std::string> only_in_first{}, only_in_second{};  ///< names of clips
  std::vector<std::size_t> guessed_clips{};  ///< of the first file, which others of the same name could have been
  Counterparts counterparts{};
  std::vector<Warning> warnings{};  ///< of clips and joints that were matched by a guess

  [[nodiscard]] const std::string& name_of(const ClipDifference& clip) const;
  /// As people are told it.
  [[nodiscard]] std::string name_of_joint(std::size_t joint) const;
};

/// Errors: bad_data where no clip is in both files, bad_argument for a rate with too many times.
[[nodiscard]] ORISPLINE_EXPORT Expected<DifferenceOutcome> difference(DifferenceRequest request);

/// Described in docs/skeletons.md.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const DifferenceOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const DifferenceOutcome& outcome);
/// With ORISPLINE_PAGE. Notes of the head stand before those of the page.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage page_of(const DifferenceOutcome& outcome,
                                                            const pages::PageHead& head);

}  // namespace jobs

}}  // namespace orispline
