// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/averages.hpp>

#include <algorithm>
#include <numbers>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/curve/points_through.hpp>
#include <orispline/curve/reflected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

namespace {

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
  return control_points_through(points, Averages::info.name, AverageToKey(key_knots(keys), basis_on(keys.times())))
      .map([&](const std::vector<P>& solved) { return with_ghosts(solved); });
}

Error too_far_apart(std::size_t key, std::string_view found) {
  return {ErrorCode::not_converged,
          formatted("averages does not converge for these keys: {}, for the control orientations around this key are "
                    "too far apart to have one average; put keys in between, or take a local method such as timed-c2",
                    found),
          {.key = key}};
}

Error misses_average(std::size_t key, double missing) {
  return too_far_apart(key, formatted("the residual stays at {:.3g} rad, wanted 0", missing));
}

/// Then they have one average, and no more.
bool points_in_one_half_of_the_sphere(const AverageCurve& curve, std::size_t segment) {
  const auto points = std::span(curve.points()).subspan(segment, AverageCurve::active);
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Eigen::Quaterniond& p : points) sum += p.coeffs();
  return std::ranges::all_of(points, [&](const Eigen::Quaterniond& p) { return p.coeffs().dot(sum) > 0.0; });
}

/// By how much the average jumps between two near times [rad]; nothing where its rates account for the way between
/// them.
std::optional<double> jump_between(const Motion& before, const Motion& after, double duration) {
  const double way = increment<double>(before.orientation, after.orientation).norm();
  const double rate = std::max(before.angular_velocity.norm(), after.angular_velocity.norm());
  return way <= 2.0 * rate * duration + 1e-9 ? std::nullopt : std::optional(way);
}

/// Whether a segment's average exists, and moves without jumps where there may be several.
std::optional<Error> without_average(const AverageCurve& curve, std::size_t segment) {
  constexpr double allowed = 1e-9;  // [rad]
  const bool one_at_most = points_in_one_half_of_the_sphere(curve, segment);
  const int parts = one_at_most ? 5 : 64;
  const KnotSpan span = curve.knots().span(segment);
  std::optional<Motion> before;
  for (int k = 0; k <= parts; ++k) {
    const double t = span.start() + span.step() * k / parts;
    const double missing = curve.missing(curve.point(t, segment), curve.weights(t, segment), segment).norm();
    if (!(missing <= allowed)) return misses_average(segment, missing);
    if (one_at_most) continue;
    const Motion here = motion_from_jet(curve.point(Jet<double, 3>::variable(t), segment));
    if (!here.angular_velocity.allFinite()) return too_far_apart(segment, "the average has no rates");
    const auto jump = before ? jump_between(*before, here, span.step() / parts) : std::nullopt;
    if (jump) return too_far_apart(segment, formatted("the average jumps by {:.3g} rad", *jump));
    before = here;
  }
  return std::nullopt;
}

/// The first segment where nothing is the average of the control orientations.
std::optional<Error> without_average(const AverageCurve& curve) {
  for (std::size_t i = 0; i < curve.knots().segments(); ++i)
    if (auto error = without_average(curve, i)) return error;
  return std::nullopt;
}

/// The first key that fulfils its equation, but not as the average: where the control orientations nearly surround it.
std::optional<Error> beside_average(const AverageCurve& curve, std::span<const Eigen::Quaterniond> keys) {
  for (std::size_t i = 0; i < curve.knots().segments(); ++i)
    for (const std::size_t key : {i, i + 1}) {
      const double missing = angular_distance(curve.point(curve.knots().times()[key], i), keys[key]);
      if (!(missing <= chain::tolerance)) return misses_average(key, missing);
    }
  return std::nullopt;
}

}  // namespace

Expected<AverageCurve> Averages::curve(const Keyframes& keys, const FamilySettings& settings) {
  auto points = control_points(keys, keys.orientations(), settings);
  if (!points) return tl::unexpected(std::move(points.error()));
  AverageCurve curve(key_knots(keys), basis_on(keys.times()), std::move(*points));
  if (auto error = without_average(curve)) return tl::unexpected(std::move(*error));
  if (settings.choice("points") == "through")
    if (auto error = beside_average(curve, keys.orientations())) return tl::unexpected(std::move(*error));
  return curve;
}

Expected<CumulativePath<BSplineBasis<3>>> Averages::path(const Keyframes& keys, const FamilySettings& settings) {
  return control_points(keys, keys.positions(), settings).map([&](const std::vector<Eigen::Vector3d>& points) {
    return CumulativePath<BSplineBasis<3>>(key_knots(keys), basis_on(keys.times()), points);
  });
}

}}}  // namespace orispline::families
