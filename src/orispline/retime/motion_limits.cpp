// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/motion_limits.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

int LimitedQuantity::order() const noexcept {
  switch (vector) {
    case Vector::rate:
    case Vector::speed:
      return 1;
    case Vector::jerk:
      return 3;
    default:
      return 2;
  }
}

std::vector<LimitedQuantity> quantities_of(const MotionLimits& limits) {
  using Vector = LimitedQuantity::Vector;
  std::vector<LimitedQuantity> quantities;
  const auto add = [&](Vector vector, const std::optional<Limit>& limit) {
    if (!limit) return;
    for (std::size_t axis = 0; axis < limit->sizes.size(); ++axis)
      quantities.push_back(
          {vector, limit->is_per_axis() ? std::optional(axis) : std::nullopt, limit->sizes[axis], limit->stated_in});
  };
  add(Vector::rate, limits.rate);
  add(Vector::acceleration, limits.acceleration);
  add(Vector::jerk, limits.jerk);
  add(Vector::torque, limits.torque);
  add(Vector::speed, limits.speed);
  add(Vector::linear_acceleration, limits.linear_acceleration);
  return quantities;
}

}}  // namespace orispline
