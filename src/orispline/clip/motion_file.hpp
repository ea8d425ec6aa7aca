// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What the format of a file tells of the clips in it.
struct ClipFormat {
  std::string_view title{};   ///< what people call it: `glTF`
  std::string_view file{};    ///< with its article: `a BVH file`; empty where the format is not known
  bool has_no_unit = false;   ///< its files do not say in what their lengths are; others: in metres
  bool holds_floats = false;  ///< times and values are in single precision
  bool is_sampled = false;    ///< its keys are frames of a motion: it does not say what lies between them
};

/// The clips of a skeleton, and the file that they are from.
struct MotionFile {
  std::string name{};  ///< for people
  Skeleton skeleton{};
  std::vector<Clip> clips{};
  ClipFormat format{};
  std::string next_tool{};  ///< that it comes from or goes through, where that compresses keys; else empty
};

/// The file with its lengths in metres: of the rest pose and of all clips, and with a format that says so.
///
/// `metres`: in the unit of length of the file. Errors (bad_argument of `position_scale`): a number that is not finite
/// and above 0, a file whose lengths are in metres already.
[[nodiscard]] ORISPLINE_EXPORT Expected<MotionFile> in_metres(MotionFile file, double metres);

/// What in_metres() refuses, before there are clips.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check_metres(const ClipFormat& format, double metres);

/// A warning where lengths of a file without a unit are taken for metres, and the skeleton at rest would be less than
/// 0.3 m or more than 3 m large then, along the axis of the world along which it is largest. It names the scale that
/// makes it as large as a person, if one of a usual unit does. In a file with a unit all sizes are meant.
///
/// `metres`: in the unit of the file, by what was stated; 1 where nothing was. `made`: the file that gets them.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Warning> warnings_of_height(const Skeleton& skeleton,
                                                                       const ClipFormat& format, double metres,
                                                                       const std::string& made);

}}  // namespace orispline
