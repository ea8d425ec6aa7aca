// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Values over even times that one tracker recorded: the turns of joints about three axes [rad], and places of joints.
struct Channels {
  Eigen::MatrixXd values{};           ///< a row for each time, a column for each channel
  std::vector<std::size_t> joints{};  ///< of each channel, from 0: its noise has one size along all of them
  std::vector<std::size_t> kinds{};   ///< of each channel, from 0: the joints of one kind have like noise
};

/// What is known of their noise.
struct ChannelNoise {
  std::optional<double> time{};                 ///< within which its correlation falls to 1/e, in intervals; 0: white
  std::vector<std::optional<double>> sigmas{};  ///< of each kind
};

/// The motion of channels, of which some move together, beside noise of one kind.
///
/// Accelerations are white beside one another in time, with any covariance between the channels; the noise of channels
/// is independent. So along the directions of that covariance, of channels over their σ, smoothing goes channel by
/// channel: much where hardly anything moves, little where limbs swing together.
struct SharedMotion {
  double noise_time = 0.0;       ///< within which the correlation of the noise falls to 1/e, in intervals; 0: white
  Eigen::VectorXd sigmas{};      ///< of the noise of each channel
  Eigen::MatrixXd directions{};  ///< by columns, orthonormal, of channels over their σ
  Eigen::VectorXd strengths{};   ///< of the accelerations along each, over σ² and per interval³
};

/// The motion of greatest likelihood, by the spectra of stretches of up to 512 times (Whittle's), and by expectation
/// and maximisation for the covariance and the noise. Each channel moves, and there are 16 times at least.
[[nodiscard]] SharedMotion shared_motion(const Channels& channels, const ChannelNoise& known);

/// The channels without their noise.
[[nodiscard]] Eigen::MatrixXd smoothed_channels(const Channels& channels, const SharedMotion& motion);

/// σ² over the strength of one channel by itself, in intervals³: the weight of its penalty without the others.
[[nodiscard]] double lambda_alone(const SharedMotion& motion, Eigen::Index channel);

}}  // namespace orispline
