// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/analysis/measure_info.hpp>
#include <orispline/math/degrees.hpp>

// How each measure of the list takes its value from the results, in its unit.

namespace orispline { inline namespace ORISPLINE_ABI { namespace measure_value {

using Value = std::optional<double>;

/// Angles of equal orientations, energies of constant rates and the like, far below what any motion has.
inline constexpr double no_value = 1e-12, no_square = 1e-24;

[[nodiscard]] inline double time_in_file(const MeasureTimes& times, double t) {
  return (times.epoch + Decimal::from_double(t)).to_double();
}

template <double DistanceStatistics::*figure>
[[nodiscard]] Value angle(const Measures& m, const MeasureTimes&) {
  return m.distance.*figure * degrees;
}

[[nodiscard]] inline Value time_of_largest(const Measures& m, const MeasureTimes& times) {
  return time_in_file(times, times.recording[m.distance.largest_at]);
}

[[nodiscard]] inline Value mean_square(const Measures& m, const MeasureTimes&) { return m.distance.mean_square(); }

template <double DistanceStatistics::*figure>
[[nodiscard]] Value spherical(const Measures& m, const MeasureTimes&) {
  return m.distance.*figure * 0.5;
}

template <double DistanceStatistics::*figure>
[[nodiscard]] Value rate(const Measures& m, const MeasureTimes&) {
  return m.rate_error ? Value((*m.rate_error).*figure) : std::nullopt;
}

[[nodiscard]] inline Value leave_out(const Measures& m, const MeasureTimes&) {
  return m.leave_out ? Value(m.leave_out->rms * degrees) : std::nullopt;
}

[[nodiscard]] inline Value inside_band(const Measures& m, const MeasureTimes&) { return m.inside_band; }

[[nodiscard]] inline Value continuity(const Measures& m, const MeasureTimes&) { return m.continuity.order(); }

[[nodiscard]] inline Value shape(const Measures& m, const MeasureTimes&) {
  const auto order = m.shape.order();
  return order ? Value(*order) : std::nullopt;
}

[[nodiscard]] inline Value curvature_jump(const Measures& m, const MeasureTimes&) {
  return m.shape.rests < m.shape.joints || m.shape.joints == 0 ? Value(m.shape.curvature.largest) : std::nullopt;
}

template <double Energies::*figure>
[[nodiscard]] Value energy(const Measures& m, const MeasureTimes&) {
  return m.energies.*figure;
}

/// Absent where ω jumps, since the energy is infinite then, and where the least is as small as rounding errors.
[[nodiscard]] inline Value times_least_energy(const Measures& m, const MeasureTimes&) {
  if (!m.least_energy || !(*m.least_energy > no_square) || m.continuity.order() < 1) return std::nullopt;
  return m.energies.acceleration / *m.least_energy;
}

template <Peak Peaks::*figure>
[[nodiscard]] Value peak(const Measures& m, const MeasureTimes&) {
  return (m.peaks.*figure).value;
}

template <Peak Peaks::*figure>
[[nodiscard]] Value peak_time(const Measures& m, const MeasureTimes& times) {
  return time_in_file(times, (m.peaks.*figure).time);
}

template <Peak Peaks::*figure>
[[nodiscard]] Value peak_bound(const Measures& m, const MeasureTimes&) {
  return (m.peaks.*figure).bound;
}

[[nodiscard]] inline Value angle_travelled(const Measures& m, const MeasureTimes&) {
  return m.angle_travelled * degrees;
}

template <double Measures::*figure>
[[nodiscard]] Value seconds(const Measures& m, const MeasureTimes&) {
  return m.*figure;
}

}}}  // namespace orispline::measure_value
