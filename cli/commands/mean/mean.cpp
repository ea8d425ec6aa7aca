// SPDX-License-Identifier: Apache-2.0
#include "commands/mean/mean.hpp"

#include <memory>
#include <utility>

#include <orispline/fields.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/jobs/mean.hpp>

#include "output/found_output.hpp"
#include "output/keys_file.hpp"
#include "output/repairs_text.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  io::SampleColumns columns;
  orispline::MeanOptions mean;
};

Expected<Request> request_in(const MeanArguments& options) {
  FirstError checked;
  Request request{.input = checked(input_request(options.input)),
                  .columns = checked(columns_of_made(options.output, options.summary, {"mean", "the mean"},
                                                     {{"INPUT", options.input.path}})),
                  .mean = checked(options_in<orispline::MeanOptions>(options.mean))};
  request.input.read.rate_orders = 0;
  request.input.read.count_rows = !request.mean.every;
  request.input.read.parameters = {std::string(jobs::weight_name)};
  return std::move(checked).or_else(std::move(request));
}

}  // namespace

Expected<void> mean(const MeanArguments& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  if (writes_file(options.output))
    if (auto able = check_output(options.output.path); !able) return able;
  auto file = io::read_track(request->input.path, request->input.read, request->input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  warn(file->warnings);
  io::SampleColumns columns = columns_like(*file->format, request->columns, options.output);
  columns.derivatives = 0;
  auto outcome = jobs::mean({.rows = std::make_shared<const Track>(std::move(file->track)),
                             .options = request->mean,
                             .has_times = !request->input.read.count_rows});
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  outcome->mended = text_of(file->repairs);
  warn(outcome->warnings);
  if (!writes_file(options.output)) return print_found(options.summary, *outcome, {{"input", options.input.path}});
  return write_keys(options.output.path, outcome->track(), columns).and_then([&] {
    return summarise(options.summary, Written{options.input.path, options.output.path, "mean", std::move(*outcome)});
  });
}

}  // namespace orispline::cli
