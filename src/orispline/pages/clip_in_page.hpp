// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <orispline/clip/clip_difference.hpp>
#include <orispline/report/page.hpp>

// One clip of the page of a skeleton.

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// A clip of a skeleton.
struct ClipOf {
  const Skeleton& skeleton;
  const Clip& clip;
  const ClipMotion* motion = nullptr;  ///< in the place of what the clip says
};

/// How two motions of a clip are compared.
struct ClipComparison {
  std::span<const std::size_t> counterparts;  ///< of the joints before: the same ones after, or `no_parent`
  std::span<const double> times;              ///< [s], increasing, one at least
  double shell = default_shell;
  std::size_t most = 600;          ///< times that are shown, at least 3
  std::span<const double> keys{};  ///< some of the times, with the first: each stands for those up to the next
};

/// The clip in both motions as a page shows it, lengths in the unit of the skeletons, at the keys or, without these, at
/// all times. Of more than `most` times those
/// are shown where the shell distance is the largest of so many neighbours; the angles and distances there are the
/// largest of these neighbours too. Where times are far apart there are positions between them.
[[nodiscard]] report::PageClip clip_in_page(const ClipOf& before, const ClipOf& after,
                                            const ClipComparison& comparison);

/// The clip alone, compared with where it begins. The counterparts are the joints themselves.
[[nodiscard]] report::PageClip clip_alone_in_page(const ClipOf& shown, const ClipComparison& comparison);

}}}  // namespace orispline::pages
