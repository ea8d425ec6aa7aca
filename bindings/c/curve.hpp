// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <orispline/batch/pose_sampler.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/track.hpp>

#include "handles.hpp"

namespace orispline::c {

/// A curve as C holds it.
struct HeldCurve {
  std::shared_ptr<const Track> track;
  Method method;
  PoseSampler sampler;

  [[nodiscard]] const PoseCurve& pose() const noexcept { return sampler.curve(); }
};

template <>
struct HandleOf<orispline_curve> {
  using Body = HeldCurve;
  static constexpr Kind kind = Kind::curve;
  static constexpr std::string_view name = "curve";
};

}  // namespace orispline::c
