// SPDX-License-Identifier: Apache-2.0
#include <orispline/optimise/rate_bounds.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/analysis/torque.hpp>

namespace orispline::optimise {
namespace {

constexpr double gap = 1e-4;               // of a bound above the largest value found, relative
constexpr double rounding = 1e-12;         // of evaluation, relative
constexpr std::size_t most_halvings = 14;  // of an interval; there a bound may stay farther above

using Coefficients = std::array<Eigen::Vector3d, form_degree + 1>;

/// |X'|, |X''|, |X'''| by the largest Bernstein coefficients of the derivatives, per unit of time.
Eigen::Vector3d derivative_bounds(Coefficients c, std::size_t degree, double duration) {
  Eigen::Vector3d bounds = Eigen::Vector3d::Zero();
  double factor = 1.0;
  for (std::size_t order = 1; order <= std::min<std::size_t>(3, degree); ++order) {
    factor *= static_cast<double>(degree - order + 1) / duration;
    for (std::size_t i = 0; i + order <= degree; ++i) {
      c[i] = c[i + 1] - c[i];
      double& bound = bounds[static_cast<Eigen::Index>(order) - 1];
      bound = std::max(bound, factor * c[i].norm());
    }
  }
  return bounds;
}

std::optional<double> jerk_bound(const SegmentForm& form, double duration) {
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  if (const auto* chart = std::get_if<ChartForm>(&form)) {
    Coefficients c{};
    for (std::size_t i = 0; i <= chart->degree; ++i)
      c[i] = 0.5 * Eigen::Vector3d(chart->rotation_vector[0].coefficients[i], chart->rotation_vector[1].coefficients[i],
                                   chart->rotation_vector[2].coefficients[i]);
    a = derivative_bounds(c, chart->degree, duration);
  } else if (const auto* product = std::get_if<CumulativeForm>(&form)) {
    for (std::size_t k = 0; k < product->increments.size(); ++k) {
      Coefficients c{};
      for (std::size_t i = 0; i <= product->degree; ++i)
        c[i] = 0.5 * product->blending[k].coefficients[i] * product->increments[k];
      a += derivative_bounds(c, product->degree, duration);
    }
  } else {
    return std::nullopt;
  }
  return 2.0 * (a[2] + 6.0 * a[0] * a[1] + 4.0 * a[0] * a[0] * a[0]) * (1.0 + rounding);
}

struct Values {
  double rate, acceleration, torque;
};

/// One segment, cut into intervals.
class PeakSearch {
 public:
  PeakSearch(const AnyCurve& curve, std::size_t segment, double jerk, const std::optional<Eigen::Matrix3d>& inertia,
             const PeakFloors& floors)
      : curve_(curve),
        segment_(segment),
        jerk_(jerk),
        inertia_(inertia ? *inertia : Eigen::Matrix3d::Zero()),
        weight_(inertia_.norm()),
        floors_(floors) {}

  SegmentPeaks run() {
    const KnotSpan span = curve_.knots().span(segment_);
    constexpr std::size_t first_cuts = 16;
    const double step = span.step() / static_cast<double>(first_cuts);
    for (const double t : {span.start(), span.end()}) note(values(t), t);
    const auto middle = [&](std::size_t i) { return span.start() + (static_cast<double>(i) + 0.5) * step; };
    for (std::size_t i = 0; i < first_cuts; ++i) note(values(middle(i)), middle(i));
    for (std::size_t i = 0; i < first_cuts; ++i) search(middle(i), 0.5 * step, 0);
    return peaks_;
  }

 private:
  [[nodiscard]] Values values(double t) const {
    const Motion m = curve_.motion_on(segment_, t);
    return {m.angular_velocity.norm(), m.angular_acceleration.norm(), orispline::torque(m, inertia_).norm()};
  }
  void note(const Values& v, double t) {
    const auto take = [t](CertifiedPeak& peak, double value) {
      if (value > peak.found) peak.found = value, peak.time = t;
      peak.bound = std::max(peak.bound, value * (1.0 + rounding));
    };
    take(peaks_.rate, v.rate);
    take(peaks_.acceleration, v.acceleration);
    take(peaks_.torque, v.torque);
  }

  void search(double middle, double radius, std::size_t halvings) {
    const Values v = values(middle);
    note(v, middle);
    const double rate = v.rate + (v.acceleration + 0.5 * jerk_ * radius) * radius;
    const double acceleration = v.acceleration + jerk_ * radius;
    const double torque = v.torque + weight_ * (jerk_ + 2.0 * rate * acceleration) * radius;
    const bool near = rate <= allowed(peaks_.rate, floors_.rate) &&
                      acceleration <= allowed(peaks_.acceleration, floors_.acceleration) &&
                      torque <= allowed(peaks_.torque, floors_.torque);
    if (near || halvings == most_halvings) {
      const auto raise = [](CertifiedPeak& peak, double bound) {
        peak.bound = std::max(peak.bound, bound * (1.0 + rounding));
      };
      raise(peaks_.rate, rate);
      raise(peaks_.acceleration, acceleration);
      raise(peaks_.torque, torque);
      return;
    }
    search(middle - 0.5 * radius, 0.5 * radius, halvings + 1);
    search(middle + 0.5 * radius, 0.5 * radius, halvings + 1);
  }
  static double allowed(const CertifiedPeak& peak, double floor) { return std::max(peak.found * (1.0 + gap), floor); }

  const AnyCurve& curve_;
  std::size_t segment_;
  double jerk_;
  Eigen::Matrix3d inertia_;
  double weight_;
  PeakFloors floors_;
  SegmentPeaks peaks_{};
};

}  // namespace

std::optional<std::vector<SegmentPeaks>> certified_peaks(const AnyCurve& curve,
                                                         const std::optional<Eigen::Matrix3d>& inertia,
                                                         const PeakFloors& floors) {
  std::vector<SegmentPeaks> peaks;
  for (std::size_t s = 0; s < curve.knots().segments(); ++s) {
    const auto jerk = jerk_bound(curve.form(s), curve.knots().span(s).step());
    if (!jerk) return std::nullopt;
    peaks.push_back(PeakSearch(curve, s, *jerk, inertia, floors).run());
  }
  return peaks;
}

}  // namespace orispline::optimise
