// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh/writer.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <orispline/base/decimal.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/scenes/usual_step.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

/// How far times are rounded.
enum class TimeRounding { to_float, to_double };

/// How far from its exact value a time may be [s].
double rounding_at(double time, TimeRounding rounding) noexcept {
  const double of_double = 8.0 * std::numeric_limits<double>::epsilon() * std::abs(time);
  if (time == 0.0 || rounding == TimeRounding::to_double) return of_double;
  return std::ldexp(1.0, std::ilogb(time) - std::numeric_limits<float>::digits) + of_double;
}

/// From the least to the most that a step may be [s].
struct StepRange {
  double least, most;

  [[nodiscard]] bool has(double step) const noexcept { return least <= step && step <= most; }
  [[nodiscard]] double middle() const noexcept { return least + (most - least) / 2; }
  /// The decimal of the fewest digits in it, the nearest to its middle of those.
  [[nodiscard]] Decimal shortest() const;
};

/// More frames than this are not written.
constexpr double most_frames = 1e8;

constexpr double finer_step = 0.75;  // of the step of most keys: such a grid is not theirs
constexpr int most_parts = 64;       // of the shortest step between keys, which need not be at every frame

/// The distances of times from the first one, and how far each may be off.
class EvenTimes {
 public:
  EvenTimes(std::span<const double> times, TimeRounding rounding) : times_(times), rounding_(rounding) {}

  /// The shortest step between times that are not the same within their rounding; from 0 on where there is none.
  [[nodiscard]] StepRange shortest_step() const {
    StepRange shortest{0.0, std::numeric_limits<double>::max()};
    for (std::size_t i = 1; i < times_.size(); ++i) {
      const double step = times_[i] - times_[i - 1], off = off_at(i) + off_at(i - 1);
      if (step > off && step + off < shortest.most) shortest = {step - off, step + off};
    }
    return shortest;
  }

  /// What is left of a range of steps by all times; nothing where nothing is.
  [[nodiscard]] std::optional<StepRange> narrowed(StepRange steps) const {
    for (std::size_t i = 1; i < times_.size(); ++i) {
      const double distance = times_[i] - times_[0], off = off_at(i) + off_at(0);
      const double count = std::round(distance / steps.middle());
      if (count == 0.0 && distance <= off) continue;
      steps.least = std::max(steps.least, (distance - off) / count);
      steps.most = std::min(steps.most, (distance + off) / count);
      if (!(steps.least <= steps.most)) return std::nullopt;
    }
    return steps;
  }

  /// Whether the rounding is small beside a step: else any grid would do.
  [[nodiscard]] bool tells(double step) const {
    return 4.0 * (off_at(times_.size() - 1) + off_at(0)) < step && times_.back() - times_.front() < most_frames * step;
  }

 private:
  [[nodiscard]] double off_at(std::size_t i) const { return rounding_at(times_[i], rounding_); }

  std::span<const double> times_;
  TimeRounding rounding_;
};

Decimal StepRange::shortest() const {
  const int first = Decimal::from_double(most).decade();
  for (int digits = 1; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    const int exponent = first + 1 - digits;
    const Decimal nearest = Decimal::from_double(std::round(middle() * Decimal::power_of_ten(-exponent).to_double()));
    if (const Decimal step = nearest * Decimal::power_of_ten(exponent); has(step.to_double())) return step;
  }
  return Decimal::from_double(middle());
}

/// The steps of the coarsest even grid from the first time on that has all times within their rounding; nothing where
/// there is none. `times`: two at least, rising. `most`: parts of the shortest step between them.
std::optional<StepRange> even_steps_of(std::span<const double> times, TimeRounding rounding, int most) {
  const EvenTimes even(times, rounding);
  const StepRange step = even.shortest_step();
  if (step.least == 0.0) return std::nullopt;
  for (int parts = 1; parts <= most; ++parts) {
    const StepRange part{step.least / parts, step.most / parts};
    if (!even.tells(part.middle())) return std::nullopt;
    if (const auto steps = even.narrowed(part)) return steps;
  }
  return std::nullopt;
}

/// All times of keys, each once.
std::vector<double> key_times_of(const Clip& clip) {
  std::vector<double> times;
  const auto add = [&](const auto& channels) {
    for (const auto& channel : channels) times.insert(times.end(), channel.times.begin(), channel.times.end());
  };
  add(clip.rotations);
  add(clip.translations);
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
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

std::optional<Frames> even_frames(std::span<const double> keys, TimeRounding rounding, const Source* source, int most) {
  const auto steps = even_steps_of(keys, rounding, most);
  if (!steps) return std::nullopt;
  const bool is_of_source = source && steps->has(source->frame_time.to_double());
  const Decimal frame_time = is_of_source ? source->frame_time : steps->shortest();
  const double step = frame_time.to_double();
  const auto count = static_cast<std::size_t>(std::round((keys.back() - keys.front()) / step)) + 1;
  return Frames{frame_time, times_at(step, count, keys, rounding)};
}

/// The step [s] of frames that were cut between two of them, or joined with others, or between which a joint got more:
/// that of most keys, else that of their file; nothing where keys are farther apart.
std::optional<Decimal> step_of_cut(std::span<const double> keys, double usual, const Source& source) {
  constexpr double same_step = 1e-3,
                   nearly = 1e-2;  // shares by which steps may differ, and one where files were joined
  double longest = 0.0;
  std::size_t usual_steps = 0;
  const auto is_usual = [usual](double step) { return std::abs(step - usual) <= same_step * usual; };
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const double step = keys[i + 1] - keys[i];
    longest = std::max(longest, step * (1.0 - nearly));
    if (is_usual(step)) ++usual_steps;
  }
  const double of_file = source.frame_time.to_double();
  if (2 * usual_steps > keys.size() - 1 && longest <= usual && !is_usual(of_file)) {
    const double off = 2.0 * rounding_at(keys.back(), rounding_of(keys));
    return StepRange{usual - off, usual + off}.shortest();
  }
  return longest <= of_file ? std::optional(source.frame_time) : std::nullopt;
}

Expected<Frames> frames_with_step(const Decimal& step, std::span<const double> keys) {
  auto frames = frames_at_rate(1.0 / step.to_double(), keys);
  if (frames) frames->frame_time = step;
  return frames;
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
  for (const int most : source ? std::vector{1, most_parts} : std::vector{most_parts}) {
    const bool may_be_cut = most == 1;  // between two frames, whose own step then counts more than a finer one
    const double usual = may_be_cut ? usual_step_of(clip) : 0.0;
    for (const TimeRounding rounding : {first, second})
      if (auto frames = even_frames(keys, rounding, source, most);
          frames && !(may_be_cut && frames->frame_time.to_double() < finer_step * usual))
        return std::move(*frames);
    if (may_be_cut)
      if (const auto step = step_of_cut(keys, usual, *source)) return frames_with_step(*step, keys);
  }
  return mended_by("rate", "found keys at uneven times, wanted even key times or a `rate`");
}

}}}  // namespace orispline::scenes::bvh
