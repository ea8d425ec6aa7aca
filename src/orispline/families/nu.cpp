// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/nu.hpp>

#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/points_through.hpp>
#include <orispline/curve/rate_chain.hpp>
#include <orispline/families/nu_construction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

using Ratios = NuRatios<double>;

Expected<Ratios> ratios_of(std::span<const double> t, const PerKey& nu) {
  const NuSteps step{t};
  std::vector<double> gamma;
  for (std::size_t i = 0; i < t.size(); ++i) {
    gamma.push_back(nu_gamma<double>(step, i, nu[i]));
    if (!(gamma[i] > 0.0 && std::isfinite(gamma[i])))
      return failure(ErrorCode::bad_argument,
                     formatted("nu: nu is {}, wanted more than {:.6g} between these key times", nu[i],
                               -2.0 * (step(i) + step(i + 1)) / (step(i) * step(i + 1))),
                     {.key = i});
  }
  return nu_ratios<double>(step, gamma);
}

using Handle = std::optional<Eigen::Vector3d>;

Expected<Handle> handle_of(const End& end, double third, std::size_t key) {
  if (end.rule == EndRule::natural) return std::nullopt;
  Eigen::Vector3d handle = third * end.angular_velocity;
  if (handle.norm() < NuRule<double>::forbidden_turn) return handle;
  return failure(ErrorCode::bad_argument,
                 formatted("nu: the end rate is {:.6g} rad/s, wanted less than {:.6g} for the length of this end's "
                           "segment: the handle would wind round",
                           end.angular_velocity.norm(), NuRule<double>::forbidden_turn / std::abs(third)),
                 {.key = key});
}

Expected<NuRule<double>> rule_of(const Keyframes& keys, const FamilySettings& settings, const Ratios& ratios) {
  const auto t = keys.times();
  const std::size_t last = t.size() - 1;
  return handle_of(settings.start, (t[1] - t[0]) / 3.0, 0).and_then([&](const Handle& start) {
    return handle_of(settings.end, -(t[last] - t[last - 1]) / 3.0, last).map([&](const Handle& end) {
      return NuRule<double>{.ratios = ratios, .start = start, .end = end};
    });
  });
}

/// Every segment from a key over the two inner points on its arc of the control polygon to the next key.
SlerpBezierCurve curve_of(const Keyframes& keys, const std::vector<Eigen::Quaterniond>& d, const Ratios& ratios) {
  const auto q = keys.orientations();
  std::vector<Eigen::Quaterniond> points{q[0]};
  for (std::size_t i = 0; i + 1 < q.size(); ++i)
    points.insert(points.end(), {slerp<double>(d[i], d[i + 1], ratios.after[i]),
                                 slerp<double>(d[i], d[i + 1], ratios.before[i + 1]), q[i + 1]});
  return {key_knots(keys), points};
}

}  // namespace

Expected<Nu::Construction> Nu::construction(const Keyframes& keys, const FamilySettings& settings) {
  return ratios_of(keys.times(), settings.per_key("nu")).and_then([&](const Ratios& ratios) {
    return rule_of(keys, settings, ratios).and_then([&](const NuRule<double>& rule) {
      return control_points_through(keys.orientations(), info.name, rule).map([&](auto controls) {
        return Construction{rule, std::move(controls)};
      });
    });
  });
}

Expected<SlerpBezierCurve> Nu::curve(const Keyframes& keys, const FamilySettings& settings) {
  return construction(keys, settings).map([&](const Construction& made) {
    return curve_of(keys, made.controls, made.rule.ratios);
  });
}

Expected<HermitePath<3>> Nu::path(const Keyframes& keys, const FamilySettings& settings) {
  return cubic_spline_path(info.name, keys, settings);
}

}}}  // namespace orispline::families
