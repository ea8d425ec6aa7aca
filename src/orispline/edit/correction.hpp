// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include <orispline/edit/channel_path.hpp>

// A displacement over time that carries a curve to given ends: q exp(c(t)), or p + c(t).

namespace orispline { inline namespace ORISPLINE_ABI {

/// A displacement with its first two derivatives in time, in rotation vectors [rad] or the unit of vectors.
struct Bend {
  Eigen::Vector3d value = Eigen::Vector3d::Zero(), rate = Eigen::Vector3d::Zero(),
                  acceleration = Eigen::Vector3d::Zero();
};

/// How long the corrections of rates and of accelerations at an end last [s].
struct BendTimes {
  double rate, acceleration;
};

/// C2 in time: the values go from one end to the other by a quintic over the whole domain, rates and accelerations fade
/// beside each end by quintic Hermite polynomials.
class Correction {
 public:
  Correction(Domain domain, const Bend& start, const Bend& end, BendTimes times)
      : domain_(domain), start_(start), end_(end), times_(times) {}

  template <Number T>
  [[nodiscard]] Vector3<T> at(const T& t) const noexcept {
    const T before = t - T(domain_.start), after = T(domain_.end) - t;
    const T u = before / (domain_.end - domain_.start);
    const T share = u * u * u * (T(10.0) - u * (T(15.0) - T(6.0) * u));
    const Eigen::Vector3d across = end_.value - start_.value;
    return constant<T>(start_.value) + constant<T>(across) * share + fading(start_.rate, start_.acceleration, before) +
           fading<T>(-end_.rate, end_.acceleration, after);
  }

 private:
  /// What has that rate and that acceleration at an end, and is gone at some time from it.
  template <Number T>
  [[nodiscard]] Vector3<T> fading(const Eigen::Vector3d& rate, const Eigen::Vector3d& acceleration,
                                  const T& beyond) const noexcept {
    Vector3<T> sum = constant<T>(Eigen::Vector3d(0.0, 0.0, 0.0));
    if (value_of(beyond) < times_.rate) {
      const T u = beyond / times_.rate, v = T(1.0) - u;
      sum += constant<T>(rate) * T(u * v * v * v * (T(1.0) + T(3.0) * u) * times_.rate);
    }
    if (value_of(beyond) < times_.acceleration) {
      const T u = beyond / times_.acceleration, v = T(1.0) - u;
      sum += constant<T>(acceleration) * T(u * u * v * v * v * (0.5 * times_.acceleration * times_.acceleration));
    }
    return sum;
  }

  Domain domain_;
  Bend start_, end_;
  BendTimes times_;
};

/// The curve with a correction, on the domain of that. Its rates are exact.
template <CurvePoint P>
class CorrectedCurve {
 public:
  CorrectedCurve(AnyCurveThrough<P> curve, const Correction& correction, Domain domain)
      : curve_(std::move(curve)), correction_(correction), knots_(knots_within(curve_.knots(), domain)) {
    for (std::size_t i = 0; i < knots_.segments(); ++i)
      segments_.push_back(curve_.knots().segment_at(0.5 * (knots_.span(i).start() + knots_.span(i).end())));
  }

  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  [[nodiscard]] P point(double t, std::size_t segment) const noexcept {
    return displaced<double>(point_of(motion_on(curve_, segments_[segment], t)), correction_.at(t));
  }
  [[nodiscard]] PointOver<P, Jet<double, 3>> point(const Jet<double, 3>& t, std::size_t segment) const noexcept {
    return displaced<Jet<double, 3>>(taylor(motion_on(curve_, segments_[segment], t.c[0]), t - t.c[0]),
                                     correction_.at(t));
  }

 private:
  static Knots knots_within(const Knots& all, Domain domain) {
    std::vector<double> times{domain.start};
    for (const double t : all.times())
      if (t > domain.start && t < domain.end) times.push_back(t);
    times.push_back(domain.end);
    return Knots(std::move(times));
  }

  AnyCurveThrough<P> curve_;
  Correction correction_;
  Knots knots_;
  std::vector<std::size_t> segments_{};  ///< of the curve
};

/// The displacement that is `by` where a motion is, and gives it these rates there.
[[nodiscard]] Bend bend_to(const Motion& motion, const Eigen::Vector3d& by, const Eigen::Vector3d& rate,
                           const Eigen::Vector3d& acceleration);
[[nodiscard]] Bend bend_to(const LinearMotion& motion, const Eigen::Vector3d& by, const Eigen::Vector3d& rate,
                           const Eigen::Vector3d& acceleration);

}}  // namespace orispline
