// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/clip_motion.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/rational_curve.hpp>
#include <orispline/math/bernstein.hpp>

// What a channel is between its keys, over any number type.

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The value of the key before.
template <CurvePoint P>
class StepCurve {
 public:
  explicit StepCurve(const Channel<P>& channel) : knots_(channel.times), values_(channel.values) {}
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] PointOver<P, T> point(const T& t, std::size_t segment) const noexcept {
    return constant<T>(value_of(t) < knots_.back() ? values_[segment] : values_.back());
  }

 private:
  Knots knots_;
  std::vector<P> values_;
};

/// Geodesics from key to key.
template <CurvePoint P>
class GeodesicCurve {
 public:
  explicit GeodesicCurve(const Channel<P>& channel) : knots_(channel.times), values_(channel.values) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      for (std::size_t i = 1; i < values_.size(); ++i)
        if (values_[i].dot(values_[i - 1]) < 0.0) values_[i].coeffs() = -values_[i].coeffs();
  }
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] PointOver<P, T> point(const T& t, std::size_t segment) const noexcept {
    return on_geodesic<T>(constant<T>(values_[segment]), constant<T>(values_[segment + 1]),
                          knots_.span(segment).normalised(t));
  }

 private:
  Knots knots_;
  std::vector<P> values_;
};

/// Cubic Hermite polynomials of positions or scales, whose derivatives may differ on the two sides of a key.
class CubicPath {
 public:
  explicit CubicPath(const VectorChannel& channel) : knots_(channel.times) {
    for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
      const double third = (channel.times[i + 1] - channel.times[i]) / 3.0;
      controls_.push_back({channel.values[i], channel.values[i] + third * channel.out_tangents[i],
                           channel.values[i + 1] - third * channel.in_tangents[i + 1], channel.values[i + 1]});
    }
  }
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] Vector3<T> point(const T& t, std::size_t segment) const noexcept {
    const auto basis = bernstein_basis<3>(knots_.span(segment).normalised(t));
    Vector3<T> sum = Vector3<T>::Constant(T(0.0));
    for (std::size_t i = 0; i < basis.size(); ++i)
      for (Eigen::Index axis = 0; axis < 3; ++axis) sum[axis] += basis[i] * Plain<T>(controls_[segment][i][axis]);
    return sum;
  }

 private:
  Knots knots_;
  std::vector<std::array<Eigen::Vector3d, 4>> controls_;
};

RationalCurve cubic_curve(const RotationChannel& channel) {
  std::vector<RationalPiece> pieces;
  for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
    const double third = (channel.times[i + 1] - channel.times[i]) / 3.0;
    const Eigen::Vector4d start = channel.values[i].coeffs(), end = channel.values[i + 1].coeffs();
    const Eigen::Vector4d leaving = third * channel.out_tangents[i].coeffs(),
                          arriving = third * channel.in_tangents[i + 1].coeffs();
    pieces.push_back({start, end, {leaving, (end - start) - leaving - arriving, arriving}});
  }
  return {Knots(channel.times), std::move(pieces)};
}
CubicPath cubic_curve(const VectorChannel& channel) { return CubicPath(channel); }

/// A channel by its interpolation.
template <CurvePoint P>
using ChannelPieces = std::variant<ConstantCurve<P>, StepCurve<P>, GeodesicCurve<P>,
                                   std::conditional_t<std::same_as<P, Eigen::Quaterniond>, RationalCurve, CubicPath>>;

template <CurvePoint P>
ChannelPieces<P> pieces_of(const Channel<P>& channel) {
  if (channel.size() == 1) return ConstantCurve<P>(channel.times.front(), channel.values.front());
  switch (channel.interpolation) {
    case ChannelInterpolation::step:
      return StepCurve<P>(channel);
    case ChannelInterpolation::cubicspline:
      return cubic_curve(channel);
    case ChannelInterpolation::linear:
      break;
  }
  return GeodesicCurve<P>(channel);
}

template <CurvePoint P>
ErasedCurve<P> curve_of(const Channel<P>& channel) {
  return std::visit([](auto pieces) { return ErasedCurve<P>(std::move(pieces)); }, pieces_of(channel));
}

Motion at_rest(const Eigen::Quaterniond& value) { return {.orientation = value}; }
LinearMotion at_rest(const Eigen::Vector3d& value) { return {.position = value}; }

Eigen::Affine3d transform(const JointPose& pose) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  transform.linear() = pose.rotation.toRotationMatrix() * pose.scale.asDiagonal();
  transform.translation() = pose.translation;
  return transform;
}

/// What moves one joint in the frame of its parent.
struct Link {
  ChannelPieces<Eigen::Quaterniond> rotation;
  ChannelPieces<Eigen::Vector3d> translation, scale;
};

/// Joints from one that is carried by nothing, or by what does not count, to the one that is asked for.
struct Chain {
  Knots knots;
  std::vector<Link> links;
  NewFrames frames;  // that the motion is stated in

  /// A channel's value where the chain is at `t` in one of its segments: in the middle of that the channel is in the
  /// same one of its own.
  template <CurvePoint P, Number T>
  [[nodiscard]] PointOver<P, T> value(const ChannelPieces<P>& pieces, const T& t, std::size_t segment) const noexcept {
    return std::visit(
        [&](const auto& curve) -> PointOver<P, T> {
          const Knots& own = curve.knots();
          const double middle =
              knots.segments() == 0 ? knots.front() : 0.5 * (knots.span(segment).start() + knots.span(segment).end());
          if (middle < own.front()) return constant<T>(P(curve.point(own.front(), 0)));
          if (middle > own.back()) return constant<T>(P(curve.point(own.back(), own.segment_at(own.back()))));
          return curve.point(t, own.segment_at(middle));
        },
        pieces);
  }

  template <Number T>
  [[nodiscard]] Quaternion<T> orientation(const T& t, std::size_t segment) const noexcept {
    Quaternion<T> orientation = constant<T>(Eigen::Quaterniond::Identity());
    for (const Link& link : links) orientation = orientation * value<Eigen::Quaterniond>(link.rotation, t, segment);
    return frames.orientation<T>(orientation);
  }

  /// Scales above are even: the x of each is that of all axes.
  template <Number T>
  [[nodiscard]] Vector3<T> position(const T& t, std::size_t segment) const noexcept {
    Quaternion<T> orientation = constant<T>(Eigen::Quaterniond::Identity());
    Vector3<T> position = constant<T>(Eigen::Vector3d(0.0, 0.0, 0.0));
    T scale(1.0);
    for (const Link& link : links) {
      const Vector3<T> step = value<Eigen::Vector3d>(link.translation, t, segment) * scale;
      position += to_world<T>(orientation, step);
      orientation = orientation * value<Eigen::Quaterniond>(link.rotation, t, segment);
      scale = scale * value<Eigen::Vector3d>(link.scale, t, segment).x();
    }
    return frames.in_world<T>(position);
  }
};

class ChainOrientation {
 public:
  explicit ChainOrientation(std::shared_ptr<const Chain> chain) : chain_(std::move(chain)) {}
  [[nodiscard]] const Knots& knots() const noexcept { return chain_->knots; }
  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t segment) const noexcept {
    return chain_->orientation(t, segment);
  }

 private:
  std::shared_ptr<const Chain> chain_;
};

class ChainPath {
 public:
  explicit ChainPath(std::shared_ptr<const Chain> chain) : chain_(std::move(chain)) {}
  [[nodiscard]] const Knots& knots() const noexcept { return chain_->knots; }
  template <Number T>
  [[nodiscard]] Vector3<T> point(const T& t, std::size_t segment) const noexcept {
    return chain_->position(t, segment);
  }

 private:
  std::shared_ptr<const Chain> chain_;
};

/// The joint and those above it, the joint last.
std::vector<std::size_t> joints_of(const Skeleton& skeleton, std::size_t joint, JointSpace space) {
  std::vector<std::size_t> joints{joint};
  if (space == JointSpace::world)
    for (joint = skeleton[joint].parent; joint != no_parent; joint = skeleton[joint].parent) joints.push_back(joint);
  std::ranges::reverse(joints);
  return joints;
}

/// Collects the chain's channels and their key times.
class ChainBuilder {
 public:
  ChainBuilder(const Skeleton& skeleton, const Clip& clip, const NewFrames& frames)
      : skeleton_(skeleton), clip_(clip), frames_(frames) {}

  Expected<Chain> built(std::size_t joint, JointSpace space) {
    std::vector<Link> links;
    for (const std::size_t i : joints_of(skeleton_, joint, space)) {
      if (i != joint && !has_even_scale(i))
        return failure(ErrorCode::bad_data, formatted("{}: found a scale that is zero, negative or not the same along "
                                                      "all axes, wanted another one for the world",
                                                      place_of(skeleton_, clip_, i)));
      const JointPose& rest = skeleton_[i].rest;
      links.push_back({pieces(clip_.rotations, i, rest.rotation), pieces(clip_.translations, i, rest.translation),
                       pieces(clip_.scales, i, rest.scale)});
    }
    if (times_.empty()) times_.push_back(clip_.domain().start);
    std::ranges::sort(times_);
    times_.erase(std::unique(times_.begin(), times_.end()), times_.end());
    return Chain{Knots(std::move(times_)), std::move(links), frames_};
  }

 private:
  template <CurvePoint P>
  ChannelPieces<P> pieces(const std::vector<Channel<P>>& channels, std::size_t joint, const P& rest) {
    const Channel<P>* const channel = channel_of(channels, joint);
    if (!channel) return ConstantCurve<P>(0.0, rest);
    times_.insert(times_.end(), channel->times.begin(), channel->times.end());
    return pieces_of(*channel);
  }

  [[nodiscard]] bool has_even_scale(std::size_t joint) const {
    const auto is_even = [](const Eigen::Vector3d& v, double size) {
      return v.maxCoeff() - v.minCoeff() <= 1e-5 * std::max(size, v.cwiseAbs().maxCoeff());
    };
    const auto is_scale = [&](const Eigen::Vector3d& scale) { return scale.minCoeff() > 0.0 && is_even(scale, 0.0); };
    const VectorChannel* const channel = channel_of(clip_.scales, joint);
    if (!channel) return is_scale(skeleton_[joint].rest.scale);
    const auto is_rate = [&](const Eigen::Vector3d& rate) { return is_even(rate, channel->values.front().x()); };
    return std::ranges::all_of(channel->values, is_scale) && std::ranges::all_of(channel->in_tangents, is_rate) &&
           std::ranges::all_of(channel->out_tangents, is_rate);
  }

  const Skeleton& skeleton_;
  const Clip& clip_;
  const NewFrames& frames_;
  std::vector<double> times_;
};

/// Channels that share their keys share their curve.
template <CurvePoint P>
std::vector<ChannelCurve<P>> curves_of(const std::vector<Channel<P>>& channels) {
  std::map<PlacesOfKeys<P>, std::size_t> known;
  std::vector<ChannelCurve<P>> curves;
  for (const Channel<P>& channel : channels) {
    const auto [same, is_new] = known.try_emplace(places_of_keys(channel), curves.size());
    if (is_new) curves.emplace_back(channel);
    else curves.push_back(curves[same->second].of_joint(channel.joint));
  }
  return curves;
}

}  // namespace

template <CurvePoint P>
ChannelCurve<P>::ChannelCurve(const Channel<P>& channel)
    : curve_(curve_of(channel)), last_(channel.values.back()), joint_(channel.joint) {}

template <CurvePoint P>
ChannelCurve<P>::ChannelCurve(std::size_t joint, ErasedCurve<P> curve)
    : curve_(std::move(curve)),
      last_(curve_.point(knots().back(), knots().segment_at(knots().back()))),
      joint_(joint) {}

template <CurvePoint P>
P ChannelCurve<P>::at(double t) const noexcept {
  if (t >= knots().back()) return last_;
  t = std::max(t, knots().front());
  return curve_.point(t, knots().segment_at(t));
}

template <CurvePoint P>
MotionOf<P> ChannelCurve<P>::motion(double t) const noexcept {
  if (t < knots().front() || t > knots().back()) return at_rest(at(t));
  MotionOf<P> motion = curve_.motion(t, knots().segment_at(t));
  if (t == knots().back()) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>) motion.orientation = last_;
    else motion.position = last_;
  }
  return motion;
}

template class ChannelCurve<Eigen::Quaterniond>;
template class ChannelCurve<Eigen::Vector3d>;

ClipMotion::ClipMotion(const Skeleton& skeleton, const Clip& clip)
    : ClipMotion(skeleton, curves_of(clip.rotations), curves_of(clip.translations), curves_of(clip.scales)) {}

ClipMotion::ClipMotion(const Skeleton& skeleton, std::vector<ChannelCurve<Eigen::Quaterniond>> rotations,
                       std::vector<ChannelCurve<Eigen::Vector3d>> translations,
                       std::vector<ChannelCurve<Eigen::Vector3d>> scales)
    : skeleton_(&skeleton),
      rotations_(std::move(rotations)),
      translations_(std::move(translations)),
      scales_(std::move(scales)),
      places_(skeleton.size()) {
  for (const Joint& joint : skeleton.joints()) still_.push_back(joint.rest);
  const auto place = [&](const auto& curves, auto part, std::size_t Places::*place_of_part) {
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const std::size_t joint = curves[i].joint();
      if (curves[i].knots().segments() > 0) places_[joint].*place_of_part = i + 1;
      else still_[joint].*part = curves[i].at(curves[i].knots().front());
    }
  };
  place(rotations_, &JointPose::rotation, &Places::rotation);
  place(translations_, &JointPose::translation, &Places::translation);
  place(scales_, &JointPose::scale, &Places::scale);
}

JointPose ClipMotion::local_pose(std::size_t joint, double t) const noexcept {
  JointPose pose = still_[joint];
  const Places& places = places_[joint];
  if (places.rotation) pose.rotation = rotations_[places.rotation - 1].at(t);
  if (places.translation) pose.translation = translations_[places.translation - 1].at(t);
  if (places.scale) pose.scale = scales_[places.scale - 1].at(t);
  return pose;
}

Eigen::Affine3d ClipMotion::placed(std::size_t joint, const JointPose& pose,
                                   std::span<const Eigen::Affine3d> world) const noexcept {
  const std::size_t parent = (*skeleton_)[joint].parent;
  return parent == no_parent ? transform(pose) : world[parent] * transform(pose);
}

void ClipMotion::world_poses(double t, std::span<Eigen::Affine3d> poses) const noexcept {
  for (std::size_t i = 0; i < skeleton_->size(); ++i) poses[i] = placed(i, local_pose(i, t), poses);
}

void ClipMotion::poses(double t, std::span<JointPose> local, std::span<Eigen::Affine3d> world) const noexcept {
  for (std::size_t i = 0; i < skeleton_->size(); ++i) {
    local[i] = local_pose(i, t);
    world[i] = placed(i, local[i], world);
  }
}

Eigen::Affine3d ClipMotion::world_pose(std::size_t joint, double t) const noexcept {
  Eigen::Affine3d pose = transform(local_pose(joint, t));
  while ((joint = (*skeleton_)[joint].parent) != no_parent) pose = transform(local_pose(joint, t)) * pose;
  return pose;
}

std::vector<Eigen::Affine3d> world_poses(const Skeleton& skeleton, const Clip& clip, std::span<const double> times) {
  const ClipMotion motion(skeleton, clip);
  std::vector<Eigen::Affine3d> poses(skeleton.size() * times.size());
  for (std::size_t i = 0; i < times.size(); ++i)
    motion.world_poses(times[i], std::span(poses).subspan(i * skeleton.size(), skeleton.size()));
  return poses;
}

Expected<PoseCurve> joint_curve(const Skeleton& skeleton, const Clip& clip, std::size_t joint, JointSpace space,
                                const FrameChange& change) {
  if (auto checked = check(change); !checked) return tl::unexpected(std::move(checked.error()));
  const NewFrames frames(change);
  return ChainBuilder(skeleton, clip, frames).built(joint, space).map([](Chain chain) {
    const auto shared = std::make_shared<const Chain>(std::move(chain));
    return PoseCurve{.orientation = AnyCurve(ChainOrientation(shared)), .position = AnyPath(ChainPath(shared))};
  });
}

}}  // namespace orispline
