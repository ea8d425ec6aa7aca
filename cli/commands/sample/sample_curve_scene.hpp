// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/path.hpp>

#include "commands/sample/sample_request.hpp"

namespace orispline::cli {

/// A curve, how many keys it is through, and where samples are wanted.
struct CurveScene {
  std::size_t keys;
  const PoseCurve& curve;
  const SampleTimes& times;
};

/// Writes a curve into a file of skeletons, as the motion of one joint: as cubics within the tolerance, or its samples.
[[nodiscard]] Expected<void> write_curve_scene(const SampleArguments& options, const SampleRequest& request,
                                               const CurveScene& scene);

}  // namespace orispline::cli
