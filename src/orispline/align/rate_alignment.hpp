// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <orispline/align/align.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A gyro as a recording by itself.
struct GyroTrack {
  GyroRates rates{};      ///< whose times count from the epoch
  Decimal epoch{};        ///< [s], exact
  bool is_dated = false;  ///< as of Track

  /// [s], exact where the file's own text is known, else as near as a double.
  [[nodiscard]] ORISPLINE_EXPORT Decimal time_of(std::size_t rate) const;
};

/// What two recordings cannot tell of their alignment by rates: so much of these together changes nothing.
struct OpenRateDirection {
  Eigen::Vector3d body = Eigen::Vector3d::Zero();  ///< a turn about this axis of the fixed body [rad]
  double offset = 0.0;                             ///< [s]
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// What brings a gyro onto another one, or onto the orientations of a body: ω′ = B (ω − bias), t′ = t − offset. Where
/// orientations are what is moved, onto a gyro: R′ = R Bᵀ, and B (ω of the body) = ω of the gyro − bias.
struct RateAlignment {
  Eigen::Quaterniond body = Eigen::Quaterniond::Identity();  ///< B
  Decimal offset{};                                          ///< [s], so much the stamps of the moved one are late
  /// [rad/s], in its own frame, of the gyro that was moved, or of the only one; beside a second gyro the difference.
  Eigen::Vector3d bias = Eigen::Vector3d::Zero();
  Eigen::Vector3d body_sigma = Eigen::Vector3d::Zero();  ///< one standard deviation [rad], about axes of the fixed body
  double offset_sigma = 0.0;                             ///< [s]; 0 of what was not looked for, here and above
  Eigen::Vector3d bias_sigma = Eigen::Vector3d::Zero();  ///< [rad/s]
  std::vector<OpenRateDirection> open{};  ///< 1 rad, or what turns the body as far; no part of the sigmas
  std::size_t compared = 0;               ///< turns of the fixed recording, or of the one of orientations
  std::vector<std::size_t> rejected_moved{}, rejected_fixed{};  ///< samples that do not count
  /// How far orientations are from where the gyro leads from those before [rad], indices of these; not of two gyros.
  std::optional<DistanceStatistics> distance{};
  /// Between the mean rates of two gyros over about 50 ms [rad/s].
  std::optional<DistanceStatistics> rate_distance{};
  double excess = 0.0;  ///< robust σ of what is left, in units of what the noise of both recordings explains
  std::vector<Warning> warnings{};  ///< `poor_alignment`, `open_alignment`, `ambiguous_offset`
};

/// The alignment of two gyros on one body, with the least robust squares between the turns to which both lead; of the
/// options `body_turn` and `offset` count. Nothing is differentiated, and a tenth of bad rates in either does no harm.
/// docs/align.md.
///
/// Errors: bad_argument for an offset that is not finite, or with which fewer than `least_aligned` turns lie side by
/// side; bad_data for times and rates that are not finite, not as many, or not in order, for recordings that are too
/// short, do not overlap, do not turn beyond their noise, or have no turns in common; cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<RateAlignment> align(const GyroTrack& moved, const GyroTrack& fixed,
                                                             const AlignOptions& options = {},
                                                             const Progress& progress = {});
/// Aligns a gyro with the orientations of the body that carries it. Errors: those above, and those of smooth().
[[nodiscard]] ORISPLINE_EXPORT Expected<RateAlignment> align(const GyroTrack& moved, const Track& fixed,
                                                             const AlignOptions& options = {},
                                                             const Progress& progress = {});
[[nodiscard]] ORISPLINE_EXPORT Expected<RateAlignment> align(const Track& moved, const GyroTrack& fixed,
                                                             const AlignOptions& options = {},
                                                             const Progress& progress = {});

/// The rates without their bias, in the axes of the fixed body and on its clock, from whose epoch their times count.
[[nodiscard]] ORISPLINE_EXPORT GyroTrack aligned(const GyroTrack& moved, const Decimal& fixed_epoch,
                                                 const RateAlignment& alignment);
/// Orientations of the frame of the gyro, on its clock, from whose epoch their times count. Errors: those of aligned()
/// of two tracks.
[[nodiscard]] ORISPLINE_EXPORT Expected<Track> aligned(const Track& moved, const GyroTrack& fixed,
                                                       const RateAlignment& alignment);

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<RateAlignment>() noexcept;

}}  // namespace orispline
