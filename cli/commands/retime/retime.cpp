// SPDX-License-Identifier: Apache-2.0
#include "commands/retime/retime.hpp"

#include <memory>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/fields.hpp>
#include <orispline/jobs/retime.hpp>

#include "options/file_places.hpp"
#include "output/each_input.hpp"
#include "output/keys_file.hpp"
#include "output/noted_output.hpp"

namespace orispline::cli {

namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  std::optional<Method> named;
  io::SampleColumns columns;
  orispline::RetimeOptions retiming;
};

/// What the files ask of each other.
Expected<void> agree(const RetimeArguments& options) {
  if (auto apart = check_output_apart(options.output.option, options.output.path, {{"INPUT", options.input.path}});
      !apart)
    return apart;
  return check_summary(options.summary, options.output.path, "keys").and_then([&] {
    return check_report(options.report,
                        {{place_of_output(options.output), options.output.path}, {"INPUT", options.input.path}});
  });
}

Expected<Request> request_in(const RetimeArguments& options) {
  FirstError checked;
  Request request{.input = checked(input_request(options.input)),
                  .named = checked(named_method(options.method, options.shape)),
                  .columns = checked(output_columns(options.output)),
                  .retiming = checked(options_in<orispline::RetimeOptions>(options.retiming))};
  request.input.read.rate_orders = 0;
  request.input.read.keep_as_read = true;
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  return check(read->retiming)
      .and_then([&] { return agree(options); })
      .and_then([&] { return check_times_are_kept(*read->columns.format, options.output.option, "the limits"); })
      .map([&] { return std::move(*read); });
}

Expected<void> retime_one(const RetimeArguments& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  if (auto writable = check_output(options.output.path); !writable) return writable;
  auto input = io::KeyInput::open(request->input.path, request->input.read);
  if (!input) return tl::unexpected(std::move(input.error()));
  auto chosen = chosen_method(request->named, options.shape, *input, jobs::usual_retimed);
  if (!chosen) return tl::unexpected(std::move(chosen.error()));
  warn(std::exchange(chosen->warnings, {}));
  request->input.read.parameters = open_parameters(chosen->method);
  auto file = io::read_track(std::move(*input), request->input.read, request->input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  warn(file->warnings);
  const io::SampleColumns columns = columns_like(*file->format, request->columns, options.output);
  if (!file->ignored_columns.empty())
    warn({{.code = "columns_left_out",
           .message = formatted("the output leaves out the columns {}", joined(file->ignored_columns, ", "))}});
  auto outcome = jobs::retime({.keys = std::make_shared<const Track>(std::move(file->track)),
                               .method = std::move(*chosen),
                               .options = request->retiming});
  if (!outcome) return tl::unexpected(std::move(outcome.error()));
  warn(outcome->warnings);
  const Track& retimed = outcome->retiming.track;
  if (auto fit = check_settings_fit(retimed, columns, options.output.option, "the limits hold"); !fit) return fit;
  return page->write([&](const auto& head) { return page_of(*outcome, head); })
      .and_then([&] { return write_keys(options.output.path, retimed, columns); })
      .and_then([&] { return page->finish(); })
      .and_then([&] {
        return summarise(options.summary,
                         Written{options.input.path, options.output.path, "keys", std::move(*outcome)});
      });
}

}  // namespace

Expected<void> retime(const RetimeArguments& options) {
  const auto check = [](const RetimeArguments& one) { return request_in(one).map([](const Request&) {}); };
  return on_inputs(options, {.written = "keys", .check = check, .work = retime_one});
}

}  // namespace orispline::cli
