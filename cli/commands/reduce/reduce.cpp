// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce.hpp"

#include <memory>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/fields.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/jobs/reduce.hpp>

#include "commands/reduce/reduce_scene.hpp"
#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/each_input.hpp"
#include "output/keys_file.hpp"
#include "output/noted_output.hpp"
#include "output/repairs_text.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  io::SampleColumns columns;
  jobs::ReduceRequest job;
};

Expected<InputRequest> input_in(const ReduceArguments& options) {
  return input_request(options.input).map([](InputRequest request) {
    request.read.rate_orders = 0;
    request.read.keep_exact_times = true;
    request.read.keep_as_read = true;
    return request;
  });
}

Expected<std::optional<orispline::SmoothOptions>> smoothing_wanted(const ReduceArguments& options) {
  if (!options.smooth && !any_given(options.smoothness)) return std::optional<orispline::SmoothOptions>();
  return smoothing_in(options.smoothness).map([](const orispline::SmoothOptions& found) {
    return std::optional(found);
  });
}

Expected<std::vector<Method>> methods_in(const ReduceArguments& options) {
  if (options.method != smallest_method)
    return method_request(options.method, options.shape).map([](Method method) {
      return std::vector{std::move(method)};
    });
  if (any_given(options.shape))
    return usage_failure("options that shape a curve want --method with one method as well");
  return jobs::ReduceRequest().methods;
}

Expected<io::SampleColumns> columns_in(const ReduceArguments& options) {
  return output_columns(options.output).and_then([&](io::SampleColumns columns) {
    return check_times_are_kept(*columns.format, options.output.option, "the tolerance").map([&] { return columns; });
  });
}

/// What makes sense for clips only.
Expected<void> check_no_clips(const ReduceArguments& options) {
  for (const auto& [name, text] : options.scene)
    if (text)
      return usage_failure(
          formatted("{}: found keys of one track, wanted a glTF output, such as small.glb", flag_of(name)));
  if (options.position_scale)
    return usage_failure("--position-scale: found keys of one track, wanted a glTF output, such as small.glb");
  if (options.closed)
    return usage_failure("--closed: found keys of one track, wanted a glTF output, such as small.glb");
  if (options.method == cubicspline_method)
    return usage_failure(
        "--method: found 'cubicspline' for keys of one track, wanted a glTF output, such as small.glb");
  if (is_given(options.reduction, "tolerance")) return {};
  return usage_failure("reduce: --tolerance is missing; 'orispline help reduce' shows what to type");
}

Expected<Request> request_in(const ReduceArguments& options) {
  if (auto fits = check_no_clips(options); !fits) return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  Request request{.input = checked(input_in(options)),
                  .columns = checked(columns_in(options)),
                  .job = {.recordings = {},
                          .methods = checked(methods_in(options)),
                          .options = checked(options_in<orispline::ReduceOptions>(options.reduction)),
                          .smoothing = checked(smoothing_wanted(options)),
                          .threads = static_cast<unsigned>(checked(threads_in(options.inputs.threads)))}};
  if (request.job.methods.size() == 1)  // the settings of one method may stand in columns
    request.input.read.parameters = open_parameters(request.job.methods.front());
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  return check_files(options).map([&] { return std::move(*read); });
}

/// What is wrong in the words of files and of the command.
Error in_words(const ReduceArguments& options, Error error) {
  if (error.code == ErrorCode::bad_data && error.option == "position_tolerance") {
    error.message = "found no positions, wanted columns px,py,pz for `position_tolerance`";
    error.option.clear();
  }
  return said_of_cutoff(options.smoothness, std::move(error));
}

Expected<jobs::ReduceOutcome> reduced(const ReduceArguments& options, jobs::ReduceRequest request, io::TrackFile file) {
  request.recordings = {std::make_shared<const Track>(std::move(file.track))};
  auto outcome = std::move(jobs::reduce(request).front());
  if (!outcome) return tl::unexpected(in_words(options, std::move(outcome.error())));
  outcome->mended = cli::text_of(file.repairs);
  return outcome;
}

/// The keys of the best curve, and where they were written.
struct ReducedKeys : Written<jobs::ReduceOutcome> {};

std::string text_of(const ReducedKeys& written) {
  const Reduction& chosen = written.outcome.chosen();
  return summary_of(written.outcome) + formatted("{} written to {}; they are for --method {}\n",
                                                 counted(chosen.samples.size(), "key"), destination(written.output),
                                                 chosen.method.name);
}

Expected<void> write(const Track& keys, const std::string& path, io::SampleColumns columns) {
  columns.derivatives = keys.keys.angular_velocities().empty() ? 0 : 1;
  return check_settings_fit(keys, columns, path, "the tolerance holds").and_then([&] {
    return write_keys(path, keys, columns);
  });
}

Expected<void> reduce_one(const ReduceArguments& options) {
  if (is_scene(options.output.path)) return reduce_scene(options);
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  if (auto able = check_output(options.output.path); !able) return able;
  auto file = io::read_track(request->input.path, request->input.read, request->input.signs);
  if (!file) return tl::unexpected(or_all_of_them(std::move(file.error()), "an output such as all.glb"));
  warn(file->warnings);
  const io::SampleColumns columns = columns_like(*file->format, request->columns, options.output);
  auto outcome = reduced(options, std::move(request->job), std::move(*file));
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  warn(outcome->warnings);
  return page->write([&](const auto& head) { return page_of(*outcome, head); })
      .and_then([&] { return write(outcome->chosen().track, options.output.path, columns); })
      .and_then([&] { return page->finish(); })
      .and_then([&] {
        return summarise(options.summary,
                         ReducedKeys{{options.input.path, options.output.path, "keys", std::move(*outcome)}});
      });
}

}  // namespace

Expected<void> check_files(const ReduceArguments& options) {
  const OutputOptions& output = options.output;
  return check_output_apart(output.option, output.path, {{"INPUT", options.input.path}})
      .and_then([&] { return check_summary(options.summary, output.path, "keys"); })
      .and_then([&] {
        return check_report(options.report, {{place_of_output(output), output.path}, {"INPUT", options.input.path}});
      });
}

Expected<void> reduce(const ReduceArguments& options) {
  const auto check = [](const ReduceArguments& one) {
    return is_scene(one.output.path) ? check_reduce_scene(one) : request_in(one).map([](const Request&) {});
  };
  return on_inputs(options, {.written = "keys", .check = check, .work = reduce_one, .scenes = SceneOutputs::glb});
}

}  // namespace orispline::cli
