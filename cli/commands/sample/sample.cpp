// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample.hpp"

#include <algorithm>

#include "commands/sample/sample_report.hpp"
#include "commands/sample/sampling.hpp"
#include "options/threads.hpp"
#include "output/interruption.hpp"
#include "output/progress.hpp"
#include "output/standard_output.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/families/method_warnings.hpp>

namespace orispline::cli {
namespace {

constexpr int default_csv_derivatives = 2;
constexpr int most_position_derivatives = 2;  // of the path: velocity and acceleration

/// The command line, understood.
struct Request {
  InputRequest input;
  Method method;
  TimeRequest times;
  io::SampleColumns columns;
  Extrapolation extrapolation = Extrapolation::hold;
  std::size_t threads = 1;
};

Expected<int> derivatives_in(OptionText option) {
  const auto order = count_in(option, 0);
  if (!order || *order > 3) return wanted(option, "0, 1, 2 or 3");
  return static_cast<int>(*order);
}

Expected<io::SampleColumns> columns_in(const SampleOptions& options) {
  FirstError checked;
  auto columns = checked(output_columns(options.output));
  const auto derivatives = checked(if_given("--derivatives", options.derivatives, derivatives_in));
  const auto frame = checked(if_given("--frame", options.frame, choice_of(frame_choices)));
  const bool holds_rates = columns.format->holds.rates;
  columns.derivatives = derivatives.value_or(holds_rates ? default_csv_derivatives : 0);
  columns.frame = frame.value_or(io::Frame::body);
  auto read = std::move(checked).or_else(std::move(columns));
  if (!read || holds_rates) return read;
  const auto refused = [&](OptionText option, std::string_view only) {
    return wanted(option, formatted("{} for {}, which has no columns for rates", only, read->format->file));
  };
  if (read->derivatives > 0) return refused({"--derivatives", *options.derivatives}, "0");
  if (read->frame == io::Frame::world) return refused({"--frame", *options.frame}, "body");
  return read;
}

/// Standard input can be read once only.
bool reads_standard_input_twice(const SampleOptions& options) {
  const int readers = (options.input.path == io::standard_stream) + (options.times.list == io::standard_stream) +
                      (options.truth == io::standard_stream);
  return readers > 1;
}

Expected<Request> request_in(const SampleOptions& options) {
  FirstError checked;
  Request request{
      .input = checked(input_request(options.input)),
      .method = checked(method_request(options.method, options.shape)),
      .times = checked(time_request(options.times)),
      .columns = checked(columns_in(options)),
      .extrapolation = checked(if_given("--extrapolate", options.extrapolate, choice_of(extrapolation_choices)))
                           .value_or(Extrapolation::hold),
      .threads = checked(threads_in(options.threads))};
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  if (auto fits = check_summary(options.summary, options.output.path, "samples"); !fits)
    return tl::unexpected(std::move(fits.error()));
  if (reads_standard_input_twice(options))
    return usage_failure("found '-' for several of INPUT, --times and --truth, wanted it for one at most");
  read->input.read.parameters = open_parameters(read->method);
  read->input.read.rate_orders = family_of(read->method).rate_orders;
  read->input.read.world_rates = true;
  return read;
}

/// The keys, read and turned into a curve.
struct Source {
  io::TrackFile file;
  PoseCurve curve;
  SampleTimes times;
};

std::size_t rate_orders_of(const Keyframes& keys) {
  const std::array rates{keys.angular_velocities(), keys.angular_accelerations(), keys.angular_jerks()};
  return static_cast<std::size_t>(std::ranges::count_if(rates, [](const auto& values) { return !values.empty(); }));
}

Expected<Source> open_source(const Request& request) {
  auto file = io::read_track(request.input.path, request.input.read, request.input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  const Track& track = file->track;
  auto curve = shaped_curve(request.method, track);
  if (!curve) return tl::unexpected(std::move(curve.error()));
  warn(warnings_of(request.method, track));
  const Domain domain = curve->orientation.domain();
  auto times = SampleTimes::make(request.times, track.epoch, domain);
  if (!times) return tl::unexpected(std::move(times.error()));
  if (request.extrapolation == Extrapolation::error)
    if (auto stray = times->outside(domain)) return tl::unexpected(std::move(*stray));
  return Source{std::move(*file), std::move(*curve), std::move(*times)};
}

Expected<TruthReport> truth_report(const std::string& path, const Source& source) {
  const auto file = io::read_track(path);
  if (!file) return tl::unexpected(file.error());
  const Track& truth = file->track;
  const double shift = (truth.epoch - source.file.track.epoch).to_double();
  std::vector<double> times(truth.keys.times().begin(), truth.keys.times().end());
  for (double& t : times) t += shift;
  const auto distance = distance_to_reference(source.curve.orientation, {times, truth.keys.orientations()});
  return TruthReport{path, distance, truth.time_of(distance.largest_at)};
}

SampleReport report_on(const Source& source, const SampleOptions& options, const Request& request) {
  const Domain domain = source.curve.orientation.domain();
  const Track& track = source.file.track;
  return {.input = options.input.path,
          .output = options.output.path,
          .method = request.method.name,
          .keys = track.keys.size(),
          .repairs = source.file.repairs,
          .keyframes = track.keys.report(),
          .columns = request.columns,
          .samples = source.times.size(),
          .rate_orders = rate_orders_of(track.keys),
          .rates_of_unknown_frame = source.file.rates_of_unknown_frame,
          .start = track.epoch + Decimal::from_double(domain.start),
          .end = track.epoch + Decimal::from_double(domain.end)};
}

Progress::Show progress_for(const SampleOptions& options) {
  const bool in_the_way = options.summary.quiet || options.output.path == io::standard_stream;
  return in_the_way ? Progress::Show::never : Progress::Show::on_terminal;
}

}  // namespace

Expected<void> sample(const SampleOptions& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  const auto source = open_source(*request);
  if (!source) return tl::unexpected(source.error());
  io::SampleColumns& columns = request->columns;
  columns.positions = source->curve.position.has_value();
  if (columns.positions) columns.position_derivatives = std::min(columns.derivatives, most_position_derivatives);
  SampleReport report = report_on(*source, options, *request);
  if (options.truth) {
    auto truth = truth_report(*options.truth, *source);
    if (!truth) return tl::unexpected(std::move(truth.error()));
    report.truth = std::move(*truth);
  }
  const Sampling sampling{source->curve, source->times, columns, request->threads};
  const auto held =
      io::SampleWriter::open(options.output.path, columns, source->times.size()).and_then([&](io::SampleWriter writer) {
        const RemovedWhenInterrupted unfinished(writer.part());
        return write_samples(writer, sampling, progress_for(options));
      });
  if (!held) return tl::unexpected(held.error());
  report.held_samples = *held;
  return summarise(options.summary, report);
}

}  // namespace orispline::cli
