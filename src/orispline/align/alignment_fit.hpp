// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <orispline/align/align.hpp>
#include <orispline/align/best_of_offsets.hpp>
#include <orispline/curve/path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// R′ = W R Bᵀ, p′ = s W p + d; the moved time is the fixed one and the offset.
struct Transform {
  Eigen::Quaterniond world = Eigen::Quaterniond::Identity(), body = Eigen::Quaterniond::Identity();
  double offset = 0.0;  ///< [s]
  double scale = 1.0;
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< [m]
};

/// A moved motion as a curve, and samples of the fixed one.
struct AlignmentData {
  PoseCurve moved;
  Keyframes fixed;
  bool has_positions = false;  ///< of both
  AlignOptions options{};      ///< what is not looked for stays as it is in the guess
};

/// A Transform of least robust squares, and what is known of it.
struct AlignmentFit {
  Transform transform{};
  AlignmentSigmas sigmas{};
  std::vector<OpenDirection> open{};
  std::vector<std::size_t> compared{}, rejected{};  ///< samples of the fixed motion
  std::vector<double> angles{}, distances{};        ///< of each that was compared [rad], [m]
  double noise = 0.0, position_noise = 0.0;         ///< robust σ per axis [rad], [m]

  /// Minus twice a logarithm of the likelihood, but for a constant: less is better, also of fits that compare other
  /// numbers of samples.
  [[nodiscard]] double cost() const;
  [[nodiscard]] TriedOffset tried() const { return {transform.offset, sigmas.offset, noise, angles.size()}; }
};

/// The least robust squares near to the guess. None where fewer than `least_aligned` samples overlap.
[[nodiscard]] std::optional<AlignmentFit> fit_alignment(const AlignmentData& data, const Transform& guess);

}}  // namespace orispline
