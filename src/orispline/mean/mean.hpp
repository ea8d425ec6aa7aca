// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/fields/field_info.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Which middle of many orientations; that of positions is the like of it.
enum class MeanKind {
  mean,     ///< the sum of the squared angles to it is least; the arithmetic mean of positions
  median,   ///< the sum of the angles to it is least; the geometric median of positions
  chordal,  ///< the sum of the squared chords to it is least, as SciPy has it; the arithmetic mean of positions
};

struct MeanOptions {
  MeanKind kind = MeanKind::mean;
  std::optional<double> every{};  ///< length of windows in time with a mean each [s]; absent: all have one
};

/// Orientations, and what belongs to them. Their order and their signs do not count. A list that is not empty has an
/// entry for each.
struct OrientationSet {
  std::span<const Eigen::Quaterniond> orientations{};  ///< body to world, norm within 1e-3 of 1
  std::span<const Eigen::Vector3d> positions{};        ///< [m]
  std::span<const double> weights{};                   ///< 0 or more; empty: all the same
};

/// The middle of many orientations, and of their positions, and how far they are from it.
///
/// What is in three components is along the axes of the body at `orientation`, of positions along those of the world.
/// Orientations of weight 0 count for nothing.
struct Mean {
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  std::optional<Eigen::Vector3d> position{};  ///< [m]
  std::size_t count = 0;                      ///< of orientations with a weight
  double weight = 0.0;                        ///< sum of the weights
  bool certified = false;                     ///< it is proved that no other orientation is as good
  double ball_radius = 0.0;  ///< of a ball that holds all orientations [rad], the smallest if below π/2
  /// No other orientation that is as good is farther from this one [rad]; absent where that is not known.
  std::optional<double> others_within{};
  double residual = 0.0;  ///< of the mean the length of the gradient, of the median that over its steepest change [rad]
  std::size_t iterations = 0;                   ///< steps to it
  double rms_distance = 0.0;                    ///< weighted [rad]
  double largest_distance = 0.0;                ///< [rad]
  std::size_t farthest = 0;                     ///< index of the orientation there
  std::optional<Eigen::Matrix3d> spread{};      ///< covariance of one orientation [rad²]; absent for a single one
  std::optional<Eigen::Matrix3d> covariance{};  ///< of the mean itself [rad²]; absent where it cannot be told
  std::optional<double> position_rms_distance{}, position_largest_distance{};  ///< [m]
  std::optional<std::size_t> farthest_position{};
  std::optional<Eigen::Matrix3d> position_spread{}, position_covariance{};  ///< [m²]
  std::vector<Warning> warnings{};  ///< `mean_not_certified`, `median_of_a_range`
};

/// One standard deviation of the mean along each axis; absent where it cannot be told.
[[nodiscard]] ORISPLINE_EXPORT std::optional<Eigen::Vector3d> sigma_of(const Mean& mean);  ///< [rad], of the body
[[nodiscard]] ORISPLINE_EXPORT std::optional<Eigen::Vector3d> position_sigma_of(
    const Mean& mean);  ///< [m], of the world

/// The mean or the median of all, with `every` too. Formulas and proofs: docs/mean.md.
///
/// Errors (bad_data, with the key): no orientations, lists of different length, a quaternion that is none, a weight
/// below 0 or not finite, no weight above 0; orientations that cancel, such as two that are 180° apart.
[[nodiscard]] ORISPLINE_EXPORT Expected<Mean> mean(const OrientationSet& given, const MeanOptions& options = {});

/// The chordal mean alone, with its bits in mean(), in a fifth of the time. Errors: as of mean().
[[nodiscard]] ORISPLINE_EXPORT Expected<Eigen::Quaterniond> chordal_mean(const OrientationSet& given);

/// A window in time, and the mean of what is in it.
struct MeanWindow {
  double time = 0.0;      ///< its middle, or that of all times [s]
  std::size_t first = 0;  ///< index of the first orientation in it
  Mean mean{};
};

/// Those of successive windows, the first of which begins at the first time; without `every` a single one. A window
/// with nothing in it, or nothing with a weight, has no mean. Times rise.
///
/// Errors: those of check() and mean(), with the first key of the window where they name none.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<MeanWindow>> mean_in_windows(std::span<const double> times,
                                                                                 const OrientationSet& given,
                                                                                 const MeanOptions& options = {});

/// Error (bad_argument): options that are wrong whatever is given.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const MeanOptions& options);

template <>
inline constexpr std::array words<MeanKind>{
    word("mean", MeanKind::mean, "the sum of the squared angles to it is least"),
    word("median", MeanKind::median, "the sum of the angles to it is least, which bad rows hardly move"),
    word("chordal", MeanKind::chordal,
         "the sum of the squared chords to it is least, as SciPy's Rotation.mean has it")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<MeanOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Mean>() noexcept;

}}  // namespace orispline
