// SPDX-License-Identifier: Apache-2.0
#include "commands/align/align.hpp"

#include <memory>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/fields.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/jobs/align.hpp>
#include <orispline/jobs/align_rates.hpp>

#include "commands/align/align_recordings.hpp"
#include "options/option_text.hpp"
#include "output/found_output.hpp"
#include "output/keys_file.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  io::SampleColumns columns;
  orispline::AlignOptions alignment;
};

/// Standard input can be read once only.
Expected<void> check_streams(const AlignArguments& options) {
  if (options.input.path != io::standard_stream || options.reference != io::standard_stream) return {};
  return usage_failure("found '-' for INPUT and for REFERENCE, wanted it for one at most");
}

Expected<Request> request_in(const AlignArguments& options) {
  if (auto apart = check_streams(options); !apart) return tl::unexpected(std::move(apart.error()));
  FirstError checked;
  Request request{
      .input = checked(input_request(options.input)),
      .columns = checked(columns_of_made(options.output, options.summary, {"keys", "the aligned recording"},
                                         {{"INPUT", options.input.path}, {"REFERENCE", options.reference}})),
      .alignment = checked(options_in<orispline::AlignOptions>(options.alignment))};
  request.input.read.keep_exact_times = true;
  return std::move(checked).or_else(std::move(request));
}

/// What was found, or what was made and where it is. `made`: what is in the file.
template <class Outcome, class Write>
Expected<void> tell(const AlignArguments& options, Outcome outcome, const std::string& made, Write write) {
  warn(outcome.warnings);
  if (!writes_file(options.output))
    return print_found(options.summary, outcome, {{"input", options.input.path}, {"reference", options.reference}});
  return write(outcome).and_then([&] {
    return summarise(options.summary, Written{options.input.path, options.output.path, made, std::move(outcome)});
  });
}

Expected<void> align_orientations(const AlignArguments& options, const Request& request, io::TrackFile moved,
                                  io::TrackFile fixed) {
  const io::SampleColumns columns = columns_like(*moved.format, request.columns, options.output);
  auto outcome = jobs::align({.moved = std::make_shared<const Track>(std::move(moved.track)),
                              .fixed = std::make_shared<const Track>(std::move(fixed.track)),
                              .options = request.alignment});
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  return tell(options, std::move(*outcome), "keys",
              [&](const jobs::AlignOutcome& made) { return write_keys(options.output.path, made.aligned, columns); });
}

jobs::Recording recording_in(AlignedFile& file) {
  if (auto* const gyro = std::get_if<GyroTrack>(&file)) return std::make_shared<const GyroTrack>(std::move(*gyro));
  return std::make_shared<const Track>(std::move(std::get<io::TrackFile>(file).track));
}

/// Rates are written as CSV; the options of writing are about orientations.
Expected<void> check_rates_output(const OutputOptions& output) {
  for (const auto& [name, text] : output.writing)
    if (text)
      return usage_failure(
          formatted("{}: found INPUT of a gyro, wanted none: its rates are written as t,wx,wy,wz", flag_of(name)));
  return {};
}

Expected<void> align_by_rates(const AlignArguments& options, const Request& request, AlignedFile moved,
                              AlignedFile fixed) {
  const auto* const orientations = std::get_if<io::TrackFile>(&moved);
  const io::SampleColumns columns =
      orientations ? columns_like(*orientations->format, request.columns, options.output) : request.columns;
  if (!orientations)
    if (auto checked = check_rates_output(options.output); !checked) return checked;
  auto outcome =
      jobs::align_rates({.moved = recording_in(moved), .fixed = recording_in(fixed), .options = request.alignment});
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  return tell(options, std::move(*outcome), orientations ? "keys" : "rates", [&](const jobs::RateAlignOutcome& made) {
    if (const auto* const keys = std::get_if<Track>(&made.aligned))
      return write_keys(options.output.path, *keys, columns);
    return write_aligned_rates(options.output.path, std::get<GyroTrack>(made.aligned));
  });
}

}  // namespace

Expected<void> align(const AlignArguments& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  if (writes_file(options.output))
    if (auto able = check_output(options.output.path); !able) return able;
  auto moved = read_moved(request->input);
  if (!moved) return tl::unexpected(std::move(moved.error()));
  auto fixed = read_fixed(*moved, options.reference, request->input.read);
  if (!fixed) return tl::unexpected(std::move(fixed.error()));
  auto *const from = std::get_if<io::TrackFile>(&*moved), *const onto = std::get_if<io::TrackFile>(&*fixed);
  if (from && onto) return align_orientations(options, *request, std::move(*from), std::move(*onto));
  return align_by_rates(options, *request, std::move(*moved), std::move(*fixed));
}

}  // namespace orispline::cli
