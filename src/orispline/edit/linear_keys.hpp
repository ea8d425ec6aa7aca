// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include <orispline/edit/channel_path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Collects keys of a curve for a linear channel, which goes the shorter way from key to key.
template <CurvePoint P>
class LinearKeys {
 public:
  /// Appends to the channel, whose last key is on the curve. Refers to both.
  LinearKeys(Channel<P>& channel, const AnyCurveThrough<P>& curve) : channel_(channel), curve_(curve) {}

  /// A key there, and others between where the curve turns by nearly a half turn or more.
  void go_to(double time) { follow(time, most_halvings); }

  /// The same in even steps that are about as long, or in one that is shorter.
  void go_to(double time, double step) {
    const double start = channel_.times.back(), pieces = std::max(1.0, std::round((time - start) / step));
    for (double k = 1.0; k < pieces; k += 1.0) go_to(start + (time - start) * (k / pieces));
    go_to(time);
  }

 private:
  static constexpr int most_halvings = 6;
  static constexpr double longest_turn = std::numbers::pi * 179.0 / 180.0;

  void follow(double time, int halvings) {
    const P value = point_of(motion_at(curve_, time));
    if constexpr (std::same_as<P, Eigen::Quaterniond>) {
      const double start = channel_.times.back(), middle = 0.5 * (start + time);
      const P half = point_of(motion_at(curve_, middle));
      const double turn = angular_distance(channel_.values.back(), half) + angular_distance(half, value);
      if (halvings > 0 && turn > longest_turn) {
        follow(middle, halvings - 1);
        return follow(time, halvings - 1);
      }
    }
    channel_.times.push_back(time);
    channel_.values.push_back(with_sign_near(value, channel_.values.back()));
  }

  Channel<P>& channel_;
  const AnyCurveThrough<P>& curve_;
};

}}  // namespace orispline
