// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample.hpp"

#include "commands/sample/sample_joints.hpp"
#include "commands/sample/sample_keys.hpp"
#include "commands/sample/sample_request.hpp"
#include "output/each_input.hpp"

namespace orispline::cli {

namespace {

Expected<void> sample_one(const SampleArguments& options) {
  if (!asks_for_stored(options)) return sample_keys(options);
  return options.inputs.folder ? sample_joints(options) : sample_joint(options);
}

Expected<void> check_each(const SampleArguments& options) {
  if (options.rows.list == io::standard_stream || options.truth == io::standard_stream)
    return usage_failure(
        "--output-folder: found '-' for --times or --truth, wanted a file, which is read again for each input");
  const auto request = asks_for_stored(options) ? stored_request(options) : sample_request(options);
  return request.map([](const SampleRequest&) {});
}

}  // namespace

Expected<void> sample(const SampleArguments& options) {
  return on_inputs(options, {.written = "samples", .check = check_each, .work = sample_one});
}

}  // namespace orispline::cli
