// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/clip/clip_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How far the points that a joint is judged by are from it, in the skeleton's unit of length: 3 cm in metres.
inline constexpr double default_shell = 0.03;

/// The largest of some values, and when it is reached.
struct LargestInTime {
  double value = 0.0;
  double time = 0.0;  ///< [s]

  void take(double other, double t) noexcept {
    if (other > value) value = other, time = t;
  }
};

/// How far a joint of one motion is from the same joint of another one, where that is farthest.
struct JointDifference {
  LargestInTime angle{};        ///< between the rotations in the frames of the parents [rad]
  LargestInTime translation{};  ///< between the translations in the frames of the parents
  LargestInTime distance{};     ///< the shell distance in the world
};

/// Whether motions are compared at the times alone, or also between them, beside the largest differences until nothing
/// rises: what is found is the largest there is if the times are dense enough to show where it is. Of all joints, or of
/// the one where each difference is largest: what the others have is the largest at the times.
enum class Between { nothing, looked_at, looked_at_for_largest };

/// The largest distance in the world between the same points of a joint at two places: the joint itself, and those that
/// are `shell` off it along each of its axes.
[[nodiscard]] double shell_distance(const Eigen::Affine3d& a, const Eigen::Affine3d& b, double shell);

/// Of every joint of the first skeleton, over the times [s], rising, at least one. `counterparts` are the joints of the
/// second skeleton that are the same ones (`Counterparts::joints`), `no_parent` for those that are not there, which do
/// not count.
///
/// The shell distance tells how far a skin that hangs on the joint is off.
/// Source: N. Frechette, the Animation Compression Library (ACL).
[[nodiscard]] ORISPLINE_EXPORT std::vector<JointDifference> differences(
    const ClipMotion& first, const ClipMotion& second, std::span<const std::size_t> counterparts,
    std::span<const double> times, double shell = default_shell, Between between = Between::nothing);

/// All times of keys of a clip [s], rising, each once.
[[nodiscard]] ORISPLINE_EXPORT std::vector<double> key_times(const Clip& clip);

/// Which joints of two skeletons are the same ones.
struct Counterparts {
  std::vector<std::size_t> joints{};  ///< per joint of the first skeleton that of the second; `no_parent` for none
  std::size_t only_in_first = 0, only_in_second = 0;
  /// Joints of the first skeleton that the second has elsewhere in the tree, found by their names.
  std::vector<std::size_t> by_name{};
  /// Joints of the first skeleton that could have been others of the same name; the order in the files decided.
  std::vector<std::size_t> guessed{};
};

/// By the path in the tree: from the roots down, those below counterparts that have the same name. Of several of one
/// name there, those with the same rest pose and the same joints below. What is left is found by its name alone.
///
/// The order of joints in the skeletons says nothing, unless nothing else tells some of them apart.
[[nodiscard]] ORISPLINE_EXPORT Counterparts counterparts_of(const Skeleton& first, const Skeleton& second);

}}  // namespace orispline
