// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <orispline/clip/clip_difference.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/report/page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// A skeleton with its clips, and what the page calls them, such as the name of a file.
struct NamedClips {
  std::string name;
  const Skeleton& skeleton;
  std::span<const Clip> clips;
};

/// A clip in both motions: places in the lists of clips, and when they are compared.
struct ClipPair {
  std::size_t before = 0, after = 0;
  std::vector<double> times{};  ///< [s], increasing, one at least
};

/// What the lengths of a file are.
struct PageLengths {
  double metres = 1.0;           ///< in one unit of the file
  bool are_known = true;         ///< false: they are shown as they are, without a unit
  double shell = default_shell;  ///< of the shell distance, in the unit of the file
};

/// The page to look at of two motions of a skeleton, clip by clip, those that are farthest from each other in the world
/// first. Joints go by their names. The pairs are compared as differences() does, on up to that many threads; 0 means
/// one per core.
///
/// Of a clip 300 times are shown at most, of up to ten clips 600 each: of more the largest errors of every few.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage skeleton_page(const NamedClips& before, const NamedClips& after,
                                                                  std::span<const ClipPair> pairs,
                                                                  const PageLengths& lengths, const PageHead& head,
                                                                  unsigned threads = 0);

/// The page of clips that were reduced by reduce_clips(), as many as there were before, compared at their keys.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage reduced_clips_page(const NamedClips& before, std::string after,
                                                                       std::span<const ClipReduction> reductions,
                                                                       const ClipReduceOptions& options,
                                                                       const PageLengths& lengths, const PageHead& head,
                                                                       unsigned threads = 0);

}}}  // namespace orispline::pages
