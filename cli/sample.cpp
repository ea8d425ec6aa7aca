// SPDX-License-Identifier: Apache-2.0
#include "sample.hpp"

#include <fmt/format.h>

#include "interruption.hpp"
#include "json.hpp"
#include "progress.hpp"
#include "sample_report.hpp"
#include "standard_output.hpp"

namespace orispline::cli {
namespace {

constexpr int default_csv_derivatives = 2;

/// The command line, understood.
struct Request {
  InputRequest input;
  MethodRequest method;
  TimeRequest times;
  io::SampleColumns columns;
  Extrapolation extrapolation = Extrapolation::hold;
};

Expected<int> derivatives_in(OptionText option) {
  const auto order = count_in(option, 0);
  if (!order || *order > 3) return wanted(option, "0, 1, 2 or 3");
  return static_cast<int>(*order);
}

Expected<io::SampleColumns> columns_in(const SampleOptions& options) {
  FirstError checked;
  const auto format = checked(if_given("--output-format", options.output_format, choice_of(format_choices)));
  const auto derivatives = checked(if_given("--derivatives", options.derivatives, derivatives_in));
  const auto frame = checked(if_given("--frame", options.frame, choice_of(frame_choices)));
  io::SampleColumns columns{
      .format = format.value_or(io::format_of_extension(options.output).value_or(io::FileFormat::csv)),
      .frame = frame.value_or(io::Frame::body)};
  const bool holds_rates = columns.format == io::FileFormat::csv;
  columns.derivatives = derivatives.value_or(holds_rates ? default_csv_derivatives : 0);
  auto read = std::move(checked).or_else(columns);
  if (read && !holds_rates && read->derivatives > 0)
    return wanted({"--derivatives", *options.derivatives}, "0 for a TUM file, which has no columns for rates");
  if (read && !holds_rates && read->frame == io::Frame::world)
    return wanted({"--frame", *options.frame}, "body for a TUM file, which has no columns for rates");
  return read;
}

/// Standard input can be read once only.
bool reads_standard_input_twice(const SampleOptions& options) {
  const int readers = (options.input.path == io::standard_stream) + (options.times.list == io::standard_stream) +
                      (options.truth == io::standard_stream);
  return readers > 1;
}

Expected<Request> request_in(const SampleOptions& options) {
  if (options.output.empty()) return usage_failure("-o: found an empty name, wanted FILE or -");
  FirstError checked;
  Request request{
      .input = checked(input_request(options.input)),
      .method = checked(method_request(options.method, options.shape)),
      .times = checked(time_request(options.times)),
      .columns = checked(columns_in(options)),
      .extrapolation = checked(if_given("--extrapolate", options.extrapolate, choice_of(extrapolation_choices)))
                           .value_or(Extrapolation::hold)};
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  if (options.json && options.output == io::standard_stream)
    return usage_failure("--json: the summary goes to standard output, wanted -o FILE for the samples");
  if (reads_standard_input_twice(options))
    return usage_failure("found '-' for several of INPUT, --times and --truth, wanted it for one at most");
  read->input.read.parameters = open_parameters(read->method);
  return read;
}

/// The keys, read and turned into a curve.
struct Source {
  io::KeyFile file;  ///< without the keyframes, which the curve holds now
  std::size_t keys = 0;
  KeyframeReport report;
  PoseCurve curve;
  SampleTimes times;
};

Expected<Source> open_source(const Request& request) {
  auto file = io::read_keys(request.input.path, request.input.read);
  if (!file) return tl::unexpected(std::move(file.error()));
  auto times = SampleTimes::make(request.times, *file);
  if (!times) return tl::unexpected(std::move(times.error()));
  const auto keys = Keyframes::make(std::exchange(file->data, {}), request.input.signs);
  if (!keys) return tl::unexpected(located(*file, keys.error()));
  auto curve = shaped_curve(request.method, *keys, *file);
  if (!curve) return tl::unexpected(std::move(curve.error()));
  if (request.extrapolation == Extrapolation::error)
    if (auto stray = times->outside(curve->orientation.domain())) return tl::unexpected(std::move(*stray));
  return Source{std::move(*file), keys->size(), keys->report(), std::move(*curve), std::move(*times)};
}

/// Writes every sample; the number of those that hold an end orientation.
Expected<std::size_t> write_samples(io::SampleWriter& writer, const Source& source, Progress::Show show) {
  const Domain domain = source.curve.orientation.domain();
  Progress progress(source.times.size(), show);
  std::size_t held = 0;
  for (std::size_t k = 0; k < source.times.size(); ++k) {
    const auto [t, offset] = source.times[k];
    if (!domain.contains(t)) ++held;
    io::Sample sample{.t = offset, .motion = source.curve.orientation.motion(t)};
    if (source.curve.position) sample.position = source.curve.position->travel(t).position;
    if (auto written = writer.write(sample); !written) return tl::unexpected(std::move(written.error()));
    progress.advance_to(k);
  }
  return writer.finish().map([held] { return held; });
}

Expected<TruthReport> truth_report(const std::string& path, const Source& source) {
  auto truth = io::read_keys(path);
  if (!truth) return tl::unexpected(std::move(truth.error()));
  const auto keys = Keyframes::make(std::move(truth->data));
  if (!keys) return tl::unexpected(located(*truth, keys.error()));
  const double shift = (truth->epoch - source.file.epoch).to_double();
  std::vector<double> times(keys->times().begin(), keys->times().end());
  for (double& t : times) t += shift;
  const auto distance = distance_to_reference(source.curve.orientation, {times, keys->orientations()});
  return TruthReport{path, distance, truth->epoch + io::Decimal::from_double(keys->times()[distance.largest_at])};
}

SampleReport report_on(const Source& source, const SampleOptions& options, const Request& request) {
  const Domain domain = source.curve.orientation.domain();
  return {.input = options.input.path,
          .output = options.output,
          .method = std::string(request.method.family->name),
          .keys = source.keys,
          .repairs = source.file.repairs,
          .keyframes = source.report,
          .columns = request.columns,
          .samples = source.times.size(),
          .start = source.file.epoch + io::Decimal::from_double(domain.start),
          .end = source.file.epoch + io::Decimal::from_double(domain.end)};
}

Progress::Show progress_for(const SampleOptions& options) {
  const bool in_the_way = options.quiet || options.output == io::standard_stream;
  return in_the_way ? Progress::Show::never : Progress::Show::on_terminal;
}

}  // namespace

Expected<void> sample(const SampleOptions& options) {
  auto request = request_in(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  const auto source = open_source(*request);
  if (!source) return tl::unexpected(source.error());
  request->columns.positions = source->curve.position.has_value();
  SampleReport report = report_on(*source, options, *request);
  if (options.truth) {
    auto truth = truth_report(*options.truth, *source);
    if (!truth) return tl::unexpected(std::move(truth.error()));
    report.truth = std::move(*truth);
  }
  const auto held = io::SampleWriter::open(options.output, request->columns, source->times.epoch())
                        .and_then([&](io::SampleWriter writer) {
                          const RemovedWhenInterrupted unfinished(writer.part());
                          return write_samples(writer, *source, progress_for(options));
                        });
  if (!held) return tl::unexpected(held.error());
  report.held_samples = *held;
  if (options.json) return print_document(json_of(report));
  if (!options.quiet) tell(text_of(report));
  return {};
}

}  // namespace orispline::cli
