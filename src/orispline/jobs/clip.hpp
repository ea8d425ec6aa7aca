// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/edit/clip_edits.hpp>
#include <orispline/edit/seam.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/jobs/difference.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace report {
struct SkeletonPage;
}
namespace pages {
struct PageHead;
}

namespace jobs {

struct ClipRequest {
  MotionFile file{};
  ClipEdits edits{};
  // Names of joints; empty: none.
  std::string root{};                    ///< whose way a loop keeps, and goes on in an appended clip
  std::string extract_root{};            ///< whose way goes into a node above it
  std::string root_node{};               ///< that one; empty: the topmost one, which is made where there is none
  std::string in_place{};                ///< whose way is taken out
  std::optional<MotionFile> appended{};  ///< with the clip that is appended
  std::string append_clip{};             ///< its name; empty: the only one
  unsigned threads = 0;                  ///< at most so many at work; 0: one per core
};

/// Clips of a skeleton with their edits, and what was asked for.
struct ClipOutcome {
  ClipRequest request;              ///< with the joint that was made
  std::string made_root{};          ///< its name; empty: none was
  std::vector<ClipEdit> clips{};    ///< of each
  std::vector<ClipSeam> seams{};    ///< of each, as it is written
  std::vector<Warning> warnings{};  ///< of what could not be edited with them
};

/// Errors: bad_data, with the name of the file, for a file without clips and for a joint that is not there; those of
/// edited().
[[nodiscard]] ORISPLINE_EXPORT Expected<ClipOutcome> clip(ClipRequest request);

/// The steps of a seam with the joints that take them.
[[nodiscard]] ORISPLINE_EXPORT Json json_of(const ClipSeam& seam, const Skeleton& skeleton);
/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const ClipOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const ClipOutcome& outcome);
/// With ORISPLINE_PAGE: the clips as they are now. `after`: what the page calls them, such as the name of a file.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage page_of(const ClipOutcome& outcome, std::string after,
                                                            pages::PageHead head);

}  // namespace jobs

}}  // namespace orispline
