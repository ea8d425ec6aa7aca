// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/motion_limits.hpp>

#include <algorithm>
#include <cmath>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The root that undoes a power of slowing.
double root(double x, int order) {
  if (order == 1) return x;
  if (order == 2) return std::sqrt(x);
  if (!(x > 0.0) || std::isinf(x)) return x;
  // The same bits on every machine: Newton's steps from a power of two, at most a factor of 2 away.
  int exponent = 0;
  const double scaled = std::frexp(x, &exponent);
  const int whole = exponent >= 0 ? exponent / 3 : (exponent - 2) / 3;
  const double y = std::ldexp(scaled, exponent - 3 * whole);  // in [1/2, 4)
  double z = 1.0;
  for (int step = 0; step < 8; ++step) z -= (z * z * z - y) / (3.0 * z * z);
  return std::ldexp(z, whole);
}

}  // namespace

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

double needed_factor(const QuantitySizes& peaks, std::span<const LimitedQuantity> quantities) {
  double factor = 0.0;
  for (std::size_t k = 0; k < quantities.size(); ++k)
    factor = std::max(factor, root(peaks[k] / quantities[k].limit, quantities[k].order()));
  return factor;
}

}}  // namespace orispline
