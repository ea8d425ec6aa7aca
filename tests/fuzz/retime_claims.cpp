// SPDX-License-Identifier: Apache-2.0
#include <fuzz/optimise_claims.hpp>
#include <fuzz/outcome_claims.hpp>
#include <orispline/jobs/retime.hpp>
#include <orispline/retime/motion_limits.hpp>

namespace orispline::fuzz {

namespace {

using Vector = LimitedQuantity::Vector;

/// The promise, and what lies between two of 64 places on a segment: at most an eighth of the square of their distance
/// times the second derivative of the peak.
constexpr double slack_of_retiming = 1e-4, slack_of_places = 5e-3;

MotionLimits fuzzed_limits(Flags& flags, double size, FuzzInput& more) {
  MotionLimits limits;
  if (flags.next()) limits.rate = size;
  if (flags.next()) limits.acceleration = 2.0 * size;
  Flags others(more);
  if (others.next()) limits.rate = Limit(size * Eigen::Vector3d(1.0, 0.5, 2.0));
  if (others.next()) limits.acceleration = Limit(size * Eigen::Vector3d(4.0, 1.0, 0.25));
  if (others.next()) limits.jerk = 8.0 * size;
  if (others.next()) limits.torque = size;
  if (limits.torque) limits.inertia = Eigen::Vector3d(1.0, 1.5, 2.0).asDiagonal();
  if (others.next()) limits.speed = size;
  if (others.next()) limits.linear_acceleration = Limit(size * Eigen::Vector3d(1.0, 3.0, 1.0));
  return limits;
}

Eigen::Vector3d vector_of(Vector which, const Motion& m, const LinearMotion& p, const MotionLimits& limits) {
  switch (which) {
    case Vector::rate:
      return m.angular_velocity;
    case Vector::acceleration:
      return m.angular_acceleration;
    case Vector::jerk:
      return m.angular_jerk;
    case Vector::torque:
      return *limits.inertia * m.angular_acceleration +
             m.angular_velocity.cross((*limits.inertia * m.angular_velocity).eval());
    case Vector::speed:
      return p.velocity;
    case Vector::linear_acceleration:
      return p.acceleration;
  }
  return Eigen::Vector3d::Zero();
}

std::string text_of(const MotionLimits& limits) {
  std::string text;
  for (const LimitedQuantity& quantity : quantities_of(limits))
    text += fmt::format(" vector {}{} {:g}", static_cast<int>(quantity.vector),
                        quantity.axis ? fmt::format(" axis {}", *quantity.axis) : "", quantity.limit);
  return text;
}

/// The largest of each quantity that is met on the way, on both sides of the knots.
std::vector<double> met(const PoseCurve& curve, const MotionLimits& limits) {
  const auto quantities = quantities_of(limits);
  std::vector<double> largest(quantities.size(), 0.0);
  const Knots& knots = curve.orientation.knots();
  for (std::size_t i = 0; i < knots.segments(); ++i)
    for (int k = 0; k <= 64; ++k) {
      const KnotSpan span = knots.span(i);
      const double t = k == 64 ? span.end() : span.start() + span.step() * k / 64.0;
      const Motion m = curve.orientation.motion_on(i, t);
      const LinearMotion p =
          curve.position ? curve.position->linear_motion(t, k == 64 ? Side::left : Side::right) : LinearMotion{};
      for (std::size_t q = 0; q < quantities.size(); ++q)
        largest[q] = std::max(largest[q], quantities[q].size_of(vector_of(quantities[q].vector, m, p, limits)));
    }
  return largest;
}

/// The greatest share of a limit, in the measure of time.
double share_used(const std::vector<double>& sizes, const MotionLimits& limits) {
  const auto quantities = quantities_of(limits);
  double used = 0.0;
  for (std::size_t q = 0; q < quantities.size(); ++q)
    used = std::max(used, std::pow(sizes[q] / quantities[q].limit, 1.0 / quantities[q].order()));
  return used;
}

void claim_within(const jobs::RetimeOutcome& outcome) {
  const Retiming& retiming = outcome.retiming;
  const MotionLimits& limits = outcome.request.options.limits;
  const auto curve = make_pose_curve(retiming.method, retiming.track.keys);
  claim(curve.has_value(), "the result has no curve: {}", curve ? "" : describe(curve.error()));
  const std::vector<double> sizes = met(*curve, limits);
  const auto quantities = quantities_of(limits);
  for (std::size_t q = 0; q < quantities.size(); ++q)
    claim(sizes[q] <= quantities[q].limit * (1.0 + 1e-9), "quantity {} is {}, allowed {}", q, sizes[q],
          quantities[q].limit);
  if (!(retiming.time_scale > 1.0)) return;
  // What the motion uses of the bounds is found again but for rounding.
  double bounds = 0.0;
  for (const SegmentPeaks& peaks : retiming.peaks) {
    std::vector<double> of_segment;
    for (const CertifiedPeak& peak : peaks) of_segment.push_back(peak.bound);
    bounds = std::max(bounds, share_used(of_segment, limits));
  }
  // Where rounding loosens the bounds, it loosens them otherwise at other times, and the warning says how far.
  const bool is_warned_of =
      std::ranges::any_of(outcome.warnings, [](const Warning& warning) { return warning.code == "loose_bounds"; });
  claim(is_warned_of || bounds >= 1.0 - slack_of_retiming, "it is slowed {} times, and its bounds are {} of the limits",
        retiming.time_scale, bounds);
  const double used = share_used(sizes, limits);
  claim(is_warned_of || used >= 1.0 - retiming.slack - slack_of_retiming - slack_of_places,
        "it is slowed {} times, and uses {} of the limits", retiming.time_scale, used);
}

}  // namespace

void try_retime(TaskInput& input) {
  constexpr std::array names{"auto", "timed-c2", "timed-c3", "slerp", "quintic", "timed-c1", "rotation-spline"};
  RetimeOptions options;
  Flags flags(input.options);
  const double size = std::pow(10.0, static_cast<double>(input.options.below(7)) - 3.0);
  options.limits = fuzzed_limits(flags, size, input.more);
  const bool per_interval = flags.next();
  const Method method = input.chosen(names);
  Flags more(input.more);
  if (more.next()) options.shorten_rests = size;
  const Situation situation([&] { return fmt::format("retime {} to {}", text_of(method), text_of(options.limits)); });
  const Stopwatch stopwatch;
  const auto outcome = jobs::retime({.keys = input.keys, .method = {.method = method}, .options = options});
  if (!outcome) return claim_plain(outcome.error());
  claim_told(*outcome);
  const Retiming& retiming = outcome->retiming;
  claim(options.shorten_rests || retiming.time_scale >= 1.0, "it is slowed {} times", retiming.time_scale);
  claim_within(*outcome);
  if (!per_interval) return;
  options.slowing = Slowing::per_interval;
  const auto each = retime(*input.keys, method, options);
  if (!each) return claim_plain(each.error());
  claim(each->time_scale <= retiming.time_scale * (1.0 + slack_of_retiming), "interval by interval {} times, else {}",
        each->time_scale, retiming.time_scale);
}

}  // namespace orispline::fuzz
