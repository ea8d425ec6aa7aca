// SPDX-License-Identifier: Apache-2.0
// THE list of the measures that `orispline compare` prints.
#include "commands/compare/compare_report.hpp"

#include <fmt/format.h>

#include "options/quantity.hpp"

namespace orispline::cli {
namespace {

using report::Better;
using report::Notation;

double time_in_file(const ComparedData& data, double t) {
  return (data.epoch + Decimal::from_double(t)).to_double();
}

/// A figure of the distances to the recording.
auto of_distance(double DistanceStatistics::*figure, double unit = degrees) {
  return [=](const Measures& m, const ComparedData&) { return std::optional(m.distance.*figure * unit); };
}

auto of_rate(double DistanceStatistics::*figure) {
  return [=](const Measures& m, const ComparedData&) -> std::optional<double> {
    if (!m.rate_error) return std::nullopt;
    return (*m.rate_error).*figure;
  };
}

auto of_energy(double Energies::*figure) {
  return [=](const Measures& m, const ComparedData&) { return std::optional(m.energies.*figure); };
}

auto peak_of(Peak Peaks::*peak) {
  return [=](const Measures& m, const ComparedData&) { return std::optional((m.peaks.*peak).value); };
}

auto peak_time_of(Peak Peaks::*peak) {
  return [=](const Measures& m, const ComparedData& data) {
    return std::optional(time_in_file(data, (m.peaks.*peak).time));
  };
}

}  // namespace

std::vector<CompareFigure> distance_figures() {
  using D = DistanceStatistics;
  const auto largest_time = [](const Measures& m, const ComparedData& data) {
    return std::optional(time_in_file(data, data.times[m.distance.largest_at]));
  };
  const auto mse = [](const Measures& m, const ComparedData&) { return std::optional(m.distance.mean_square()); };
  return {{"rms_deg",
           "rms",
           {"RMS [°]", Notation::shortest, 4},
           "RMS",
           "deg",
           "Root mean square of the angle to the recording",
           Better::less,
           of_distance(&D::rms)},
          {"mean_deg",
           "mean",
           {"mean [°]", Notation::shortest, 4},
           "mean",
           "deg",
           "Mean angle to the recording",
           Better::less,
           of_distance(&D::mean)},
          {"median_deg",
           "median",
           {},
           "median",
           "deg",
           "Half of the angles are not greater",
           Better::less,
           of_distance(&D::median)},
          {"p95_deg",
           "p95",
           {"95 % [°]", Notation::shortest, 4},
           "95 %",
           "deg",
           "95 % of the angles are not greater",
           Better::less,
           of_distance(&D::percentile_95)},
          {"p99_deg",
           "p99",
           {},
           "99 %",
           "deg",
           "99 % of the angles are not greater",
           Better::less,
           of_distance(&D::percentile_99)},
          {"max_deg",
           "max",
           {"max [°]", Notation::shortest, 4},
           "max",
           "deg",
           "Largest angle to the recording",
           Better::less,
           of_distance(&D::largest)},
          {"max_at_s",
           "",
           {"at [s]", Notation::shortest, 15},
           "max at",
           "s",
           "When the angle is the largest, in the file's own time",
           Better::neither,
           largest_time},
          {"mse_rad2", "", {}, "MSE", "rad²", "Mean square of the angle", Better::less, mse},
          {"spherical_rms_rad",
           "",
           {},
           "spherical RMS",
           "rad",
           "The same RMS on the sphere of unit quaternions: half the angles",
           Better::less,
           of_distance(&D::rms, 0.5)},
          {"spherical_max_rad",
           "",
           {},
           "spherical max",
           "rad",
           "The largest distance on the sphere of unit quaternions",
           Better::less,
           of_distance(&D::largest, 0.5)}};
}

namespace {

std::vector<CompareFigure> rate_figures() {
  using D = DistanceStatistics;
  return {{"rate_rms_rad_s",
           "rate",
           {"ω RMS [rad/s]", Notation::shortest, 4},
           "ω RMS",
           "rad/s",
           "Root mean square of the error of the angular velocity against the logged one",
           Better::less,
           of_rate(&D::rms)},
          {"rate_max_rad_s",
           "",
           {},
           "ω max",
           "rad/s",
           "Largest error of the angular velocity",
           Better::less,
           of_rate(&D::largest)}};
}

std::vector<CompareFigure> leave_out_figures() {
  return {{"leave_out_rms_deg",
           "",
           {"left out [°]", Notation::shortest, 4},
           "left out",
           "deg",
           "RMS at keys that were left out: an estimate of the error, not for choosing",
           Better::neither,
           [](const Measures& m, const ComparedData&) -> std::optional<double> {
             if (!m.leave_out) return std::nullopt;
             return m.leave_out->rms * degrees;
           }}};
}

}  // namespace

std::vector<CompareFigure> shape_figures() {
  const auto order = [](const Measures& m, const ComparedData&) { return std::optional<double>(m.continuity.order()); };
  const auto travelled = [](const Measures& m, const ComparedData&) {
    return std::optional(m.angle_travelled * degrees);
  };
  return {
      {"continuity",
       "continuity",
       {},
       "continuity",
       "",
       "Highest order up to 3 in which no rate jumps at a key",
       Better::more,
       order},
      {"energy",
       "energy",
       {"∫|α|² [rad²/s³]", Notation::shortest, 5},
       "∫|α|²",
       "rad²/s³",
       "Angular acceleration squared, summed over the segments; where ω jumps the true one is infinite",
       Better::less,
       of_energy(&Energies::acceleration)},
      {"jerk_energy",
       "jerk",
       {},
       "∫|jerk|²",
       "rad²/s⁵",
       "Angular jerk squared, summed over the segments",
       Better::less,
       of_energy(&Energies::jerk)},
      {"peak_rate_rad_s",
       "peak-rate",
       {"peak |ω| [rad/s]", Notation::shortest, 4},
       "peak |ω|",
       "rad/s",
       "Largest angular velocity",
       Better::less,
       peak_of(&Peaks::angular_velocity)},
      {"peak_rate_at_s", "", {}, "peak |ω| at", "s", "When", Better::neither, peak_time_of(&Peaks::angular_velocity)},
      {"peak_acceleration_rad_s2",
       "peak-acceleration",
       {},
       "peak |α|",
       "rad/s²",
       "Largest angular acceleration",
       Better::less,
       peak_of(&Peaks::angular_acceleration)},
      {"peak_acceleration_at_s",
       "",
       {},
       "peak |α| at",
       "s",
       "When",
       Better::neither,
       peak_time_of(&Peaks::angular_acceleration)},
      {"angle_travelled_deg",
       "",
       {},
       "travelled",
       "deg",
       "The whole angle that the curve turns by",
       Better::neither,
       travelled}};
}

std::vector<CompareFigure> torque_figures() {
  return {{"torque_energy",
           "torque",
           {"∫|torque|² [N²m²s]", Notation::shortest, 5},
           "∫|torque|²",
           "N²m²s",
           "Torque squared, summed over the segments",
           Better::less,
           of_energy(&Energies::torque)},
          {"peak_torque_n_m",
           "peak-torque",
           {"peak |torque| [N m]", Notation::shortest, 4},
           "peak |torque|",
           "N m",
           "Largest torque",
           Better::less,
           peak_of(&Peaks::torque)},
          {"peak_torque_at_s", "", {}, "peak |torque| at", "s", "When", Better::neither, peak_time_of(&Peaks::torque)}};
}

namespace {

std::vector<CompareFigure> cost_figures() {
  const auto build = [](const Measures& m, const ComparedData&) { return std::optional(m.build_seconds); };
  const auto total = [](const Measures& m, const ComparedData&) { return std::optional(m.seconds); };
  return {{"build_seconds", "", {}, "build", "s", "From keys to the curve, on this machine", Better::less, build},
          {"seconds",
           "seconds",
           {"time [s]", Notation::shortest, 2},
           "time",
           "s",
           "From keys to all samples, on this machine",
           Better::less,
           total}};
}

std::vector<CompareFigure> joined(std::initializer_list<std::vector<CompareFigure>> lists) {
  std::vector<CompareFigure> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace

std::vector<CompareFigure> compare_figures(const CompareReport& report) {
  const bool has_rates = !report.data.samples.angular_velocities().empty();
  return joined({distance_figures(), has_rates ? rate_figures() : std::vector<CompareFigure>(),
                 report.leave_out == LeaveOut::yes ? leave_out_figures() : std::vector<CompareFigure>(),
                 shape_figures(), report.inertia ? torque_figures() : std::vector<CompareFigure>(), cost_figures()});
}

std::vector<CompareFigure> all_compare_figures() {
  return joined({distance_figures(), rate_figures(), shape_figures(), torque_figures(), cost_figures()});
}

}  // namespace orispline::cli
