// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/control_points.hpp>

#include <orispline/curve/increments.hpp>

namespace orispline {
namespace {

/// Lagrange extrapolation of the displacements of `nodes` keys (the end key's own is zero) to the ghost's time.
Eigen::Vector3d extrapolated(std::size_t nodes, const EndNeighbourhood& end) {
  const double ghost = -end.distance(1);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t j = 1; j < nodes; ++j) {
    double weight = 1.0;
    for (std::size_t k = 0; k < nodes; ++k)
      if (k != j) weight *= (ghost - end.distance(k)) / (end.distance(j) - end.distance(k));
    sum += weight * end.displacement(j);
  }
  return sum;
}

enum class EndKey { first, last };

/// The keys seen inwards from one end; `between(i, j)` is the displacement from key i to key j.
template <class Between>
EndNeighbourhood inwards_from(EndKey end, const Keyframes& keys, Between between) {
  const std::size_t last = keys.size() - 1;
  const auto key = [end, last](std::size_t j) { return end == EndKey::first ? j : last - j; };
  return {.distance = [&keys, key](std::size_t j) { return std::abs(keys.times()[key(j)] - keys.times()[key(0)]); },
          .displacement = [key, between](std::size_t j) { return between(key(0), key(j)); }};
}

EndNeighbourhood orientations_from(EndKey end, const Keyframes& keys) {
  return inwards_from(
      end, keys, [q = keys.orientations()](std::size_t i, std::size_t j) { return increment<double>(q[i], q[j]); });
}

EndNeighbourhood positions_from(EndKey end, const Keyframes& keys) {
  return inwards_from(end, keys,
                      [p = keys.positions()](std::size_t i, std::size_t j) -> Eigen::Vector3d { return p[j] - p[i]; });
}

/// The error of an end, at its key.
tl::unexpected<Error> at_key(std::size_t key, Error error) {
  error.where.key = key;
  return tl::unexpected(std::move(error));
}

}  // namespace

Expected<Eigen::Vector3d> ghost_increment(EndRule rule, const Eigen::Vector3d& inward_rate, RateWeights weights,
                                          const EndNeighbourhood& end) {
  switch (rule) {
    case EndRule::natural:
    case EndRule::reflect:
      return end.displacement(1);
    case EndRule::quadratic:
      return Eigen::Vector3d(-extrapolated(3, end));
    case EndRule::cubic:
      return Eigen::Vector3d(-extrapolated(4, end));
    case EndRule::clamped:
    case EndRule::rest: {
      const Eigen::Vector3d missing = inward_rate - weights.after * end.displacement(1);
      if (weights.before != 0.0) return Eigen::Vector3d(missing / weights.before);
      if (missing.isZero(0.0)) return Eigen::Vector3d::Zero();
      return failure(ErrorCode::bad_argument, "a clamped end needs a non-zero tension at that key, found 0");
    }
    default:
      return Eigen::Vector3d::Zero();
  }
}

Expected<ControlPolygon> ghosted_polygon(const Keyframes& keys, const FamilySettings& settings, RateWeights at_start,
                                         RateWeights at_end) {
  const auto before = ghost_increment(settings.start.rule, settings.start.angular_velocity, at_start,
                                      orientations_from(EndKey::first, keys));
  if (!before) return at_key(0, before.error());
  // Seen from the last key inwards time runs backwards: rates and increments change sign.
  const auto after = ghost_increment(settings.end.rule, -settings.end.angular_velocity, at_end.mirrored(),
                                     orientations_from(EndKey::last, keys));
  if (!after) return at_key(keys.size() - 1, after.error());
  const auto q = keys.orientations();
  ControlPolygon polygon;
  polygon.bases.reserve(q.size() - 1);
  polygon.increments.reserve(q.size() + 1);
  polygon.bases.push_back(q.front() * exp<double>(-*before));
  polygon.bases.insert(polygon.bases.end(), q.begin(), q.end() - 2);
  polygon.increments.push_back(*before);
  const std::vector<Eigen::Vector3d> inner = increments_between(q);
  polygon.increments.insert(polygon.increments.end(), inner.begin(), inner.end());
  polygon.increments.push_back(-*after);
  return polygon;
}

Expected<PathPolygon> ghosted_path(const Keyframes& keys, const FamilySettings& settings, RateWeights at_start,
                                   RateWeights at_end) {
  const Eigen::Vector3d at_rest = Eigen::Vector3d::Zero();
  const auto before =
      ghost_increment(rule_for_positions(settings.start.rule), at_rest, at_start, positions_from(EndKey::first, keys));
  if (!before) return at_key(0, before.error());
  const auto after = ghost_increment(rule_for_positions(settings.end.rule), at_rest, at_end.mirrored(),
                                     positions_from(EndKey::last, keys));
  if (!after) return at_key(keys.size() - 1, after.error());
  const auto p = keys.positions();
  PathPolygon polygon;
  polygon.reserve(p.size() + 2);
  polygon.push_back(p.front() - *before);
  polygon.insert(polygon.end(), p.begin(), p.end());
  polygon.push_back(p.back() - *after);
  return polygon;
}

}  // namespace orispline
