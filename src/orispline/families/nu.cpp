// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/nu.hpp>

#include <cmath>

#include <numbers>

#include <fmt/format.h>

#include <orispline/curve/key_knots.hpp>
#include <orispline/curve/points_through.hpp>
#include <orispline/curve/rate_chain.hpp>

// The names γ, λ, μ, δ are Nielson's; steps and ratios are indexed by key here: docs/families/nu.md.

namespace orispline::families {
namespace {

/// Where the cubics' inner points lie on the arcs of the control polygon, and each key between them.
struct Ratios {
  std::vector<double> before, after;  ///< λ_i on the arc that ends at control i, μ_i on the arc that starts there
  std::vector<double> key;            ///< δ_i between the two
};

Expected<Ratios> ratios_of(std::span<const double> t, const PerKey& nu) {
  const std::size_t n = t.size();
  const auto step = [&](std::size_t i) { return i == 0 || i >= n ? 0.0 : t[i] - t[i - 1]; };  // h_i ends at key i
  const auto gamma = [&](std::size_t i) {
    const double both = 2.0 * (step(i) + step(i + 1));
    return both / (nu[i] * step(i) * step(i + 1) + both);
  };
  Ratios r{std::vector<double>(n, 1.0), std::vector<double>(n, 0.0), std::vector<double>(n, 0.0)};
  for (std::size_t i = 0; i < n; ++i) {
    if (!(gamma(i) > 0.0 && std::isfinite(gamma(i))))
      return failure(ErrorCode::bad_argument,
                     fmt::format("nu: nu is {}, wanted more than {:.6g} between these key times", nu[i],
                                 -2.0 * (step(i) + step(i + 1)) / (step(i) * step(i + 1))),
                     {.key = i});
    const double here = gamma(i) * step(i), next = gamma(i) * step(i + 1);
    if (i > 0) {
      const double earlier = gamma(i - 1) * step(i - 1);
      r.before[i] = (earlier + step(i)) / (earlier + step(i) + next);
    }
    if (i + 1 < n) r.after[i] = here / (here + step(i + 1) + gamma(i + 1) * step(i + 2));
    r.key[i] = step(i) / (step(i) + step(i + 1));
  }
  return r;
}

/// By how much three neighbouring controls miss the key in the middle: it must lie between its two inner points; an
/// end's control stands at a given handle, or where there is no acceleration.
struct NuRule {
  static constexpr double forbidden_turn = 2.0 * std::numbers::pi;
  Ratios ratios;
  std::optional<Eigen::Vector3d> start, end;  ///< handles of clamped ends [rad]

  template <Number T>
  [[nodiscard]] Vector3<T> operator()(std::size_t i, const Quaternion<T>& before, const Quaternion<T>& at,
                                      const Quaternion<T>& after, const Quaternion<T>& key) const {
    const std::size_t last = ratios.key.size() - 1;
    if (i == 0) return increment<T>(at, end_control<T>(key, start, after, ratios.before[1]));
    if (i == last) return increment<T>(at, end_control<T>(key, end, before, 1.0 - ratios.after[last - 1]));
    return increment<T>(
        slerp<T>(slerp<T>(before, at, T(ratios.before[i])), slerp<T>(at, after, T(ratios.after[i])), T(ratios.key[i])),
        key);
  }

 private:
  template <Number T>
  [[nodiscard]] static Quaternion<T> end_control(const Quaternion<T>& key, const std::optional<Eigen::Vector3d>& handle,
                                                 const Quaternion<T>& inner, double ratio) {
    if (handle) return key * exp<T>(constant<T>(*handle));
    return slerp<T>(key, inner, T(ratio / (1.0 + ratio)));
  }
};

using Handle = std::optional<Eigen::Vector3d>;

Expected<Handle> handle_of(const End& end, double third, std::size_t key) {
  if (end.rule == EndRule::natural) return std::nullopt;
  Eigen::Vector3d handle = third * end.angular_velocity;
  if (handle.norm() < NuRule::forbidden_turn) return handle;
  return failure(ErrorCode::bad_argument,
                 fmt::format("nu: the end rate is {:.6g} rad/s, wanted less than {:.6g} for the length of this end's "
                             "segment: the handle would wind round",
                             end.angular_velocity.norm(), NuRule::forbidden_turn / std::abs(third)),
                 {.key = key});
}

Expected<NuRule> rule_of(const Keyframes& keys, const FamilySettings& settings, const Ratios& ratios) {
  const auto t = keys.times();
  const std::size_t last = t.size() - 1;
  return handle_of(settings.start, (t[1] - t[0]) / 3.0, 0).and_then([&](const Handle& start) {
    return handle_of(settings.end, -(t[last] - t[last - 1]) / 3.0, last).map([&](const Handle& end) {
      return NuRule{.ratios = ratios, .start = start, .end = end};
    });
  });
}

/// Every segment from a key over the two inner points on its arc of the control polygon to the next key.
SlerpBezierCurve curve_of(const Keyframes& keys, const std::vector<Eigen::Quaterniond>& d, const Ratios& ratios) {
  const auto q = keys.orientations();
  std::vector<SlerpBezierCurve::Segment> segments;
  for (std::size_t i = 0; i + 1 < q.size(); ++i)
    segments.push_back(slerp_bezier_segment({q[i], slerp<double>(d[i], d[i + 1], ratios.after[i]),
                                             slerp<double>(d[i], d[i + 1], ratios.before[i + 1]), q[i + 1]}));
  return {key_knots(keys), std::move(segments)};
}

}  // namespace

Expected<SlerpBezierCurve> Nu::curve(const Keyframes& keys, const FamilySettings& settings) {
  return ratios_of(keys.times(), settings.per_key("nu")).and_then([&](const Ratios& ratios) {
    return rule_of(keys, settings, ratios)
        .and_then([&](const NuRule& rule) { return control_points_through(keys.orientations(), info.name, rule); })
        .map([&](const std::vector<Eigen::Quaterniond>& controls) { return curve_of(keys, controls, ratios); });
  });
}

Expected<HermitePath<3>> Nu::path(const Keyframes& keys, const FamilySettings& settings) {
  return cubic_spline_path(info.name, keys, settings);
}

}  // namespace orispline::families
