// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/curve_measures.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <orispline/analysis/segment_motions.hpp>
#include <orispline/curve/motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t steps_per_segment = 16;
constexpr int most_bisections = 60;
/// Between two steps |rate|² does not rise by more than this share: lower maxima need no search.
constexpr double worth_searching = 0.8;

/// Half the derivative of |rate|² beside |rate|² itself.
struct Height {
  double square = 0.0, slope = 0.0;
};
using Heights = std::array<Height, 3>;

Height height_of(const Eigen::Vector3d& rate, const Eigen::Vector3d& derivative) {
  return {rate.squaredNorm(), rate.dot(derivative)};
}

struct Searched {
  const AnyCurve& curve;
  const Eigen::Matrix3d& inertia;
  std::size_t rates = inertia == Eigen::Matrix3d::Identity() ? 2 : 3;  // of unit inertia the torque is α

  [[nodiscard]] Heights of(const Eigen::Vector3d& velocity, const Eigen::Vector3d& acceleration,
                           const Eigen::Vector3d& jerk) const {
    Heights heights{height_of(velocity, acceleration), height_of(acceleration, jerk)};
    if (rates < heights.size()) return heights;
    const Motion m{.angular_velocity = velocity, .angular_acceleration = acceleration, .angular_jerk = jerk};
    heights[2] = height_of(torque(m, inertia), torque_rate(m, inertia));
    return heights;
  }
  [[nodiscard]] Heights at(std::size_t segment, double t) const {
    const Motion m = curve.motion_on(segment, t);
    return of(m.angular_velocity, m.angular_acceleration, m.angular_jerk);
  }
};

using Steps = std::array<double, steps_per_segment + 1>;  // the times of a segment's steps, both ends among them

Steps steps_between(double start, double end) {
  Steps steps;
  for (std::size_t k = 0; k < steps.size(); ++k)
    steps[k] = std::lerp(start, end, static_cast<double>(k) / double{steps_per_segment});
  return steps;
}

/// A step within a segment, at whose ends a rate rises and falls: a maximum lies between.
struct Summit {
  std::size_t segment;
  double start, end;
  double square;  ///< the larger one at the ends
};

struct Search {
  double square = -1.0, time = 0.0;
  std::vector<Summit> summits;

  void see(double found, double at) {
    if (found <= square) return;
    square = found;
    time = at;
  }
  [[nodiscard]] double floor() const { return worth_searching * square; }
  void climb_later(const Summit& summit) {
    if (summit.square >= floor()) summits.push_back(summit);
  }
};

void climb(Search& search, const Summit& summit, const Searched& searched, std::size_t rate) {
  double low = summit.start, high = summit.end;
  for (int i = 0; i < most_bisections; ++i) {
    const double middle = 0.5 * (low + high);
    if (middle <= low || middle >= high) break;
    (searched.at(summit.segment, middle)[rate].slope > 0.0 ? low : high) = middle;
  }
  search.see(searched.at(summit.segment, low)[rate].square, low);
}

Peak peak_of(Search& search, const Searched& searched, std::size_t rate) {
  const double floor = search.floor();
  for (const Summit& summit : search.summits)
    if (summit.square >= floor) climb(search, summit, searched, rate);
  return {std::sqrt(std::max(search.square, 0.0)), search.time};
}

}  // namespace

Peaks peaks(const AnyCurve& curve, const Eigen::Matrix3d& inertia) {
  const Searched searched{curve, inertia};
  const auto knots = curve.knots().times();
  if (knots.size() < 2) return {{0.0, knots.front()}, {0.0, knots.front()}, {0.0, knots.front()}};
  std::array<Search, 3> searches;
  for (std::size_t segment = 0; segment + 1 < knots.size(); ++segment) {
    SegmentMotions motions(curve, segment, MotionPart::rates);
    if (motions.is_gap()) continue;
    const Steps times = steps_between(knots[segment], knots[segment + 1]);
    motions.evaluate(times);
    Heights last{};
    for (std::size_t step = 0; step < times.size(); ++step) {
      const Heights now =
          searched.of(motions.angular_velocity(step), motions.angular_acceleration(step), motions.angular_jerk(step));
      for (std::size_t rate = 0; rate < searched.rates; ++rate) {
        searches[rate].see(now[rate].square, times[step]);
        if (step > 0 && last[rate].slope > 0.0 && now[rate].slope < 0.0)
          searches[rate].climb_later(
              {segment, times[step - 1], times[step], std::max(last[rate].square, now[rate].square)});
      }
      last = now;
    }
  }
  const Peak acceleration = peak_of(searches[1], searched, 1);
  return {peak_of(searches[0], searched, 0), acceleration,
          searched.rates < 3 ? acceleration : peak_of(searches[2], searched, 2)};
}

}}  // namespace orispline
