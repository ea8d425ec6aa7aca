// SPDX-License-Identifier: Apache-2.0
#include "reduce.hpp"

#include <cmath>
#include <utility>

#include "interruption.hpp"
#include "json.hpp"
#include "quantity.hpp"
#include "reduce_page.hpp"
#include "standard_output.hpp"

namespace orispline::cli {
namespace {

/// The command line, understood.
struct Request {
  InputRequest input;
  io::SampleColumns columns;
  std::optional<std::string_view> method;
  optimise::ReduceOptions reduction;
};

Expected<Request> request_in(const ReduceOptions& options) {
  FirstError checked;
  Request request{
      .input = checked(input_request(options.input)),
      .columns = checked(output_columns(options.output)),
      .method = checked(choice_of(reduce_choices)({"--method", options.method})),
      .reduction = {.tolerance = {.angle = checked(quantity_in({"--tolerance", options.tolerance}, angle_units))},
                    .values = options.refit ? optimise::KeyValues::refitted : optimise::KeyValues::sampled}};
  const auto position =
      checked(if_given("--position-tolerance", options.position_tolerance, quantity_of(length_units)));
  if (position) request.reduction.tolerance.position = *position;
  request.input.read.rate_orders = 0;
  request.input.read.keep_exact_times = true;
  auto read = std::move(checked).or_else(std::move(request));
  if (read && options.json && options.output.path == io::standard_stream)
    return usage_failure("--json: the summary goes to standard output, wanted -o FILE for the keys");
  if (auto fits = check_report(options.report, options.output.path); read && !fits)
    return tl::unexpected(std::move(fits.error()));
  return read;
}

/// The recording as it was read, and as it was checked.
struct Source {
  io::KeyFile file;  ///< without the samples
  std::vector<Eigen::Quaterniond> as_read;
  Keyframes samples;
};

Expected<Source> open_source(const Request& request, const ReduceOptions& options) {
  auto file = io::read_keys(request.input.path, request.input.read);
  if (!file) return tl::unexpected(std::move(file.error()));
  auto as_read = file->data.orientations;
  auto samples = Keyframes::make(std::exchange(file->data, {}), request.input.signs);
  if (!samples) return tl::unexpected(located(*file, samples.error()));
  if (samples->size() < 2)
    return failure(ErrorCode::bad_data, "found 1 sample, wanted 2 at least to keep the fewest that suffice",
                   {.file = file->path});
  if (options.position_tolerance && samples->positions().empty())
    return failure(ErrorCode::bad_data, "found no positions, wanted columns px,py,pz for --position-tolerance",
                   {.file = file->path});
  return Source{std::move(*file), std::move(as_read), std::move(*samples)};
}

/// By the method that was asked for, or by all.
Expected<std::vector<optimise::Reduction>> reductions_of(const Request& request, const Keyframes& samples) {
  if (!request.method) return optimise::reduce_by_each(optimise::reducing_methods, samples, request.reduction);
  return optimise::reduce_by_each(std::array{*request.method}, samples, request.reduction);
}

/// The digits of the file where the key is a sample of unit norm.
Eigen::Quaterniond written_quaternion(const Source& source, const optimise::Reduction& reduction, std::size_t key) {
  const Eigen::Quaterniond &found = reduction.keys.orientations()[key],
                           &as_read = source.as_read[reduction.samples[key]];
  const double sign = as_read.dot(found) < 0.0 ? -1.0 : 1.0;
  const Eigen::Quaterniond turned(sign * as_read.coeffs());
  const bool is_sample = std::abs(as_read.norm() - 1.0) <= unit_norm_tolerance &&
                         (turned.coeffs().normalized() - found.coeffs()).norm() <= 4e-16;
  return is_sample ? turned : found;
}

Expected<void> write_keys(io::SampleWriter& writer, const Source& source, const optimise::Reduction& reduction) {
  for (std::size_t key = 0; key < reduction.samples.size(); ++key) {
    io::Sample sample{.motion = {.orientation = written_quaternion(source, reduction, key)}};
    if (!reduction.keys.positions().empty()) sample.travel.position = reduction.keys.positions()[key];
    auto written = writer.write(source.file.exact_times[reduction.samples[key]], sample);
    if (written) continue;
    if (written.error().code != ErrorCode::bad_data) return written;
    written.error().where.key = reduction.samples[key];
    return tl::unexpected(located(source.file, std::move(written.error())));
  }
  return writer.finish();
}

}  // namespace

Expected<void> reduce(const ReduceOptions& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto page = ReportFile::open(options.report);
  if (!page) return tl::unexpected(std::move(page.error()));
  auto source = open_source(*request, options);
  if (!source) return tl::unexpected(std::move(source.error()));
  if (!source->samples.positions().empty() && !options.position_tolerance)
    warn("positions are carried along without a bound, wanted --position-tolerance LENGTH for one");
  auto reductions = reductions_of(*request, source->samples);
  if (!reductions) return tl::unexpected(std::move(reductions.error()));
  const std::size_t chosen = optimise::smallest(*reductions);
  ReduceReport report{.input = options.input.path,
                      .output = options.output.path,
                      .samples = source->samples.size(),
                      .repairs = source->file.repairs,
                      .options = request->reduction,
                      .reductions = std::move(*reductions),
                      .chosen = chosen,
                      .times = source->file.exact_times};
  const optimise::Reduction& written = report.reductions[chosen];
  request->columns.positions = !source->samples.positions().empty();
  request->columns.derivatives = 0;
  return page->write([&] { return page_of(report, source->samples, source->file.epoch, options.report); })
      .and_then([&] { return io::SampleWriter::open(options.output.path, request->columns, written.samples.size()); })
      .and_then([&](io::SampleWriter writer) {
        const RemovedWhenInterrupted unfinished(writer.part());
        return write_keys(writer, *source, written);
      })
      .and_then([&] { return page->finish(); })
      .and_then([&]() -> Expected<void> {
        if (options.json) return print_document(json_of(report));
        if (!options.quiet) tell(text_of(report));
        return {};
      });
}

}  // namespace orispline::cli
