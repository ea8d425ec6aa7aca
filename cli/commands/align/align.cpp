// SPDX-License-Identifier: Apache-2.0
#include "commands/align/align.hpp"

#include <memory>
#include <utility>

#include <orispline/fields.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/jobs/align.hpp>

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
      .columns = checked(columns_of_made(options.output, options.summary, {"keys", "the aligned keys"},
                                         {{"INPUT", options.input.path}, {"REFERENCE", options.reference}})),
      .alignment = checked(options_in<orispline::AlignOptions>(options.alignment))};
  request.input.read.keep_exact_times = true;
  return std::move(checked).or_else(std::move(request));
}

}  // namespace

Expected<void> align(const AlignArguments& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  if (writes_file(options.output))
    if (auto able = check_output(options.output.path); !able) return able;
  auto file = io::read_track(request->input.path, request->input.read, request->input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  warn(file->warnings);
  auto reference = io::read_track_beside(*file, options.reference, request->input.read);
  if (!reference) return tl::unexpected(std::move(reference.error()));
  warn(reference->warnings);
  const io::SampleColumns columns = columns_like(*file->format, request->columns, options.output);
  auto outcome = jobs::align({.moved = std::make_shared<const Track>(std::move(file->track)),
                              .fixed = std::make_shared<const Track>(std::move(reference->track)),
                              .options = request->alignment});
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  warn(outcome->warnings);
  if (!writes_file(options.output))
    return print_found(options.summary, *outcome, {{"input", options.input.path}, {"reference", options.reference}});
  return write_keys(options.output.path, outcome->aligned, columns).and_then([&] {
    return summarise(options.summary, Written{options.input.path, options.output.path, "keys", std::move(*outcome)});
  });
}

}  // namespace orispline::cli
