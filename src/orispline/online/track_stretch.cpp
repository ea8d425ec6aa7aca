// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/track_stretch.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI {

void TrackStretch::push(const StreamKey& key, const StreamMethod& method) {
  keys_.push(key);
  if (keys_.count() == method.first_key + 1) start_ = key.time;
  curve_.reset();
}

Expected<void> TrackStretch::finish(const StreamMethod& method) {
  const auto count = static_cast<std::size_t>(keys_.count());
  if (auto error = method.check_count(count)) return tl::unexpected(std::move(*error));
  if (count == 1) start_ = keys_.time(0);
  stream_ = Stream::finished;
  curve_.reset();
  return {};
}

std::optional<std::uint64_t> TrackStretch::last_joint(const StreamMethod& method) const noexcept {
  const KeyUse& use = method.family->key_use;
  const std::uint64_t count = keys_.count();
  if (is_finished()) return count == 1 ? 0 : count - 1 - method.first_key;
  if (!method.keys_beside || count < std::max<std::uint64_t>(method.keys_at_start, use.keys_for(1)))
    return std::nullopt;
  return method.first_key + (count - 1 - method.first_key - *method.keys_beside) / use.stride * use.stride;
}

std::uint64_t TrackStretch::first_sample(const SampleGrid& grid) const {
  return grid.is_range() && first_key_ == 0 ? 0 : grid.first_from(*start_);
}

SampleRange TrackStretch::final_samples(const StreamMethod& method, const SampleGrid& grid) const {
  const auto joint = last_joint(method);
  if (!start_ || !joint) return {};
  const double end = keys_.time(*joint);
  return {first_sample(grid),
          is_finished() ? grid.first_after(end) : std::min(grid.first_from(end), grid.settled_until(end))};
}

std::uint64_t TrackStretch::joint_before(double t, const StreamMethod& method) const noexcept {
  const KeyUse& use = method.family->key_use;
  const auto times = keys_.times();
  const auto passed = static_cast<std::uint64_t>(std::ranges::upper_bound(times, t) - times.begin());
  const std::uint64_t key = keys_.first() + passed - std::min<std::uint64_t>(passed, 1);
  const std::uint64_t last = last_joint(method).value_or(method.first_key);
  const std::uint64_t last_start = is_finished() ? last - std::min<std::uint64_t>(last, use.stride) : last;
  const std::uint64_t segments = key > method.first_key ? (key - method.first_key) / use.stride : 0;
  return std::min(method.first_key + segments * use.stride, last_start);
}

void TrackStretch::forget_before(std::uint64_t sample, const StreamMethod& method, const SampleGrid& grid) {
  const std::uint64_t key = keys_.needed_from(joint_before(grid.time(sample), method), method);
  if (last_joint(method)) keys_.forget_before(key);
}

Expected<const PoseCurve*> TrackStretch::curve_from(std::uint64_t sample, const StreamMethod& method,
                                                    const SampleGrid& grid) {
  if (!curve_) {
    const std::uint64_t key = keys_.needed_from(joint_before(grid.time(sample), method), method);
    auto made = keys_.curve_from(std::max(key, keys_.first()), method, stream_);
    if (!made) {
      Error error = std::move(made.error());
      if (error.where.key) *error.where.key += static_cast<std::size_t>(first_key_);
      return tl::unexpected(std::move(error));
    }
    curve_ = std::move(*made);
  }
  return &*curve_;
}

Expected<TrackStretch> TrackStretch::from_kept(StreamKeys keys, Stream stream, std::uint64_t first_key,
                                               std::optional<double> start, std::uint64_t sample,
                                               const StreamMethod& method, const std::optional<SampleGrid>& grid) {
  TrackStretch stretch(first_key);
  stretch.keys_ = std::move(keys);
  stretch.start_ = start;
  const auto refused = [] { return failure(ErrorCode::bad_data, "a state lacks keys on which its samples depend"); };
  const auto count = static_cast<std::size_t>(stretch.keys_.count());
  if (start.has_value() != (count > method.first_key || stream == Stream::finished)) return refused();
  if (stream == Stream::finished && method.check_count(count)) return refused();
  stretch.stream_ = stream;
  std::uint64_t needed = 0;
  if (start && grid && stretch.last_joint(method)) {
    const std::uint64_t next = std::max(sample, stretch.first_sample(*grid));
    needed = stretch.keys_.needed_from(stretch.joint_before(grid->time(next), method), method);
  }
  if (stretch.keys_.first() > needed) return refused();
  return stretch;
}

}}  // namespace orispline
