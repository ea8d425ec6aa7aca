// SPDX-License-Identifier: Apache-2.0
#include "retime.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <orispline/families/registry.hpp>
#include <orispline/tune/tune.hpp>

#include "compare_request.hpp"
#include "interruption.hpp"
#include "json.hpp"
#include "quantity.hpp"
#include "retime_page.hpp"

namespace orispline::cli {
namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  io::SampleColumns columns;
  orispline::MotionLimits limits;
  orispline::Slowing slowing;
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
                  .columns = checked(output_columns(options.output)),
                  .limits = {.rate = checked(if_given("--max-rate", options.rate, quantity_of(rate_units))),
                             .acceleration = checked(
                                 if_given("--max-acceleration", options.acceleration, quantity_of(acceleration_units))),
                             .torque = checked(if_given("--max-torque", options.torque, quantity_of(torque_units))),
                             .inertia = checked(if_given("--inertia", options.inertia, inertia_in))},
                  .slowing = options.per_interval ? orispline::Slowing::per_interval : orispline::Slowing::uniform};
  request.input.read.rate_orders = 0;
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  if (auto agreed = agree(options); !agreed) return tl::unexpected(std::move(agreed.error()));
  return check_times_are_kept(read->columns.format, "-o", "the limits").map([&] { return std::move(*read); });
}

Expected<void> write_keys(io::SampleWriter& writer, const io::KeyFile& file, const Keyframes& keys,
                          const orispline::Retiming& retiming) {
  for (std::size_t key = 0; key < keys.size(); ++key) {
    io::Sample sample{.motion = {.orientation = keys.orientations()[key]}};
    if (!keys.positions().empty()) sample.linear_motion.position = keys.positions()[key];
    auto written = writer.write(file.epoch + io::Decimal::from_double(retiming.times[key]), sample);
    if (!written) return written;
  }
  return writer.finish();
}

/// With the place in the file, unless the command line alone is at fault.
Error placed(const io::KeyFile& file, Error error) {
  const bool concerns_file = error.code != ErrorCode::bad_argument || error.where.key;
  return concerns_file ? located(file, std::move(error)) : error;
}

/// The file's columns that are not written: those that shape the curve are refused, for the limits would not hold of
/// the curve that they shape.
Expected<void> check_columns_left_out(const io::KeyFile& file, const std::string& method) {
  const auto family = find_family(method);
  if (!family) return tl::unexpected(family.error());
  for (const Parameter& parameter : (*family)->parameters)
    if (std::ranges::find(file.ignored_columns, parameter.name) != file.ignored_columns.end())
      return failure(ErrorCode::bad_data,
                     fmt::format("found the column {}, which shapes the curve of {}, wanted none: the limits are kept "
                                 "with its default value",
                                 parameter.name, method),
                     {.file = file.path});
  if (!file.ignored_columns.empty()) warn(fmt::format("not carried over: {}", fmt::join(file.ignored_columns, ", ")));
  return {};
}

}  // namespace

Expected<void> retime(const RetimeOptions& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  if (auto writable = io::check_output(options.output.path); !writable) return writable;
  auto file = io::read_keys(request->input.path, request->input.read);
  if (!file) return tl::unexpected(std::move(file.error()));
  const auto keys = Keyframes::make(std::exchange(file->data, {}), request->input.signs);
  if (!keys) return tl::unexpected(located(*file, keys.error()));
  if (auto checked = check_columns_left_out(*file, options.method); !checked) return checked;
  if (request->limits.inertia) warn_unless_rigid(*request->limits.inertia);
  auto retiming = orispline::retime(options.method, *keys, request->limits, request->slowing);
  if (!retiming) return tl::unexpected(placed(*file, std::move(retiming.error())));
  const RetimeReport report{.input = options.input.path,
                            .output = options.output.path,
                            .method = options.method,
                            .limits = request->limits,
                            .slowing = request->slowing,
                            .duration_before = keys->times().back() - keys->times().front(),
                            .retiming = std::move(*retiming)};
  request->columns.positions = !keys->positions().empty();
  request->columns.derivatives = 0;
  return page->write([&] { return page_of(report, *keys, file->epoch, options.report); })
      .and_then([&] { return io::SampleWriter::open(options.output.path, request->columns, keys->size()); })
      .and_then([&](io::SampleWriter writer) {
        const RemovedWhenInterrupted unfinished(writer.part());
        return write_keys(writer, *file, *keys, report.retiming);
      })
      .and_then([&] { return page->finish(); })
      .and_then([&] { return summarise(options.summary, report); });
}

}  // namespace orispline::cli
