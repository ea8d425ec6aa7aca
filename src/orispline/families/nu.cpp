// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/nu.hpp>

#include <cmath>

#include <fmt/format.h>

#include <orispline/curve/control_chain.hpp>
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

/// The control orientations as unknowns: each key must lie between its two inner points.
class NuChain : public ControlChain {
 public:
  NuChain(const Keyframes& keys, const FamilySettings& settings, const Ratios& ratios, double share,
          const NuChain* before)
      : ControlChain(keys, share, before), ratios_(ratios) {
    const std::size_t last = keys.size() - 1;
    const auto handle = [share](const End& end, double third) -> std::optional<Eigen::Vector3d> {
      if (end.rule == EndRule::natural) return std::nullopt;
      return Eigen::Vector3d(share * third * end.angular_velocity);
    };
    start_ = handle(settings.start, (keys.times()[1] - keys.times()[0]) / 3.0);
    end_ = handle(settings.end, -(keys.times()[last] - keys.times()[last - 1]) / 3.0);
  }

  template <Number T>
  [[nodiscard]] std::vector<Vector3<T>> residual(std::span<const Vector3<T>> moved_by) const {
    const std::vector<Quaternion<T>> d = moved<T>(moved_by);
    const std::size_t last = size() - 1;
    std::vector<Vector3<T>> residual;
    residual.reserve(size());
    residual.push_back(increment<T>(d[0], end_control<T>(0, start_, d[1], ratios_.before[1])));
    for (std::size_t i = 1; i < last; ++i) {
      const Quaternion<T> before = slerp<T>(d[i - 1], d[i], T(ratios_.before[i]));
      const Quaternion<T> after = slerp<T>(d[i], d[i + 1], T(ratios_.after[i]));
      residual.push_back(increment<T>(slerp<T>(before, after, T(ratios_.key[i])), key<T>(i)));
    }
    residual.push_back(increment<T>(d[last], end_control<T>(last, end_, d[last - 1], 1.0 - ratios_.after[last - 1])));
    return residual;
  }

  /// The inner points of the segments, as rates out of and into the keys.
  [[nodiscard]] SlerpBezierCurve curve(Knots knots) const {
    std::vector<SlerpBezierCurve::Segment> segments;
    const auto& d = controls();
    for (std::size_t i = 0; i + 1 < size(); ++i)
      segments.push_back({key<double>(i), slerp<double>(d[i], d[i + 1], ratios_.after[i]),
                          slerp<double>(d[i], d[i + 1], ratios_.before[i + 1]), key<double>(i + 1)});
    return {std::move(knots), std::move(segments)};
  }

 private:
  /// An end's control orientation: at a given handle, or such that there is no acceleration.
  template <Number T>
  [[nodiscard]] Quaternion<T> end_control(std::size_t at, const std::optional<Eigen::Vector3d>& handle,
                                          const Quaternion<T>& inner, double ratio) const {
    if (handle) return key<T>(at) * exp<T>(constant<T>(*handle));
    return slerp<T>(key<T>(at), inner, T(ratio / (1.0 + ratio)));
  }

  Ratios ratios_;
  std::optional<Eigen::Vector3d> start_, end_;  ///< handles of clamped ends
};

}  // namespace

Expected<SlerpBezierCurve> Nu::curve(const Keyframes& keys, const FamilySettings& settings) {
  return ratios_of(keys.times(), settings.per_key("nu")).and_then([&](const Ratios& ratios) {
    return solve_chain(info.name, [&](double share,
                                      const NuChain* before) { return NuChain(keys, settings, ratios, share, before); })
        .map([&](const NuChain& chain) {
          return chain.curve(Knots({keys.times().begin(), keys.times().end()}));
        });
  });
}

Expected<HermitePath<3>> Nu::path(const Keyframes& keys, const FamilySettings& settings) {
  return cubic_spline_path(info.name, keys, settings);
}

}  // namespace orispline::families
