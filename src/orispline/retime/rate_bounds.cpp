// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/rate_bounds.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/analysis/torque.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/batch/sample.hpp>

namespace orispline::inline ORISPLINE_ABI {
namespace {

constexpr double gap = 1e-4;               // of a bound above the largest value found, relative
constexpr double rounding = 1e-14;         // of evaluation, of the size of what is added up
constexpr std::size_t most_halvings = 16;  // of an interval; there a bound may stay farther above
constexpr std::size_t first_cuts = 4;      // of a segment

using Coefficients = std::array<Eigen::Vector3d, form_degree + 1>;
using OrderBounds = Eigen::Matrix<double, 5, 1>;  // of order 0 to 4

/// |X| to |X''''| by the largest Bernstein coefficients of the derivatives, per unit of time.
OrderBounds derivative_bounds(Coefficients c, std::size_t degree, double duration) {
  OrderBounds bounds = OrderBounds::Zero();
  double factor = 1.0;
  for (std::size_t order = 0; order <= std::min<std::size_t>(4, degree); ++order) {
    if (order > 0) factor *= static_cast<double>(degree - order + 1) / duration;
    double& bound = bounds[static_cast<Eigen::Index>(order)];
    for (std::size_t i = 0; i + order <= degree; ++i) bound = std::max(bound, factor * c[i].norm());
    for (std::size_t i = 0; i + order + 1 <= degree; ++i) c[i] = c[i + 1] - c[i];
  }
  return bounds;
}

/// What is known of a whole segment.
struct SegmentSize {
  double snap;           ///< bound of |jerk'| [rad/s⁴]
  MotionSizes rounding;  ///< of evaluated ω and α; none of the torque [rad/s], [rad/s²]
};

SegmentSize size_of(const OrderBounds& a, std::size_t degree, double duration) {
  const double q1 = a[1], q2 = a[2] + a[1] * a[1], q3 = a[3] + 3.0 * a[1] * a[2] + a[1] * a[1] * a[1];
  const double q4 = a[4] + 4.0 * a[1] * a[3] + 3.0 * a[2] * a[2] + 6.0 * a[1] * a[1] * a[2] + q1 * q1 * q1 * q1;
  const double per_time = 2.0 * static_cast<double>(degree) / duration;  // of coefficients that are not differences yet
  return {2.0 * (q4 + 4.0 * q1 * q3 + 3.0 * q2 * q2) * (1.0 + 1e-12),
          {rounding * (2.0 * a[0] * per_time + q1), rounding * (2.0 * a[0] * per_time * per_time + q2), 0.0}};
}

/// `form`: one of polynomials; the exponents of its factors are halved into pure quaternions.
SegmentSize size_of(const SegmentForm& form, double duration) {
  OrderBounds bounds = OrderBounds::Zero();
  Coefficients c{};
  if (const auto* chart = std::get_if<ChartForm>(&form)) {
    for (std::size_t i = 0; i <= chart->degree; ++i)
      c[i] = 0.5 * Eigen::Vector3d(chart->rotation_vector[0].coefficients[i], chart->rotation_vector[1].coefficients[i],
                                   chart->rotation_vector[2].coefficients[i]);
    return size_of(derivative_bounds(c, chart->degree, duration), chart->degree, duration);
  }
  const auto& product = std::get<CumulativeForm>(form);
  for (std::size_t k = 0; k < product.increments.size(); ++k) {
    for (std::size_t i = 0; i <= product.degree; ++i)
      c[i] = 0.5 * product.blending[k].coefficients[i] * product.increments[k];
    bounds += derivative_bounds(c, product.degree, duration);
  }
  return size_of(bounds, product.degree, duration);
}

/// The longer end of the line a ± b r.
double longest(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double r) {
  return std::max((a + b * r).norm(), (a - b * r).norm());
}

/// One segment, cut into intervals.
class PeakSearch {
 public:
  PeakSearch(const AnyCurve& curve, std::size_t segment, const SegmentSize& size,
             const std::optional<Eigen::Matrix3d>& inertia, const MotionSizes& floors)
      : curve_(curve),
        segment_(segment),
        size_(size),
        inertia_(inertia ? *inertia : Eigen::Matrix3d::Zero()),
        weight_(inertia_.norm()),
        floors_(floors) {}

  SegmentPeaks run() {
    const KnotSpan span = curve_.knots().span(segment_);
    const double step = span.step() / static_cast<double>(first_cuts);
    for (std::size_t i = 0; i < first_cuts; ++i) note(span.start() + static_cast<double>(i) * step);
    note(span.end());
    for (std::size_t i = 0; i < first_cuts; ++i)
      search(span.start() + (static_cast<double>(i) + 0.5) * step, 0.5 * step, 0);
    return peaks_;
  }

 private:
  Motion note(double t) {
    const Motion m = curve_.motion_on(segment_, t);
    const auto take = [t](CertifiedPeak& peak, double value) {
      if (value > peak.found) peak.found = value, peak.time = t;
      peak.bound = std::max(peak.bound, value);
    };
    take(peaks_.rate, m.angular_velocity.norm());
    take(peaks_.acceleration, m.angular_acceleration.norm());
    take(peaks_.torque, orispline::torque(m, inertia_).norm());
    return m;
  }

  /// Of all times within `r` of the motion's.
  [[nodiscard]] MotionSizes bounds(const Motion& m, double r) const {
    const double jerk = m.angular_jerk.norm();
    const double rate = longest(m.angular_velocity, m.angular_acceleration, r) +
                        (0.5 * jerk + size_.snap * r / 6.0) * r * r + size_.rounding.rate;
    const double acceleration =
        longest(m.angular_acceleration, m.angular_jerk, r) + 0.5 * size_.snap * r * r + size_.rounding.acceleration;
    const double bend =
        weight_ * (size_.snap + 2.0 * ((jerk + size_.snap * r) * rate + acceleration * acceleration));  // of the torque
    const double torque = longest(orispline::torque(m, inertia_), torque_rate(m, inertia_), r) + 0.5 * bend * r * r +
                          weight_ * (size_.rounding.acceleration + 2.0 * rate * size_.rounding.rate);
    return {rate, acceleration, torque};
  }

  void search(double middle, double radius, std::size_t halvings) {
    const Motion m = note(middle);
    const double of_time = 2.0 * std::numeric_limits<double>::epsilon() * std::abs(middle);
    const MotionSizes b = bounds(m, radius + of_time);
    const bool near = b.rate <= allowed(peaks_.rate, floors_.rate) &&
                      b.acceleration <= allowed(peaks_.acceleration, floors_.acceleration) &&
                      b.torque <= allowed(peaks_.torque, floors_.torque);
    if (near || halvings == most_halvings) {
      peaks_.rate.bound = std::max(peaks_.rate.bound, b.rate);
      peaks_.acceleration.bound = std::max(peaks_.acceleration.bound, b.acceleration);
      peaks_.torque.bound = std::max(peaks_.torque.bound, b.torque);
      return;
    }
    search(middle - 0.5 * radius, 0.5 * radius, halvings + 1);
    search(middle + 0.5 * radius, 0.5 * radius, halvings + 1);
  }
  static double allowed(const CertifiedPeak& peak, double floor) { return std::max(peak.found * (1.0 + gap), floor); }

  const AnyCurve& curve_;
  std::size_t segment_;
  SegmentSize size_;
  Eigen::Matrix3d inertia_;
  double weight_;
  MotionSizes floors_;
  SegmentPeaks peaks_{};
};

}  // namespace

std::vector<MotionSizes> sampled_peaks(const AnyCurve& curve, const std::optional<Eigen::Matrix3d>& inertia) {
  constexpr std::size_t cuts = 16, places = cuts + 1;
  std::vector<MotionSizes> peaks(curve.knots().segments(), MotionSizes{});
  std::vector<double> times;
  for (std::size_t s = 0; s < peaks.size(); ++s) {
    const KnotSpan span = curve.knots().span(s);
    const double step = span.step() / static_cast<double>(cuts);
    const double last = std::nextafter(span.end(), span.start());  // the end itself belongs to the next segment
    for (std::size_t i = 0; i < places; ++i)
      times.push_back(std::min(span.start() + static_cast<double>(i) * step, last));
  }
  std::vector<double> orientations(4 * times.size()), rates(3 * times.size()), accelerations(3 * times.size());
  static_cast<void>(sample<double>(  // no times that decrease, no sizes that differ: no error
      curve, times, {.orientations = orientations, .angular_velocities = rates, .angular_accelerations = accelerations},
      {.threads = 0}));
  for (std::size_t k = 0; k < times.size(); ++k) {
    const Motion m{.angular_velocity = Eigen::Map<const Eigen::Vector3d>(&rates[3 * k]),
                   .angular_acceleration = Eigen::Map<const Eigen::Vector3d>(&accelerations[3 * k])};
    MotionSizes& largest = peaks[k / places];
    largest.rate = std::max(largest.rate, m.angular_velocity.norm());
    largest.acceleration = std::max(largest.acceleration, m.angular_acceleration.norm());
    if (inertia) largest.torque = std::max(largest.torque, torque(m, *inertia).norm());
  }
  return peaks;
}

std::optional<double> snap_bound(const SegmentForm& form, double duration) {
  if (std::holds_alternative<std::monostate>(form)) return std::nullopt;
  return size_of(form, duration).snap;
}

std::optional<std::vector<SegmentPeaks>> certified_peaks(const AnyCurve& curve,
                                                         const std::optional<Eigen::Matrix3d>& inertia,
                                                         const MotionSizes& floors) {
  constexpr std::size_t together = 64;  // segments
  const std::size_t segments = curve.knots().segments();
  if (segments > 0 && std::holds_alternative<std::monostate>(curve.form(0))) return std::nullopt;
  std::vector<SegmentPeaks> peaks(segments);
  parallel_for((segments + together - 1) / together, 0, [&](std::size_t part) {
    for (std::size_t s = part * together; s < std::min(segments, (part + 1) * together); ++s)
      peaks[s] = PeakSearch(curve, s, size_of(curve.form(s), curve.knots().span(s).step()), inertia, floors).run();
  });
  return peaks;
}

}  // namespace orispline::inline ORISPLINE_ABI
