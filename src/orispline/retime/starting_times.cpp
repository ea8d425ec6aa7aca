// SPDX-License-Identifier: Apache-2.0
#include <orispline/retime/starting_times.hpp>

#include <algorithm>
#include <array>
#include <functional>

#include <orispline/base/formatted.hpp>
#include <orispline/retime/motion_limits.hpp>
#include <orispline/retime/rest_to_rest.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Of the time in which a step could be the only cause of what is limited: so fast that limits are broken nearly
/// everywhere, since the way down from there ends lower than that from slow times.
constexpr double haste = 0.5;

/// What a limited vector would be if the step to the next key took a second and were its only cause. What is within the
/// rounding of keys at rest does not count.
double change_of(const LimitedQuantity& quantity, const Keyframes& keys, std::size_t i,
                 const std::optional<Eigen::Matrix3d>& inertia) {
  if (quantity.is_of_position()) {
    const Eigen::Vector3d moved = keys.positions()[i + 1] - keys.positions()[i];
    return moved.norm() > rest_length ? quantity.size_of(moved) : 0.0;
  }
  const Eigen::Vector3d turned = increment(keys.orientations()[i], keys.orientations()[i + 1]);
  if (!(turned.norm() > rest_angle)) return 0.0;
  return quantity.size_of(
      quantity.vector == LimitedQuantity::Vector::torque && inertia ? Eigen::Vector3d(*inertia * turned) : turned);
}

/// Of each of the limited quantities, the largest of all bodies.
QuantitySizes changes_of(std::span<const Keyframes> bodies, std::size_t i, const MotionLimits& limits,
                         const std::vector<LimitedQuantity>& quantities) {
  QuantitySizes changes{};
  for (std::size_t k = 0; k < quantities.size(); ++k)
    for (const Keyframes& keys : bodies)
      changes[k] = std::max(changes[k], change_of(quantities[k], keys, i, limits.inertia));
  return changes;
}

/// The largest change over the limit, for quantities of the orders 1, 2 and 3 [s], [s²], [s³].
std::array<double, 3> way_of(const QuantitySizes& changes, const std::vector<LimitedQuantity>& quantities) {
  std::array<double, 3> way{};
  for (std::size_t k = 0; k < quantities.size(); ++k) {
    double& of_order = way[static_cast<std::size_t>(quantities[k].order() - 1)];
    of_order = std::max(of_order, changes[k] / quantities[k].limit);
  }
  return way;
}

/// The ways of successive steps, one after the other.
struct Ways {
  std::vector<std::array<double, 3>> steps{};
  std::array<double, 3> sum{};

  void add(const std::array<double, 3>& step) {
    steps.push_back(step);
    std::ranges::transform(sum, step, sum.begin(), std::plus<>());
  }
  /// Of the whole way, the mean of the orders.
  [[nodiscard]] double share(const std::array<double, 3>& step) const {
    double share = 0.0, orders = 0.0;
    for (std::size_t k = 0; k < sum.size(); ++k)
      if (sum[k] > 0.0) share += step[k] / sum[k], orders += 1.0;
    return share / orders;
  }
};

/// Times of the keys in the fastest motion from each rest to the next, if it had one axis.
std::vector<double> rest_to_rest_times(std::span<const Keyframes> bodies, const StartingTimes& start,
                                       const MotionLimits& limits) {
  const auto quantities = quantities_of(limits);
  std::vector<double> times{start.times.front()};
  Ways ways;
  const auto go = [&] {
    if (ways.steps.empty()) return;
    const RestToRest motion(ways.sum);
    const double from = times.back();
    double gone = 0.0;
    for (std::size_t i = 0; i < ways.steps.size(); ++i) {
      gone += ways.share(ways.steps[i]);
      times.push_back(from + (i + 1 < ways.steps.size() ? motion.time_of(gone) : motion.duration()));
    }
    ways = {};
  };
  for (std::size_t i = 0; i + 1 < bodies.front().size(); ++i) {
    if (!all_rest_after(bodies, i)) {
      ways.add(way_of(changes_of(bodies, i, limits, quantities), quantities));
      continue;
    }
    go();
    times.push_back(times.back() + start.least[i]);
  }
  go();
  return times;
}

/// The times of the keys, with what is beyond `longest_rest` cut from rests.
std::vector<double> with_rests_cut(std::span<const Keyframes> bodies, const std::optional<double>& longest_rest) {
  std::vector<double> times(bodies.front().times().begin(), bodies.front().times().end());
  double cut = 0.0;
  for (std::size_t i = 0; i + 1 < bodies.front().size(); ++i) {
    const double interval = bodies.front().times()[i + 1] - bodies.front().times()[i];
    if (longest_rest && interval > *longest_rest && all_rest_after(bodies, i)) cut += interval - *longest_rest;
    times[i + 1] -= cut;
  }
  return times;
}

}  // namespace

bool all_rest_after(std::span<const Keyframes> bodies, std::size_t key) {
  return std::ranges::all_of(bodies, [key](const Keyframes& keys) { return keys.rests_after(key); });
}

Expected<StartingTimes> starting_times(std::span<const Keyframes> bodies, const RetimeOptions& options) {
  StartingTimes start{.times = with_rests_cut(bodies, options.shorten_rests), .least = {}};
  for (std::size_t i = 0; i + 1 < bodies.front().size(); ++i)
    start.least.push_back(start.times[i + 1] - start.times[i]);
  if (options.slowing != Slowing::fastest_keys) return start;
  const auto quantities = quantities_of(options.limits);
  for (std::size_t i = 0; i + 1 < bodies.front().size(); ++i) {
    double interval = start.least[i];
    if (!all_rest_after(bodies, i)) {
      start.least[i] = 0.0;
      interval = haste * needed_factor(changes_of(bodies, i, options.limits, quantities), quantities);
      if (!(interval > 0.0))
        return failure(ErrorCode::bad_argument,
                       "no limit concerns the step from this key to the next, which would take no time; wanted a limit "
                       "of what changes there, such as `max_rate` for a turn or `max_speed` for a shift",
                       {.key = i});
    }
    start.times[i + 1] = start.times[i] + interval;
    if (!(start.times[i + 1] - start.times[i] >= shortest_step) || !(interval <= longest_step))
      return failure(ErrorCode::bad_argument,
                     formatted("the limits leave {:.3g} s for the step from this key to the next, wanted limits with "
                               "which times can tell these keys apart, such as `max_rate` for degrees in seconds",
                               interval),
                     {.key = i});
  }
  start.others.push_back(rest_to_rest_times(bodies, start, options.limits));
  return start;
}

}}  // namespace orispline
