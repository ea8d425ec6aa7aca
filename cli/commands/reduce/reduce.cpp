// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce.hpp"

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/reduce/clip_reduction.hpp>
#include <orispline/reduce/reduce_fields.hpp>

#include "commands/reduce/reduce_report.hpp"
#include "commands/reduce/reduce_scene.hpp"
#include "commands/reduce/reduce_track.hpp"
#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "options/threads.hpp"
#include "output/each_input.hpp"
#include "output/keys_file.hpp"
#include "output/noted_output.hpp"
#include "output/smoothing_text.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  io::SampleColumns columns;
  std::vector<Method> methods;
  orispline::ReduceOptions reduction;
  std::optional<orispline::SmoothOptions> smoothing;
  unsigned threads = 1;
};

/// What the files ask of each other.
Expected<void> agree(const ReduceOptions& options) {
  const OutputOptions& output = options.output;
  if (auto apart = check_output_apart(output.option, output.path, {{"INPUT", options.input.path}}); !apart)
    return apart;
  return check_summary(options.summary, output.path, "keys").and_then([&] {
    return check_report(options.report, {{place_of_output(output), output.path}, {"INPUT", options.input.path}});
  });
}

Expected<InputRequest> input_in(const ReduceOptions& options) {
  return input_request(options.input).map([](InputRequest request) {
    request.read.rate_orders = 0;
    request.read.keep_exact_times = true;
    return request;
  });
}

Expected<std::optional<orispline::SmoothOptions>> smoothing_wanted(const ReduceOptions& options) {
  if (!options.smooth && !any_given(options.smoothness)) return std::optional<orispline::SmoothOptions>();
  return smoothing_in(options.smoothness).map([](const orispline::SmoothOptions& found) {
    return std::optional(found);
  });
}

Expected<std::vector<Method>> methods_in(const ReduceOptions& options) {
  if (options.method != smallest_method)
    return method_request(options.method, options.shape).map([](Method method) {
      return std::vector{std::move(method)};
    });
  if (any_given(options.shape))
    return usage_failure("options that shape a curve want --method with one method as well");
  return std::vector<Method>(orispline::reducing_methods.begin(), orispline::reducing_methods.end());
}

Expected<io::SampleColumns> columns_in(const ReduceOptions& options) {
  return output_columns(options.output).and_then([&](io::SampleColumns columns) {
    return check_times_are_kept(*columns.format, options.output.option, "the tolerance").map([&] { return columns; });
  });
}

/// What makes sense for clips only.
Expected<void> check_no_clips(const ReduceOptions& options) {
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

Expected<Request> request_in(const ReduceOptions& options) {
  if (auto fits = check_no_clips(options); !fits) return tl::unexpected(std::move(fits.error()));
  FirstError checked;
  Request request{.input = checked(input_in(options)),
                  .columns = checked(columns_in(options)),
                  .methods = checked(methods_in(options)),
                  .reduction = checked(options_in<orispline::ReduceOptions>(options.reduction)),
                  .smoothing = checked(smoothing_wanted(options)),
                  .threads = static_cast<unsigned>(checked(threads_in(options.inputs.threads)))};
  if (request.methods.size() == 1)  // the settings of one method may stand in columns
    request.input.read.parameters = open_parameters(request.methods.front());
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  return agree(options).map([&] { return std::move(*read); });
}

Expected<void> check_positions(const ReducedTrack& track, const orispline::Tolerance& tolerance) {
  if (!track.samples().positions().empty()) {
    if (!tolerance.bounds_positions())
      warn("positions are kept but not checked; add --position-tolerance LENGTH to bound them");
    return {};
  }
  if (!tolerance.bounds_positions()) return {};
  return failure(ErrorCode::bad_data, "found no positions, wanted columns px,py,pz for --position-tolerance",
                 {.file = track.recording.track.name});
}

Expected<std::vector<orispline::Reduction>> reductions_of(const Request& request, const ReducedTrack& track) {
  auto found = orispline::reduce_tracks({&track.reduced, 1}, request.methods, request.reduction, request.threads);
  return std::move(found.front());
}

Expected<ReduceReport> report_of(const Request& request, const ReducedTrack& track,
                                 std::vector<orispline::Reduction> reductions) {
  const std::size_t chosen = orispline::smallest(reductions);
  ReduceReport report{.input = request.input.path,
                      .output = {},
                      .samples = track.samples().size(),
                      .repairs = track.recording.repairs,
                      .options = request.reduction,
                      .reductions = std::move(reductions),
                      .chosen = chosen,
                      .times = track.recording.track.exact_times,
                      .lines = track.recording.track.lines,
                      .smoothed = {}};
  if (!track.smoothing) return report;
  const orispline::Reduction& reduction = report.reductions[chosen];
  const Keyframes& raw = track.recording.track.keys;
  const auto distance = orispline::distance_of(reduction, raw, track.smoothing->rejected);
  if (!distance) return tl::unexpected(distance.error());
  SmoothedFirst smoothed{.smoothing = *track.smoothing, .raw = *distance};
  if (const auto& positions = track.smoothing->positions) {
    const auto of_positions = orispline::position_distance_of(reduction, raw, positions->rejected);
    if (!of_positions) return tl::unexpected(of_positions.error());
    smoothed.raw_positions = *of_positions;
  }
  report.smoothed = std::move(smoothed);
  return report;
}

Expected<ReduceReport> reduced(const Request& request, const ReducedTrack& track) {
  return reductions_of(request, track).and_then([&](std::vector<orispline::Reduction> reductions) {
    return report_of(request, track, std::move(reductions));
  });
}

Expected<void> write(const ReduceReport& report, const io::SampleColumns& columns) {
  const Track& keys = report.reductions[report.chosen].track;
  return check_settings_fit(keys, columns, report.output, "the tolerance holds").and_then([&] {
    io::SampleColumns filled = columns;
    filled.derivatives = keys.keys.angular_velocities().empty() ? 0 : 1;
    return write_keys(report.output, keys, filled);
  });
}

Expected<void> reduce_one(const ReduceOptions& options) {
  if (is_scene(options.output.path)) return reduce_scene(options);
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  if (auto able = check_output(options.output.path); !able) return able;
  const auto track = open_track(request->input, request->smoothing);
  if (!track)
    return tl::unexpected(
        or_all_of_them(said_of_cutoff(options.smoothness, track.error()), "an output such as all.glb"));
  warn(track->recording.warnings);
  if (auto checked = check_positions(*track, request->reduction.tolerance); !checked) return checked;
  if (track->smoothing) warn(remark_on(*track->smoothing, track->recording.track));
  request->columns = columns_like(*track->recording.format, request->columns, options.output);
  auto report = reduced(*request, *track);
  if (!report) return tl::unexpected(std::move(report.error()));
  report->output = options.output.path;
  const auto make_page = [&](const auto& head) {
    const auto smoothing_time = track->smoothing ? std::optional(track->smoothing->smoothing_time) : std::nullopt;
    return pages::reduce_page(track->reduced, report->reductions, request->reduction, head, smoothing_time);
  };
  return page->write(make_page)
      .and_then([&] { return write(*report, request->columns); })
      .and_then([&] { return page->finish(); })
      .and_then([&] { return summarise(options.summary, *report); });
}

}  // namespace

Expected<void> reduce(const ReduceOptions& options) {
  const auto check = [](const ReduceOptions& one) {
    return is_scene(one.output.path) ? check_reduce_scene(one) : request_in(one).map([](const Request&) {});
  };
  return on_inputs(options, {.written = "keys", .check = check, .work = reduce_one, .scenes = SceneOutputs::glb});
}

}  // namespace orispline::cli
