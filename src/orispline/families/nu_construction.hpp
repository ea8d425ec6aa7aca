// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include <orispline/curve/family.hpp>
#include <orispline/math/geodesic.hpp>

// Nielson's construction over numbers that may know how they change with ν. The names γ, λ, μ, δ are his; steps and
// ratios are indexed by key here: docs/families/nu.md.

namespace orispline { inline namespace ORISPLINE_ABI { namespace families {

/// Where the cubics' inner points lie on the arcs of the control polygon, and each key between them.
template <Number T>
struct NuRatios {
  std::vector<T> before, after;  ///< λ_i on the arc that ends at control i, μ_i on the arc that starts there
  std::vector<T> key;            ///< δ_i between the two
};

/// The steps of a curve's keys, 0 beyond the ends.
struct NuSteps {
  std::span<const double> t;
  /// h_i, which ends at key i.
  [[nodiscard]] double operator()(std::size_t i) const noexcept {
    return i == 0 || i >= t.size() ? 0.0 : t[i] - t[i - 1];
  }
};

/// γ_i, which must be positive.
template <Number T>
[[nodiscard]] T nu_gamma(NuSteps step, std::size_t i, const T& nu) noexcept {
  const double both = 2.0 * (step(i) + step(i + 1));
  return T(both) / (nu * (step(i) * step(i + 1)) + T(both));
}

/// From the times of the keys and their γ.
template <Number T>
[[nodiscard]] NuRatios<T> nu_ratios(NuSteps step, const std::vector<T>& gamma) {
  const std::size_t n = gamma.size();
  NuRatios<T> r{std::vector<T>(n, T(1.0)), std::vector<T>(n, T(0.0)), std::vector<T>(n, T(0.0))};
  for (std::size_t i = 0; i < n; ++i) {
    const T here = gamma[i] * step(i), next = gamma[i] * step(i + 1);
    if (i > 0) {
      const T earlier = gamma[i - 1] * step(i - 1);
      r.before[i] = (earlier + T(step(i))) / (earlier + T(step(i)) + next);
    }
    if (i + 1 < n) r.after[i] = here / (here + T(step(i + 1)) + gamma[i + 1] * step(i + 2));
    r.key[i] = T(step(i) / (step(i) + step(i + 1)));
  }
  return r;
}

/// By how much three neighbouring controls miss the key in the middle: it must lie between its two inner points; an
/// end's control stands at a given handle, or where there is no acceleration.
template <Number R>
struct NuRule {
  static constexpr double forbidden_turn = 2.0 * std::numbers::pi;
  NuRatios<R> ratios;
  std::optional<Eigen::Vector3d> start, end;  ///< handles of clamped ends [rad]

  template <Number T>
  [[nodiscard]] Vector3<T> operator()(std::size_t i, const Quaternion<T>& before, const Quaternion<T>& at,
                                      const Quaternion<T>& after, const Quaternion<T>& key) const {
    const std::size_t last = ratios.key.size() - 1;
    if (i == 0) return increment<T>(at, end_control<T>(key, start, after, ratios.before[1]));
    if (i == last) return increment<T>(at, end_control<T>(key, end, before, R(1.0) - ratios.after[last - 1]));
    return increment<T>(
        slerp<T>(slerp<T>(before, at, T(ratios.before[i])), slerp<T>(at, after, T(ratios.after[i])), T(ratios.key[i])),
        key);
  }

 private:
  template <Number T>
  [[nodiscard]] static Quaternion<T> end_control(const Quaternion<T>& key, const std::optional<Eigen::Vector3d>& handle,
                                                 const Quaternion<T>& inner, const R& ratio) {
    if (handle) return key * exp<T>(constant<T>(*handle));
    return slerp<T>(key, inner, T(ratio / (R(1.0) + ratio)));
  }
};

}}}  // namespace orispline::families
