// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/loop.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// What keeps the last key from being the first one come back; nothing if it is.
std::optional<std::string> gap_at_seam(const Keyframes& keys) {
  const double angle = angular_distance(keys.orientations().front(), keys.orientations().back());
  if (angle > closing_tolerance) return formatted("{:.6g} degrees", angle * degrees);
  if (keys.positions().empty()) return std::nullopt;
  const double distance = (keys.positions().front() - keys.positions().back()).norm();
  if (distance > closing_tolerance) return formatted("{:.6g} m", distance);
  return std::nullopt;
}

double sign_towards_first(const Keyframes& keys, const Eigen::Quaterniond& from) {
  return from.dot(keys.orientations().front()) < 0.0 ? -1.0 : 1.0;
}

/// A key of the loop, one period away.
Eigen::Quaterniond come_round(const Eigen::Quaterniond& key, const Closure& closure) {
  return Eigen::Quaterniond(closure.sign * key.coeffs());
}
Eigen::Vector3d come_round(const Eigen::Vector3d& key, const Closure&) { return key; }

/// The keys of a loop, unless steps beside its seam are too uneven.
Expected<ClosedKeys> comparable_around(const Keyframes& keys, const Closure& closure) {
  const auto t = keys.times();
  const std::size_t last = t.size() - 1;
  const double closing_step = closure.period - (t[last] - t[0]);
  for (const double step : {t[last] - t[last - 1], t[1] - t[0]})
    if (!are_comparable(closing_step, step))
      return failure(ErrorCode::bad_data,
                     formatted("the closing step is {:g} s and one beside it {:g} s, wanted neither longer than {:g} "
                               "times the other",
                               closing_step, step, widest_step_ratio));
  return ClosedKeys{keys, closure};
}

}  // namespace

Expected<ClosedKeys> closed_keys(const Keyframes& keys, const Loop& loop) {
  if (keys.size() < 2)
    return failure(ErrorCode::bad_data, formatted("a closed curve needs 2 keys, found {}", keys.size()));
  const std::size_t last = keys.size() - 1;
  const double span = keys.times()[last] - keys.times()[0];
  const double period = loop.period.value_or(span);
  const double sign = sign_towards_first(keys, keys.orientations()[last]);
  if (period != span) {
    const double closing_step = period - span;
    if (shortest_step <= closing_step && closing_step <= longest_step) return comparable_around(keys, {period, sign});
    return failure(
        ErrorCode::bad_argument,
        formatted("the period is {} s, wanted a finite number greater than the keys' span of {} s", period, span));
  }
  if (const auto gap = gap_at_seam(keys))
    return failure(
        ErrorCode::bad_data,
        formatted("the last key is {} from the first, wanted the first one again, or `period` for a later return",
                  *gap),
        {.key = last});
  if (last < 2) return failure(ErrorCode::bad_data, "a closed curve needs 2 different keys, found 1");
  return comparable_around(keys.first(last), {period, sign});
}

Knots closed_knots(const Keyframes& keys, const Closure& closure) {
  std::vector<double> times(keys.times().begin(), keys.times().end());
  times.push_back(times.front() + closure.period);
  return Knots::closed(std::move(times));
}

std::vector<Eigen::Quaterniond> joint_orientations(const Keyframes& keys, const FamilySettings& settings) {
  std::vector<Eigen::Quaterniond> joints(keys.orientations().begin(), keys.orientations().end());
  if (settings.closure) joints.push_back(come_round(joints.front(), *settings.closure));
  return joints;
}

template <CurvePoint P>
ControlPolygon<P> closed_polygon(const Keyframes& keys, const Closure& closure) {
  const auto p = keys.points<P>();
  std::vector<P> around{come_round(p.back(), closure)};
  around.insert(around.end(), p.begin(), p.end());
  around.insert(around.end(), {come_round(p[0], closure), come_round(p[1], closure)});
  return polygon_through<P>(around, 3, 1);
}

template ControlPolygon<Eigen::Quaterniond> closed_polygon(const Keyframes&, const Closure&);
template ControlPolygon<Eigen::Vector3d> closed_polygon(const Keyframes&, const Closure&);

}}  // namespace orispline
