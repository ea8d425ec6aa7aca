// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh/turns.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/math/continuous_euler.hpp>
#include <orispline/math/number.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

constexpr double same_rotation = 1e-9;  // [rad]
constexpr double near_lock = 1.0 * radians_per_degree;

double handedness_of(int i, int j) { return (j - i + 3) % 3 == 1 ? 1.0 : -1.0; }

/// The turns about two different axes that come nearest to a rotation: with half angles α, β and e_i × e_j = ε e_k,
/// (w, q_i) = cos β (cos α, sin α) and (q_j, ε q_k) = sin β (cos α, sin α).
std::array<double, 2> two_turns(int i, int j, const Eigen::Quaterniond& q) {
  const double w = q.w(), x = q.vec()[i], y = q.vec()[j], z = handedness_of(i, j) * q.vec()[3 - i - j];
  const double first = w * w + x * x >= y * y + z * z ? atan2_of(x, w) : atan2_of(z, y);
  const auto [sine, cosine] = elementary::sine_cosine(first);
  return {2.0 * first, 2.0 * atan2_of(y * cosine + z * sine, w * cosine + x * sine)};
}

bool makes(std::span<const int> turns, std::span<const double> angles, const Eigen::Quaterniond& wanted) {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < turns.size(); ++i) q = q * exp<double>(angles[i] * Eigen::Vector3d::Unit(turns[i]));
  return angular_distance(q, wanted) <= same_rotation;
}

std::optional<JointAngles> fewer_turns(std::span<const int> turns, std::span<const Eigen::Quaterniond> rotations,
                                       std::span<const double> start) {
  if (turns.size() == 2 && turns[0] == turns[1]) return std::nullopt;
  JointAngles found;
  found.degrees.reserve(rotations.size() * turns.size());
  std::array before{0.0, 0.0};
  for (std::size_t i = 0; i < start.size(); ++i) before[i] = start[i] * radians_per_degree;
  for (const Eigen::Quaterniond& q : rotations) {
    const std::array angles = turns.size() == 2 ? two_turns(turns[0], turns[1], q)
                                                : std::array{2.0 * atan2_of(q.vec()[turns[0]], q.w()), 0.0};
    if (!makes(turns, angles, q)) return std::nullopt;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      before[i] = nearest_angle(angles[i], before[i]);
      found.degrees.push_back(before[i] * degrees);
    }
  }
  return found;
}

JointAngles three_turns(const EulerOrder& order, std::span<const Eigen::Quaterniond> rotations,
                        std::span<const double> start) {
  const ContinuousEuler turns(order);
  const Eigen::Vector3d first = start.size() == 3 ? Eigen::Vector3d(start[0], start[1], start[2]) * radians_per_degree
                                                  : euler_angles(order, rotations.front());
  JointAngles found;
  found.degrees.reserve(rotations.size() * 3);
  for (const Eigen::Vector3d& angles : turns.over(rotations, first)) {
    if (turns.lock_distance(angles) <= near_lock) found.near_lock.push_back(found.degrees.size() / 3);
    for (const double angle : angles) found.degrees.push_back(angle * degrees);
  }
  return found;
}

/// Part of the shorter way.
Eigen::Quaterniond between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, double share) {
  const Eigen::Vector3d turn =
      from.dot(to) < 0.0 ? increment<double>(from, Eigen::Quaterniond(-to.coeffs())) : increment<double>(from, to);
  return from * exp<double>(Eigen::Vector3d(share * turn));
}

Eigen::Quaterniond made_by(const EulerOrder& order, const Eigen::Vector3d& turns) {
  return quaternion_from_euler(order, turns * radians_per_degree);
}

/// From one frame's angles [°] to the next one's [rad].
double detour_between(const EulerOrder& order, const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  constexpr int parts = 8;
  const Eigen::Vector3d step = (to - from) * radians_per_degree;
  // The accelerations of three even turns are at most these products of their rates; an eighth of them is the detour.
  const double bent = std::abs(step[0] * step[1]) + std::abs(step[1] * step[2]) + std::abs(step[2] * step[0]);
  if (bent < 4.0 * largest_detour) return 0.0;
  const Eigen::Quaterniond start = made_by(order, from), end = made_by(order, to);
  double largest = 0.0;
  for (int part = 1; part < parts; ++part) {
    const double share = static_cast<double>(part) / parts;
    const Eigen::Quaterniond straight = between(start, end, share);
    largest = std::max(largest, angular_distance(made_by(order, from + share * (to - from)), straight));
  }
  return largest;
}

/// The largest over the frames.
Detour detour_over(const EulerOrder& order, std::span<const double> turns) {
  Detour found;
  for (std::size_t k = 0; 3 * k + 6 <= turns.size(); ++k) {
    const Eigen::Map<const Eigen::Vector3d> from(turns.data() + 3 * k), to(turns.data() + 3 * k + 3);
    if (const double angle = detour_between(order, from, to); angle > found.angle) found.angle = angle, found.frame = k;
  }
  return found;
}

/// From one frame to the next in so many steps.
double detour_in_steps(const EulerOrder& order, std::span<const double> start, const Eigen::Quaterniond& from,
                       const Eigen::Quaterniond& to, std::size_t steps) {
  std::vector<Eigen::Quaterniond> way;
  for (std::size_t i = 0; i <= steps; ++i)
    way.push_back(between(from, to, static_cast<double>(i) / static_cast<double>(steps)));
  return detour_over(order, three_turns(order, way, start).degrees).angle;
}

Detour detour_of(const EulerOrder& order, std::span<const double> turns,
                 std::span<const Eigen::Quaterniond> rotations) {
  Detour found = detour_over(order, turns);
  const auto holds = [&](std::size_t steps, std::size_t k) {
    return detour_in_steps(order, turns.subspan(3 * k, 3), rotations[k], rotations[k + 1], steps) <= largest_detour;
  };
  for (std::size_t k = 0; found.frames_for_one > 0 && k + 1 < rotations.size(); ++k) {
    const Eigen::Map<const Eigen::Vector3d> from(turns.data() + 3 * k), to(turns.data() + 3 * k + 3);
    if (detour_between(order, from, to) <= largest_detour) continue;
    std::size_t steps = std::max<std::size_t>(found.frames_for_one, 2);
    while (steps <= most_frames_for_one && !holds(steps, k)) steps *= 2;
    found.frames_for_one = steps <= most_frames_for_one ? steps : 0;
  }
  return found;
}

}  // namespace

std::optional<JointAngles> angles_of(std::span<const Column> columns, std::span<const Eigen::Quaterniond> rotations,
                                     std::span<const double> start) {
  std::vector<int> axes;
  for (const Column& column : columns) axes.push_back(column.axis);
  if (axes.size() == 1 || axes.size() == 2) return fewer_turns(axes, rotations, start);
  if (axes.size() != 3 || axes[0] == axes[1] || axes[1] == axes[2]) return std::nullopt;
  const EulerOrder order{.turns = {axes[0], axes[1], axes[2]}};
  JointAngles found = three_turns(order, rotations, start);
  found.detour = detour_of(order, found.degrees, rotations);
  return found;
}

}}}  // namespace orispline::scenes::bvh
