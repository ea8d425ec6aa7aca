// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh_angles.hpp>

#include <cmath>
#include <numbers>

#include <orispline/math/degrees.hpp>
#include <orispline/math/euler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

constexpr double pi = std::numbers::pi, full_turn = 2.0 * pi;
constexpr double same_rotation = 1e-9;  // [rad]
constexpr double near_lock = 1.0 * radians_per_degree;
constexpr double at_lock = 1e-12;  // [rad], where euler_angles() gives the third angle as 0

/// The angle of the same direction that is nearest to another.
double nearest(double angle, double to) { return to + std::remainder(angle - to, full_turn); }
Eigen::Vector3d nearest(Eigen::Vector3d angles, const Eigen::Vector3d& to) {
  for (Eigen::Index i = 0; i < 3; ++i) angles[i] = nearest(angles[i], to[i]);
  return angles;
}

double handedness_of(int i, int j) { return (j - i + 3) % 3 == 1 ? 1.0 : -1.0; }

/// Angles of three turns that follow one another without jumps.
class ThreeTurns {
 public:
  explicit ThreeTurns(const EulerOrder& order) : order_(order) {}

  [[nodiscard]] Eigen::Vector3d after(const Eigen::Vector3d& before, const Eigen::Quaterniond& q) const {
    const Eigen::Vector3d angles = euler_angles(order_, q);
    if (lock_distance(angles) <= at_lock) return at_the_lock(before, angles);
    const double mirrored = order_.is_proper() ? -angles[1] : pi - angles[1];
    const Eigen::Vector3d one = nearest(angles, before);
    const Eigen::Vector3d other = nearest({angles[0] + pi, mirrored, angles[2] + pi}, before);
    return (one - before).squaredNorm() <= (other - before).squaredNorm() ? one : other;
  }

  /// How far the second turn is from where the first and the third have one axis [rad].
  [[nodiscard]] double lock_distance(const Eigen::Vector3d& angles) const {
    return order_.is_proper() ? std::abs(std::remainder(angles[1], pi))
                              : std::abs(std::remainder(angles[1] - pi / 2, pi));
  }

 private:
  /// Only a sum or a difference of the outer angles means anything: both take half of its step.
  [[nodiscard]] Eigen::Vector3d at_the_lock(const Eigen::Vector3d& before, const Eigen::Vector3d& angles) const {
    const bool is_sum = order_.is_proper() ? angles[1] < pi / 2
                                           : (angles[1] > 0.0) == (handedness_of(order_.turns[0], order_.turns[1]) > 0);
    const double sign = is_sum ? 1.0 : -1.0;
    const double step = std::remainder(angles[0] + sign * angles[2] - before[0] - sign * before[2], full_turn);
    return {before[0] + step / 2, nearest(angles[1], before[1]), before[2] + sign * step / 2};
  }

  EulerOrder order_;
};

/// The turns about two different axes that come nearest to a rotation: with half angles α, β and e_i × e_j = ε e_k,
/// (w, q_i) = cos β (cos α, sin α) and (q_j, ε q_k) = sin β (cos α, sin α).
std::array<double, 2> two_turns(int i, int j, const Eigen::Quaterniond& q) {
  const double w = q.w(), x = q.vec()[i], y = q.vec()[j], z = handedness_of(i, j) * q.vec()[3 - i - j];
  const double first = std::hypot(w, x) >= std::hypot(y, z) ? std::atan2(x, w) : std::atan2(z, y);
  const double cosine = std::cos(first), sine = std::sin(first);
  return {2.0 * first, 2.0 * std::atan2(y * cosine + z * sine, w * cosine + x * sine)};
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
                                                : std::array{2.0 * std::atan2(q.vec()[turns[0]], q.w()), 0.0};
    if (!makes(turns, angles, q)) return std::nullopt;
    for (std::size_t i = 0; i < turns.size(); ++i) {
      before[i] = nearest(angles[i], before[i]);
      found.degrees.push_back(before[i] * degrees);
    }
  }
  return found;
}

JointAngles three_turns(const EulerOrder& order, std::span<const Eigen::Quaterniond> rotations,
                        std::span<const double> start) {
  const ThreeTurns turns(order);
  JointAngles found;
  found.degrees.reserve(rotations.size() * 3);
  Eigen::Vector3d before = euler_angles(order, rotations.front());
  if (start.size() == 3) before = Eigen::Vector3d(start[0], start[1], start[2]) * radians_per_degree;
  for (std::size_t k = 0; k < rotations.size(); ++k) {
    before = turns.after(before, rotations[k]);
    if (turns.lock_distance(before) <= near_lock) found.near_lock.push_back(k);
    for (const double angle : before) found.degrees.push_back(angle * degrees);
  }
  return found;
}

}  // namespace

std::optional<JointAngles> angles_of(std::span<const int> turns, std::span<const Eigen::Quaterniond> rotations,
                                     std::span<const double> start) {
  if (turns.size() == 1 || turns.size() == 2) return fewer_turns(turns, rotations, start);
  if (turns.size() != 3 || turns[0] == turns[1] || turns[1] == turns[2]) return std::nullopt;
  return three_turns({.turns = {turns[0], turns[1], turns[2]}}, rotations, start);
}

}}}  // namespace orispline::scenes::bvh
