// SPDX-License-Identifier: Apache-2.0
#include "commands/align/align.hpp"

#include <memory>
#include <utility>

#include <orispline/fields.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/jobs/align.hpp>

#include "options/file_places.hpp"
#include "output/keys_file.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  io::SampleColumns columns;
  orispline::AlignOptions alignment;
};

bool writes_file(const AlignArguments& options) { return !options.output.path.empty(); }

/// What is asked of the output.
Expected<io::SampleColumns> columns_in(const AlignArguments& options) {
  if (options.input.path == io::standard_stream && options.reference == io::standard_stream)
    return usage_failure("found '-' for INPUT and for REFERENCE, wanted it for one at most");
  if (writes_file(options))
    return check_summary(options.summary, options.output.path, "keys")
        .and_then([&] {
          return check_output_apart(options.output.option, options.output.path,
                                    {{"INPUT", options.input.path}, {"REFERENCE", options.reference}});
        })
        .and_then([&] { return output_columns(options.output); });
  if (options.summary.quiet) return usage_failure("--quiet: found no -o, wanted -o FILE for the aligned keys");
  for (const auto& [name, text] : options.output.writing)
    if (text) return usage_failure(flag_of(name) + ": found no -o, wanted -o FILE for the aligned keys");
  return io::SampleColumns();
}

Expected<Request> request_in(const AlignArguments& options) {
  FirstError checked;
  Request request{.input = checked(input_request(options.input)),
                  .columns = checked(columns_in(options)),
                  .alignment = checked(options_in<orispline::AlignOptions>(options.alignment))};
  request.input.read.keep_exact_times = true;
  return std::move(checked).or_else(std::move(request));
}

Expected<void> print(const AlignArguments& options, const jobs::AlignOutcome& outcome) {
  if (!options.summary.json) return print_document(summary_of(outcome));
  Json json{{"input", options.input.path}, {"reference", options.reference}};
  json.update(document_of(outcome));
  json["warnings"] = json_of_warnings();
  return print_document(document(json));
}

}  // namespace

Expected<void> align(const AlignArguments& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  if (writes_file(options))
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
  if (!writes_file(options)) return print(options, *outcome);
  return write_keys(options.output.path, outcome->aligned, columns).and_then([&] {
    return summarise(options.summary, Written{options.input.path, options.output.path, "keys", std::move(*outcome)});
  });
}

}  // namespace orispline::cli
