// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/loop.hpp>

#include <numbers>

#include <fmt/format.h>

#include <orispline/curve/increments.hpp>

namespace orispline {
namespace {

/// What keeps the last key from being the first one come back; nothing if it is.
std::optional<std::string> gap_at_seam(const Keyframes& keys) {
  const double angle = angular_distance(keys.orientations().front(), keys.orientations().back());
  if (angle > closing_tolerance) return fmt::format("{:.6g} degrees", angle * 180.0 / std::numbers::pi);
  if (keys.positions().empty()) return std::nullopt;
  const double distance = (keys.positions().front() - keys.positions().back()).norm();
  if (distance > closing_tolerance) return fmt::format("{:.6g} m", distance);
  return std::nullopt;
}

double sign_towards_first(const Keyframes& keys, const Eigen::Quaterniond& from) {
  return from.dot(keys.orientations().front()) < 0.0 ? -1.0 : 1.0;
}

}  // namespace

Expected<ClosedKeys> closed_keys(const Keyframes& keys, const Loop& loop) {
  if (keys.size() < 2)
    return failure(ErrorCode::bad_data, fmt::format("a closed curve needs 2 keys, found {}", keys.size()));
  const std::size_t last = keys.size() - 1;
  const double span = keys.times()[last] - keys.times()[0];
  const double period = loop.period.value_or(span);
  const double sign = sign_towards_first(keys, keys.orientations()[last]);
  if (period != span) {
    const double closing_step = period - span;
    if (shortest_step <= closing_step && closing_step <= longest_step) return ClosedKeys{keys, {period, sign}};
    return failure(
        ErrorCode::bad_argument,
        fmt::format("the period is {} s, wanted a finite number greater than the keys' span of {} s", period, span));
  }
  if (const auto gap = gap_at_seam(keys))
    return failure(ErrorCode::bad_data,
                   fmt::format("the last key is {} from the first, wanted the first again or a period", *gap),
                   {.key = last});
  if (last < 2) return failure(ErrorCode::bad_data, "a closed curve needs 2 different keys, found 1");
  return ClosedKeys{keys.first(last), {period, sign}};
}

Knots closed_knots(const Keyframes& keys, const Closure& closure) {
  std::vector<double> times(keys.times().begin(), keys.times().end());
  times.push_back(times.front() + closure.period);
  return Knots::closed(std::move(times));
}

std::vector<Eigen::Quaterniond> joint_orientations(const Keyframes& keys, const FamilySettings& settings) {
  std::vector<Eigen::Quaterniond> joints(keys.orientations().begin(), keys.orientations().end());
  if (settings.closure) joints.emplace_back(settings.closure->sign * joints.front().coeffs());
  return joints;
}

ControlPolygon closed_polygon(const Keyframes& keys, const Closure& closure) {
  const auto q = keys.orientations();
  const auto wrapped = [&](const Eigen::Quaterniond& key) { return Eigen::Quaterniond(closure.sign * key.coeffs()); };
  std::vector<Eigen::Quaterniond> around{wrapped(q.back())};
  around.insert(around.end(), q.begin(), q.end());
  around.insert(around.end(), {wrapped(q[0]), wrapped(q[1])});
  return {.bases = {around.begin(), around.end() - 3}, .increments = increments_between(around)};
}

PathPolygon closed_path(const Keyframes& keys) {
  const auto p = keys.positions();
  PathPolygon around{p.back()};
  around.insert(around.end(), p.begin(), p.end());
  around.insert(around.end(), {p[0], p[1]});
  return around;
}

}  // namespace orispline
