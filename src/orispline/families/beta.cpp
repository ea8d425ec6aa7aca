// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/beta.hpp>

#include <fmt/format.h>

namespace orispline::families {
namespace {

/// Where the two inner points of arc i stand on the way from control point i to i+1, and how a joint divides its arc.
struct Ratios {
  std::vector<double> inner1, inner2;  ///< γ_i/Δ_i and (γ_i + 1)/Δ_i, one per arc
  std::vector<double> joint;           ///< 1/(1 + β_{i,1}), one per control point
};

Expected<Ratios> ratios_of(std::size_t points, const FamilySettings& settings) {
  const PerKey beta1 = settings.per_key("beta1"), beta2 = settings.per_key("beta2");
  std::vector<double> gamma(points);
  Ratios r;
  for (std::size_t i = 0; i < points; ++i) {
    const double b1 = beta1[i], b2 = beta2[i], pole = -2.0 * b1 * (1.0 + b1);
    if (!(b2 > pole))
      return failure(ErrorCode::bad_argument,
                     fmt::format("beta: beta2 is {}, wanted more than -2 beta1 (1 + beta1) = {}: there the control "
                                 "points of the construction meet a pole or fold back",
                                 b2, pole),
                     {.key = i});
    gamma[i] = 2.0 * (1.0 + b1) / (b2 - pole);
    r.joint.push_back(1.0 / (1.0 + b1));
  }
  for (std::size_t i = 0; i + 1 < points; ++i) {
    const double delta = gamma[i] + 1.0 + beta1[i + 1] * beta1[i + 1] * gamma[i + 1];
    r.inner1.push_back(gamma[i] / delta);
    r.inner2.push_back((gamma[i] + 1.0) / delta);
  }
  return r;
}

Knots joint_times(const Keyframes& keys) { return Knots({keys.times().begin() + 1, keys.times().end() - 1}); }

}  // namespace

Expected<CubicBezierCurve> Beta::curve(const Keyframes& keys, const FamilySettings& settings) {
  const auto p = keys.orientations();
  return ratios_of(p.size(), settings).map([&](const Ratios& r) {
    std::vector<Eigen::Quaterniond> inner1, inner2;  // q_{i,1}, q_{i,2} of the paper
    ControlPolygon polygon;
    for (std::size_t i = 0; i + 1 < p.size(); ++i) {
      const Eigen::Vector3d arc = increment<double>(p[i], p[i + 1]);
      inner1.push_back(p[i] * exp<double>(r.inner1[i] * arc));
      inner2.push_back(p[i] * exp<double>(r.inner2[i] * arc));
    }
    for (std::size_t i = 1; i + 2 < p.size(); ++i) {
      const Eigen::Vector3d in = increment<double>(inner2[i - 1], inner1[i]);
      const Eigen::Vector3d out = increment<double>(inner2[i], inner1[i + 1]);
      const double before = r.joint[i];
      polygon.bases.push_back(inner2[i - 1] * exp<double>(before * in));
      polygon.increments.insert(polygon.increments.end(),
                                {(1.0 - before) * in, increment<double>(inner1[i], inner2[i]), r.joint[i + 1] * out});
    }
    return CubicBezierCurve(joint_times(keys), CubicBezierBasis{}, std::move(polygon));
  });
}

Expected<CubicBezierPath> Beta::path(const Keyframes& keys, const FamilySettings& settings) {
  const auto p = keys.positions();
  return ratios_of(p.size(), settings).map([&](const Ratios& r) {
    const auto on_arc = [&](std::size_t i, double s) -> Eigen::Vector3d { return p[i] + s * (p[i + 1] - p[i]); };
    PathPolygon points;
    for (std::size_t i = 1; i + 1 < p.size(); ++i) {
      const Eigen::Vector3d before = on_arc(i - 1, r.inner2[i - 1]), after = on_arc(i, r.inner1[i]);
      points.push_back(before + r.joint[i] * (after - before));
      if (i + 2 < p.size()) points.insert(points.end(), {after, on_arc(i, r.inner2[i])});
    }
    return CubicBezierPath(joint_times(keys), CubicBezierBasis{}, std::move(points));
  });
}

}  // namespace orispline::families
