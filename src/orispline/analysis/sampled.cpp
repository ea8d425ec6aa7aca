// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/sampled.hpp>

#include <algorithm>

#include <orispline/base/expect.hpp>
#include <orispline/batch/sample.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Sampling in bulk gives the rates on leaving a key: neither side is the right one where they jump.
void average_sides_at_keys(std::vector<Eigen::Vector3d>& rates, const AnyCurve& curve, std::span<const double> times) {
  const auto knots = curve.knots().times();
  for (std::size_t key = 1; key + 1 < knots.size(); ++key) {
    const auto found = std::ranges::lower_bound(times, knots[key]);
    if (found == times.end()) return;
    if (*found != knots[key]) continue;
    Eigen::Vector3d& rate = rates[static_cast<std::size_t>(found - times.begin())];
    rate = 0.5 * (rate + curve.motion(knots[key], Side::left).angular_velocity);
  }
}

/// Of two samples at one time the first one stands before the jump, which sampling in bulk does not know.
void take_side_before_jumps(SampledCurve& samples, const AnyCurve& curve, std::span<const double> times) {
  const auto knots = curve.knots().times();
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (times[i] != times[i - 1] || std::ranges::equal_range(knots, times[i]).size() < 2) continue;
    const Motion before = curve.motion(times[i], Side::left);
    samples.orientations[i - 1] = before.orientation;
    if (!samples.angular_velocities.empty()) samples.angular_velocities[i - 1] = before.angular_velocity;
  }
}

}  // namespace

SampledCurve sampled(const AnyCurve& curve, std::span<const double> times, Sampled what) {
  static_assert(sizeof(Eigen::Quaterniond) == 4 * sizeof(double) && sizeof(Eigen::Vector3d) == 3 * sizeof(double));
  SampledCurve samples{.orientations = std::vector<Eigen::Quaterniond>(times.size()), .angular_velocities = {}};
  if (times.empty()) return samples;
  Samples<double> out{.orientations = {samples.orientations.data()->coeffs().data(), 4 * times.size()}};
  if (what == Sampled::orientations_and_rates) {
    samples.angular_velocities.resize(times.size());
    out.angular_velocities = {samples.angular_velocities.data()->data(), 3 * times.size()};
  }
  const auto made = sample<double>(curve, times, out);
  ORISPLINE_EXPECT(made.has_value());
  if (what == Sampled::orientations_and_rates) average_sides_at_keys(samples.angular_velocities, curve, times);
  take_side_before_jumps(samples, curve, times);
  return samples;
}

TimesWithin times_within(std::span<const double> times, Domain domain) {
  const auto first = std::ranges::lower_bound(times, domain.start), last = std::ranges::upper_bound(times, domain.end);
  return {static_cast<std::size_t>(first - times.begin()), static_cast<std::size_t>(std::max(last - first, {}))};
}

}}  // namespace orispline
