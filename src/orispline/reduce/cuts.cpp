// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/cuts.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include <orispline/math/shorter_way.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double longest_cut = 0.0021;  // of close keys [s], with the rounding of times
constexpr double short_cut = 0.001;     // that is written [s]
constexpr double near_share = 0.25;     // of its neighbours' intervals, for close keys
constexpr double beyond_neighbours = 5.0;
constexpr double least_turn = 10.0 * std::numbers::pi / 180.0, least_shift_share = 0.05;
constexpr double rounding_of_rest = 1e-4;  // of close keys that stand still [rad], or in the unit of length

/// The longest chain of bones in the rest pose, from a root down.
double longest_chain(const Skeleton& skeleton) {
  std::vector<double> chains(skeleton.size(), 0.0);
  double longest = 0.0;
  for (std::size_t i = 0; i < skeleton.size(); ++i) {
    if (const std::size_t parent = skeleton[i].parent; parent != no_parent)
      chains[i] = chains[parent] + skeleton[i].rest.translation.norm();
    longest = std::max(longest, chains[i]);
  }
  return longest;
}

double least_jump(const RotationChannel&, double) { return least_turn; }
double least_jump(const VectorChannel& channel, double chain) {
  if (chain > 0.0) return least_shift_share * chain;
  Eigen::Vector3d lowest = channel.values.front(), highest = lowest;
  for (const Eigen::Vector3d& value : channel.values)
    lowest = lowest.cwiseMin(value), highest = highest.cwiseMax(value);
  return least_shift_share * (highest - lowest).norm();
}

/// Adds the channel's own cuts.
template <CurvePoint P>
void find(const Channel<P>& channel, CutSearch search, double chain, std::vector<Cut>& cuts) {
  if (channel.interpolation == ChannelInterpolation::step || channel.size() < 2) return;
  const bool has_single_steps =
      search == CutSearch::single_steps && channel.interpolation == ChannelInterpolation::linear;
  const auto& times = channel.times;
  const std::size_t steps = channel.size() - 1;
  std::vector<double> lengths, intervals;
  for (std::size_t i = 0; i < steps; ++i) {
    lengths.push_back(distance_between(channel.values[i], channel.values[i + 1]));
    intervals.push_back(times[i + 1] - times[i]);
  }
  const double least = has_single_steps ? least_jump(channel, chain) : 0.0;
  for (std::size_t i = 0; i < steps; ++i) {
    double largest_rate = 0.0, shortest = std::numeric_limits<double>::infinity(), largest_step = 0.0;
    for (std::size_t k = i - std::min<std::size_t>(i, 2); k < std::min(steps, i + 3); ++k) {
      if (k == i) continue;
      largest_rate = std::max(largest_rate, lengths[k] / intervals[k]);
      largest_step = std::max(largest_step, lengths[k]);
      if (k + 1 == i || k == i + 1) shortest = std::min(shortest, intervals[k]);
    }
    const bool is_close = intervals[i] <= longest_cut && intervals[i] <= near_share * shortest && steps > 1;
    const bool is_beyond = lengths[i] > beyond_neighbours * largest_rate * intervals[i];
    const bool is_close_cut = is_close && is_beyond && lengths[i] > rounding_of_rest;
    const bool is_single = has_single_steps && steps > 2 && is_beyond && lengths[i] >= least &&
                           lengths[i] > beyond_neighbours * largest_step;
    if (is_close_cut || is_single) cuts.push_back({times[i], times[i + 1]});
  }
}

/// In the order of time; those that overlap become one.
void merge(std::vector<Cut>& cuts) {
  std::ranges::sort(cuts, {}, &Cut::before);
  std::vector<Cut> merged;
  for (const Cut& cut : cuts)
    if (!merged.empty() && cut.before < merged.back().after)
      merged.back().after = std::max(merged.back().after, cut.after);
    else merged.push_back(cut);
  cuts = std::move(merged);
}

/// Where the channel has both of its ends as keys, with none between.
template <CurvePoint P>
std::optional<std::size_t> key_before(const Channel<P>& channel, const Cut& cut) {
  const auto found = std::ranges::lower_bound(channel.times, cut.before);
  const auto k = static_cast<std::size_t>(found - channel.times.begin());
  if (k + 1 >= channel.size() || channel.times[k] != cut.before || channel.times[k + 1] != cut.after)
    return std::nullopt;
  return k;
}

/// Until when the value before a cut is held, if that is long: late times in single precision are farther apart.
double held_until(const Cut& cut) {
  if (cut.after - cut.before <= longest_cut) return cut.before;
  const auto after = static_cast<float>(cut.after);
  const double between_floats =
      cut.after - static_cast<double>(std::nextafter(after, -std::numeric_limits<float>::infinity()));
  return std::max(cut.before, cut.after - std::max(short_cut, 4.0 * std::abs(between_floats)));
}

/// The value before each cut held.
template <CurvePoint P>
void hold(Channel<P>& channel, const std::vector<Cut>& cuts) {
  if (channel.interpolation != ChannelInterpolation::linear) return;
  for (const Cut& cut : cuts) {
    const double held = held_until(cut);
    const auto before = key_before(channel, cut);
    if (!before || held == cut.before) continue;
    const P value = channel.values[*before];
    const auto place = static_cast<std::ptrdiff_t>(*before) + 1;
    channel.times.insert(channel.times.begin() + place, held);
    channel.values.insert(channel.values.begin() + place, value);
  }
}

}  // namespace

std::vector<std::vector<Cut>> cuts_of(const Skeleton& skeleton, const Clip& clip, CutSearch search) {
  std::vector<std::vector<Cut>> cuts(skeleton.size());
  const double chain = longest_chain(skeleton);
  for (const RotationChannel& channel : clip.rotations) find(channel, search, chain, cuts[channel.joint]);
  for (const VectorChannel& channel : clip.translations) find(channel, search, chain, cuts[channel.joint]);
  for (std::vector<Cut>& of_joint : cuts) merge(of_joint);
  return cuts;
}

std::size_t count_of(const std::vector<std::vector<Cut>>& of_joints) {
  std::vector<Cut> all;
  for (const std::vector<Cut>& cuts : of_joints) all.insert(all.end(), cuts.begin(), cuts.end());
  merge(all);
  return all.size();
}

Clip with_short_cuts(Clip clip, std::vector<std::vector<Cut>>& of_joints) {
  const auto hold_in = [&](auto& channels) {
    for (auto& channel : channels) hold(channel, of_joints[channel.joint]);
  };
  hold_in(clip.rotations), hold_in(clip.translations), hold_in(clip.scales);
  for (std::vector<Cut>& cuts : of_joints)
    for (Cut& cut : cuts) cut.before = held_until(cut);
  return clip;
}

template <CurvePoint P>
std::vector<Cut> cuts_in(const Channel<P>& channel, const std::vector<Cut>& of_joint) {
  std::vector<Cut> cuts;
  for (const Cut& cut : of_joint)
    if (key_before(channel, cut)) cuts.push_back(cut);
  return cuts;
}

template std::vector<Cut> cuts_in(const RotationChannel&, const std::vector<Cut>&);
template std::vector<Cut> cuts_in(const VectorChannel&, const std::vector<Cut>&);

}}  // namespace orispline
