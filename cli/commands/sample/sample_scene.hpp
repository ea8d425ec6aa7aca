// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/curve/path.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "commands/sample/sample_report.hpp"
#include "commands/sample/sample_request.hpp"

namespace orispline::cli {

/// Whether joints of a file of skeletons are to be sampled as the file says that they move.
[[nodiscard]] bool asks_for_stored(const SampleArguments& options);

/// What is then to be sampled. Error (bad_argument): what does not fit to it.
[[nodiscard]] Expected<SampleRequest> stored_request(const SampleArguments& options);

/// The chosen clips.
[[nodiscard]] Expected<scenes::Scene> opened(const InputRequest& input);

/// The motion of one joint, and when it is to be sampled.
struct JointSamples {
  PoseCurve curve;
  SampleTimes times;
  std::vector<Warning> warnings{};
};
[[nodiscard]] Expected<JointSamples> joint_samples(const SampleRequest& request, const scenes::Scene& scene,
                                                   const Clip& clip, std::size_t joint);

/// Writes them.
[[nodiscard]] Expected<SampleReport> write_joint(const SampleRequest& request, const JointSamples& samples);

/// Samples the one joint that is chosen.
[[nodiscard]] Expected<void> sample_stored(const SampleArguments& options);

}  // namespace orispline::cli
