// SPDX-License-Identifier: Apache-2.0
#include <orispline/edit/root_motion.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/edit/channel_path.hpp>
#include <orispline/edit/up_axis.hpp>
#include <orispline/math/rotation_matrix.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double straight_within = 1e-4;  // [rad], and as a share of the extent of a path
constexpr int most_halvings_of_steps = 8;
constexpr double even_scale = 1e-5;

/// Keys of a joint in the frame of its parent.
struct Poses {
  std::vector<double> times{};
  std::vector<Eigen::Quaterniond> rotations{};
  std::vector<Eigen::Vector3d> translations{};
};

/// A rigid motion of the world, or that in a frame whose unit of length is another one.
Eigen::Affine3d within(const Eigen::Affine3d& frame, const Eigen::Affine3d& motion) {
  return frame.inverse() * motion * frame;
}

class RootMotionChange {
 public:
  RootMotionChange(const Skeleton& skeleton, const Clip& clip, const RootMotion& motion)
      : skeleton_(skeleton), clip_(clip), options_(motion), moving_(skeleton, clip) {
    const double start = clip.domain().start;
    start_rotation_ = world_rotation(start);
    start_ = moving_.world_pose(motion.joint, start).translation();
  }

  Expected<Clip> made() {
    if (auto sound = check(); !sound) return tl::unexpected(std::move(sound.error()));
    Clip changed = clip_;
    put(changed, options_.joint, keys_of(options_.joint, [this](double t) { return in_joint(t); }));
    if (options_.node != no_parent)
      put(changed, options_.node, keys_of(options_.node, [this](double t) { return in_node(t); }));
    return changed;
  }

 private:
  [[nodiscard]] Expected<void> check() const {
    const auto fault = [&](std::size_t joint, std::string_view found) {
      return failure(ErrorCode::bad_data, formatted("{}: {}", place_of(skeleton_, clip_, joint), found));
    };
    bool is_above = options_.node == no_parent;
    for (std::size_t joint = skeleton_[options_.joint].parent; joint != no_parent; joint = skeleton_[joint].parent) {
      is_above = is_above || joint == options_.node;
      const VectorChannel* const scales = channel_of(clip_.scales, joint);
      const auto is_even = [](const Eigen::Vector3d& v) {
        return v.minCoeff() > 0.0 && v.maxCoeff() - v.minCoeff() <= even_scale * v.maxCoeff();
      };
      const Eigen::Vector3d* uneven = is_even(skeleton_[joint].rest.scale) ? nullptr : &skeleton_[joint].rest.scale;
      if (scales) {
        const auto found = std::ranges::find_if_not(scales->values, is_even);
        uneven = found == scales->values.end() ? nullptr : &*found;
      }
      if (uneven)
        return fault(joint,
                     formatted("found scale {:.4g}, {:.4g}, {:.4g}, wanted one above 0 that is the same along "
                               "all axes, above joint {}; apply the scale where the file was made",
                               uneven->x(), uneven->y(), uneven->z(), in_quotes(skeleton_.shown_name(options_.joint))));
    }
    if (is_above) return {};
    return fault(options_.node, formatted("found it not above joint {}, wanted one above it, which can carry it",
                                          in_quotes(skeleton_.shown_name(options_.joint))));
  }

  /// Of a pose with one scale along all axes.
  static Eigen::Quaterniond rotation_of(const Eigen::Affine3d& pose) {
    const Eigen::Matrix3d unit = pose.linear() / pose.linear().col(0).norm();
    return quaternion_from_matrix(unit).normalized();
  }

  /// Of the joint, whatever its own scale.
  [[nodiscard]] Eigen::Quaterniond world_rotation(double t) const {
    return rotation_of(frame_above(options_.joint, t)) * moving_.local_pose(options_.joint, t).rotation;
  }

  /// From the start of the clip to a time, in the world.
  [[nodiscard]] Eigen::Affine3d way(double t) const {
    const double heading = heading_of(options_.up, world_rotation(t) * start_rotation_.conjugate());
    const Eigen::Quaterniond turn = exp<double>(Eigen::Vector3d(heading * options_.up));
    const Eigen::Vector3d to = moving_.world_pose(options_.joint, t).translation() - turn * start_;
    Eigen::Affine3d way = Eigen::Affine3d::Identity();
    way.linear() = turn.toRotationMatrix();
    way.translation() = to - options_.up * options_.up.dot(to);
    return way;
  }

  [[nodiscard]] Eigen::Affine3d frame_above(std::size_t joint, double t) const {
    const std::size_t parent = skeleton_[joint].parent;
    return parent == no_parent ? Eigen::Affine3d::Identity() : moving_.world_pose(parent, t);
  }

  [[nodiscard]] JointPose moved(std::size_t joint, double t, const Eigen::Affine3d& by) const {
    JointPose pose = moving_.local_pose(joint, t);
    pose.rotation = (rotation_of(by) * pose.rotation).normalized();
    pose.translation = by * pose.translation;
    return pose;
  }
  [[nodiscard]] JointPose in_joint(double t) const {
    return moved(options_.joint, t, within(frame_above(options_.joint, t), way(t).inverse()));
  }
  [[nodiscard]] JointPose in_node(double t) const {
    return moved(options_.node, t, within(frame_above(options_.node, t), way(t)));
  }

  /// Of all channels that move the joint in the world.
  [[nodiscard]] std::vector<double> times() const {
    std::vector<double> times{clip_.domain().start, clip_.domain().end};
    for (std::size_t joint = options_.joint; joint != no_parent; joint = skeleton_[joint].parent) {
      if (const auto* const channel = channel_of(clip_.rotations, joint))
        times.insert(times.end(), channel->times.begin(), channel->times.end());
      if (const auto* const channel = channel_of(clip_.translations, joint))
        times.insert(times.end(), channel->times.begin(), channel->times.end());
    }
    std::ranges::sort(times);
    times.erase(std::unique(times.begin(), times.end()), times.end());
    return times;
  }

  /// How far the joint goes, in the unit of another one's parent.
  [[nodiscard]] double extent_for(std::size_t joint, const std::vector<double>& all) const {
    constexpr double none = 1e-9;
    Eigen::AlignedBox3d box;
    for (const double t : all) box.extend(moving_.world_pose(options_.joint, t).translation());
    const double unit = frame_above(joint, all.front()).linear().col(0).norm();
    return std::max(box.diagonal().norm(), none) / unit;
  }

  template <class At>
  [[nodiscard]] Poses keys_of(std::size_t joint, const At& at) const {
    const std::vector<double> all = times();
    Poses poses;
    append(poses, all.front(), at(all.front()));
    const double extent = extent_for(joint, all);
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
      follow(poses, at, all[i], all[i + 1], extent, most_halvings_of_steps);
    return poses;
  }

  /// Whether the way from the last key to a pose is straight there, at some shares of the time between.
  template <class At>
  [[nodiscard]] static bool is_straight(const Poses& poses, const At& at, double end, const JointPose& to,
                                        double extent) {
    const double start = poses.times.back();
    const Eigen::Quaterniond& from = poses.rotations.back();
    return std::ranges::all_of(std::array{0.25, 0.5, 0.75}, [&](double share) {
      const JointPose between = at(start + share * (end - start));
      const Eigen::Vector3d straight = poses.translations.back() + share * (to.translation - poses.translations.back());
      const Eigen::Quaterniond turned = slerp<double>(from, with_sign_near(to.rotation, from), share);
      return angular_distance(between.rotation, turned) <= straight_within &&
             (between.translation - straight).norm() <= straight_within * extent;
    });
  }

  template <class At>
  void follow(Poses& poses, const At& at, double start, double end, double extent, int halvings) const {
    const JointPose to = at(end);
    if (halvings == 0 || is_straight(poses, at, end, to, extent)) return append(poses, end, to);
    const double middle = 0.5 * (start + end);
    follow(poses, at, start, middle, extent, halvings - 1);
    follow(poses, at, middle, end, extent, halvings - 1);
  }

  static void append(Poses& poses, double time, const JointPose& pose) {
    poses.times.push_back(time);
    poses.rotations.push_back(poses.rotations.empty() ? pose.rotation
                                                      : with_sign_near(pose.rotation, poses.rotations.back()));
    poses.translations.push_back(pose.translation);
  }

  static void put(Clip& clip, std::size_t joint, Poses poses) {
    const auto set = [&](auto& channels, auto values) {
      std::erase_if(channels, [&](const auto& channel) { return channel.joint == joint; });
      channels.push_back({.joint = joint,
                          .interpolation = ChannelInterpolation::linear,
                          .times = poses.times,
                          .values = std::move(values)});
    };
    set(clip.rotations, std::move(poses.rotations));
    set(clip.translations, std::move(poses.translations));
  }

  const Skeleton& skeleton_;
  const Clip& clip_;
  RootMotion options_;
  ClipMotion moving_;
  Eigen::Quaterniond start_rotation_ = Eigen::Quaterniond::Identity();
  Eigen::Vector3d start_ = Eigen::Vector3d::Zero();
};

}  // namespace

Expected<Clip> with_root_motion(const Skeleton& skeleton, const Clip& clip, const RootMotion& motion) {
  return RootMotionChange(skeleton, clip, motion).made();
}

Expected<MotionFile> with_root_above(MotionFile file, std::size_t joint) {
  std::string name = "root";
  while (file.skeleton.find(name)) name += '_';
  std::vector<Joint> joints{{.name = std::move(name)}};
  for (std::size_t j = 0; j < file.skeleton.size(); ++j) {
    Joint& below = joints.emplace_back(file.skeleton[j]);
    if (below.parent != no_parent) ++below.parent;
    else if (j == joint) below.parent = 0;
  }
  for (Clip& clip : file.clips) {
    const auto move = [](auto& channels) {
      for (auto& channel : channels) ++channel.joint;
    };
    move(clip.rotations);
    move(clip.translations);
    move(clip.scales);
    move(clip.weights);
    for (WeightChannels& weights : clip.weights) move(weights.triples);
  }
  return Skeleton::make(std::move(joints)).map([&](Skeleton skeleton) {
    file.skeleton = std::move(skeleton);
    return std::move(file);
  });
}

std::size_t topmost_above(const Skeleton& skeleton, std::size_t joint) noexcept {
  std::size_t top = no_parent;
  for (std::size_t above = skeleton[joint].parent; above != no_parent; above = skeleton[above].parent) top = above;
  return top;
}

}}  // namespace orispline
