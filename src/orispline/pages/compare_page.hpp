// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/analysis/compared_method.hpp>
#include <orispline/pages/page_head.hpp>
#include <orispline/report/page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// Methods on sets of keys, with what they were compared with.
struct ComparedCurves {
  std::span<const ComparedMethod> methods;  ///< one at least; those on the first set of keys stand first
  RecordedMotion recording;
  Decimal epoch{};                           ///< of all times [s]
  std::vector<std::string> key_sets{};       ///< their names: the columns of all but the first say them
  std::vector<std::string> named{};          ///< labels of the methods that somebody asked for by name, in that order
  std::vector<MeasureInfo> measures{};       ///< that were taken
  std::string_view sorted_by{};              ///< the word of one of them; empty: as the methods stand
  std::optional<Eigen::Matrix3d> inertia{};  ///< [kg m²]: torques are shown too
};

/// The page to look at: the curves through the first set of keys, the measures on all sets. On up to `threads` threads;
/// 0: one per core.
///
/// At first it shows the default method beside the first one that was named, else beside that of the widely used
/// splines which stands last. Without the default method the best one takes its place.
[[nodiscard]] ORISPLINE_EXPORT report::Page compare_page(const ComparedCurves& compared, const PageHead& head,
                                                         unsigned threads = 0);

}}}  // namespace orispline::pages
