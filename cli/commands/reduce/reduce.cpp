// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/io/track_writer.hpp>
#include <orispline/pages/reduce_page.hpp>
#include <orispline/reduce/reduce_fields.hpp>

#include "commands/reduce/reduce_report.hpp"
#include "commands/reduce/reduce_track.hpp"
#include "options/file_places.hpp"
#include "options/threads.hpp"
#include "output/output_folder.hpp"
#include "output/smoothing_text.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {
namespace {

/// The command line, understood.
struct Request {
  std::vector<InputRequest> inputs;
  std::vector<std::string> outputs;        ///< one for each input
  std::vector<io::SampleColumns> columns;  ///< of each output
  std::vector<Method> methods;
  orispline::ReduceOptions reduction;
  std::optional<orispline::SmoothOptions> smoothing;
  unsigned threads = 1;
};

/// What the options ask of each other.
Expected<void> agree(const ReduceOptions& options, const Request& request) {
  const bool to_standard_output = options.output.path == io::standard_stream;
  if (options.folder && !to_standard_output)
    return usage_failure("found -o and --output-folder, wanted one of them: a file for the keys, or their folder");
  if (!options.folder && options.inputs.size() > 1)
    return usage_failure(
        formatted("found {} inputs, wanted --output-folder FOLDER for their keys", options.inputs.size()));
  if (!options.folder)
    if (auto fits = check_summary(options.summary, options.output.path, "keys"); !fits) return fits;
  if (auto apart = check_output_apart("-o", request.outputs.front(), {{"INPUT", options.inputs.front()}}); !apart)
    return apart;
  if (options.report.path && options.inputs.size() > 1)
    return usage_failure(
        formatted("--report: found {} inputs, wanted one: a page shows one recording", options.inputs.size()));
  return check_report(options.report, {{options.folder ? "that of the keys" : "that of -o", request.outputs.front()},
                                       {"INPUT", options.inputs.front()}});
}

Expected<std::vector<InputRequest>> inputs_in(const ReduceOptions& options) {
  std::vector<InputRequest> inputs;
  for (const std::string& path : options.inputs) {
    InputOptions input = options.input;
    input.path = path;
    auto request = input_request(input);
    if (!request) return tl::unexpected(std::move(request.error()));
    request->read.rate_orders = 0;
    request->read.keep_exact_times = true;
    inputs.push_back(std::move(*request));
  }
  return inputs;
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

/// Every file in the format of its name, unless one is asked for.
Expected<std::vector<io::SampleColumns>> columns_in(const ReduceOptions& options,
                                                    const std::vector<std::string>& outputs) {
  std::vector<io::SampleColumns> columns;
  for (const std::string& path : outputs) {
    OutputOptions output = options.output;
    output.path = path;
    const auto found = output_columns(output);
    if (!found) return tl::unexpected(found.error());
    if (auto kept = check_times_are_kept(*found->format, options.folder ? "--output-folder" : "-o", "the tolerance");
        !kept)
      return tl::unexpected(std::move(kept.error()));
    columns.push_back(*found);
  }
  return columns;
}

Expected<std::vector<std::string>> outputs_of(const ReduceOptions& options) {
  if (!options.folder) return std::vector{options.output.path};
  if (options.folder->empty()) return usage_failure("--output-folder: found an empty name, wanted FOLDER");
  return output_format(options.output).and_then([&](std::optional<const io::FormatInfo*> format) {
    return outputs_in(*options.folder, options.inputs, format.value_or(nullptr));
  });
}

Expected<Request> request_in(const ReduceOptions& options) {
  FirstError checked;
  Request request{.inputs = checked(inputs_in(options)),
                  .outputs = checked(outputs_of(options)),
                  .columns = {},
                  .methods = {},
                  .reduction = {},
                  .smoothing = {},
                  .threads = static_cast<unsigned>(checked(threads_in(options.threads)))};
  request.columns = checked(columns_in(options, request.outputs));
  request.methods = checked(methods_in(options));
  request.reduction = checked(options_in<orispline::ReduceOptions>(options.reduction));
  request.smoothing = checked(smoothing_wanted(options));
  if (request.methods.size() == 1)  // the settings of one method may stand in columns
    for (InputRequest& input : request.inputs) input.read.parameters = open_parameters(request.methods.front());
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  return agree(options, *read).map([&] { return std::move(*read); });
}

/// All of them, or the first complaint.
Expected<std::vector<ReducedTrack>> open_tracks(const Request& request) {
  std::vector<std::optional<Expected<ReducedTrack>>> opened(request.inputs.size());
  parallel_for(opened.size(), request.threads,
               [&](std::size_t i) { opened[i] = open_track(request.inputs[i], request.smoothing); });
  std::vector<ReducedTrack> tracks;
  for (auto& found : opened) {
    Expected<ReducedTrack>& track = *found;
    if (!track) return tl::unexpected(std::move(track.error()));
    tracks.push_back(std::move(*track));
    if (request.reduction.tolerance.bounds_positions() && tracks.back().samples().positions().empty())
      return failure(ErrorCode::bad_data, "found no positions, wanted columns px,py,pz for --position-tolerance",
                     {.file = tracks.back().recording.track.name});
  }
  return tracks;
}

void warn_of(const std::vector<ReducedTrack>& tracks, const Request& request) {
  const auto has_positions = [](const ReducedTrack& track) { return !track.samples().positions().empty(); };
  if (!request.reduction.tolerance.bounds_positions() && std::ranges::any_of(tracks, has_positions))
    warn("positions are kept but not checked; add --position-tolerance LENGTH to bound them");
  for (const ReducedTrack& track : tracks) {
    warn(track.recording.warnings);
    if (!track.smoothing) continue;
    auto remarks = remark_on(*track.smoothing, track.recording.track);
    if (tracks.size() > 1)
      for (Warning& remark : remarks) remark.where.file = track.recording.track.name;
    warn(remarks);
  }
}

Expected<std::vector<std::vector<orispline::Reduction>>> reductions_of(const Request& request,
                                                                       const std::vector<ReducedTrack>& tracks) {
  std::vector<Track> samples;
  for (const ReducedTrack& track : tracks) samples.push_back(track.reduced);
  std::vector<std::vector<orispline::Reduction>> reductions;
  auto found = orispline::reduce_tracks(samples, request.methods, request.reduction, request.threads);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!found[i] && tracks.size() == 1) return tl::unexpected(std::move(found[i].error()));
    if (!found[i]) return tl::unexpected(tracks[i].recording.track.located(std::move(found[i].error())));
    reductions.push_back(std::move(*found[i]));
  }
  return reductions;
}

Expected<ReduceReport> report_of(const Request& request, std::size_t i, const ReducedTrack& track,
                                 std::vector<orispline::Reduction> reductions) {
  const std::size_t chosen = orispline::smallest(reductions);
  ReduceReport report{.input = request.inputs[i].path,
                      .output = request.outputs[i],
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

/// Of all tracks, in their order.
Expected<std::vector<ReduceReport>> reports_of(const Request& request, const std::vector<ReducedTrack>& tracks) {
  auto reductions = reductions_of(request, tracks);
  if (!reductions) return tl::unexpected(std::move(reductions.error()));
  std::vector<ReduceReport> reports;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    auto report = report_of(request, i, tracks[i], std::move((*reductions)[i]));
    if (!report) return tl::unexpected(tracks[i].recording.track.located(std::move(report.error())));
    reports.push_back(std::move(*report));
  }
  return reports;
}

/// Before the work: a folder that is not there is only made with the outputs.
Expected<void> check_outputs(const Request& request, const ReduceOptions& options) {
  if (options.folder)
    if (auto able = check_folder(*options.folder); !able || !std::filesystem::exists(*options.folder)) return able;
  for (const std::string& output : request.outputs)
    if (auto able = io::check_output(output); !able) return able;
  return {};
}

/// All or none.
Expected<void> write_all(const Request& request, const std::vector<ReduceReport>& reports) {
  std::vector<Noted<io::OutputFile>> outputs;
  for (std::size_t i = 0; i < reports.size(); ++i) {
    auto output = write_keys(reports[i].output, request.columns[i], reports[i].reductions[reports[i].chosen].track);
    if (!output) return tl::unexpected(std::move(output.error()));
    outputs.push_back(std::move(*output));
  }
  for (Noted<io::OutputFile>& output : outputs)
    if (auto finished = output.file.finish(); !finished) return finished;
  std::vector<Warning> warnings;
  for (std::size_t i = 0; i < reports.size(); ++i)
    if (auto unstated = io::recipe_not_stated(reports[i].reductions[reports[i].chosen].track, request.columns[i],
                                              reports[i].output))
      warnings.push_back(std::move(*unstated));
  warn(warnings);
  return {};
}

}  // namespace

Expected<void> reduce(const ReduceOptions& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  if (auto able = check_outputs(*request, options); !able) return able;
  const auto tracks = open_tracks(*request);
  if (!tracks) return tl::unexpected(said_of_cutoff(options.smoothness, tracks.error()));
  for (std::size_t i = 0; i < tracks->size(); ++i) {
    OutputOptions output = options.output;
    output.path = request->outputs[i];
    request->columns[i] = columns_like(*(*tracks)[i].recording.format, request->columns[i], output);
  }
  warn_of(*tracks, *request);
  const auto reports = reports_of(*request, *tracks);
  if (!reports) return tl::unexpected(reports.error());
  if (options.folder)
    if (auto made = make_folder(*options.folder); !made) return made;
  const ReducedTrack& first = tracks->front();
  const auto make_page = [&](const auto& head) {
    const auto smoothing_time = first.smoothing ? std::optional(first.smoothing->smoothing_time) : std::nullopt;
    return pages::reduce_page(first.reduced, reports->front().reductions, request->reduction, head, smoothing_time);
  };
  return page->write(make_page)
      .and_then([&] { return write_all(*request, *reports); })
      .and_then([&] { return page->finish(); })
      .and_then([&] {
        return options.folder ? summarise(options.summary, std::span(*reports))
                              : summarise(options.summary, reports->front());
      });
}

}  // namespace orispline::cli
