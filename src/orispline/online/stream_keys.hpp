// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/online/stream_method.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Whether more keys may come.
enum class Stream { open, finished };

/// The keys of a stream that are still needed, the newest. Their signs are chosen already, their norms are as given: a
/// curve through some of them normalises as one through all of them does.
class ORISPLINE_EXPORT StreamKeys {
 public:
  /// Takes the next key, which has been checked against those before, with its sign.
  void push(const StreamKey& key);
  /// Takes the newest key back.
  void pop();
  /// Forgets the keys before that one.
  void forget_before(std::uint64_t key);
  void clear();

  /// Keys taken since the beginning.
  [[nodiscard]] std::uint64_t count() const noexcept { return first_ + data_.times.size(); }
  /// The oldest key that is kept.
  [[nodiscard]] std::uint64_t first() const noexcept { return first_; }
  [[nodiscard]] std::size_t kept() const noexcept { return data_.times.size(); }
  [[nodiscard]] double time(std::uint64_t key) const noexcept {
    return data_.times[static_cast<std::size_t>(key - first_)];
  }
  [[nodiscard]] std::span<const double> times() const noexcept { return data_.times; }
  /// The orientation of the newest key, as it is kept.
  [[nodiscard]] const Eigen::Quaterniond& newest() const noexcept { return data_.orientations.back(); }
  /// What all keys have; false everywhere without keys.
  [[nodiscard]] KeyParts parts() const noexcept;

  /// The first key that the curve from key `start` on needs, with as many keys before the end as that needs.
  [[nodiscard]] std::uint64_t needed_from(std::uint64_t start, const StreamMethod& method) const noexcept;

  /// The curve through the keys from that one to the newest, of which the segments in the middle have the bits of the
  /// whole curve; with the end rule if the stream is finished. Errors: those of make_curve().
  [[nodiscard]] Expected<PoseCurve> curve_from(std::uint64_t key, const StreamMethod& method, Stream stream) const;

  [[nodiscard]] const KeyframeData& data() const noexcept { return data_; }
  /// The values of the parameters that come with the keys, by parameter.
  [[nodiscard]] const std::vector<std::vector<double>>& settings() const noexcept { return settings_; }
  /// Keys as they were kept. Errors (bad_data): keys or settings that no stream of the method can keep.
  [[nodiscard]] static Expected<StreamKeys> from_kept(std::uint64_t first, KeyframeData data,
                                                      std::vector<std::vector<double>> settings,
                                                      const StreamMethod& method);

 private:
  KeyframeData data_;
  std::vector<std::vector<double>> settings_;  ///< one list for every parameter of StreamMethod::per_key
  std::uint64_t first_ = 0;
};

}}  // namespace orispline
