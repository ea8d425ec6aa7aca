// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/base/progress.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/reduce/reduce.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Between an orientation and the same one evaluated in another order of operations [rad].
inline constexpr double angle_rounding = 4e-15;

/// The rotation vector of the shorter way from one orientation to another [rad], body frame of the first.
[[nodiscard]] inline Eigen::Vector3d shorter_turn(const Eigen::Quaterniond& from, Eigen::Quaterniond to) noexcept {
  if (from.dot(to) < 0.0) to.coeffs() = -to.coeffs();
  return increment<double>(from, to);
}

/// Keys at some times of a recording, the first and the last among them.
struct KeySet {
  std::vector<std::size_t> samples;              ///< indices of the samples at whose times they stand, rising
  std::vector<Eigen::Quaterniond> orientations;  ///< one per key
  std::vector<Eigen::Vector3d> positions{};      ///< [m], one per key where the recording has positions
  /// [rad/s], body frame, one per key where they were sought with the keys.
  std::vector<Eigen::Vector3d> angular_velocities{};

  [[nodiscard]] std::size_t size() const noexcept { return samples.size(); }
};

/// The sample that a segment misses most, its keys among them.
struct WorstSample {
  double excess = 0.0;  ///< square of the distance by the tolerance, small angles by their sines: above 1 it is broken
  std::size_t sample = 0;  ///< its index
};

/// What a curve misses a sample by, in the world frame.
struct Miss {
  Eigen::Vector3d turn, shift;  ///< from the curve to the sample [rad], [m]
  double excess;                ///< as in WorstSample
};

/// A recording that curves are measured against: steps between keys go the shorter way. Refers to its samples.
class ToleranceCheck {
 public:
  ToleranceCheck(const Keyframes& samples, Tolerance tolerance, OpenEndedWork& work);
  ToleranceCheck(Keyframes&&, Tolerance, OpenEndedWork&) = delete;

  [[nodiscard]] const Keyframes& samples() const noexcept { return samples_; }
  [[nodiscard]] std::size_t size() const noexcept { return samples_.size(); }
  [[nodiscard]] bool has_positions() const noexcept { return !samples_.positions().empty(); }
  [[nodiscard]] Tolerance tolerance() const noexcept { return tolerance_; }
  /// Whether positions are bounded as well.
  [[nodiscard]] bool bounds_positions() const noexcept;

  /// As in WorstSample, of one sample.
  [[nodiscard]] double excess(std::size_t sample, const Eigen::Quaterniond& orientation) const noexcept;
  [[nodiscard]] double excess(std::size_t sample, const Eigen::Vector3d& position) const noexcept;

  [[nodiscard]] KeySet keys_at(std::vector<std::size_t> samples) const;
  [[nodiscard]] Expected<Keyframes> keyframes(const KeySet& keys) const;
  /// The curve of a method for the samples, with the settings of those where the keys stand. Errors: those of
  /// make_pose_curve(); cancelled.
  [[nodiscard]] Expected<PoseCurve> curve(const Method& method, const KeySet& keys) const;
  [[nodiscard]] bool stopped() const noexcept { return work_.stopped(); }

  /// Of every segment of the method's curve through the keys. Errors: those of curve().
  [[nodiscard]] Expected<std::vector<WorstSample>> worst_samples(const Method& method, const KeySet& keys) const;
  /// Of every sample. Errors: those of curve().
  [[nodiscard]] Expected<std::vector<Miss>> misses(const Method& method, const KeySet& keys) const;
  /// Over all samples, each by the curve's own evaluator.
  [[nodiscard]] Expected<Deviation> deviation(const Method& method, const Keyframes& keys) const;

 private:
  const Keyframes& samples_;
  Tolerance tolerance_;
  double per_square_sine_, per_square_distance_;
  OpenEndedWork& work_;  ///< every curve is a piece of it; when it is stopped, none is made any more
};

/// The worst sample of every segment, the keys' own samples among them.
[[nodiscard]] std::vector<WorstSample> worst_of_segments(const KeySet& keys, const std::vector<Miss>& misses);

}}  // namespace orispline
