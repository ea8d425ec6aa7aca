// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include <orispline/curve/method.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/track.hpp>

#include "handles.hpp"

namespace orispline::c {

/// How a curve is sampled: samples.cpp says it, or samples_singly.cpp where there are no samples in bulk.
class Sampler;
[[nodiscard]] std::shared_ptr<const Sampler> sampler_of(const PoseCurve& curve);

/// A curve as C holds it.
struct HeldCurve {
  std::shared_ptr<const Track> track;
  Method method;
  PoseCurve pose;
  std::shared_ptr<const Sampler> sampler;
};

template <>
struct HandleOf<orispline_curve> {
  using Body = HeldCurve;
  static constexpr Kind kind = Kind::curve;
  static constexpr std::string_view name = "curve";
};

}  // namespace orispline::c
