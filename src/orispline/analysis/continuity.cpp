// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/continuity.hpp>

#include <algorithm>
#include <array>

#include <orispline/analysis/joints.hpp>
#include <orispline/analysis/rounding.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Rate = Eigen::Vector3d Motion::*;
constexpr std::array<Rate, 3> rates_of_motion{&Motion::angular_velocity, &Motion::angular_acceleration,
                                              &Motion::angular_jerk};
using Jumps = std::array<RateJump, 3>;

void widen_magnitudes(Jumps& jumps, const Motion& motion) {
  for (std::size_t k = 0; k < rates_of_motion.size(); ++k)
    jumps[k].magnitude = std::max(jumps[k].magnitude, (motion.*rates_of_motion[k]).norm());
}

/// Largest jumps, and of those that are not rounding the largest as `relative`, still in the unit of the rate.
void compare_sides(Jumps& jumps, const Joint& joint) {
  widen_magnitudes(jumps, joint.left);
  widen_magnitudes(jumps, joint.right);
  for (std::size_t k = 0; k < rates_of_motion.size(); ++k) {
    const double jump = (joint.right.*rates_of_motion[k] - joint.left.*rates_of_motion[k]).norm();
    if (jump > jumps[k].largest) {
      jumps[k].largest = jump;
      jumps[k].key = joint.key;
    }
    if (jump > rounding_of_rates(joint.spacing, static_cast<int>(k) + 1))
      jumps[k].relative = std::max(jumps[k].relative, jump);
  }
}

}  // namespace

int Continuity::order() const noexcept {
  if (angular_velocity.relative > continuity_tolerance) return 0;
  if (angular_acceleration.relative > continuity_tolerance) return 1;
  return angular_jerk.relative > continuity_tolerance ? 2 : 3;
}

Continuity continuity_at_keys(const AnyCurve& curve, Seam seam) {
  Jumps jumps{};
  for_each_probe(curve, [&](const Motion& motion) { widen_magnitudes(jumps, motion); });
  for_each_joint(curve, seam, [&](const Joint& joint) { compare_sides(jumps, joint); });
  for (RateJump& jump : jumps)
    if (jump.relative > 0.0) jump.relative /= jump.magnitude;
  return {jumps[0], jumps[1], jumps[2]};
}

}}  // namespace orispline
