// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/fields/json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// A curve that is to be the motion of the only joint of a clip for a glTF file.
struct CurveClipRequest {
  std::string name{};    ///< of the clip
  std::string source{};  ///< name of the keys' file
  std::string method{};
  std::size_t keys = 0;  ///< of the curve
  /// Absent: samples; else cubics that are nowhere farther from the curve [rad] and its path [m].
  std::optional<double> tolerance{};
  double position_tolerance = 0.0;
  std::vector<double> sample_times{};  ///< increasing [s]
};

/// The clip, and what was asked for.
struct CurveClipOutcome {
  CurveClipRequest request;
  Clip clip{};
  double largest = 0.0, largest_position = 0.0;  ///< distances of the cubics in single precision [rad], [m]
  std::vector<Warning> warnings{};               ///< of distances that are above their tolerance
  std::string written_to{};                      ///< where the clip is, in words
};

[[nodiscard]] ORISPLINE_EXPORT CurveClipOutcome curve_clip(CurveClipRequest request, const PoseCurve& curve);

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const CurveClipOutcome& outcome);
/// A few lines for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const CurveClipOutcome& outcome);

}}}  // namespace orispline::jobs
