// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <orispline/batch/sample.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/retime/rate_bounds.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

Eigen::Vector3d vector_at(const std::vector<double>& numbers, std::size_t k) {
  return numbers.empty() ? Eigen::Vector3d::Zero().eval() : Eigen::Vector3d(&numbers[3 * k]);
}

}  // namespace

std::vector<QuantitySizes> sampled_peaks(const PoseCurve& curve, const MotionQuantities& quantities) {
  using Vector = LimitedQuantity::Vector;
  constexpr std::size_t cuts = 16, places = cuts + 1;
  const Knots& knots = curve.orientation.knots();
  std::vector<QuantitySizes> peaks(knots.segments(), QuantitySizes{});
  std::vector<double> times;
  for (std::size_t s = 0; s < peaks.size(); ++s) {
    const KnotSpan span = knots.span(s);
    const double step = span.step() / static_cast<double>(cuts);
    const double last = std::nextafter(span.end(), span.start());  // the end itself belongs to the next segment
    for (std::size_t i = 0; i < places; ++i)
      times.push_back(std::min(span.start() + static_cast<double>(i) * step, last));
  }
  std::array<std::vector<double>, 6> found;  // by what is limited; the torque needs the first two
  const auto wants = [&](Vector vector) {
    return std::ranges::count(quantities.all, vector, &LimitedQuantity::vector) > 0;
  };
  const auto room = [&](Vector vector, bool wanted) {
    auto& numbers = found[static_cast<std::size_t>(vector)];
    if (wanted) numbers.resize(3 * times.size());
    return std::span<double>(numbers);
  };
  std::vector<double> orientations(4 * times.size());
  const Samples<double> out{.orientations = orientations,
                            .angular_velocities = room(Vector::rate, true),
                            .angular_accelerations = room(Vector::acceleration, true),
                            .angular_jerks = room(Vector::jerk, wants(Vector::jerk)),
                            .velocities = room(Vector::speed, wants(Vector::speed)),
                            .accelerations = room(Vector::linear_acceleration, wants(Vector::linear_acceleration))};
  // No times that decrease, no sizes that differ: no error.
  static_cast<void>(wants_positions(out) ? sample<double>(curve, times, out, {.threads = 0})
                                         : sample<double>(curve.orientation, times, out, {.threads = 0}));
  const auto& rates = found[static_cast<std::size_t>(Vector::rate)];
  const auto& accelerations = found[static_cast<std::size_t>(Vector::acceleration)];
  for (std::size_t k = 0; k < times.size(); ++k)
    for (std::size_t i = 0; i < quantities.all.size(); ++i) {
      const LimitedQuantity& quantity = quantities.all[i];
      Eigen::Vector3d v = vector_at(found[static_cast<std::size_t>(quantity.vector)], k);
      if (quantity.vector == Vector::torque && quantities.inertia)
        v = torque(Motion{.angular_velocity = vector_at(rates, k), .angular_acceleration = vector_at(accelerations, k)},
                   *quantities.inertia);
      double& largest_found = peaks[k / places][i];
      largest_found = std::max(largest_found, quantity.size_of(v));
    }
  return peaks;
}

}}  // namespace orispline
