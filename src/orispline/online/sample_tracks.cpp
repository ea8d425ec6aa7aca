// SPDX-License-Identifier: Apache-2.0
#include <orispline/online/sample_tracks.hpp>

#include <algorithm>
#include <optional>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>

namespace orispline {
namespace {

std::optional<Error> check_columns(const TrackColumns& keys, const WantedSamples& wanted) {
  const auto refused = [](std::string message) { return Error{ErrorCode::bad_argument, std::move(message), {}}; };
  const std::size_t size = keys.times.size();
  const bool has_positions = !keys.positions[0].empty();
  for (const auto& column : keys.orientations)
    if (column.size() != size)
      return refused(formatted("found {} orientations for {} times, wanted as many", column.size(), size));
  for (const auto& column : keys.positions)
    if (column.size() != (has_positions ? size : 0))
      return refused(formatted("found {} positions for {} times, wanted as many or none", column.size(), size));
  if (keys.offsets.empty() || keys.offsets.front() < 0 || !std::ranges::is_sorted(keys.offsets) ||
      static_cast<std::uint64_t>(keys.offsets.back()) > size)
    return refused(formatted("the offsets do not rise from 0 on to {}, the number of keys, at most", size));
  if (!has_positions && size > 0 && (wanted.positions || wanted.velocities || wanted.accelerations))
    return refused("positions are wanted, and the keys have none");
  return std::nullopt;
}

/// All keys of a track, and the curves through them.
Expected<void> feed(TrackSampler& sampler, const TrackColumns& keys, std::size_t first, std::size_t end) {
  const auto& [x, y, z, w] = keys.orientations;
  for (std::size_t i = first; i < end; ++i) {
    StreamKey key{.time = keys.times[i], .orientation = quaternion_xyzw(x[i], y[i], z[i], w[i])};
    if (!keys.positions[0].empty())
      key.position = Eigen::Vector3d(keys.positions[0][i], keys.positions[1][i], keys.positions[2][i]);
    if (auto taken = sampler.append(key); !taken) return taken;
  }
  return sampler.finish().and_then([&] { return sampler.prepare(); });
}

template <std::size_t N>
void resize(std::array<std::vector<double>, N>& columns, bool wanted, std::size_t size) {
  for (auto& column : columns) column.resize(wanted ? size : 0);
}

/// The samples of a track, interleaved, on their way to the columns.
class Rows {
 public:
  Rows(std::size_t count, const WantedSamples& wanted)
      : orientations_(4 * count),
        angular_velocities_(wanted.angular_velocities ? 3 * count : 0),
        angular_accelerations_(wanted.angular_accelerations ? 3 * count : 0),
        positions_(wanted.positions ? 3 * count : 0),
        velocities_(wanted.velocities ? 3 * count : 0),
        accelerations_(wanted.accelerations ? 3 * count : 0) {}

  [[nodiscard]] Samples<double> spans() noexcept {
    return {.orientations = orientations_,
            .angular_velocities = angular_velocities_,
            .angular_accelerations = angular_accelerations_,
            .positions = positions_,
            .velocities = velocities_,
            .accelerations = accelerations_};
  }
  void lay_out(SampledTracks& out, std::size_t first) const noexcept {
    lay_out(orientations_, out.orientations, first);
    lay_out(angular_velocities_, out.angular_velocities, first);
    lay_out(angular_accelerations_, out.angular_accelerations, first);
    lay_out(positions_, out.positions, first);
    lay_out(velocities_, out.velocities, first);
    lay_out(accelerations_, out.accelerations, first);
  }

 private:
  template <std::size_t N>
  static void lay_out(const std::vector<double>& rows, std::array<std::vector<double>, N>& columns,
                      std::size_t first) noexcept {
    for (std::size_t i = 0; i < rows.size(); ++i) columns[i % N][first + i / N] = rows[i];
  }

  std::vector<double> orientations_, angular_velocities_, angular_accelerations_;
  std::vector<double> positions_, velocities_, accelerations_;
};

/// Room for the samples that are ready, track after track; the errors of tracks become those of the table.
SampledTracks table_for(const std::vector<TrackSampler>& samplers, const std::vector<std::optional<Error>>& errors,
                        const WantedSamples& wanted) {
  SampledTracks table;
  table.offsets.push_back(0);
  for (std::size_t i = 0; i < samplers.size(); ++i) {
    const auto count = errors[i] ? 0 : static_cast<std::int64_t>(samplers[i].ready());
    table.offsets.push_back(table.offsets.back() + count);
    if (!errors[i]) continue;
    table.errors.push_back(*errors[i]);
    table.errors.back().where.curve = i;
  }
  const auto size = static_cast<std::size_t>(table.offsets.back());
  table.times.resize(size);
  resize(table.orientations, true, size);
  resize(table.angular_velocities, wanted.angular_velocities, size);
  resize(table.angular_accelerations, wanted.angular_accelerations, size);
  resize(table.positions, wanted.positions, size);
  resize(table.velocities, wanted.velocities, size);
  resize(table.accelerations, wanted.accelerations, size);
  return table;
}

}  // namespace

Expected<SampledTracks> sample_tracks(const Method& method, const TrackColumns& keys, const TrackGrid& grid,
                                      const WantedSamples& wanted, const TrackOptions& options, Work work) {
  if (auto error = check_columns(keys, wanted)) return tl::unexpected(std::move(*error));
  const auto empty = TrackSampler::make(method, grid, options);
  if (!empty) return tl::unexpected(empty.error());
  const std::size_t tracks = keys.offsets.size() - 1;
  std::vector<TrackSampler> samplers(tracks, *empty);
  std::vector<std::optional<Error>> errors(tracks);
  parallel_for(tracks, work.threads, [&](std::size_t i) {
    const auto fed = feed(samplers[i], keys, static_cast<std::size_t>(keys.offsets[i]),
                          static_cast<std::size_t>(keys.offsets[i + 1]));
    if (!fed) errors[i] = fed.error();
  });
  SampledTracks table = table_for(samplers, errors, wanted);
  parallel_for(tracks, work.threads, [&](std::size_t i) {
    const auto first = static_cast<std::size_t>(table.offsets[i]);
    const std::size_t count = static_cast<std::size_t>(table.offsets[i + 1]) - first;
    if (count == 0) return;
    Rows rows(count, wanted);
    [[maybe_unused]] const auto taken = samplers[i].take(rows.spans(), std::span(table.times).subspan(first, count));
    ORISPLINE_EXPECT(taken.has_value());  // the curves are built, the room is right
    rows.lay_out(table, first);
  });
  return table;
}

}  // namespace orispline
