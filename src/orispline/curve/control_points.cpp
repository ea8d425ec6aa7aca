// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/control_points.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

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

/// The keys seen inwards from one end.
template <CurvePoint P>
EndNeighbourhood inwards_from(EndKey end, const Keyframes& keys) {
  const std::size_t last = keys.size() - 1;
  const auto key = [end, last](std::size_t j) { return end == EndKey::first ? j : last - j; };
  return {.distance = [&keys, key](std::size_t j) { return std::abs(keys.times()[key(j)] - keys.times()[key(0)]); },
          .displacement = [key,
                           p = keys.points<P>()](std::size_t j) { return displacement<double>(p[key(0)], p[key(j)]); }};
}

/// The end for points of this kind: at a clamped one positions, for which there is no rate, continue naturally.
template <CurvePoint P>
End end_for(const End& end) {
  if constexpr (std::same_as<P, Eigen::Quaterniond>) return end;
  else return {.rule = rule_for_positions(end.rule)};
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

template <CurvePoint P>
Expected<ControlPolygon<P>> ghosted_polygon(const Keyframes& keys, const FamilySettings& settings, RateWeights at_start,
                                            RateWeights at_end) {
  const End start = end_for<P>(settings.start), end = end_for<P>(settings.end);
  const auto before =
      ghost_increment(start.rule, start.angular_velocity, at_start, inwards_from<P>(EndKey::first, keys));
  if (!before) return at_key(0, before.error());
  // Seen from the last key inwards time runs backwards: rates and increments change sign.
  const auto after =
      ghost_increment(end.rule, -end.angular_velocity, at_end.mirrored(), inwards_from<P>(EndKey::last, keys));
  if (!after) return at_key(keys.size() - 1, after.error());
  const auto p = keys.points<P>();
  std::vector<P> points{displaced(p.front(), -*before)};
  points.reserve(p.size() + 2);
  points.insert(points.end(), p.begin(), p.end());
  points.push_back(displaced(p.back(), -*after));
  auto polygon = polygon_through<P>(points, 3, 1);
  if constexpr (std::same_as<P, Eigen::Quaterniond>) {  // no logarithm gives an increment beyond a full turn back
    polygon.increments.front() = *before;
    polygon.increments.back() = -*after;
  }
  return polygon;
}

template Expected<ControlPolygon<Eigen::Quaterniond>> ghosted_polygon(const Keyframes&, const FamilySettings&,
                                                                      RateWeights, RateWeights);
template Expected<ControlPolygon<Eigen::Vector3d>> ghosted_polygon(const Keyframes&, const FamilySettings&, RateWeights,
                                                                   RateWeights);

}}  // namespace orispline
