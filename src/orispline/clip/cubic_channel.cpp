// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/cubic_channel.hpp>

#include <algorithm>
#include <array>
#include <utility>

#include <orispline/clip/clip_motion.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/math/highest.hpp>
#include <orispline/math/shorter_way.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t parts = 16;     // of an interval, between which it is looked at
constexpr double shortest = 0x1p-20;  // interval that is halved, as a part of the curve

/// A value with its time derivative, component by component [1/s].
template <CurvePoint P>
struct Moving {
  P value, derivative;
};

Moving<Eigen::Quaterniond> moving(const AnyCurve& curve, double t, Side side) {
  const Motion motion = curve.motion(t, side);
  const Eigen::Vector3d half = 0.5 * motion.angular_velocity;
  return {motion.orientation, motion.orientation * Eigen::Quaterniond(0.0, half.x(), half.y(), half.z())};
}
Moving<Eigen::Vector3d> moving(const AnyPath& path, double t, Side side) {
  const LinearMotion motion = path.linear_motion(t, side);
  return {motion.position, motion.velocity};
}

/// The farthest that a curve is from cubics in an interval, if it comes near the distance that is known.
template <CurvePoint P, class C>
Height farthest_between(const C& curve, const ChannelCurve<P>& cubics, double start, double end, double known) {
  const auto off = [&](double t) { return distance_between(cubics.at(t), moving(curve, t, Side::right).value); };
  std::array<double, parts - 1> times, distances;
  for (std::size_t k = 0; k < times.size(); ++k) {
    times[k] = start + (end - start) * static_cast<double>(k + 1) / double{parts};
    distances[k] = off(times[k]);
  }
  return highest(times, distances, off, known);
}

/// Goes from the start of a curve to its end.
template <CurvePoint P, class C>
class Follower {
 public:
  Follower(const C& curve, double tolerance) : curve_(curve), tolerance_(tolerance) {
    const Knots& knots = curve.knots();
    shortest_ = shortest * (knots.back() - knots.front());
    found_.channel.interpolation = ChannelInterpolation::cubicspline;
    append(knots.front(), moving(curve_, knots.front(), Side::right));
  }

  [[nodiscard]] CubicChannel<P> followed() && {
    const auto times = curve_.knots().times();
    for (std::size_t i = 0; i + 1 < times.size(); ++i) follow(times[i], times[i + 1]);
    return std::move(found_);
  }

 private:
  void follow(double start, double end) {
    Moving<P> left = moving(curve_, start, Side::right), right = moving(curve_, end, Side::left);
    align(left, found_.channel.values.back());
    align(right, left.value);
    // The last key is that value, but where the curve jumps: there the piece must come from it.
    const Channel<P> piece{.interpolation = ChannelInterpolation::cubicspline,
                           .times = {start, end},
                           .values = {found_.channel.values.back(), right.value},
                           .in_tangents = {left.derivative, right.derivative},
                           .out_tangents = {left.derivative, right.derivative}};
    const auto [at, farthest] =
        farthest_between(curve_, ChannelCurve<P>(piece), start, end, std::min(found_.largest_distance, tolerance_));
    const double middle = start + 0.5 * (end - start);
    if ((farthest > tolerance_ || turns_far(piece)) && end - start > shortest_)
      return follow(start, middle), follow(middle, end);
    if (farthest > found_.largest_distance) found_.largest_distance = farthest, found_.largest_at = at;
    found_.channel.out_tangents.back() = left.derivative;
    append(end, right);
  }

  /// By nearly 180°, where readers may turn the other way.
  static bool turns_far(const Channel<P>& piece) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      return piece.values[0].dot(piece.values[1]) < cosine_near_half_turn;
    else return false;
  }

  /// Gives it the sign of the nearer of the two quaternions that are its orientation.
  static void align(Moving<P>& key, const P& before) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      if (before.dot(key.value) < 0.0) key.value.coeffs() *= -1.0, key.derivative.coeffs() *= -1.0;
  }

  /// A key with its tangents; the one after it is the same until the next piece says otherwise.
  void append(double t, const Moving<P>& key) {
    Channel<P>& channel = found_.channel;
    channel.times.push_back(t);
    channel.values.push_back(key.value);
    channel.in_tangents.push_back(key.derivative);
    channel.out_tangents.push_back(key.derivative);
  }

  const C& curve_;
  double tolerance_, shortest_;
  CubicChannel<P> found_;
};

template <CurvePoint P, class C>
double largest_distance_of(const C& curve, const Channel<P>& channel) {
  const ChannelCurve<P> cubic(channel);
  double worst = 0.0;
  for (std::size_t i = 0; i + 1 < channel.size(); ++i)
    worst = std::max(worst, farthest_between(curve, cubic, channel.times[i], channel.times[i + 1], worst).value);
  return worst;
}

}  // namespace

double largest_distance(const AnyCurve& curve, const RotationChannel& channel) {
  return largest_distance_of(curve, channel);
}
double largest_distance(const AnyPath& path, const VectorChannel& channel) {
  return largest_distance_of(path, channel);
}

CubicChannel<Eigen::Quaterniond> cubic_channel(const AnyCurve& curve, double tolerance) {
  return Follower<Eigen::Quaterniond, AnyCurve>(curve, tolerance).followed();
}

CubicChannel<Eigen::Vector3d> cubic_channel(const AnyPath& path, double tolerance) {
  return Follower<Eigen::Vector3d, AnyPath>(path, tolerance).followed();
}

}}  // namespace orispline
