// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <orispline/base/progress.hpp>
#include <orispline/online/track_sampler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Keys of many tracks, column by column. Those of track i are offsets[i] … offsets[i + 1] - 1.
struct TrackColumns {
  std::span<const std::int64_t> offsets;
  std::span<const double> times;                        ///< [s]
  std::array<std::span<const double>, 4> orientations;  ///< qx, qy, qz, qw, body to world
  std::array<std::span<const double>, 3> positions{};   ///< x, y, z [m]; empty: none
};

/// What samples have besides time and orientation.
struct WantedSamples {
  bool angular_velocities = false, angular_accelerations = false, angular_jerks = false;
  bool positions = false, velocities = false, accelerations = false;
};

/// Samples of many tracks, column by column as the keys. Columns that are not wanted are empty.
struct SampledTracks {
  std::vector<std::int64_t> offsets;
  std::vector<double> times;                        ///< [s]
  std::array<std::vector<double>, 4> orientations;  ///< qx, qy, qz, qw
  /// [rad/s], [rad/s²] and [rad/s³], body frame
  std::array<std::vector<double>, 3> angular_velocities{}, angular_accelerations{}, angular_jerks{};
  std::array<std::vector<double>, 3> positions{}, velocities{}, accelerations{};  ///< [m], [m/s], [m/s²], world frame
  std::vector<Error> errors;  ///< of the tracks that have no samples for it: `where.curve` says of which, in order
};

/// Samples of one track in columns of the caller, each as long as there are samples; empty ones are not wanted.
struct TrackSampleColumns {
  std::span<double> times{};
  std::array<std::span<double>, 4> orientations;
  std::array<std::span<double>, 3> angular_velocities{}, angular_accelerations{}, angular_jerks{};
  std::array<std::span<double>, 3> positions{}, velocities{}, accelerations{};
};

/// More samples between two keys are those of a wrong time, which would go on for days.
inline constexpr double most_samples_between_keys = 1e9;

/// Takes the next key of a track that somebody may have put together wrongly. Errors: those of TrackSampler::append(),
/// and bad_data for a key which so many samples lie before.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> append_checked(TrackSampler& sampler, StreamKey key);

/// The curves of many tracks, of which the samples are counted but not taken: the caller makes room for them first.
class ORISPLINE_EXPORT TrackBatch {
 public:
  /// Samples every track on a grid of its own, as a TrackSampler does; the samples do not depend on the threads.
  ///
  /// A track whose keys are refused by append_checked(), or make no curve, has no samples and does not hinder the
  /// others. Errors (bad_argument): those of TrackSampler::make; columns of different length, offsets that do not rise
  /// from 0 on within them; cancelled. The share that is shown is that of the tracks.
  [[nodiscard]] static Expected<TrackBatch> make(const Method& method, const TrackColumns& keys, const TrackGrid& grid,
                                                 const TrackOptions& options = {}, Work work = {},
                                                 const Progress& progress = {});

  /// The samples of track i will be offsets()[i] … offsets()[i + 1] - 1.
  [[nodiscard]] std::span<const std::int64_t> offsets() const noexcept { return offsets_; }
  [[nodiscard]] std::size_t size() const noexcept { return static_cast<std::size_t>(offsets_.back()); }
  /// Of them those that are not taken yet.
  [[nodiscard]] std::size_t left() const noexcept { return size() - taken_; }
  /// Of the tracks that have no samples for it: `where.curve` says of which, in order.
  [[nodiscard]] std::span<const Error> errors() const noexcept { return errors_; }

  /// Takes the next samples, as many as the columns have room for, across the ends of tracks.
  ///
  /// Errors: bad_argument for columns of different length or for more samples than are left, and for positions of keys
  /// that have none; cancelled, which leaves the columns half filled and the samples lost.
  [[nodiscard]] Expected<void> take(const TrackSampleColumns& out, Work work = {}, const Progress& progress = {});

 private:
  std::vector<TrackSampler> samplers_;
  std::vector<std::int64_t> offsets_{0};
  std::vector<Error> errors_;
  bool has_positions_ = false;
  std::size_t taken_ = 0;
};

/// Takes the next samples of one track, as many as the columns have room for.
///
/// Errors: those of TrackSampler::take; bad_argument for columns of different length; cancelled, which leaves the
/// columns half filled and the samples lost.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> take_columns(TrackSampler& sampler, const TrackSampleColumns& out,
                                                           Work work = {}, const Progress& progress = {});

/// All samples that a TrackBatch gives, with columns of its own, in one call. Errors: those of TrackBatch.
[[nodiscard]] ORISPLINE_EXPORT Expected<SampledTracks> sample_tracks(const Method& method, const TrackColumns& keys,
                                                                     const TrackGrid& grid,
                                                                     const WantedSamples& wanted = {},
                                                                     const TrackOptions& options = {}, Work work = {},
                                                                     const Progress& progress = {});

}}  // namespace orispline
