// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include <orispline/clip/clip.hpp>

// A clip on another clock.

namespace orispline { inline namespace ORISPLINE_ABI {

/// The clip with every channel changed.
template <class Change>
[[nodiscard]] Clip with_channels(Clip clip, const Change& change) {
  for (RotationChannel& channel : clip.rotations) channel = change(std::move(channel));
  for (VectorChannel& channel : clip.translations) channel = change(std::move(channel));
  for (VectorChannel& channel : clip.scales) channel = change(std::move(channel));
  for (WeightChannels& weights : clip.weights)
    for (VectorChannel& channel : weights.triples) channel = change(std::move(channel));
  return clip;
}

/// The components of a value or a tangent, each so many times.
[[nodiscard]] inline Eigen::Quaterniond scaled(const Eigen::Quaterniond& q, double factor) {
  return Eigen::Quaterniond(Eigen::Vector4d(factor * q.coeffs()));
}
[[nodiscard]] inline Eigen::Vector3d scaled(const Eigen::Vector3d& v, double factor) { return factor * v; }

/// Times [s] and what they become: two at least, as many of both, rising. Between them, and beyond the ends, time goes
/// evenly.
struct ClipClock {
  std::vector<double> before{}, after{};

  /// On which side of a time.
  enum class Beside { earlier, later };
  [[nodiscard]] double at(double time) const;
  /// How much longer time gets there.
  [[nodiscard]] double pace(double time, Beside side) const;
};

/// The clip at the times of that clock. A cubic stays the curve that it is where time goes evenly between two keys.
[[nodiscard]] ORISPLINE_EXPORT Clip on_clock(Clip clip, const ClipClock& clock);

}}  // namespace orispline
