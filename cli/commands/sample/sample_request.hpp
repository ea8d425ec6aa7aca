// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/sample/sample.hpp"
#include "output/progress.hpp"

namespace orispline::cli {

/// The command line of `sample`, understood.
struct SampleRequest {
  InputRequest input;
  std::optional<Method> named{};  ///< by the user
  MethodOptions shape{};          ///< for the method that the file names
  Method method{};                ///< when it is known: settle_method()
  RowRequest rows;
  std::size_t threads = 1;
  std::string output;
  std::optional<std::string> truth;
  bool align = false;                 ///< the truth, with the keys
  std::optional<double> tolerance{};  ///< of the cubics of a file of skeletons [rad]; absent: samples are written
  double position_tolerance = 1e-3;   ///< of those of positions [m]
  Progress::Show progress = Progress::Show::never;
};

[[nodiscard]] Expected<SampleRequest> sample_request(const SampleArguments& options);

/// Decides for a method, by the file if nobody else does, and how the keys are read for it; what is noteworthy.
[[nodiscard]] Expected<std::vector<Warning>> settle_method(SampleRequest& request, const io::KeyInput& keys);

/// Whether joints of a file of skeletons are to be sampled as the file says that they move.
[[nodiscard]] bool asks_for_stored_motion(const SampleArguments& options);
/// What is then to be sampled. Error (bad_argument): what does not fit to it.
[[nodiscard]] Expected<SampleRequest> stored_request(const SampleArguments& options);

}  // namespace orispline::cli
