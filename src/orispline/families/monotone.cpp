// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/monotone.hpp>

#include <orispline/curve/four_key_curve.hpp>
#include <orispline/curve/monotone_rates.hpp>
#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

/// What cubics between the knots need: the points there, the increments between them and the rates.
template <CurvePoint P>
struct Joints {
  Knots knots;
  std::vector<P> points;
  std::vector<Displacement<P>> increments;
  std::vector<Eigen::Vector3d> rates;
};

/// No rates at either end of the steps that turn by no more than an angle, where that is not 0.
void hold_still(Joints<Eigen::Quaterniond>& joints, double angle) {
  const std::size_t last = joints.increments.size() - 1;
  for (std::size_t i = 0; i <= last && angle > 0.0; ++i) {
    if (joints.increments[i].norm() > angle) continue;
    joints.rates[i] = joints.rates[i + 1] = Eigen::Vector3d::Zero();
  }
}

template <CurvePoint P>
Joints<P> joints_of(const Keyframes& keys, const FamilySettings& settings) {
  const auto points = keys.points<P>();
  Joints<P> joints{
      .knots = four_key_knots(keys, settings), .points = {points.begin(), points.end()}, .increments = {}, .rates = {}};
  if (settings.closure) joints.points.push_back(come_round(joints.points.front(), *settings.closure));
  joints.increments = increments_between(joints.points);
  std::vector<double> steps;
  for (std::size_t i = 0; i < joints.knots.segments(); ++i) steps.push_back(joints.knots.span(i).step());
  joints.rates = monotone_rates(joints.increments, steps, settings.closure.has_value());
  if constexpr (std::same_as<P, Eigen::Quaterniond>) hold_still(joints, settings.per_key(rest_angle_setting.name)[0]);
  return joints;
}

/// The cubic from `start` by `step`, in the chart at the middle between both, with the given ω at its ends. Its part
/// along the step is the cubic Hermite polynomial with the parts of ω along it.
ChartPiece<3> cubic_about_middle(const Eigen::Quaterniond& start, const Eigen::Vector3d& step,
                                 const Eigen::Vector3d& leaving, const Eigen::Vector3d& arriving, double h) {
  const Eigen::Vector3d half = 0.5 * step, before = -half;
  return chart_piece<1>(start * exp<double>(half), before, half, chart_derivatives<1>(before, {leaving}),
                        chart_derivatives<1>(half, {arriving}), h);
}

}  // namespace

Expected<ChartCurve<3>> Monotone::curve(const Keyframes& keys, const FamilySettings& settings) {
  auto [knots, points, increments, rates] = joints_of<Eigen::Quaterniond>(keys, settings);
  std::vector<ChartPiece<3>> pieces;
  pieces.reserve(knots.segments());
  for (std::size_t i = 0; i < knots.segments(); ++i)
    pieces.push_back(cubic_about_middle(points[i], increments[i], rates[i], rates[i + 1], knots.span(i).step()));
  return ChartCurve<3>(std::move(knots), std::move(pieces));
}

Expected<HermitePath<3>> Monotone::path(const Keyframes& keys, const FamilySettings& settings) {
  auto joints = joints_of<Eigen::Vector3d>(keys, settings);
  std::vector<HermitePath<3>::Derivatives> derivatives;
  derivatives.reserve(joints.rates.size());
  for (const Eigen::Vector3d& rate : joints.rates) derivatives.push_back({rate});
  return HermitePath<3>(std::move(joints.knots), std::move(joints.points), std::move(derivatives));
}

}}}  // namespace orispline::families
