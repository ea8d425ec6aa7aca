// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/recent_keys.hpp>

#include <algorithm>
#include <cmath>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Keys counted inwards from one end. The functions of an EndNeighbourhood hold one pointer to it: what is larger would
/// be put on the heap.
struct InwardKeys {
  EndKey end;
  const RecentKeys& keys;

  [[nodiscard]] std::size_t operator()(std::size_t j) const noexcept {
    return end == EndKey::first ? j : keys.size - 1 - j;
  }
  [[nodiscard]] double distance(std::size_t j) const noexcept {
    return std::abs(keys.times[(*this)(j)] - keys.times[(*this)(0)]);
  }
  [[nodiscard]] Eigen::Vector3d turn(std::size_t j) const noexcept {
    return increment<double>(keys.orientations[(*this)(0)], keys.orientations[(*this)(j)]);
  }
  [[nodiscard]] Eigen::Vector3d shift(std::size_t j) const noexcept {
    return keys.positions[(*this)(j)] - keys.positions[(*this)(0)];
  }
};

}  // namespace

void RecentKeys::push(double time, const Eigen::Quaterniond& orientation, const Eigen::Vector3d& position) noexcept {
  if (size == most) {
    std::shift_left(times.begin(), times.end(), 1);
    std::shift_left(orientations.begin(), orientations.end(), 1);
    std::shift_left(positions.begin(), positions.end(), 1);
    std::shift_left(increments.begin(), increments.end(), 1);
    --size;
  }
  times[size] = time;
  orientations[size] = orientation;
  positions[size] = position;
  if (size > 0) increments[size - 1] = increment<double>(orientations[size - 1], orientation);
  ++size;
}

Expected<GhostIncrements> ghost_beyond(EndKey which, const RecentKeys& keys, const End& end, RateWeights weights) {
  const InwardKeys inward{which, keys};
  const auto distance = [&inward](std::size_t j) { return inward.distance(j); };
  // Seen from the last key inwards time runs backwards: rates change sign.
  const Eigen::Vector3d rate = which == EndKey::first ? end.angular_velocity : Eigen::Vector3d(-end.angular_velocity);
  const auto turn =
      ghost_increment(end.rule, rate, weights,
                      {.distance = distance, .displacement = [&inward](std::size_t j) { return inward.turn(j); }});
  if (!turn) return tl::unexpected(turn.error());
  const auto shift =
      ghost_increment(rule_for_positions(end.rule), Eigen::Vector3d::Zero(), weights,
                      {.distance = distance, .displacement = [&inward](std::size_t j) { return inward.shift(j); }});
  if (!shift) return tl::unexpected(shift.error());
  return GhostIncrements{.turn = *turn, .shift = *shift};
}

}}  // namespace orispline
