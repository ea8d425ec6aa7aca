// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh_frames.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <orispline/base/formatted.hpp>
#include <orispline/scenes/bvh_even_times.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

/// All times of keys, each once.
std::vector<double> key_times_of(const Clip& clip) {
  std::vector<double> times;
  const auto add = [&](const auto& channels) {
    for (const auto& channel : channels) times.insert(times.end(), channel.times.begin(), channel.times.end());
  };
  add(clip.rotations);
  add(clip.translations);
  std::ranges::sort(times);
  const auto repeated = std::ranges::unique(times);
  times.erase(repeated.begin(), repeated.end());
  return times;
}

/// Even times from the first key on. Those that are keys within rounding get the times of these: a step begins at its
/// key, not a rounding later.
std::vector<double> times_at(double step, std::size_t count, std::span<const double> keys, TimeRounding rounding) {
  std::vector<double> times(count);
  auto key = keys.begin();
  for (std::size_t k = 0; k < count; ++k) {
    const double time = keys.front() + static_cast<double>(k) * step, off = rounding_at(time, rounding);
    times[k] = time;
    while (key != keys.end() && *key < time - off) ++key;
    for (; key != keys.end() && *key <= time + off; ++key) times[k] = *key;
  }
  return times;
}

TimeRounding rounding_of(std::span<const double> keys) {
  const auto is_float = [](double time) { return static_cast<double>(static_cast<float>(time)) == time; };
  return std::ranges::all_of(keys, is_float) ? TimeRounding::to_float : TimeRounding::to_double;
}

Expected<Frames> frames_at_rate(double rate, std::span<const double> keys) {
  if (!(std::isfinite(rate) && rate > 0.0))
    return bad_option("rate", formatted("found {}, wanted a number above 0", rate));
  const double step = 1.0 / rate, span = keys.back() - keys.front();
  const TimeRounding rounding = rounding_of(keys);
  const double steps = std::floor((span + rounding_at(keys.back(), rounding)) * rate);
  if (!(steps < most_frames))
    return bad_option("rate", formatted("found {}, which makes {:.0f} frames, wanted at most {:.0f}", rate, steps + 1.0,
                                        most_frames));
  constexpr double off = 4.0 * std::numeric_limits<double>::epsilon();
  return Frames{StepRange{step * (1.0 - off), step * (1.0 + off)}.shortest(),
                times_at(step, static_cast<std::size_t>(steps) + 1, keys, rounding)};
}

std::optional<Frames> even_frames(std::span<const double> keys, TimeRounding rounding, const Source* source) {
  const auto steps = even_steps_of(keys, rounding);
  if (!steps) return std::nullopt;
  const bool is_of_source = source && steps->has(source->frame_time.to_double());
  const Decimal frame_time = is_of_source ? source->frame_time : steps->shortest();
  const double step = frame_time.to_double();
  const auto count = static_cast<std::size_t>(std::round((keys.back() - keys.front()) / step)) + 1;
  return Frames{frame_time, times_at(step, count, keys, rounding)};
}

}  // namespace

Expected<Frames> frames_of(const Clip& clip, const SceneWriting& writing, const Source* source) {
  std::vector<double> keys = key_times_of(clip);
  if (keys.empty()) keys.push_back(0.0);
  if (writing.rate) return frames_at_rate(*writing.rate, keys);
  if (keys.size() == 1)
    return Frames{source ? source->frame_time : Decimal::parse("0.0333333").value(), {keys.front()}};
  // Of few times a grid of doubles may be found where a shorter one of floats is meant.
  const bool are_floats = rounding_of(keys) == TimeRounding::to_float;
  const TimeRounding first = are_floats ? TimeRounding::to_float : TimeRounding::to_double,
                     second = are_floats ? TimeRounding::to_double : TimeRounding::to_float;
  for (const TimeRounding rounding : {first, second})
    if (auto frames = even_frames(keys, rounding, source)) return std::move(*frames);
  return mended_by("rate", "found keys at uneven times, wanted even key times or a `rate`");
}

}}}  // namespace orispline::scenes::bvh
