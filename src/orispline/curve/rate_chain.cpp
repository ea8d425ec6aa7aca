// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/rate_chain.hpp>

#include <algorithm>

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

std::optional<Eigen::Vector3d> end_rate(const End& end, const Eigen::Vector3d& secant) {
  switch (end.rule) {
    case EndRule::clamped:
      return end.angular_velocity;
    case EndRule::rest:
      return Eigen::Vector3d::Zero();
    case EndRule::secant:
      return secant;
    default:
      return std::nullopt;
  }
}

End for_positions(End end) {
  if (end.rule == EndRule::clamped) end = {.rule = EndRule::natural};
  return end;
}

/// Length of the longest, 1 where all are zero.
double largest(const std::vector<Eigen::Vector3d>& chords) {
  double length = 0.0;
  for (const Eigen::Vector3d& chord : chords) length = std::max(length, chord.norm());
  return length > 0.0 ? length : 1.0;
}

}  // namespace

RateConditions rate_conditions(const FamilySettings& settings, std::span<const Eigen::Vector3d> increments,
                               const Knots& knots) {
  RateConditions conditions{.closed = settings.closure.has_value()};
  if (const auto nu = settings.parameters.find("nu"); nu != settings.parameters.end()) conditions.nu = nu->second;
  if (conditions.closed) return conditions;
  const std::size_t last = knots.segments() - 1;
  conditions.start = end_rate(settings.start, increments[0] / knots.span(0).step());
  conditions.end = end_rate(settings.end, increments[last] / knots.span(last).step());
  return conditions;
}

Expected<HermitePath<3>> cubic_spline_path(std::string_view method, const Keyframes& keys,
                                           const FamilySettings& settings) {
  Knots knots = four_key_knots(keys, settings);
  std::vector<Eigen::Vector3d> positions(keys.positions().begin(), keys.positions().end());
  FamilySettings ends = settings;
  if (settings.closure) positions.push_back(positions.front());
  ends.start = for_positions(settings.start);
  ends.end = for_positions(settings.end);
  std::vector<Eigen::Vector3d> chords = increments_between(positions);
  const double size = largest(chords);  // the residual is to be small beside the chords, in whatever unit they are
  for (Eigen::Vector3d& chord : chords) chord /= size;
  return solve_rates<FlatPiece>(method, chords, knots, rate_conditions(ends, chords, knots))
      .map([&](const std::vector<Eigen::Vector3d>& velocities) {
        std::vector<HermitePath<3>::Derivatives> derivatives;
        derivatives.reserve(velocities.size());
        for (const Eigen::Vector3d& v : velocities) derivatives.push_back({size * v});
        return HermitePath<3>(std::move(knots), std::move(positions), std::move(derivatives));
      });
}

}}  // namespace orispline
