// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/track_sampler.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <orispline/base/formatted.hpp>
#include <orispline/online/track_state.hpp>

namespace orispline {
namespace {

/// Samples whose times are computed at a time.
constexpr std::size_t block = 1024;

/// The samples of the span that begin at one, interleaved; empty stays empty.
std::span<double> part_of(std::span<double> all, std::size_t components, std::size_t from, std::size_t count) {
  return all.empty() ? all : all.subspan(components * from, components * count);
}

Samples<double> part_of(const Samples<double>& out, std::size_t from, std::size_t count) {
  return {.orientations = part_of(out.orientations, 4, from, count),
          .angular_velocities = part_of(out.angular_velocities, 3, from, count),
          .angular_accelerations = part_of(out.angular_accelerations, 3, from, count),
          .positions = part_of(out.positions, 3, from, count),
          .velocities = part_of(out.velocities, 3, from, count),
          .accelerations = part_of(out.accelerations, 3, from, count)};
}

std::optional<Error> check_room(const Samples<double>& out, std::span<const double> times, std::uint64_t ready) {
  const auto refused = [](std::string message) { return Error{ErrorCode::bad_argument, std::move(message), {}}; };
  if (out.layout != Layout::interleaved) return refused("found room for planar samples, wanted interleaved");
  if (out.size() > ready)
    return refused(formatted("found room for {} samples, wanted {} at most: so many are ready", out.size(), ready));
  for (const auto& span :
       {out.angular_velocities, out.angular_accelerations, out.positions, out.velocities, out.accelerations})
    if (!span.empty() && span.size() != 3 * out.size())
      return refused(
          formatted("found room for {} numbers, wanted {} for {} samples", span.size(), 3 * out.size(), out.size()));
  if (!times.empty() && times.size() != out.size())
    return refused(formatted("found room for {} times, wanted {}", times.size(), out.size()));
  return std::nullopt;
}

/// Samples `first` and as many more as there is room for.
Expected<void> sample_block(const PoseCurve& curve, const TrackClock& clock, std::uint64_t first,
                            const Samples<double>& out, std::span<double> times) {
  std::array<double, block> own;
  for (std::size_t from = 0; from < out.size(); from += block) {
    const std::size_t count = std::min(block, out.size() - from);
    const auto here = times.empty() ? std::span(own).first(count) : times.subspan(from, count);
    for (std::size_t k = 0; k < count; ++k) here[k] = clock(first + from + k);
    if (auto sampled = sample<double>(curve, here, part_of(out, from, count)); !sampled) return sampled;
  }
  return {};
}

}  // namespace

Expected<TrackSampler> TrackSampler::make(const Method& method, const TrackGrid& grid, const TrackOptions& options) {
  if (!(grid.step > 0.0) || !std::isfinite(grid.step) || !std::isfinite(grid.start.value_or(0.0)))
    return failure(ErrorCode::bad_argument, formatted("the grid starts at {} s with the step {} s, wanted finite "
                                                      "numbers and a step greater than 0",
                                                      grid.start.value_or(0.0), grid.step));
  if (options.gap && !(*options.gap > 0.0))
    return failure(ErrorCode::bad_argument, formatted("the gap is {} s, wanted more than 0", *options.gap));
  return StreamMethod::make(method.name, method.options).map([&](StreamMethod made) {
    return TrackSampler(method, std::move(made), grid, options);
  });
}

Expected<void> TrackSampler::append(const StreamKey& key) {
  if (finished_) return failure(ErrorCode::bad_argument, "the track is finished, wanted no more keys");
  if (const auto checked = checked_orientation(keys_, key, newest_, parts_); !checked)
    return tl::unexpected(checked.error());
  if (auto error = method_.check_settings(keys_, key)) return tl::unexpected(std::move(*error));
  const bool begins = !newest_ || (options_.gap && key.time - *newest_ > *options_.gap);
  if (begins && !stretches_.empty() && !stretches_.back().is_finished())
    if (auto ended = stretches_.back().finish(method_); !ended) return ended;
  if (begins) stretches_.emplace_back(keys_);
  stretches_.back().push(key, method_, options_.signs);
  if (keys_ == 0) parts_ = parts_of(key);
  ++keys_;
  newest_ = key.time;
  if (!grid_.start) grid_.start = stretches_.front().start();
  forget();
  return {};
}

Expected<void> TrackSampler::append(const KeyframeData& keys,
                                    const std::map<std::string, std::vector<double>, std::less<>>& settings) {
  const std::size_t count = keys.times.size();
  const auto fits = [count](const auto& list) { return list.empty() || list.size() == count; };
  const bool settings_fit =
      std::ranges::all_of(settings, [count](const auto& setting) { return setting.second.size() == count; });
  if (keys.orientations.size() != count || !fits(keys.positions) || !fits(keys.angular_velocities) ||
      !fits(keys.angular_accelerations) || !fits(keys.angular_jerks) || !settings_fit)
    return failure(ErrorCode::bad_data,
                   formatted("found lists of different length, wanted {} entries, one per key", count));
  const auto at = [](const std::vector<Eigen::Vector3d>& list, std::size_t i) {
    return list.empty() ? std::nullopt : std::optional(list[i]);
  };
  for (std::size_t i = 0; i < count; ++i) {
    StreamKey key{.time = keys.times[i],
                  .orientation = keys.orientations[i],
                  .position = at(keys.positions, i),
                  .angular_velocity = at(keys.angular_velocities, i),
                  .angular_acceleration = at(keys.angular_accelerations, i),
                  .angular_jerk = at(keys.angular_jerks, i)};
    for (const auto& [name, values] : settings) key.settings.emplace(name, values[i]);
    if (auto taken = append(key); !taken) return taken;
  }
  return {};
}

Expected<void> TrackSampler::finish() {
  if (keys_ == 0) return failure(ErrorCode::bad_data, "empty: no keys");
  if (finished_) return {};
  if (auto ended = stretches_.back().finish(method_); !ended) return ended;
  if (!grid_.start) grid_.start = stretches_.front().start();
  finished_ = true;
  return {};
}

std::optional<TrackClock> TrackSampler::clock() const noexcept {
  return grid_.start ? std::optional(TrackClock(*grid_.start, grid_.step)) : std::nullopt;
}

std::vector<TrackSampler::Part> TrackSampler::parts_ready() {
  std::vector<Part> parts;
  const auto times = clock();
  std::uint64_t next = next_;
  for (auto stretch = stretches_.begin(); times && stretch != stretches_.end(); ++stretch) {
    SampleRange samples = stretch->final_samples(method_, *times);
    samples.first = std::max(samples.first, next);
    if (samples.size() > 0) parts.push_back({&*stretch, samples});
    next = std::max(next, samples.end);
  }
  return parts;
}

std::uint64_t TrackSampler::ready() const noexcept {
  const auto times = clock();
  std::uint64_t next = next_, count = 0;
  for (auto stretch = stretches_.begin(); times && stretch != stretches_.end(); ++stretch) {
    SampleRange samples = stretch->final_samples(method_, *times);
    samples.first = std::max(samples.first, next);
    count += samples.size();
    next = std::max(next, samples.end);
  }
  return count;
}

Expected<void> TrackSampler::prepare() {
  for (const Part& part : parts_ready())
    if (const auto curve = part.stretch->curve_from(part.samples.first, method_, *clock()); !curve)
      return tl::unexpected(curve.error());
  return {};
}

Expected<void> TrackSampler::take(const Samples<double>& out, std::span<double> times) {
  if (auto error = check_room(out, times, ready())) return tl::unexpected(std::move(*error));
  std::size_t taken = 0;
  std::uint64_t next = next_;
  for (const auto& [stretch, samples] : parts_ready()) {
    const std::size_t count = static_cast<std::size_t>(std::min<std::uint64_t>(samples.size(), out.size() - taken));
    if (count == 0) break;
    const auto curve = stretch->curve_from(samples.first, method_, *clock());
    if (!curve) return tl::unexpected(curve.error());
    if (auto sampled =
            sample_block(**curve, *clock(), samples.first, part_of(out, taken, count), part_of(times, 1, taken, count));
        !sampled)
      return sampled;
    taken += count;
    next = samples.first + count;
  }
  next_ = next;
  forget();
  return {};
}

/// Drops what no coming sample depends on: whole stretches, and keys of the one in which the next sample lies.
void TrackSampler::forget() {
  const auto times = clock();
  if (!times) return;
  while (!stretches_.empty() && stretches_.front().is_finished()) {
    const SampleRange samples = stretches_.front().final_samples(method_, *times);
    if (std::max(samples.first, next_) < samples.end) break;
    stretches_.pop_front();
  }
  if (stretches_.empty() || !stretches_.front().start()) return;
  const std::uint64_t next = std::max(next_, times->first_from(*stretches_.front().start()));
  stretches_.front().forget_before(next, method_, *times);
}

Expected<void> TrackSampler::check_order() const {
  const auto refused = [] { return failure(ErrorCode::bad_data, "their stretches do not follow each other"); };
  if (keys_ == 0 ? newest_ || !stretches_.empty() : !newest_ || (!finished_ && stretches_.empty())) return refused();
  std::uint64_t keys = stretches_.empty() ? keys_ : stretches_.front().first_key();
  double before = -std::numeric_limits<double>::infinity();
  for (const TrackStretch& stretch : stretches_) {
    const bool is_last = &stretch == &stretches_.back();
    const auto times = stretch.keys().times();
    const KeyParts parts = stretch.keys().parts();
    if (stretch.is_finished() != (finished_ || !is_last) || stretch.first_key() != keys || !(before < times.front()) ||
        parts != parts_)
      return refused();
    keys += stretch.keys().count();
    before = times.back();
  }
  const bool ends_at_newest = stretches_.empty() || before == newest_;
  const bool has_start = stretches_.empty() || grid_.start || !stretches_.front().start();
  return keys == keys_ && ends_at_newest && has_start ? Expected<void>() : refused();
}

std::size_t TrackSampler::kept() const noexcept {
  std::size_t count = 0;
  for (const TrackStretch& stretch : stretches_) count += stretch.keys().kept();
  return count;
}

std::vector<std::byte> TrackSampler::state() const { return TrackState::bytes_of(*this); }

Expected<TrackSampler> TrackSampler::from_state(std::span<const std::byte> bytes) {
  return TrackState::sampler_from(bytes);
}

}  // namespace orispline
