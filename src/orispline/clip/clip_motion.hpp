// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/clip/clip.hpp>
#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/frame_change.hpp>
#include <orispline/curve/knots.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The value of a channel over time. Before its first key and after its last one it stands still.
///
/// `cubicspline` of rotations is the cubic Hermite polynomial of the four components, normalised, with the signs of the
/// file: q = s/|s|. Where s passes through 0, as between opposite keys at rest, q is not a number. `linear` of
/// rotations is slerp the shorter way, whatever the signs. Source: glTF 2.0, section 3.11 and appendix C.
template <CurvePoint P>
class ORISPLINE_EXPORT ChannelCurve {
 public:
  /// Precondition: check_clip() finds the channel sound.
  explicit ChannelCurve(const Channel<P>& channel);
  /// Of a joint that moves as any curve says.
  ChannelCurve(std::size_t joint, ErasedCurve<P> curve);

  [[nodiscard]] std::size_t joint() const noexcept { return joint_; }
  [[nodiscard]] const Knots& knots() const noexcept { return curve_.knots(); }
  [[nodiscard]] P at(double t) const noexcept;
  /// With its rates at time t [s]; at an interior key of the segment after it.
  [[nodiscard]] MotionOf<P> motion(double t) const noexcept;
  [[nodiscard]] const ErasedCurve<P>& curve() const noexcept { return curve_; }
  /// The same curve for another joint; it shares its keys.
  [[nodiscard]] ChannelCurve of_joint(std::size_t joint) const noexcept {
    ChannelCurve other = *this;
    other.joint_ = joint;
    return other;
  }

 private:
  ErasedCurve<P> curve_;
  P last_;  ///< the value from the last key on, where a step ends
  std::size_t joint_;
};

extern template class ChannelCurve<Eigen::Quaterniond>;
extern template class ChannelCurve<Eigen::Vector3d>;

/// A skeleton that moves as a clip says: where its joints are at any time. Refers to the skeleton. Evaluation allocates
/// nothing.
class ORISPLINE_EXPORT ClipMotion {
 public:
  /// Precondition: check_clip() finds the clip sound.
  ClipMotion(const Skeleton& skeleton, const Clip& clip);
  ClipMotion(Skeleton&&, const Clip&) = delete;
  /// Of a joint there is at most one curve in each list.
  ClipMotion(const Skeleton& skeleton, std::vector<ChannelCurve<Eigen::Quaterniond>> rotations,
             std::vector<ChannelCurve<Eigen::Vector3d>> translations,
             std::vector<ChannelCurve<Eigen::Vector3d>> scales);

  [[nodiscard]] const Skeleton& skeleton() const noexcept { return *skeleton_; }
  /// In the frame of its parent at time t [s].
  [[nodiscard]] JointPose local_pose(std::size_t joint, double t) const noexcept;
  /// What of that does not depend on the time; the rest pose of what does.
  [[nodiscard]] const JointPose& still_pose(std::size_t joint) const noexcept { return still_[joint]; }
  /// From every joint's frame to that of the world at time t [s], into as many places as there are joints. With scales,
  /// negative and uneven ones too, this need not be a rigid motion.
  void world_poses(double t, std::span<Eigen::Affine3d> poses) const noexcept;
  /// The same, and every joint in the frame of its parent.
  void poses(double t, std::span<JointPose> local, std::span<Eigen::Affine3d> world) const noexcept;
  /// A joint's frame in that of the world, where its pose in the frame of its parent and the parent's in the world are
  /// known.
  [[nodiscard]] Eigen::Affine3d placed(std::size_t joint, const JointPose& pose,
                                       std::span<const Eigen::Affine3d> world) const noexcept;
  /// That of one joint, to rounding.
  [[nodiscard]] Eigen::Affine3d world_pose(std::size_t joint, double t) const noexcept;

 private:
  /// Places of the joint's curves that move, one more than their index; 0 where it has none.
  struct Places {
    std::size_t rotation = 0, translation = 0, scale = 0;
  };

  const Skeleton* skeleton_;
  std::vector<JointPose> still_;  ///< of every joint what does not move
  std::vector<ChannelCurve<Eigen::Quaterniond>> rotations_;
  std::vector<ChannelCurve<Eigen::Vector3d>> translations_, scales_;
  std::vector<Places> places_;
};

/// From every joint's frame to that of the world at each of the times [s]: those of the first time, then the next.
[[nodiscard]] ORISPLINE_EXPORT std::vector<Eigen::Affine3d> world_poses(const Skeleton& skeleton, const Clip& clip,
                                                                        std::span<const double> times);

/// What a joint's motion is seen from.
enum class JointSpace {
  local,  ///< the frame of its parent
  world,
};

/// The motion of one joint as its clip says it, with exact rates: its knots are the keys of the channels that move it.
/// What it is seen from is the world whose frame may change, the joint is the body.
///
/// Errors: bad_data for a scale above the joint, in the world, that is negative or not the same along all axes, below
/// which there is no orientation; those of check(change).
[[nodiscard]] ORISPLINE_EXPORT Expected<PoseCurve> joint_curve(const Skeleton& skeleton, const Clip& clip,
                                                               std::size_t joint, JointSpace space,
                                                               const FrameChange& change = {});

}}  // namespace orispline
