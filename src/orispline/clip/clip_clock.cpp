// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/clip_clock.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// The interval of the clock in which a time is, one at an end of two in that of the side.
std::size_t interval_at(const ClipClock& clock, double time, ClipClock::Beside side) {
  const auto& all = clock.before;
  const auto behind =
      side == ClipClock::Beside::later ? std::ranges::upper_bound(all, time) : std::ranges::lower_bound(all, time);
  const auto index = static_cast<std::size_t>(behind - all.begin());
  return std::clamp<std::size_t>(index, 1, all.size() - 1) - 1;
}

}  // namespace

double ClipClock::pace(double time, Beside side) const {
  const std::size_t i = interval_at(*this, time, side);
  return (after[i + 1] - after[i]) / (before[i + 1] - before[i]);
}

double ClipClock::at(double time) const {
  const std::size_t i = interval_at(*this, time, Beside::later);
  if (time == before[i]) return after[i];
  if (time == before[i + 1]) return after[i + 1];
  return after[i] + (time - before[i]) * ((after[i + 1] - after[i]) / (before[i + 1] - before[i]));
}

Clip on_clock(Clip clip, const ClipClock& clock) {
  return with_channels(std::move(clip), [&clock](auto channel) {
    for (std::size_t k = 0; k < channel.in_tangents.size(); ++k) {
      const double time = channel.times[k];
      channel.in_tangents[k] = scaled(channel.in_tangents[k], 1.0 / clock.pace(time, ClipClock::Beside::earlier));
      channel.out_tangents[k] = scaled(channel.out_tangents[k], 1.0 / clock.pace(time, ClipClock::Beside::later));
    }
    for (double& time : channel.times) time = clock.at(time);
    return channel;
  });
}

}}  // namespace orispline
