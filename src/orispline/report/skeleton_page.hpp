// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

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

/// How far a joint of a clip is off, and its keys.
struct PageJointErrors {
  std::vector<double> angles{};     ///< [deg], in the frame of the parent; as many as times of errors
  std::vector<double> distances{};  ///< in the world; as many as times of errors
  PageLargest angle{}, distance{};  ///< of all times, those that are not shown too
  PageKeyCounts keys{};             ///< of its rotation
  std::vector<double> key_times{};  ///< [s], of the rotation after
};

/// A clip in both motions. Straight lines between its times show it.
struct PageClip {
  std::string name;
  double start = 0.0, end = 0.0;  ///< [s]
  PageKeyCounts rotation_keys{}, translation_keys{};
  std::vector<double> times{};            ///< [s], of the positions; increasing
  std::vector<Eigen::Vector3d> before{};  ///< in the world: all joints at the first time, then at the next
  std::vector<Eigen::Vector3d> after{};   ///< likewise; of joints that are not compared those before
  std::vector<double> error_times{};      ///< [s]; increasing
  std::vector<PageJointErrors> joints{};  ///< as many as the skeleton has
};

/// The axis of the world that points up.
enum class PageUp { y, z };

/// Everything that the page of a skeleton shows, which moves in two ways: plain data. Lengths have one unit.
struct SkeletonPage {
  std::string title{};
  std::string command{};             ///< the command line that makes this page again
  std::string date{};                ///< of the making, as it is to be read
  std::string version{};             ///< of orispline
  std::vector<std::string> notes{};  ///< sentences of the head, such as what is left out
  std::string before{}, after{};     ///< what the two motions are called, such as the names of files
  std::string length_unit{};         ///< such as `mm`; empty: not known
  double shell = 0.0;                ///< how far the points are off a joint that it is judged by in the world
  PageUp up = PageUp::y;
  std::optional<double> angle_limit{};     ///< a line in the plot of angles [deg]
  std::optional<double> distance_limit{};  ///< a line in the plot of distances
  std::vector<PageJoint> joints{};
  std::vector<PageClip> clips{};  ///< in the order in which they are shown, the first one at first
};

/// The page as one HTML file that needs nothing else, no network either.
///
/// Positions are rounded to an eight thousandth of what the clip takes up, their differences and errors to a five
/// hundredth of the largest. 76 clips of 54 joints with 40 times each make about 4 MB. Texts as in document(const
/// Page&). Not in a build without ORISPLINE_PAGE; the JSON alone (skeleton_page_json.hpp) is in every build.
[[nodiscard]] ORISPLINE_EXPORT std::string skeleton_document(const SkeletonPage& page);

}}}  // namespace orispline::report
