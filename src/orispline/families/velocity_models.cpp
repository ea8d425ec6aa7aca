// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <orispline/families/window_differences.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace families::models {

namespace {

using Velocity = Lanes<static_cast<int>(velocity_models)>;

/// e^-y and its integrals (1 - e^-y)/y and (e^-y - 1 + y)/y², without cancellation and with the same bits everywhere.
struct Decay {
  double value, first, second;
};
Decay decay_over(double y) {
  int doublings = 0;
  for (; y > 0.25; y *= 0.5) ++doublings;
  double second = 0.0;
  for (int k = 13; k >= 2; --k) second = (1.0 - y * second) / k;  // ½ (1 - y/3 (1 - y/4 (…)))
  Decay decay{0.0, 0.0, second};
  decay.first = 1.0 - y * decay.second;
  decay.value = 1.0 - y * decay.first;
  for (; doublings > 0; --doublings) {
    decay.second = 0.25 * (decay.first * decay.first + 2.0 * decay.second);
    decay.first *= 0.5 * (1.0 + decay.value);
    decay.value *= decay.value;
  }
  return decay;
}

/// What the models of velocity share: the covariance of velocities `variance` (1 + b a d) e^(-a d), b = 0 for 2ν = 1
/// and 1 for 2ν = 3.
struct VelocityShapes {
  Velocity rate, b, variance;

  VelocityShapes() {
    for (std::size_t k = 0; k < velocity_models; ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      const bool smoother = velocity_shapes[k].twice_smoothness == 3;
      rate[at] = (smoother ? std::sqrt(3.0) : 1.0) / velocity_shapes[k].length;
      b[at] = smoother ? 1.0 : 0.0;
      const auto doubled = [&](double y) { return 2.0 * spread(decay_over(y).second, y, b[at]); };
      // A second difference at spacing 1 has variance 1: 8 c(a) - 2 c(2a) with c(y) = y² spread.
      variance[at] = 1.0 / (4.0 * doubled(rate[at]) - 4.0 * doubled(2.0 * rate[at]));
    }
  }
  /// c(y)/y², half the variance of the mean velocity.
  template <class T>
  static T spread(const T& second, const T& y, const T& b) {
    return second + b * ((2.0 + y) * second - 1.0);
  }
};
const VelocityShapes& shapes() {
  static const VelocityShapes all;
  return all;
}

/// Velocity over an interval, seen from an end: the factor of what is beyond, and means over the interval.
struct Interval {
  Velocity beyond, mean, weighted_mean, spread;
};

std::array<Interval, window_intervals> remembered(const Differences& d) {
  std::array<Interval, window_intervals> all;
  for (std::size_t n = 0; n < window_intervals; ++n) {
    const Velocity y = shapes().rate * d.step(n);
    Velocity second;
    for (Eigen::Index k = 0; k < y.size(); ++k) {
      const Decay decay = decay_over(y[k]);
      all[n].beyond[k] = decay.value;
      all[n].mean[k] = decay.first;
      second[k] = decay.second;
    }
    all[n].weighted_mean = (1.0 + y) * all[n].mean - 1.0;
    all[n].spread = 2.0 * VelocityShapes::spread<Velocity>(second, y, shapes().b);
  }
  return all;
}

/// Covariances of what is seen from a time on and away from it, interval after interval.
struct Seen {
  Velocity passed = Velocity::Ones(), apart = Velocity::Zero();

  /// Of the velocity there and the mean one of the next interval.
  [[nodiscard]] Velocity mean(const Interval& next) const {
    const VelocityShapes& s = shapes();
    return s.variance * passed * ((1.0 + s.b * apart) * next.mean + s.b * next.weighted_mean);
  }
  /// Of the mean velocities of the interval before that time and of the next one.
  [[nodiscard]] Velocity means(const Interval& before, const Interval& next) const {
    const VelocityShapes& s = shapes();
    return s.variance * passed *
           (((1.0 + s.b * apart) * next.mean + s.b * next.weighted_mean) * before.mean +
            s.b * before.weighted_mean * next.mean);
  }
  [[nodiscard]] Velocity here() const { return shapes().variance * passed * (1.0 + shapes().b * apart); }
  void pass(const Interval& interval, double step) {
    passed *= interval.beyond;
    apart += shapes().rate * step;
  }
};

}  // namespace

void put_velocity_maps(ModelMaps& maps, const Differences& d) {
  const auto interval = remembered(d);
  std::array<std::array<Velocity, window_intervals>, window_intervals> means;  // covariances of the mean velocities
  for (std::size_t m = 0; m < window_intervals; ++m) {
    means[m][m] = shapes().variance * interval[m].spread;
    Seen seen;
    for (std::size_t n = m + 1; n < window_intervals; ++n) {
      means[m][n] = means[n][m] = seen.means(interval[m], interval[n]);
      seen.pass(interval[n], d.step(n));
    }
  }
  Covariances<Velocity::RowsAtCompileTime, inner_window_keys> covariances;
  std::array<Velocity, inner_window_keys> scale;
  for (std::size_t i = 0; i < inner_window_keys; ++i) {
    scale[i] = means[i + 1][i + 1] + means[i][i];
    for (std::size_t j = 0; j <= i; ++j)
      covariances.m[i][j] = means[i + 1][j + 1] - means[i][j + 1] - (means[i + 1][j] - means[i][j]);
  }
  covariances.factorise(scale);

  const std::size_t p = d.centre();
  std::array<Velocity, window_intervals> with_velocity;  // covariances of the velocity at the centre with the means
  std::array<Velocity, window_keys> with_velocities;     // and with the velocities at the keys
  Seen after, before;
  with_velocities[p] = -after.here();
  for (std::size_t n = p; n < window_intervals; ++n) {
    with_velocity[n] = after.mean(interval[n]);
    after.pass(interval[n], d.step(n));
    with_velocities[n + 1] = -after.here();
  }
  for (std::size_t n = p; n-- > 0;) {
    with_velocity[n] = before.mean(interval[n]);
    before.pass(interval[n], d.step(n));
    with_velocities[n] = -before.here();
  }
  std::array<Velocity, inner_window_keys> first;
  const auto& of_secant = means[d.interval()];
  for (std::size_t m = 0; m < inner_window_keys; ++m)
    first[m] = with_velocity[m + 1] - with_velocity[m] - (of_secant[m + 1] - of_secant[m]);
  put_maps<static_cast<int>(noise_models)>(maps, d, covariances, first, d.of(with_velocities));
}

}}}  // namespace orispline::families::models
