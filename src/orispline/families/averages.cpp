// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/averages.hpp>

#include <numbers>

#include <fmt/format.h>

#include <orispline/curve/points_through.hpp>
#include <orispline/curve/reflected.hpp>

namespace orispline::families {
namespace {

Knots key_times(const Keyframes& keys) { return Knots({keys.times().begin(), keys.times().end()}); }

BSplineBasis<3> basis_on(std::span<const double> key_times) {
  const auto t = reflected(key_times);
  BSplineBasis<3> basis;
  for (std::ptrdiff_t i = -2; i < static_cast<std::ptrdiff_t>(key_times.size()) + 2; ++i) basis.knots.push_back(t[i]);
  return basis;
}

/// What key i misses the average of control points i-1, i, i+1 by, each with its weight at the key's time.
struct AverageToKey {
  static constexpr double forbidden_turn = std::numbers::pi;
  std::vector<std::array<double, 3>> weights;

  AverageToKey(const Knots& knots, const BSplineBasis<3>& basis) {
    for (std::size_t i = 0; i < knots.segments(); ++i) {
      const auto tails = basis(knots.span(i), knots.span(i).start());
      weights.push_back({1.0 - tails[0], tails[0] - tails[1], tails[1]});
    }
    weights.push_back({weights.front()[2], weights.front()[1], weights.front()[0]});
  }

  template <class P>
  [[nodiscard]] auto operator()(std::size_t i, const P& before, const P& at, const P& after, const P& key) const {
    using T = typename P::Scalar;
    const auto& w = weights[i];
    return Vector3<T>(displacement(key, before) * T(w[0]) + displacement(key, at) * T(w[1]) +
                      displacement(key, after) * T(w[2]));
  }
};

template <CurvePoint P>
Expected<std::vector<P>> control_points(const Keyframes& keys, std::span<const P> points,
                                        const FamilySettings& settings) {
  const auto with_ghosts = [](std::span<const P> inner) {
    const auto all = reflected(inner);
    std::vector<P> list{all[-1]};
    list.insert(list.end(), inner.begin(), inner.end());
    list.push_back(all[static_cast<std::ptrdiff_t>(inner.size())]);
    return list;
  };
  if (settings.choice("points") == "control") return with_ghosts(points);
  return control_points_through(points, Averages::info.name, AverageToKey(key_times(keys), basis_on(keys.times())))
      .map([&](const std::vector<P>& solved) { return with_ghosts(solved); });
}

Error too_far_apart(std::size_t key, double missing) {
  return {ErrorCode::not_converged,
          fmt::format(
              "averages does not converge for these keys: the residual stays at {:.3g} rad, wanted 0, for the control "
              "orientations around this key lie too far apart to have one average",
              missing),
          {.key = key}};
}

/// The first segment where nothing is the average of the control orientations.
std::optional<Error> without_average(const AverageCurve& curve) {
  constexpr double allowed = 1e-9;  // [rad]
  for (std::size_t i = 0; i < curve.knots().segments(); ++i)
    for (const double u : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
      const KnotSpan span = curve.knots().span(i);
      const double t = span.start() + u * span.step();
      const double missing = curve.missing(curve.orientation(t, i), curve.weights(t, i), i).norm();
      if (!(missing <= allowed)) return too_far_apart(i, missing);
    }
  return std::nullopt;
}

/// The first key that fulfils its equation, but not as the average: where the control orientations nearly surround it.
std::optional<Error> beside_average(const AverageCurve& curve, std::span<const Eigen::Quaterniond> keys) {
  for (std::size_t i = 0; i < curve.knots().segments(); ++i)
    for (const std::size_t key : {i, i + 1}) {
      const double missing = angular_distance(curve.orientation(curve.knots().times()[key], i), keys[key]);
      if (!(missing <= chain::tolerance)) return too_far_apart(key, missing);
    }
  return std::nullopt;
}

}  // namespace

Expected<AverageCurve> Averages::curve(const Keyframes& keys, const FamilySettings& settings) {
  auto points = control_points(keys, keys.orientations(), settings);
  if (!points) return tl::unexpected(std::move(points.error()));
  AverageCurve curve(key_times(keys), basis_on(keys.times()), std::move(*points));
  if (auto error = without_average(curve)) return tl::unexpected(std::move(*error));
  if (settings.choice("points") == "through")
    if (auto error = beside_average(curve, keys.orientations())) return tl::unexpected(std::move(*error));
  return curve;
}

Expected<CumulativePath<BSplineBasis<3>>> Averages::path(const Keyframes& keys, const FamilySettings& settings) {
  return control_points(keys, keys.positions(), settings).map([&](PathPolygon points) {
    return CumulativePath<BSplineBasis<3>>(key_times(keys), basis_on(keys.times()), std::move(points));
  });
}

}  // namespace orispline::families
