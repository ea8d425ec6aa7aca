// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/analysis/compared_keys.hpp>
#include <orispline/base/abi.hpp>
#include <orispline/clip/clip_difference.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/report/page.hpp>
#include <orispline/retime/retime.hpp>
#include <orispline/smooth/clip_smoothing.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// What a page says about its making, which only the caller knows.
struct PageHead {
  std::string title{};               ///< in the place of the one that the page gives itself; empty: that one
  std::string command{};             ///< the command line that makes the page again
  std::string date{};                ///< of the making, as it is to be read
  std::vector<std::string> notes{};  ///< sentences that stand before those of the page, such as warnings
};

/// The page to look at of one curve: its motion with the keys, and the measures of its shape. With an inertia [kg m²]
/// its torques are shown and measured too. Errors: those of make_pose_curve().
[[nodiscard]] ORISPLINE_EXPORT Expected<report::Page> motion_page(const Track& track, const Method& method,
                                                                  const PageHead& head,
                                                                  const std::optional<Eigen::Matrix3d>& inertia = {});

/// A method on the keys of a page: its curve, or why there is none.
struct MethodOnKeys {
  std::string name;  ///< unlike those beside it
  Expected<PoseCurve> curve;
  Seam seam = Seam::open;
};

/// The page to look at of methods on the same keys, one at least, as motion_page() has one.
[[nodiscard]] ORISPLINE_EXPORT report::Page keys_page(const Track& track, std::span<const MethodOnKeys> methods,
                                                      const PageHead& head,
                                                      const std::optional<Eigen::Matrix3d>& inertia = {});

/// Whether the truth of a page is that of one of its curves.
enum class Truth { known, unknown };

/// A curve of any making, with the keys that it is for.
struct NamedCurve {
  std::string name;  ///< unlike those beside it
  Keyframes keys;
  PoseCurve curve;
  Truth truth = Truth::known;
};

/// The page to look at of curves side by side, one at least, each with its own keys, with the measures of their shapes.
/// With a truth, orientations over time, it has the angles to it of all of which it is the truth. Its title is that of
/// the head.
[[nodiscard]] ORISPLINE_EXPORT report::Page curves_page(std::span<const NamedCurve> curves, const PageHead& head,
                                                        const Keyframes& truth = {});

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
  std::optional<double> gap{};               ///< of the recording: intervals longer than this [s] have no motion
};

/// The page to look at: the curves through the first set of keys, the measures on all sets. On up to `threads` threads;
/// 0: one per core.
///
/// At first it shows the default method beside the first one that was named, else beside that of the widely used
/// splines which stands last. Without the default method the best one takes its place.
[[nodiscard]] ORISPLINE_EXPORT report::Page compare_page(const ComparedCurves& compared, const PageHead& head,
                                                         unsigned threads = 0);

/// The page to look at: the smoothed motion beside the recording as it was read.
[[nodiscard]] ORISPLINE_EXPORT report::Page smooth_page(const Track& recording, const Smoothing& smoothing,
                                                        const PageHead& head);

/// The page to look at: the recording that was reduced, and the curves of all reductions, one at least, the smallest
/// first. `smoothing_time`: that the recording was smoothed with before [s].
[[nodiscard]] ORISPLINE_EXPORT report::Page reduce_page(const Track& recording, std::span<const Reduction> reductions,
                                                        const ReduceOptions& options, const PageHead& head,
                                                        std::optional<double> smoothing_time = std::nullopt);

/// The page to look at: the motion as it was and as it is slowed, with the limits.
[[nodiscard]] ORISPLINE_EXPORT report::Page retime_page(const Track& before, const Retiming& retiming,
                                                        const MotionLimits& limits, const PageHead& head);

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
  bool are_known = true;         ///< false: they are shown as they are, without a unit
  double shell = default_shell;  ///< of the shell distance, in the unit of the file
};

/// The page to look at of two motions of a skeleton, clip by clip, those that are farthest from each other in the world
/// first. Joints go by counterparts_of(). The pairs are compared as differences() does, on up to that many threads; 0
/// means one per core.
///
/// Of a clip 300 times are shown at most, of up to ten clips 600 each: of more the largest errors of every few.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage skeleton_page(const NamedClips& before, const NamedClips& after,
                                                                  std::span<const ClipPair> pairs,
                                                                  const PageLengths& lengths, const PageHead& head,
                                                                  unsigned threads = 0);

/// The page of clips alone, in their order, with how far their joints get from where a clip begins; without any clip
/// the rest pose.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage scene_page(const NamedClips& scene, const PageLengths& lengths,
                                                               const PageHead& head, unsigned threads = 0);

/// The page of clips that were smoothed by smooth_clips(), as many as there were before, compared at their keys.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage smoothed_clips_page(const NamedClips& before, std::string after,
                                                                        std::span<const ClipSmoothing> smoothings,
                                                                        const PageLengths& lengths,
                                                                        const PageHead& head, unsigned threads = 0);

/// The page of clips that were reduced by reduce_clips(), as many as there were before, compared at all times at which
/// reduce_clips() looked, and where it found them farthest apart.
[[nodiscard]] ORISPLINE_EXPORT report::SkeletonPage reduced_clips_page(const NamedClips& before, std::string after,
                                                                       std::span<const ClipReduction> reductions,
                                                                       const ClipReduceOptions& options,
                                                                       const PageLengths& lengths, const PageHead& head,
                                                                       unsigned threads = 0);

}}}  // namespace orispline::pages
