// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/continuity.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/analysis/rounding.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

using Rate = Eigen::Vector3d Motion::*;
constexpr std::array<Rate, 3> rates_of_motion{&Motion::angular_velocity, &Motion::angular_acceleration,
                                              &Motion::angular_jerk};
using Jumps = std::array<RateJump, 3>;

void widen_magnitudes(Jumps& jumps, const Motion& motion) {
  for (std::size_t k = 0; k < rates_of_motion.size(); ++k)
    jumps[k].magnitude = std::max(jumps[k].magnitude, (motion.*rates_of_motion[k]).norm());
}

/// Where two segments meet.
struct Joint {
  std::size_t key;
  double spacing;  // the smaller one beside it [s]
  Motion left, right;
};

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

Joint interior_joint(const AnyCurve& curve, std::size_t key) {
  const auto t = curve.knots().times();
  return {key, std::min(t[key] - t[key - 1], t[key + 1] - t[key]), curve.motion(t[key], Side::left),
          curve.motion(t[key], Side::right)};
}

Joint seam_of(const AnyCurve& curve) {
  const auto t = curve.knots().times();
  const std::size_t last = t.size() - 1;
  return {0, std::min(t[1] - t[0], t[last] - t[last - 1]), curve.motion(t[last]), curve.motion(t[0])};
}

}  // namespace

int Continuity::order() const noexcept {
  if (angular_velocity.relative > continuity_tolerance) return 0;
  if (angular_acceleration.relative > continuity_tolerance) return 1;
  return angular_jerk.relative > continuity_tolerance ? 2 : 3;
}

Continuity continuity_at_keys(const AnyCurve& curve, Seam seam) {
  Jumps jumps{};
  const auto t = curve.knots().times();
  widen_magnitudes(jumps, curve.motion(t.front()));
  widen_magnitudes(jumps, curve.motion(t.back()));
  for (std::size_t i = 0; i + 1 < t.size(); ++i) {
    for (const double u : {0.25, 0.5, 0.75}) widen_magnitudes(jumps, curve.motion(std::lerp(t[i], t[i + 1], u)));
    if (i > 0) compare_sides(jumps, interior_joint(curve, i));
  }
  if (seam == Seam::closed && t.size() > 1) compare_sides(jumps, seam_of(curve));
  for (RateJump& jump : jumps)
    if (jump.relative > 0.0) jump.relative /= jump.magnitude;
  return {jumps[0], jumps[1], jumps[2]};
}

}  // namespace orispline::inline ORISPLINE_ABI
