// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Where the true motion may be: the angle about the curve of `measured` that is meant to hold a share of it.
///
/// By how far the models of motion miss the keys when each is predicted from its neighbours. It is 0 at the keys, where
/// their noise is not shown, unless a model of noise is believed. What moves faster than the keys show is not in it.
/// Source: docs/families/measured.md, Formula (5).
class ORISPLINE_EXPORT MotionBand {
 public:
  /// Errors: bad_argument for a share that is not between 0 and 1, for another method and for settings that the method
  /// does not accept.
  [[nodiscard]] static Expected<MotionBand> make(const Method& method, const Keyframes& keys, double share);

  /// At time t [s]; before the first key and after the last the end's. [rad] Infinite where the keys say nothing: there
  /// are fewer than nine, or every step is too large. Allocates nothing.
  [[nodiscard]] double operator()(double t) const noexcept;

 private:
  /// The width between two keys, and how it narrows towards them.
  struct Segment {
    double middle;
    std::array<double, 2> power;
  };

  MotionBand() = default;

  std::vector<double> times_;
  std::vector<Segment> segments_;  ///< none where the band is infinite
  std::vector<double> activity_;   ///< at the keys: how much the motion does there, as a share of what is usual
};

}}  // namespace orispline
