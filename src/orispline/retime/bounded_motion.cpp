// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/bounded_motion.hpp>

#include <algorithm>
#include <limits>

#include <orispline/curve/torque.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Limited = LimitedQuantity::Vector;

/// Of an increment so much is rounding [rad]: that of two keys, also when they are written, read and normalised again.
constexpr double rounding_of_keys = 16.0 * std::numeric_limits<double>::epsilon();

/// The larger size at the ends of the line a ± b r.
double largest(const LimitedQuantity& quantity, const Eigen::Vector3d& a, const Eigen::Vector3d& b, double r) {
  return std::max(quantity.size_of(a + b * r), quantity.size_of(a - b * r));
}

}  // namespace

Turning::Turning(const AnyCurve& curve, std::size_t segment, const SegmentHull& hull,
                 const MotionQuantities& quantities)
    : curve_(curve),
      segment_(segment),
      hull_(hull),
      rounding_(hull.rounding()),
      quantities_(quantities.all),
      inertia_(quantities.inertia.value_or(Eigen::Matrix3d::Zero())),
      weight_(inertia_.norm()) {}

double Turning::size(std::size_t k) const {
  const LimitedQuantity& quantity = quantities_[k];
  switch (quantity.vector) {
    case Limited::rate:
      return quantity.size_of(m_.angular_velocity);
    case Limited::acceleration:
      return quantity.size_of(m_.angular_acceleration);
    case Limited::jerk:
      return quantity.size_of(m_.angular_jerk);
    case Limited::torque:
      return quantity.size_of(torque(m_, inertia_));
    default:
      return 0.0;
  }
}

QuantitySizes Turning::bounds(const Stretch& part) const {
  const HullBounds hull = hull_.on(part.start, part.end);
  const double r = part.radius, jerk = m_.angular_jerk.norm();
  const double bend_of_rate = (0.5 * jerk + hull.snap * r / 6.0) * r * r,
               bend_of_acceleration = 0.5 * hull.snap * r * r;
  QuantitySizes sizes{};
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    const LimitedQuantity& quantity = quantities_[k];
    if (quantity.vector == Limited::rate)
      sizes[k] =
          std::min(hull.rate, largest(quantity, m_.angular_velocity, m_.angular_acceleration, r) + bend_of_rate) +
          rounding_.rate;
    if (quantity.vector == Limited::acceleration)
      sizes[k] = std::min(hull.acceleration,
                          largest(quantity, m_.angular_acceleration, m_.angular_jerk, r) + bend_of_acceleration) +
                 rounding_.acceleration;
    if (quantity.vector == Limited::jerk)
      sizes[k] = std::min(hull.jerk, jerk_bound(quantity, part, hull)) + rounding_.jerk;
    if (quantity.vector == Limited::torque) sizes[k] = torque_bound(quantity, r, hull);
  }
  return sizes;
}

void Turning::round(SegmentPeaks& peaks, double shortest) const {
  const double rate = rounding_of_keys / shortest, acceleration = rate / shortest;
  double fastest = 0.0;
  for (std::size_t k = 0; k < quantities_.size(); ++k) {
    const Limited vector = quantities_[k].vector;
    if (vector == Limited::rate) peaks[k].bound += rate;
    if (vector == Limited::acceleration) peaks[k].bound += acceleration;
    if (vector == Limited::jerk) peaks[k].bound += acceleration / shortest;
    if (vector == Limited::rate) fastest = std::max(fastest, peaks[k].bound);
  }
  for (std::size_t k = 0; k < quantities_.size(); ++k)
    if (quantities_[k].vector == Limited::torque)
      peaks[k].bound += weight_ * (acceleration + 2.0 * std::max(fastest, hull_.on(0.0, 1.0).rate) * rate);
}

double Turning::jerk_bound(const LimitedQuantity& quantity, const Stretch& part, const HullBounds& hull) const {
  const double r = part.radius;
  const auto at = [&](double t) { return quantity.size_of(curve_.motion_on(segment_, t).angular_jerk); };
  const double chord = std::max(at(part.middle - r), at(part.middle + r)) + 0.5 * hull.crackle * r * r;
  return std::min(quantity.size_of(m_.angular_jerk) + hull.snap * r, chord);
}

double Turning::torque_bound(const LimitedQuantity& quantity, double r, const HullBounds& hull) const {
  const double jerk = m_.angular_jerk.norm();
  const auto longest = [r](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return std::max((a + b * r).norm(), (a - b * r).norm());
  };
  const double rate = std::min(hull.rate, longest(m_.angular_velocity, m_.angular_acceleration) +
                                              (0.5 * jerk + hull.snap * r / 6.0) * r * r) +
                      rounding_.rate;
  const double acceleration =
      std::min(hull.acceleration, longest(m_.angular_acceleration, m_.angular_jerk) + 0.5 * hull.snap * r * r) +
      rounding_.acceleration;
  const double bend = weight_ * (hull.snap + 2.0 * ((jerk + hull.snap * r) * rate + acceleration * acceleration));
  const double along = largest(quantity, torque(m_, inertia_), torque_rate(m_, inertia_), r) + 0.5 * bend * r * r +
                       weight_ * (rounding_.acceleration + 2.0 * rate * rounding_.rate);
  return std::min(along, weight_ * (acceleration + rate * rate));
}

double Moving::size(std::size_t k) const {
  const LimitedQuantity& quantity = quantities_[k];
  if (quantity.vector == Limited::speed) return quantity.size_of(m_.velocity);
  return quantity.vector == Limited::linear_acceleration ? quantity.size_of(m_.acceleration) : 0.0;
}

QuantitySizes Moving::bounds(const Stretch& part) const {
  QuantitySizes sizes{};
  for (std::size_t k = 0; k < quantities_.size(); ++k)
    if (quantities_[k].is_of_position()) sizes[k] = hull_.bound(quantities_[k], part.start, part.end);
  return sizes;
}

}}  // namespace orispline
