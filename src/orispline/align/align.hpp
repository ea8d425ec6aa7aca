// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <orispline/analysis/distance.hpp>
#include <orispline/base/decimal.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which differences between two recordings of one motion are looked for; the others are taken to be none.
struct AlignOptions {
  bool world_turn = true;          ///< of the world's axes
  bool body_turn = true;           ///< of the body's axes
  bool scale = true;               ///< of positions
  bool translation = true;         ///< of the world's origin
  std::optional<double> offset{};  ///< of the clocks [s], as in Alignment; absent: looked for
};

/// What two recordings cannot tell of their alignment: so much of these together changes nothing that was measured.
struct OpenDirection {
  Eigen::Vector3d world = Eigen::Vector3d::Zero(), body = Eigen::Vector3d::Zero();  ///< turns about these axes [rad]
  double offset = 0.0;                                                              ///< [s]
  double scale = 0.0;                                                               ///< of 1
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();                            ///< [m]
};

/// One standard deviation of everything in an alignment, from the residuals; 0 of what was not looked for.
struct AlignmentSigmas {
  Eigen::Vector3d world = Eigen::Vector3d::Zero();        ///< [rad], of turns about the axes of the fixed world
  Eigen::Vector3d body = Eigen::Vector3d::Zero();         ///< [rad], about the axes of the fixed body
  double offset = 0.0;                                    ///< [s]
  double scale = 0.0;                                     ///< of 1
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< [m], of the moved origin
};

/// What brings one recording, the moved one, onto another one of the same motion, the fixed one: R′ = W R Bᵀ,
/// p′ = s W p + d, t′ = t − offset.
struct Alignment {
  Eigen::Quaterniond world = Eigen::Quaterniond::Identity();  ///< W
  Eigen::Quaterniond body = Eigen::Quaterniond::Identity();   ///< B
  Decimal offset{};                              ///< [s], so much the stamps of the moved recording are late
  std::optional<double> scale{};                 ///< s; absent unless both recordings have positions
  std::optional<Eigen::Vector3d> translation{};  ///< d [m]; absent unless both recordings have positions
  AlignmentSigmas sigmas{};
  std::vector<OpenDirection> open{};    ///< of length 1 in these units; what is here has no part in the sigmas
  std::vector<std::size_t> compared{};  ///< samples of the fixed recording
  std::vector<std::size_t> rejected{};  ///< of these, those that are too far to count
  DistanceStatistics distance{};        ///< of the orientations, rejected ones too [rad]; indices of `compared`
  std::optional<DistanceStatistics> position_distance{};  ///< [m]
  double noise = 0.0;                      ///< robust σ of these distances per axis [rad], 1e-6 at least
  std::optional<double> position_noise{};  ///< that of the positions [m], at least 1e-6 of how far these spread
  std::vector<Warning> warnings{};         ///< `poor_alignment`, `open_alignment`, `ambiguous_offset`
};

/// The fewest samples of each recording.
inline constexpr std::size_t least_aligned = 8;

/// The alignment with the least robust squares of the distances at samples of the fixed recording, by default with
/// everything that AlignOptions names; a tenth of bad samples in either is rejected.
///
/// Both recordings are smoothed; offsets at which their turns between equal times are most alike are tried (W and B do
/// not change by how much a body turns), and the best one is refined with all else by Gauss-Newton with Tukey's loss.
/// Where both turn about one axis only, or not at all, what cannot be told apart is in `open`, and B stays as near to
/// the identity as it can. Positions take part where both recordings have them, each kind by its own noise. Our
/// derivation; docs/align.md.
///
/// Errors: bad_argument for an offset that is not finite, or with which fewer than `least_aligned` samples lie side by
/// side; bad_data for recordings that have fewer samples, or fewer side by side at any offset, and for those that no
/// alignment brings nearer than 30° to each other (median); those of smooth(); cancelled.
[[nodiscard]] ORISPLINE_EXPORT Expected<Alignment> align(const Track& moved, const Track& fixed,
                                                         const AlignOptions& options = {},
                                                         const Progress& progress = {});

/// The moved recording in the axes, in the unit of length and on the clock of the fixed one, from whose epoch its times
/// count; its body rates are turned by B too. Settings, the recipe and lines are kept, the table of the file is
/// forgotten. Any other recording of the moved clock and axes may stand in its place. Errors: of Keyframes::make(), for
/// positions that grow too large and times that fall together in a double.
[[nodiscard]] ORISPLINE_EXPORT Expected<Track> aligned(const Track& moved, const Track& fixed,
                                                       const Alignment& alignment);

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<AlignOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Alignment>() noexcept;

}}  // namespace orispline
