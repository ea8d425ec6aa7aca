// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "commands/sample/sample.hpp"
#include "output/progress.hpp"

#include <orispline/io/sample_columns.hpp>

namespace orispline::cli {

/// The command line of `sample`, understood.
struct SampleRequest {
  InputRequest input;
  Method method;
  TimeRequest times;
  io::SampleColumns columns;
  Extrapolation extrapolation = Extrapolation::hold;
  std::size_t threads = 1;
  std::string output;
  std::optional<std::string> truth;
  Progress::Show progress = Progress::Show::never;
};

[[nodiscard]] Expected<SampleRequest> sample_request(const SampleOptions& options);

/// The columns for keys with or without positions.
[[nodiscard]] io::SampleColumns with_positions(io::SampleColumns columns, bool positions);

}  // namespace orispline::cli
