// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/continuity.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <orispline/analysis/direction_beside.hpp>
#include <orispline/analysis/joints.hpp>
#include <orispline/analysis/rounding.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Rate = Eigen::Vector3d Motion::*;
constexpr std::array<Rate, 3> rates_of_motion{&Motion::angular_velocity, &Motion::angular_acceleration,
                                              &Motion::angular_jerk};
constexpr std::array<RateJump Continuity::*, 3> jumps_of_rates{
    &Continuity::angular_velocity, &Continuity::angular_acceleration, &Continuity::angular_jerk};

void widen_magnitudes(Continuity& found, const Motion& motion) {
  for (std::size_t k = 0; k < rates_of_motion.size(); ++k) {
    double& magnitude = (found.*jumps_of_rates[k]).magnitude;
    magnitude = std::max(magnitude, (motion.*rates_of_motion[k]).norm());
  }
}

/// How large the rates are between the keys and beside them, to rounding, and whether the orientation jumps.
Continuity between_keys(const AnyCurve& curve) {
  Continuity found;
  look_between_keys(
      curve, [&](const Motion& motion) { widen_magnitudes(found, motion); },
      [&](const OrientationJump& jump) {
        if (jump.angle > found.orientation.angle) found.orientation = jump;
      });
  return found;
}

/// The jump of the orientation where segments meet, beyond what rounding of the time turns the body by.
double orientation_jump(const SegmentJoint& joint) {
  const double rate = std::max(joint.left.angular_velocity.norm(), joint.right.angular_velocity.norm());
  const double jump = angular_distance(joint.left.orientation, joint.right.orientation);
  return jump > smallest_jump + rounding_of_increments * rate * joint.spacing ? jump : 0.0;
}

/// Largest jumps, and of those that are not rounding the largest as `relative`, still in the unit of the rate.
void compare_sides(Continuity& found, const SegmentJoint& joint) {
  if (const double jump = orientation_jump(joint); jump > found.orientation.angle)
    found.orientation = {.angle = jump, .time = joint.time, .key = joint.key};
  widen_magnitudes(found, joint.left);
  widen_magnitudes(found, joint.right);
  for (std::size_t k = 0; k < rates_of_motion.size(); ++k) {
    RateJump& largest = found.*jumps_of_rates[k];
    const double jump = (joint.right.*rates_of_motion[k] - joint.left.*rates_of_motion[k]).norm();
    if (jump > largest.largest) {
      largest.largest = jump;
      largest.key = joint.key;
    }
    if (jump > rounding_of_rates(joint.spacing, static_cast<int>(k) + 1))
      largest.relative = std::max(largest.relative, jump);
  }
}

Continuity with_relative_jumps(Continuity found) {
  for (const auto of_rate : jumps_of_rates)
    if (RateJump& jump = found.*of_rate; jump.relative > 0.0) jump.relative /= jump.magnitude;
  return found;
}

/// What the rounding of the rates makes of each quantity of the shape, to first order.
struct Rounding {
  double direction, curvature, curvature_rate;
};

Rounding rounding_of(const SegmentJoint& joint) {
  const auto larger = [&](auto rate) { return std::max((joint.left.*rate).norm(), (joint.right.*rate).norm()); };
  const double v = std::min(joint.left.angular_velocity.norm(), joint.right.angular_velocity.norm());
  const double bend = larger(&Motion::angular_acceleration) / (v * v),
               twist = larger(&Motion::angular_jerk) / (v * v * v);
  const double of_rate = rounding_of_rates(joint.spacing, 1) / v;
  const double of_acceleration = rounding_of_rates(joint.spacing, 2) / (v * v);
  const double of_jerk = rounding_of_rates(joint.spacing, 3) / (v * v * v);
  return {2.0 * of_rate, of_acceleration + 4.0 * bend * of_rate,
          of_jerk + 6.0 * bend * of_acceleration + (8.0 * twist + 16.0 * bend * bend) * of_rate};
}

void compare_sides(ShapeJump& jump, std::size_t key, const Eigen::Vector3d& left, const Eigen::Vector3d& right,
                   double rounding) {
  const double found = (right - left).norm();
  if (found > jump.largest) {
    jump.largest = found;
    jump.key = key;
  }
  if (found > rounding) jump.relative = std::max(jump.relative, found / std::max({1.0, left.norm(), right.norm()}));
}

/// The smaller turn of the segments beside a joint [rad], at most 1: in this unit its path is to be judged.
double turn_beside(const AnyCurve& curve, const SegmentJoint& joint) {
  const auto t = curve.knots().times();
  const Eigen::Quaterniond& here = joint.right.orientation;
  const std::size_t before = joint.key > 0 ? joint.key - 1 : t.size() - 2;
  return std::min({1.0, angular_distance(here, curve(t[before])), angular_distance(here, curve(t[joint.key + 1]))});
}

constexpr double largest_hidden_turn = 1e-3;  // [rad]

/// The order up to which a jump that matters would not be taken for rounding.
int told_order(const AnyCurve& curve, const SegmentJoint& joint, const Rounding& rounding) {
  if (rounding.direction > largest_hidden_turn) return 0;
  if (rounding.curvature <= 1.0 && rounding.curvature_rate <= 1.0) return 3;
  const double turn = turn_beside(curve, joint);
  if (rounding.curvature * turn > 1.0) return 1;
  return rounding.curvature_rate * turn * turn > 1.0 ? 2 : 3;
}

void look_at_rest(ShapeContinuity& found, const SegmentJoint& joint, const std::optional<DirectionBeside>& left,
                  const std::optional<DirectionBeside>& right) {
  if (found.rests++ == 0) found.first_rest = joint.key;
  if (left && right)
    compare_sides(found.direction, joint.key, left->direction, right->direction, left->rounding + right->rounding);
  else if (found.stands++ == 0) found.first_stand = joint.key;
}

void compare_sides(ShapeContinuity& found, const AnyCurve& curve, const SegmentJoint& joint,
                   const Continuity& in_time) {
  ++found.joints;
  const auto before = direction_beside(joint.left, Side::left, joint.spacing, in_time);
  const auto behind = direction_beside(joint.right, Side::right, joint.spacing, in_time);
  const bool moves = before && behind && before->order == 1 && behind->order == 1;
  if (!moves) return look_at_rest(found, joint, before, behind);
  const PathShape left = path_shape(joint.left), right = path_shape(joint.right);
  const Rounding rounding = rounding_of(joint);
  if (const int told = told_order(curve, joint, rounding); told < found.told) {
    found.told = told;
    found.hidden_at = joint.key;
  }
  for (ShapeJump* jump : {&found.direction, &found.direction_in_motion})
    compare_sides(*jump, joint.key, left.direction, right.direction, rounding.direction);
  compare_sides(found.curvature, joint.key, left.curvature, right.curvature, rounding.curvature);
  compare_sides(found.curvature_rate, joint.key, left.curvature_rate, right.curvature_rate, rounding.curvature_rate);
}

int order_without_jumps(const ShapeContinuity& shape) noexcept {
  if (shape.direction_in_motion.relative > continuity_tolerance) return 0;
  if (shape.curvature.relative > continuity_tolerance) return 1;
  return shape.curvature_rate.relative > continuity_tolerance ? 2 : 3;
}

}  // namespace

std::optional<DirectionBeside> direction_beside(const Motion& motion, Side side, double spacing,
                                                const Continuity& in_time) {
  for (std::size_t k = 0; k < rates_of_motion.size(); ++k) {
    const int order = static_cast<int>(k) + 1;
    const Eigen::Vector3d& rate = motion.*rates_of_motion[k];
    const double rounding = rounding_of_rates(spacing, order), norm = rate.norm();
    if (norm <= std::max(continuity_tolerance * (in_time.*jumps_of_rates[k]).magnitude, rounding)) continue;
    const double sign = side == Side::left && order == 2 ? -1.0 : 1.0;
    return DirectionBeside{order, sign / norm * rate, rounding / norm};
  }
  return std::nullopt;
}

int Continuity::order() const noexcept {
  if (orientation.angle > 0.0) return -1;
  if (angular_velocity.relative > continuity_tolerance) return 0;
  if (angular_acceleration.relative > continuity_tolerance) return 1;
  return angular_jerk.relative > continuity_tolerance ? 2 : 3;
}

Continuity continuity_at_keys(const AnyCurve& curve, Seam seam) {
  Continuity found = between_keys(curve);
  for_each_joint(curve, seam, [&](const SegmentJoint& joint) { compare_sides(found, joint); });
  return with_relative_jumps(found);
}

std::vector<int> orders_at_keys(const AnyCurve& curve, Seam seam) {
  std::vector<Continuity> at_keys(curve.knots().times().size());
  for_each_joint(curve, seam, [&](const SegmentJoint& joint) { compare_sides(at_keys[joint.key], joint); });
  if (seam == Seam::closed) at_keys.back() = at_keys.front();
  Continuity whole;
  look_between_keys(
      curve, [&](const Motion& motion) { widen_magnitudes(whole, motion); },
      [&](const OrientationJump& jump) {
        if (jump.angle > at_keys[jump.key].orientation.angle) at_keys[jump.key].orientation = jump;
      });
  for (const auto of_rate : jumps_of_rates)
    for (const Continuity& at_key : at_keys)
      (whole.*of_rate).magnitude = std::max((whole.*of_rate).magnitude, (at_key.*of_rate).magnitude);
  std::vector<int> orders;
  for (Continuity& at_key : at_keys) {
    for (const auto of_rate : jumps_of_rates) (at_key.*of_rate).magnitude = (whole.*of_rate).magnitude;
    orders.push_back(with_relative_jumps(at_key).order());
  }
  return orders;
}

PathShape path_shape(const Motion& motion) noexcept {
  const double v = motion.angular_velocity.norm();
  const Eigen::Vector3d e = motion.angular_velocity / v;
  const auto across = [&](const Eigen::Vector3d& x) -> Eigen::Vector3d { return x - x.dot(e) * e; };
  const Eigen::Vector3d bend = across(motion.angular_acceleration) / v;  // de/dt
  const double along = motion.angular_acceleration.dot(e);
  return {e, bend / v, ((across(motion.angular_jerk) - 3.0 * along * bend) / v - bend.squaredNorm() * e) / (v * v)};
}

std::optional<int> ShapeContinuity::order_in_motion() const noexcept {
  if (broken || (joints > 0 && rests == joints)) return std::nullopt;
  return std::min(order_without_jumps(*this), told);
}

std::optional<int> ShapeContinuity::order() const noexcept {
  if (broken || stands > 0) return std::nullopt;
  const int at_rests = rests == 0 ? 3 : direction.relative > continuity_tolerance ? 0 : 1;
  return std::min(at_rests, order_in_motion().value_or(at_rests));
}

std::pair<double, std::size_t> ShapeContinuity::corner() const noexcept {
  const double half = direction.largest / 2.0;
  return {2.0 * atan2_of(half, std::sqrt(std::max(0.0, 1.0 - half * half))), direction.key};
}

bool ShapeContinuity::is_hidden() const noexcept { return order() == told && order_without_jumps(*this) > told; }

ShapeContinuity shape_continuity_at_keys(const AnyCurve& curve, Seam seam) {
  return continuities_at_keys(curve, seam).of_shape;
}

Continuities continuities_at_keys(const AnyCurve& curve, Seam seam) {
  Continuities found{.in_time = between_keys(curve)};
  for_each_joint(curve, seam, [&](const SegmentJoint& joint) {
    compare_sides(found.in_time, joint);
    compare_sides(found.of_shape, curve, joint, found.in_time);
  });
  found.of_shape.broken = found.in_time.orientation.angle > 0.0;
  found.in_time = with_relative_jumps(found.in_time);
  return found;
}

}}  // namespace orispline
