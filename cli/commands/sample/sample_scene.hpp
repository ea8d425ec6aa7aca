// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/pose_curve.hpp>

#include "commands/sample/sample_request.hpp"

namespace orispline::cli {

/// Whether one joint of a file of skeletons is to be sampled as the file says it moves.
[[nodiscard]] bool asks_for_stored(const SampleOptions& options);

/// Samples that motion.
[[nodiscard]] Expected<void> sample_stored(const SampleOptions& options);

/// Whether that is wanted of all joints, in a folder.
[[nodiscard]] bool asks_for_all_joints(const SampleOptions& options);

/// Samples every joint that moves into a file CLIP/JOINT in the folder; of a joint that is named that one of each clip.
[[nodiscard]] Expected<void> sample_all_joints(const SampleOptions& options);

/// A curve, how many keys it is through, and where samples are wanted.
struct CurveScene {
  std::size_t keys;
  const PoseCurve& curve;
  const SampleTimes& times;
};

/// Writes a curve into a file of skeletons, as the motion of one joint: as cubics within the tolerance, or its samples.
[[nodiscard]] Expected<void> write_curve_scene(const SampleOptions& options, const SampleRequest& request,
                                               const CurveScene& scene);

}  // namespace orispline::cli
