// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/fields/quantity.hpp>
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

/// A curve sampled so densely that what is drawn between the samples shows it: of orientations the cubic with the
/// angular velocities at both ends (Kim, Kim & Shin 1995), of all else straight lines.
struct PageSamples {
  PagePath path{};
  std::vector<Eigen::Vector3d> angular_velocities{};     ///< [rad/s], body; as many as times
  std::vector<Eigen::Vector3d> angular_accelerations{};  ///< [rad/s²], body; as many as times
  std::vector<Eigen::Vector3d> angular_jerks{};          ///< [rad/s³], body; as many as times
  std::vector<Eigen::Vector3d> torques{};                ///< [N m], body; none or as many as times
  std::vector<Eigen::Vector3d> positions{};              ///< [m], world; none or as many as times
  std::vector<double> error_times{};                     ///< [s], they do not decrease; empty: those of the path
  std::vector<double> errors{};  ///< [deg], angle to the reference; none or as many as times; NaN where it has no value
  bool is_straight = false;      ///< orientations go the shortest way between samples, since their rates are noise
  std::optional<double> exactness{};  ///< [deg], the largest angle found between curve and drawing; absent: not known
};

/// A band in a plot, behind its lines: from `low` to `high`, as many as times. One of NaN ends the band before it.
struct PageBand {
  std::string label;            ///< such as `one standard deviation`
  std::vector<double> times{};  ///< [s]
  std::vector<double> low{}, high{};
};

/// When a method is at the places where the others are: both times rise, straight lines are between them.
struct PageClock {
  std::vector<double> times{};  ///< [s], of the page
  std::vector<double> own{};    ///< [s], of the method; as many
};

/// What one method did.
struct PageMethod {
  std::string name;
  std::string continuity{};  ///< in time on these keys, such as `C2`
  std::string failure{};     ///< one line that says why there is no curve; empty: there is one
  std::map<std::string, double, std::less<>> measures{};  ///< by the id of the column; absent or not finite: a dash
  PageSamples samples{};                                  ///< empty where the method failed
  std::optional<PageKeys> keys{};                         ///< its own; absent: those of the page
  std::optional<PageClock> clock{};                       ///< that its bodies move by; absent: that of the page
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
  std::string command{};                ///< the command line that makes this page again
  std::string date{};                   ///< of the making, as it is to be read
  std::string version{};                ///< of orispline
  std::string time_start{};             ///< the input's own time at t = 0, as text; empty: it is 0
  std::vector<std::string> notes{};     ///< sentences of the head, such as what is left out
  PageBody body = PageBody::box;        ///< which says nothing of what moves; what is shown at first
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
/// Numbers of long lists are rounded to single precision, rates and errors to half of it. The text may hold any
/// characters; what is not UTF-8 shows as U+FFFD. The content of the embedded JSON is described in
/// studio/report/README.md. A sample takes 51 bytes beside the 760 kB of the page. Not in a build without
/// ORISPLINE_PAGE; the JSON alone (page_json.hpp) is in every build.
[[nodiscard]] ORISPLINE_EXPORT std::string document(const Page& page);

/// The JSON document in it, for a viewer that is given its data.
[[nodiscard]] ORISPLINE_EXPORT std::string data_of(const Page& page);

/// What every page runs, for a notebook: an ES module, whose default export is the widget of studio/widget, and its
/// style.
struct PageModule {
  std::string script, style;
};

/// That of the pages that this library makes. Not in a build without ORISPLINE_PAGE.
[[nodiscard]] ORISPLINE_EXPORT PageModule page_module();

/// A joint of the skeleton that a page shows.
struct PageJoint {
  std::string name;
  std::optional<std::size_t> parent{};  ///< its index, which is smaller; absent: it has none
  bool is_compared = true;              ///< whether both motions have it; else it is shown before only
};

/// A number of keys in both motions.
struct PageKeyCounts {
  std::size_t before = 0, after = 0;
};

/// The largest of some values, and when it is reached.
struct PageLargest {
  double value = 0.0;
  double time = 0.0;  ///< [s]
};

/// How far a joint of a clip is off, and its keys. Of one motion: from where the clip begins.
struct PageJointErrors {
  std::vector<double> angles{};     ///< [deg], in the frame of the parent; as many as times of errors
  std::vector<double> distances{};  ///< in the world; as many as times of errors
  PageLargest angle{}, distance{};  ///< of all times, those that are not shown too
  PageKeyCounts keys{};             ///< of its rotation
  /// [s], that are marked: of the rotation after, or of the only motion; where it was smoothed, of what was rejected.
  std::vector<double> key_times{};
};

/// A clip in one motion or in both. Straight lines between its times show it.
struct PageClip {
  std::string name;
  double start = 0.0, end = 0.0;  ///< [s]
  PageKeyCounts rotation_keys{}, translation_keys{};
  std::vector<double> times{};            ///< [s], of the positions; increasing
  std::vector<Eigen::Vector3d> before{};  ///< in the world: all joints at the first time, then at the next
  std::vector<Eigen::Vector3d> after{};   ///< in that order; of joints not compared those before; empty for one motion
  std::vector<double> error_times{};      ///< [s]; increasing
  std::vector<PageJointErrors> joints{};  ///< as many as the skeleton has
};

/// The axis of the world that points up.
enum class PageUp { y, z };

/// Everything that the page of a skeleton shows, which moves in one way or in two: plain data. Lengths have one unit.
struct SkeletonPage {
  std::string title{};
  std::string command{};             ///< the command line that makes this page again
  std::string date{};                ///< of the making, as it is to be read
  std::string version{};             ///< of orispline
  std::vector<std::string> notes{};  ///< sentences of the head, such as what is left out
  std::string before{}, after{};  ///< what the motions are called, such as the names of files; `after` empty: only one
  std::string length_unit{};      ///< such as `mm`; empty: not known
  double shell = 0.0;             ///< how far the points are off a joint that it is judged by in the world
  PageUp up = PageUp::y;
  std::optional<double> angle_limit{};     ///< a line in the plot of angles [deg]
  std::optional<double> distance_limit{};  ///< a line in the plot of distances
  std::vector<PageJoint> joints{};
  std::vector<PageClip> clips{};  ///< in the order in which they are shown, the first one at first
};

/// The page as one HTML file that needs nothing else, no network either.
///
/// Positions are rounded to an eight thousandth of what the clip takes up, their differences to a five hundredth of the
/// largest, and errors to a power of ten that is not more than that. 76 clips of 54 joints with 40 times each make
/// about 4 MB. Texts as in document(const Page&). Not in a build without ORISPLINE_PAGE; the JSON alone (page_json.hpp)
/// is in every build.
[[nodiscard]] ORISPLINE_EXPORT std::string skeleton_document(const SkeletonPage& page);

}}}  // namespace orispline::report
