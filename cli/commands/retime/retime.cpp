// SPDX-License-Identifier: Apache-2.0
#include "commands/retime/retime.hpp"

#include <algorithm>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/pages/retime_page.hpp>
#include <orispline/tune/tune.hpp>

#include "commands/retime/retime_report.hpp"
#include "options/inertia.hpp"
#include "options/quantity.hpp"
#include "output/keys_file.hpp"

namespace orispline::cli {
namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  Method method;
  io::SampleColumns columns;
  orispline::RetimeOptions retiming;
};

Expected<void> agree(const RetimeOptions& options) {
  if (!options.rate && !options.acceleration && !options.torque)
    return usage_failure("found no limit, wanted --max-rate, --max-acceleration or --max-torque");
  if (options.torque && !options.inertia) return usage_failure("--max-torque: wanted --inertia JX,JY,JZ as well");
  if (options.inertia && !options.torque) return usage_failure("--inertia: wanted --max-torque as well");
  return check_summary(options.summary, options.output.path, "keys").and_then([&] {
    return check_report(options.report, {{"that of -o", options.output.path}, {"INPUT", options.input.path}});
  });
}

Expected<Request> request_in(const RetimeOptions& options) {
  FirstError checked;
  Request request{.input = checked(input_request(options.input)),
                  .method = checked(method_request(options.method, options.shape)),
                  .columns = checked(output_columns(options.output)),
                  .retiming = {}};
  request.retiming = {.limits = {.rate = checked(if_given("--max-rate", options.rate, quantity_of(rate_units))),
                                 .acceleration = checked(if_given("--max-acceleration", options.acceleration,
                                                                  quantity_of(acceleration_units))),
                                 .torque = checked(if_given("--max-torque", options.torque, quantity_of(torque_units))),
                                 .inertia = checked(if_given("--inertia", options.inertia, inertia_in))},
                      .slowing = options.per_interval ? orispline::Slowing::per_interval : orispline::Slowing::uniform};
  request.input.read.rate_orders = 0;
  request.input.read.keep_as_read = true;
  request.input.read.parameters = open_parameters(request.method);
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  if (auto agreed = agree(options); !agreed) return tl::unexpected(std::move(agreed.error()));
  return check_times_are_kept(*read->columns.format, "-o", "the limits").map([&] { return std::move(*read); });
}

/// Settings with a value per key belong to the curve for which the limits hold: they are written as columns.
Expected<void> check_settings(const Track& track, const io::SampleColumns& columns) {
  if (track.settings.empty() || columns.format->holds.settings) return {};
  return usage_failure(formatted("-o: {} has no column for {}, with which the limits hold, wanted {}",
                                 columns.format->file, track.settings.begin()->first, formats_for_settings()));
}

}  // namespace

Expected<void> retime(const RetimeOptions& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  if (auto writable = io::check_output(options.output.path); !writable) return writable;
  const auto file = io::read_track(request->input.path, request->input.read, request->input.signs);
  if (!file) return tl::unexpected(file.error());
  const Track& track = file->track;
  if (!file->ignored_columns.empty()) warn(formatted("not carried over: {}", joined(file->ignored_columns, ", ")));
  const orispline::MotionLimits& limits = request->retiming.limits;
  if (limits.inertia) warn_if_any(inertia_warning(*limits.inertia));
  auto retiming = orispline::retime(track, request->method, request->retiming);
  if (!retiming) return tl::unexpected(placed(track, std::move(retiming.error())));
  if (auto held = check_settings(retiming->track, request->columns); !held) return held;
  const RetimeReport report{.input = options.input.path,
                            .output = options.output.path,
                            .limits = limits,
                            .slowing = request->retiming.slowing,
                            .duration_before = track.keys.times().back() - track.keys.times().front(),
                            .retiming = std::move(*retiming)};
  return page->write([&](const auto& head) { return pages::retime_page(track, report.retiming, limits, head); })
      .and_then([&] { return write_keys(options.output.path, report.retiming.track, request->columns); })
      .and_then([&] { return page->finish(); })
      .and_then([&] { return summarise(options.summary, report); });
}

}  // namespace orispline::cli
