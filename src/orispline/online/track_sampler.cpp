// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/track_sampler.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/batch/sample_layout.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/online/stream_parts.hpp>
#include <orispline/online/track_state.hpp>
#include <orispline/online/track_stretch.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Samples that one thread takes at a time.
constexpr std::size_t samples_of_a_block = 4096;

/// The samples of the span that begin at one; empty stays empty.
std::span<double> part_of(const Samples<double>& out, std::span<double> all, std::size_t components, std::size_t from,
                          std::size_t count) {
  if (all.empty()) return all;
  if (out.layout == Layout::interleaved) return all.subspan(components * from, components * count);
  return all.subspan(from, (components - 1) * (out.plane == 0 ? out.size() : out.plane) + count);
}

Samples<double> part_of(const Samples<double>& out, std::size_t from, std::size_t count) {
  const auto part = [&](std::span<double> all, std::size_t components) {
    return part_of(out, all, components, from, count);
  };
  const bool is_planar = out.layout == Layout::planar;
  return {.orientations = part(out.orientations, 4),
          .angular_velocities = part(out.angular_velocities, 3),
          .angular_accelerations = part(out.angular_accelerations, 3),
          .angular_jerks = part(out.angular_jerks, 3),
          .positions = part(out.positions, 3),
          .velocities = part(out.velocities, 3),
          .accelerations = part(out.accelerations, 3),
          .linear_jerks = part(out.linear_jerks, 3),
          .layout = out.layout,
          .plane = is_planar && out.plane == 0 ? out.size() : out.plane};
}

std::optional<Error> check_taken(const Samples<double>& out, std::span<const double> times, std::uint64_t ready) {
  const auto refused = [](std::string message) { return Error{ErrorCode::bad_argument, std::move(message), {}}; };
  if (out.size() > ready)
    return refused(formatted("found room for {} samples, wanted {} at most: so many are ready", out.size(), ready));
  if (!times.empty() && times.size() != out.size())
    return refused(formatted("found room for {} times, wanted {}", times.size(), out.size()));
  return batch::check_room(out, out.size());
}

/// Samples `first` and as many more as there is room for.
Expected<void> sample_part(const PoseCurve& curve, const SampleGrid& grid, std::uint64_t first,
                           const Samples<double>& out, std::span<double> times, Work work) {
  const std::size_t blocks = (out.size() + samples_of_a_block - 1) / samples_of_a_block;
  std::vector<Expected<void>> outcomes(blocks);
  parallel_for(blocks, work.threads, [&](std::size_t i) {
    const std::size_t from = i * samples_of_a_block, count = std::min(samples_of_a_block, out.size() - from);
    std::array<double, samples_of_a_block> own;
    const auto here = times.empty() ? std::span(own).first(count) : times.subspan(from, count);
    grid.fill(first + from, here);
    outcomes[i] = sample_at<double>(curve, here, part_of(out, from, count));
  });
  for (Expected<void>& outcome : outcomes)
    if (!outcome) return std::move(outcome);
  return {};
}

}  // namespace

TrackSampler::TrackSampler(const Method& given, StreamMethod method, const TrackGrid& grid, const TrackOptions& options)
    : given_(given), method_(std::move(method)), grid_(grid), options_(options) {}
TrackSampler::TrackSampler(const TrackSampler& other) = default;
TrackSampler::TrackSampler(TrackSampler&& other) noexcept = default;
TrackSampler& TrackSampler::operator=(const TrackSampler& other) = default;
TrackSampler& TrackSampler::operator=(TrackSampler&& other) noexcept = default;
TrackSampler::~TrackSampler() = default;

Expected<TrackSampler> TrackSampler::make(const Method& method, const TrackGrid& grid, const TrackOptions& options) {
  const double step = grid.step / grid.parts;
  if (!(step > 0.0) || !std::isfinite(step) || !(grid.step > 0.0) || !std::isfinite(grid.start.value_or(0.0)))
    return failure(ErrorCode::bad_argument, formatted("the grid starts at {} s with the step {} s, wanted finite "
                                                      "numbers and a step greater than 0",
                                                      grid.start.value_or(0.0), step));
  const auto* const rate = grid.request ? std::get_if<SampleGrid::Rate>(&grid.request->spacing) : nullptr;
  if (rate && !(rate->hertz > 0.0 && rate->seconds > 0.0 && rate->per_second() > 0.0 &&
                std::isfinite(rate->per_second()) && std::isfinite(rate->seconds)))
    return failure(ErrorCode::bad_argument, formatted("the rate is {} Hz, wanted more than 0", rate->per_second()));
  if (options.gap && !(*options.gap > 0.0))
    return failure(ErrorCode::bad_argument, formatted("the gap is {} s, wanted more than 0", *options.gap));
  return StreamMethod::make(method).map(
      [&](StreamMethod made) { return TrackSampler(method, std::move(made), grid, options); });
}

Expected<void> TrackSampler::append(StreamKey key) {
  return push(std::move(key)).map([this] { forget(); });
}

/// Takes the next key and forgets none.
Expected<void> TrackSampler::push(StreamKey key) {
  if (finished_) return failure(ErrorCode::bad_argument, "the track is finished, wanted no more keys");
  const bool begins = !newest_ || (options_.gap && key.time - *newest_ > *options_.gap);
  const auto before = !newest_ ? std::span<const double>()
                      : begins ? std::span(&*newest_, 1)
                               : stretches_.back().keys().times();
  const auto unit = checked_orientation(keys_, key, before, parts_);
  if (!unit) return tl::unexpected(unit.error());
  if (auto error = method_.check_settings(keys_, key)) return tl::unexpected(std::move(*error));
  if (begins && !stretches_.empty() && !stretches_.back().is_finished())
    if (auto ended = stretches_.back().finish(method_); !ended) return ended;
  const auto turned_from = begins ? std::nullopt : std::optional(unit_orientation(stretches_.back().keys().newest()));
  alignment_.next(*unit, checked_norm(0, key.orientation).value(), options_.signs,
                  turned_from ? &*turned_from : nullptr);
  if (alignment_.negated) key.orientation.coeffs() = -key.orientation.coeffs();
  if (begins) stretches_.emplace_back(keys_);
  if (keys_ == 0) parts_ = parts_of(key);
  ++keys_;
  newest_ = key.time;
  stretches_.back().push(key, method_);
  return place_grid();
}

Expected<void> TrackSampler::append(const KeyframeData& keys,
                                    const std::map<std::string, std::vector<double>, std::less<>>& settings) {
  const std::size_t count = keys.times.size();
  const auto fits = [count](const auto& list) { return list.empty() || list.size() == count; };
  const bool settings_fit =
      std::ranges::all_of(settings, [count](const auto& setting) { return setting.second.size() == count; });
  bool parts_fit = true;
  for_each_part([&](const auto& part) { parts_fit &= fits(keys.*part.list); });
  if (keys.orientations.size() != count || !parts_fit || !settings_fit)
    return failure(ErrorCode::bad_data,
                   formatted("found lists of different length, wanted {} entries, one per key", count));
  for (std::size_t i = 0; i < count; ++i) {
    StreamKey key{.time = keys.times[i], .orientation = keys.orientations[i]};
    for_each_stream_part([&](const auto& part) {
      if (const auto& list = keys.*part.of_keys.list; !list.empty()) key.*part.value = list[i];
    });
    for (const auto& [name, values] : settings) key.settings.emplace(name, values[i]);
    if (auto taken = push(std::move(key)); !taken) return taken;
  }
  forget();
  return {};
}

double TrackSampler::samples_until(double time) const noexcept {
  const double step = newest_ ? time - *newest_ : 0.0;
  if (!(step > 0.0) || !std::isfinite(step) || (options_.gap && step > *options_.gap)) return 0.0;
  if (!grid_.request) return step / grid_.step * grid_.parts;
  const auto* const rate = std::get_if<SampleGrid::Rate>(&grid_.request->spacing);
  return rate ? step * rate->per_second() : 0.0;
}

/// The grid, as far as the keys say where it starts and ends.
Expected<void> TrackSampler::place_grid() {
  if (!start_ && !stretches_.empty()) start_ = stretches_.front().start();
  const auto start = grid_.start ? grid_.start : start_;
  if (!grid_.request) {
    if (!times_ && start) times_.emplace(*start, SampleGrid::Step{grid_.step, grid_.parts});
    return {};
  }
  if (!start_ || (times_ && !end_)) return {};
  auto times = SampleGrid::make(*grid_.request, *start_, end_);
  if (!times) return tl::unexpected(std::move(times.error()));
  times_ = *times;
  return {};
}

Expected<void> TrackSampler::finish() {
  if (keys_ == 0) return failure(ErrorCode::bad_data, "empty: no keys");
  if (finished_) return {};
  if (auto ended = stretches_.back().finish(method_); !ended) return ended;
  end_ = stretches_.back().end(method_);
  if (auto placed = place_grid(); !placed) return placed;
  finished_ = true;
  return {};
}

/// The samples of a stretch that are final, from that one on.
SampleRange TrackSampler::final_samples(const TrackStretch& stretch, std::uint64_t next) const {
  if (!times_) return {};
  SampleRange samples = stretch.final_samples(method_, *times_);
  if (finished_ && times_->is_range() && &stretch == &stretches_.back()) samples.end = *times_->size();
  samples.first = std::max(samples.first, next);
  return samples;
}

std::vector<TrackSampler::Part> TrackSampler::parts_ready() {
  std::vector<Part> parts;
  std::uint64_t next = next_;
  for (TrackStretch& stretch : stretches_) {
    const SampleRange samples = final_samples(stretch, next);
    if (samples.size() > 0) parts.push_back({&stretch, samples});
    next = std::max(next, samples.end);
  }
  return parts;
}

std::uint64_t TrackSampler::ready() const noexcept {
  std::uint64_t next = next_, count = 0;
  for (const TrackStretch& stretch : stretches_) {
    const SampleRange samples = final_samples(stretch, next);
    count += samples.size();
    next = std::max(next, samples.end);
  }
  return count;
}

Expected<void> TrackSampler::prepare() {
  for (const Part& part : parts_ready())
    if (const auto curve = part.stretch->curve_from(part.samples.first, method_, *times_); !curve)
      return tl::unexpected(curve.error());
  return {};
}

Expected<void> TrackSampler::take(const Samples<double>& out, std::span<double> times, Work work) {
  if (auto error = check_taken(out, times, ready())) return tl::unexpected(std::move(*error));
  std::size_t taken = 0;
  std::uint64_t next = next_;
  for (const auto& [stretch, samples] : parts_ready()) {
    const std::size_t count = static_cast<std::size_t>(std::min<std::uint64_t>(samples.size(), out.size() - taken));
    if (count == 0) break;
    const auto curve = stretch->curve_from(samples.first, method_, *times_);
    if (!curve) return tl::unexpected(curve.error());
    const auto times_here = times.empty() ? times : times.subspan(taken, count);
    if (auto sampled = sample_part(**curve, *times_, samples.first, part_of(out, taken, count), times_here, work);
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
  if (!times_) return;
  while (!stretches_.empty() && stretches_.front().is_finished() &&
         final_samples(stretches_.front(), next_).size() == 0)
    stretches_.pop_front();
  if (stretches_.empty() || !stretches_.front().start()) return;
  const std::uint64_t next = std::max(next_, stretches_.front().first_sample(*times_));
  stretches_.front().forget_before(next, method_, *times_);
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
  const bool has_start = stretches_.empty() || start_ || !stretches_.front().start();
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

}}  // namespace orispline
