// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orispline/base/better.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

using orispline::Better;

/// The body that the page shows in space.
enum class PageBody { aircraft, box, axes };

/// A measure: one column of the page's table.
struct PageColumn {
  std::string id;             ///< the key of `PageMethod::measures`
  std::string label;          ///< the head of the column, such as `RMS`
  std::string unit{};         ///< such as `deg` or `rad²/s³`; empty: a pure number
  std::string explanation{};  ///< one sentence, shown where the cursor rests on the head
  Better better = Better::less;
  bool is_time = false;   ///< a moment of the motion [s], as its times are: shown as a clock, and a way to that moment
  double rounding = 0.0;  ///< values that are not larger are rounding errors: shown as 0
};

/// A unit in which a quantity of the plots is shown instead of the page's own.
struct PageUnit {
  std::string name;   ///< `°/s`
  double size = 1.0;  ///< in the page's own unit
};

/// Orientations over time; as many of each. One of NaN stands for a gap: there is nothing between its neighbours.
struct PagePath {
  std::vector<double> times{};                     ///< [s]; a time twice: the left side of a jump, then the right one
  std::vector<Eigen::Quaterniond> orientations{};  ///< body to world
};

/// Keyframes that a method was given.
struct PageKeys {
  PagePath path{};
  std::vector<Eigen::Vector3d> positions{};  ///< [m], world; none or as many as keys
};

/// A curve sampled so densely that straight lines between the samples show it: a few hundred are enough.
struct PageSamples {
  PagePath path{};
  std::vector<Eigen::Vector3d> angular_velocities{};     ///< [rad/s], body; as many as times
  std::vector<Eigen::Vector3d> angular_accelerations{};  ///< [rad/s²], body; as many as times
  std::vector<Eigen::Vector3d> angular_jerks{};          ///< [rad/s³], body; as many as times
  std::vector<Eigen::Vector3d> torques{};                ///< [N m], body; none or as many as times
  std::vector<Eigen::Vector3d> positions{};              ///< [m], world; none or as many as times
  std::vector<double> error_times{};                     ///< [s], they do not decrease; empty: those of the path
  std::vector<double> errors{};  ///< [deg], angle to the reference; none or as many as times; NaN where it has no value
};

/// A band in a plot, behind its lines: from `low` to `high`, as many as times. One of NaN ends the band before it.
struct PageBand {
  std::string label;            ///< such as `one standard deviation`
  std::vector<double> times{};  ///< [s]
  std::vector<double> low{}, high{};
};

/// What one method did.
struct PageMethod {
  std::string name;
  std::string continuity{};  ///< in time on these keys, such as `C2`
  std::string failure{};     ///< one line that says why there is no curve; empty: there is one
  std::map<std::string, double, std::less<>> measures{};  ///< by the id of the column; absent or not finite: a dash
  PageSamples samples{};                                  ///< empty where the method failed
  std::optional<PageKeys> keys{};                         ///< its own; absent: those of the page
  std::map<std::string, PageBand, std::less<>>
      bands{};  ///< in plots, by the words of Page::limits and by `angle` [deg]
};

/// Orientations that stand out, such as outliers: marked on the sphere and in the plots of angles.
struct PageMarks {
  std::string label;  ///< such as `rejected`
  PagePath path{};
  std::vector<double> errors{};  ///< [deg], angle to the first method; as many as times
};

/// Everything that the page of a report shows: plain data, in the order in which it is shown.
struct Page {
  std::string title{};
  std::string command{};             ///< the command line that makes this page again
  std::string date{};                ///< of the making, as it is to be read
  std::string version{};             ///< of orispline
  std::string time_start{};          ///< the input's own time at t = 0, as text; empty: it is 0
  std::vector<std::string> notes{};  ///< sentences of the head, such as what is left out
  PageBody body = PageBody::aircraft;
  PageKeys keys{};                      ///< of every method that has none of its own
  std::optional<PagePath> reference{};  ///< what the methods are compared with
  std::optional<PageMarks> marks{};
  /// Lines in the plots: by `error` [deg], `w` [rad/s], `a` [rad/s²], `j` [rad/s³] or `torque` [N m].
  std::map<std::string, double, std::less<>> limits{};
  /// Of plots and their limits, by the same words; absent: the unit above.
  std::map<std::string, PageUnit, std::less<>> units{};
  std::vector<PageColumn> columns{};
  std::string sorted_by{};  ///< id of the column by which the table is sorted at first; empty: as the methods stand
  std::string first{}, second{};  ///< names of the methods that are shown at first; empty: the first two with samples
  std::vector<PageMethod> methods{};
};

/// The page as one HTML file that needs nothing else, no network either.
///
/// Numbers are rounded to 7 significant digits. The text may hold any characters; what is not UTF-8 shows as U+FFFD.
/// The content of the embedded JSON is described in studio/report/README.md. 38 methods of 600 samples make about 4 MB.
/// Not in a build without ORISPLINE_PAGE; the JSON alone (page_json.hpp) is in every build.
[[nodiscard]] ORISPLINE_EXPORT std::string document(const Page& page);

}}}  // namespace orispline::report
