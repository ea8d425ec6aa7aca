// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/abi.hpp>
#include <orispline/base/decimal.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The text of a table of keys, column by column as it was read.
struct KeyTable {
  std::vector<std::string> names{};
  std::vector<std::vector<std::string>> rows{};  ///< one cell per name, one row per key
};

struct BlendingData;

/// The method whose curve through smoothed keys is the smooth motion: C2, through their orientations and rates.
inline constexpr std::string_view smoothed_method = "hermite-c2";

/// Settings of keys for it that say how certain the curve is: the standard deviation of a turn per axis [rad], at the
/// key and at sixths of the way to the next one.
inline constexpr std::array<std::string_view, 6> band_columns{"sigma_0of6", "sigma_1of6", "sigma_2of6",
                                                              "sigma_3of6", "sigma_4of6", "sigma_5of6"};

/// What keys say about the curve that they are for: with it a file of keys carries its meaning.
struct Recipe {
  std::string method{};           ///< the method's text form, read by method_from_text(); empty: none is named
  Signs signs = Signs::shortest;  ///< how the signs of the keys are to be read
  std::size_t line = 0;           ///< of the file, from 1; 0: not from a file
  std::shared_ptr<const BlendingData> blending{};  ///< of the method, where it is one of one's own
  std::optional<double> gap{};  ///< intervals between keys longer than this [s] are gaps, which no curve bridges
  bool jumps = false;           ///< two keys may have one time, where the motion jumps
  bool counts_turns = false;    ///< the signs are those of turns that were typed, which keys state without a method too

  [[nodiscard]] bool is_empty() const noexcept { return method.empty(); }
};

/// Positions at times of their own, beside orientations at others: two tracks on one clock.
struct PositionTrack {
  std::vector<double> times{};               ///< [s], since the epoch of the orientations
  std::vector<Eigen::Vector3d> positions{};  ///< [m]

  [[nodiscard]] bool is_empty() const noexcept { return times.empty(); }
};

/// Keyframes with where they come from: what tasks take and give back, and what files hold.
///
/// Keys alone are a track without a name. Vectors that are not empty have one entry per key.
struct ORISPLINE_EXPORT Track {
  Keyframes keys{};
  std::string name{};                  ///< of the file, or of the track in it; `-` for standard input
  Decimal epoch{};                     ///< [s], exact: what the times of the keys count from
  bool is_dated = false;               ///< seconds are those since 1970-01-01T00:00:00, and people have dates
  std::vector<std::uint32_t> lines{};  ///< of the file, from 1
  std::vector<Decimal> exact_times{};  ///< [s], as the file writes them
  /// Values of a method's parameters, one per key, by their names: `tension`, `bias`, …
  std::map<std::string, std::vector<double>, std::less<>> settings{};
  std::vector<Eigen::Quaterniond> as_read{};  ///< with the norms and signs of the file; only if asked for
  KeyTable table{};                 ///< all columns of the file, while they state these keys; only if asked for
  PositionTrack positions_apart{};  ///< of keys without positions, where their file has them at other times
  Recipe recipe{};                  ///< the curve that the keys are for, as their file or the task that made them says

  Track() = default;
  Track(Keyframes keyframes) : keys(std::move(keyframes)) {}  // NOLINT: keys are a track

  /// [s], exact where the file's own text is known, else as near as a double.
  [[nodiscard]] Decimal time_of(std::size_t key) const;

  /// A time [s] for people to read: `12.5 s`, or `2026-03-01T10:00:12.5` where they have dates.
  [[nodiscard]] std::string time_text(const Decimal& time) const;
  /// Two of them: `10 to 12.5 s`.
  [[nodiscard]] std::string span_text(const Decimal& from, const Decimal& to) const;

  /// An orientation as it should be written: with the digits of the file and the sign of the key, where the key is what
  /// the file has and its norm there is 1; else the key itself.
  [[nodiscard]] Eigen::Quaterniond written(std::size_t key) const;

  /// The keys at these rising indices, one at least, with all that belongs to them; signs for the shortest way. The
  /// curve that all keys were for is not theirs: the recipe is empty, and so is the band.
  [[nodiscard]] Track at(std::span<const std::size_t> indices) const;
  /// These keys at other times; exact times, the table and the band are forgotten. Errors: those of
  /// Keyframes::with_times().
  [[nodiscard]] Expected<Track> with_times(std::vector<double> times) const;
  /// Other keys at the same times, such as smoothed ones; the table is forgotten.
  [[nodiscard]] Track with_keys(const Keyframes& others) const;

  /// Without the settings of its band, which is that of another curve.
  void forget_band();

  /// The error with the name of the track and, where it names a key, its line.
  [[nodiscard]] Error located(Error error) const;
  /// The warning with the name of the track and, where it names a key, its line.
  [[nodiscard]] Warning located(Warning warning) const;
};

/// The settings of a method that have a value of their own for every key, by name: what a file of these keys states in
/// columns.
[[nodiscard]] ORISPLINE_EXPORT std::map<std::string, std::vector<double>, std::less<>> settings_per_key(
    const Method& method, std::size_t keys);

/// The method, completed by the settings of the track that it does not state itself.
[[nodiscard]] ORISPLINE_EXPORT Method completed(Method method, const FamilyInfo& family, const Track& track);

}}  // namespace orispline
