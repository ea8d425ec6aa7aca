// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <orispline/batch/sample_grid.hpp>
#include <orispline/online/stream_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// One curve of a track: the keys that are still needed, and what of it is final.
class ORISPLINE_EXPORT TrackStretch {
 public:
  /// `first_key`: how many keys of the track came before.
  explicit TrackStretch(std::uint64_t first_key) noexcept : first_key_(first_key) {}

  /// Takes the next key, with its sign.
  void push(const StreamKey& key, const StreamMethod& method);
  /// Declares the newest key to be the last. Errors: bad_data for fewer keys than the end rules need, or another count
  /// than the method takes.
  [[nodiscard]] Expected<void> finish(const StreamMethod& method);

  [[nodiscard]] bool is_finished() const noexcept { return stream_ == Stream::finished; }
  /// When the curve begins, once the key has come where it does [s].
  [[nodiscard]] std::optional<double> start() const noexcept { return start_; }
  /// When the finished curve ends [s].
  [[nodiscard]] double end(const StreamMethod& method) const noexcept { return keys_.time(*last_joint(method)); }
  /// The first sample, once the start is known. The first curve of a track has those before it too, of a request.
  [[nodiscard]] std::uint64_t first_sample(const SampleGrid& grid) const;
  /// The final samples.
  [[nodiscard]] SampleRange final_samples(const StreamMethod& method, const SampleGrid& grid) const;
  /// Forgets the keys on which no sample from that one on depends.
  void forget_before(std::uint64_t sample, const StreamMethod& method, const SampleGrid& grid);
  /// Where samples from that one on are final, the curve of which they have the bits of the whole. Errors: those of
  /// make_curve().
  [[nodiscard]] Expected<const PoseCurve*> curve_from(std::uint64_t sample, const StreamMethod& method,
                                                      const SampleGrid& grid);

  [[nodiscard]] const StreamKeys& keys() const noexcept { return keys_; }
  [[nodiscard]] std::uint64_t first_key() const noexcept { return first_key_; }
  /// A stretch as it was. Error (bad_data): it lacks keys on which that sample or a later one depends.
  [[nodiscard]] static Expected<TrackStretch> from_kept(StreamKeys keys, Stream stream, std::uint64_t first_key,
                                                        std::optional<double> start, std::uint64_t sample,
                                                        const StreamMethod& method,
                                                        const std::optional<SampleGrid>& grid);

 private:
  /// The last joint that is final or, while the stretch is open, up to which it will be next; absent before the first.
  [[nodiscard]] std::optional<std::uint64_t> last_joint(const StreamMethod& method) const noexcept;
  /// The key where the segment of a time begins.
  [[nodiscard]] std::uint64_t joint_before(double t, const StreamMethod& method) const noexcept;

  StreamKeys keys_;
  Stream stream_ = Stream::open;
  std::uint64_t first_key_;
  std::optional<double> start_;
  std::optional<PoseCurve> curve_;  ///< of the keys that are there, once it is asked for
};

}}  // namespace orispline
