// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/sample_tracks.hpp>

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include <orispline/base/counted_work.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

/// Of a track.
constexpr std::size_t samples_at_a_time = 1024, samples_of_threads = 65536, keys_at_a_time = 4096;

Error bad_columns(std::string message) { return {ErrorCode::bad_argument, std::move(message), {}}; }

std::optional<Error> check_keys(const TrackColumns& keys) {
  const std::size_t size = keys.times.size();
  const bool has_positions = !keys.positions[0].empty();
  for (const auto& column : keys.orientations)
    if (column.size() != size)
      return bad_columns(formatted("found {} orientations for {} times, wanted as many", column.size(), size));
  for (const auto& column : keys.positions)
    if (column.size() != (has_positions ? size : 0))
      return bad_columns(formatted("found {} positions for {} times, wanted as many or none", column.size(), size));
  if (keys.offsets.empty() || keys.offsets.front() < 0 || !std::ranges::is_sorted(keys.offsets) ||
      static_cast<std::uint64_t>(keys.offsets.back()) > size)
    return bad_columns(formatted("the offsets do not rise from 0 on to {}, the number of keys, at most", size));
  return std::nullopt;
}

/// All keys of a track, and the curves through them.
Expected<void> feed(TrackSampler& sampler, const TrackColumns& keys, std::size_t first, std::size_t end,
                    const Progress& progress) {
  const auto& [x, y, z, w] = keys.orientations;
  for (std::size_t i = first; i < end; ++i) {
    if (i % keys_at_a_time == 0 && progress.stopped()) return cancellation();
    StreamKey key{.time = keys.times[i], .orientation = quaternion_xyzw(x[i], y[i], z[i], w[i])};
    if (!keys.positions[0].empty())
      key.position = Eigen::Vector3d(keys.positions[0][i], keys.positions[1][i], keys.positions[2][i]);
    if (auto taken = append_checked(sampler, std::move(key)); !taken) return taken;
  }
  return sampler.finish().and_then([&] { return sampler.prepare(); });
}

std::optional<Error> check_columns(const TrackSampleColumns& out, std::size_t left, bool has_positions) {
  const std::size_t size = out.orientations[0].size();
  if (size > left) return bad_columns(formatted("found columns for {} samples, wanted {} at most", size, left));
  if (!has_positions && !(out.positions[0].empty() && out.velocities[0].empty() && out.accelerations[0].empty()))
    return bad_columns("positions are wanted, and the keys have none");
  const auto check = [size](const auto& columns, bool is_wanted) -> std::optional<Error> {
    for (const std::span<double>& column : columns)
      if (column.size() != (is_wanted ? size : 0))
        return bad_columns(formatted("found a column for {} samples, wanted one for {}", column.size(), size));
    return std::nullopt;
  };
  std::optional<Error> error = check(out.orientations, true);
  if (!error) error = check(std::array{out.times}, !out.times.empty());
  for (const auto* columns : {&out.angular_velocities, &out.angular_accelerations, &out.angular_jerks, &out.positions,
                              &out.velocities, &out.accelerations})
    if (!error) error = check(*columns, !(*columns)[0].empty());
  return error;
}

/// Samples of a track, interleaved, on their way to the columns.
class Rows {
 public:
  explicit Rows(const TrackSampleColumns& out) : out_(out) {}

  /// Takes so many samples and puts them into the columns from `first` on.
  [[nodiscard]] Expected<void> take(TrackSampler& sampler, std::size_t first, std::size_t count, Work work) {
    const auto room = [count](std::vector<double>& rows, const auto& columns) {
      rows.resize(columns[0].empty() ? 0 : columns.size() * count);
      return std::span(rows);
    };
    const Samples<double> rows{.orientations = room(orientations_, out_.orientations),
                               .angular_velocities = room(angular_velocities_, out_.angular_velocities),
                               .angular_accelerations = room(angular_accelerations_, out_.angular_accelerations),
                               .angular_jerks = room(angular_jerks_, out_.angular_jerks),
                               .positions = room(positions_, out_.positions),
                               .velocities = room(velocities_, out_.velocities),
                               .accelerations = room(accelerations_, out_.accelerations)};
    const auto times = out_.times.empty() ? out_.times : out_.times.subspan(first, count);
    return sampler.take(rows, times, work).map([&] {
      lay_out(orientations_, out_.orientations, first);
      lay_out(angular_velocities_, out_.angular_velocities, first);
      lay_out(angular_accelerations_, out_.angular_accelerations, first);
      lay_out(angular_jerks_, out_.angular_jerks, first);
      lay_out(positions_, out_.positions, first);
      lay_out(velocities_, out_.velocities, first);
      lay_out(accelerations_, out_.accelerations, first);
    });
  }

 private:
  template <std::size_t N>
  static void lay_out(const std::vector<double>& rows, const std::array<std::span<double>, N>& columns,
                      std::size_t first) noexcept {
    for (std::size_t i = 0; i < rows.size(); ++i) columns[i % N][first + i / N] = rows[i];
  }

  const TrackSampleColumns& out_;
  std::vector<double> orientations_, angular_velocities_, angular_accelerations_, angular_jerks_;
  std::vector<double> positions_, velocities_, accelerations_;
};

/// Takes the next samples of a track into the columns from `first` to before `end`.
Expected<void> take_into(const TrackSampleColumns& out, std::size_t first, std::size_t end, TrackSampler& sampler,
                         Work work, const Progress& progress) {
  Rows rows(out);
  Expected<void> outcome;
  const std::size_t at_a_time = work.threads == 1 ? samples_at_a_time : samples_of_threads;
  for (; first < end && outcome && !progress.stopped(); first += at_a_time)
    outcome = rows.take(sampler, first, std::min(at_a_time, end - first), work);
  return outcome;
}

template <std::size_t N>
std::array<std::span<double>, N> made(std::array<std::vector<double>, N>& columns, bool wanted, std::size_t size) {
  std::array<std::span<double>, N> spans;
  for (std::size_t i = 0; i < N; ++i) {
    columns[i].resize(wanted ? size : 0);
    spans[i] = columns[i];
  }
  return spans;
}

/// Works on every track, until it is asked to stop.
Expected<void> for_each_track(std::size_t tracks, Work work, const Progress& progress,
                              const std::function<void(std::size_t)>& job) {
  CountedWork done(progress, tracks);
  parallel_for(tracks, work.threads, [&](std::size_t i) {
    if (progress.stopped()) return;
    job(i);
    done.add_part();
  });
  if (progress.stopped()) return cancellation();
  return {};
}

/// Of the first half of the work, or of the second one.
Progress half_of(const Progress& progress, double start) {
  return {.stop = progress.stop, .show = [&progress, start](double share) { progress.at(start + 0.5 * share); }};
}

}  // namespace

Expected<void> append_checked(TrackSampler& sampler, StreamKey key) {
  const double wanted = sampler.samples_until(key.time);
  if (wanted <= most_samples_between_keys) return sampler.append(std::move(key));
  return failure(
      ErrorCode::bad_data,
      formatted("found a request for {:.4g} samples since the key before, wanted {:g} at most: check the rate "
                "and the unit of the times, or set `gap`",
                wanted, most_samples_between_keys),
      {.key = static_cast<std::size_t>(sampler.keys())});
}

Expected<TrackBatch> TrackBatch::make(const Method& method, const TrackColumns& keys, const TrackGrid& grid,
                                      const TrackOptions& options, Work work, const Progress& progress) {
  if (auto error = check_keys(keys)) return tl::unexpected(std::move(*error));
  const auto empty = TrackSampler::make(method, grid, options);
  if (!empty) return tl::unexpected(empty.error());
  const std::size_t tracks = keys.offsets.size() - 1;
  TrackBatch batch;
  batch.samplers_.assign(tracks, *empty);
  batch.has_positions_ = !keys.positions[0].empty() || keys.times.empty();
  std::vector<std::optional<Error>> errors(tracks);
  const auto done = for_each_track(tracks, work, progress, [&](std::size_t i) {
    const auto fed = feed(batch.samplers_[i], keys, static_cast<std::size_t>(keys.offsets[i]),
                          static_cast<std::size_t>(keys.offsets[i + 1]), progress);
    if (!fed) errors[i] = fed.error();
  });
  if (!done) return tl::unexpected(done.error());
  for (std::size_t i = 0; i < tracks; ++i) {
    const auto count = errors[i] ? 0 : static_cast<std::int64_t>(batch.samplers_[i].ready());
    batch.offsets_.push_back(batch.offsets_.back() + count);
    if (!errors[i]) continue;
    batch.errors_.push_back(*errors[i]);
    batch.errors_.back().where.curve = i;
  }
  return batch;
}

Expected<void> TrackBatch::take(const TrackSampleColumns& out, Work work, const Progress& progress) {
  if (auto error = check_columns(out, left(), has_positions_)) return tl::unexpected(std::move(*error));
  const std::size_t begin = std::exchange(taken_, taken_ + out.orientations[0].size());
  const auto track_of = [this](std::size_t sample) {  // the one in which it lies
    return static_cast<std::size_t>(std::ranges::upper_bound(offsets_, static_cast<std::int64_t>(sample)) -
                                    offsets_.begin()) -
           1;
  };
  if (begin == taken_) return {};
  const std::size_t first_track = track_of(begin), tracks = track_of(taken_ - 1) + 1 - first_track;
  std::vector<Expected<void>> outcomes(tracks);
  auto done = for_each_track(tracks, work, progress, [&](std::size_t i) {
    const std::size_t track = first_track + i;
    const std::size_t first = std::max(static_cast<std::size_t>(offsets_[track]), begin);
    const std::size_t end = std::min(static_cast<std::size_t>(offsets_[track + 1]), taken_);
    outcomes[i] = take_into(out, first - begin, end - begin, samplers_[track], tracks == 1 ? work : Work{}, progress);
  });
  if (!done) return done;
  for (Expected<void>& outcome : outcomes)
    if (!outcome) return std::move(outcome);
  return {};
}

Expected<void> take_columns(TrackSampler& sampler, const TrackSampleColumns& out, Work work, const Progress& progress) {
  const std::size_t count = out.orientations[0].size();
  if (auto error = check_columns(out, static_cast<std::size_t>(sampler.ready()), true))
    return tl::unexpected(std::move(*error));
  if (auto taken = take_into(out, 0, count, sampler, work, progress); !taken) return taken;
  if (progress.stopped()) return cancellation();
  return {};
}

Expected<SampledTracks> sample_tracks(const Method& method, const TrackColumns& keys, const TrackGrid& grid,
                                      const WantedSamples& wanted, const TrackOptions& options, Work work,
                                      const Progress& progress) {
  auto made_ready = TrackBatch::make(method, keys, grid, options, work, half_of(progress, 0.0));
  return std::move(made_ready).and_then([&](TrackBatch batch) -> Expected<SampledTracks> {
    if (keys.positions[0].empty() && !keys.times.empty() &&
        (wanted.positions || wanted.velocities || wanted.accelerations))
      return tl::unexpected(bad_columns("positions are wanted, and the keys have none"));
    const std::size_t size = batch.size();
    SampledTracks table;
    table.offsets.assign(batch.offsets().begin(), batch.offsets().end());
    table.times.resize(size);
    table.errors.assign(batch.errors().begin(), batch.errors().end());
    const TrackSampleColumns columns{
        .times = table.times,
        .orientations = made(table.orientations, true, size),
        .angular_velocities = made(table.angular_velocities, wanted.angular_velocities, size),
        .angular_accelerations = made(table.angular_accelerations, wanted.angular_accelerations, size),
        .angular_jerks = made(table.angular_jerks, wanted.angular_jerks, size),
        .positions = made(table.positions, wanted.positions, size),
        .velocities = made(table.velocities, wanted.velocities, size),
        .accelerations = made(table.accelerations, wanted.accelerations, size)};
    return batch.take(columns, work, half_of(progress, 0.5)).map([&] { return std::move(table); });
  });
}

}}  // namespace orispline
