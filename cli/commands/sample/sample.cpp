// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample.hpp"

#include <algorithm>
#include <utility>

#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>

#include "commands/sample/sample_curve_scene.hpp"
#include "commands/sample/sample_joints.hpp"
#include "commands/sample/sample_report.hpp"
#include "commands/sample/sample_request.hpp"
#include "commands/sample/sample_scene.hpp"
#include "commands/sample/sample_stream.hpp"
#include "commands/sample/sampling.hpp"
#include "options/scene_input.hpp"
#include "output/each_input.hpp"
#include "output/findings_text.hpp"
#include "output/gathered_output.hpp"
#include "output/noted_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The keys, read and turned into a curve.
struct Source {
  io::TrackFile file;
  PoseCurve curve;
  SampleTimes times;
  std::optional<MotionBand> band;
  std::optional<KeyFindings> findings;
};

std::size_t rate_orders_of(const Keyframes& keys) {
  const std::array rates{keys.angular_velocities(), keys.angular_accelerations(), keys.angular_jerks()};
  return static_cast<std::size_t>(std::ranges::count_if(rates, [](const auto& values) { return !values.empty(); }));
}

Expected<io::TrackFile> track_of(io::KeyReader reader, Signs signs) {
  auto file = reader.next();
  if (!file) return tl::unexpected(std::move(file.error()));
  auto keys = Keyframes::make(std::exchange(file->data, {}), signs);
  if (!keys) return tl::unexpected(located(*file, std::move(keys.error())));
  file->recipe.signs = signs;
  return io::track_file(std::move(*file), std::move(*keys));
}

Expected<Source> open_source(const SampleRequest& request, io::KeyReader keys) {
  auto file = track_of(std::move(keys), *request.input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  const Track& track = file->track;
  auto findings = findings_by(request.method, track);
  const Method method = with_found(request.method, findings);
  // Positions say something of their own.
  auto curve = shaped_curve(track.keys.positions().empty() ? method : request.method, track);
  if (!curve) return tl::unexpected(std::move(curve.error()));
  warn(file->warnings);
  warn(warnings_of(method, track));
  const Domain domain = curve->orientation.domain();
  const TimeRequest wanted = anchored(request.times, track.epoch);
  auto times = SampleTimes::make(wanted, track.epoch, domain);
  if (!times) return tl::unexpected(std::move(times.error()));
  warn(times->warnings());
  if (request.extrapolation == Extrapolation::hold) warn(range_warnings(wanted, track.epoch, domain));
  if (request.extrapolation == Extrapolation::error)
    if (auto stray = times->outside(domain)) return tl::unexpected(std::move(*stray));
  Source source{std::move(*file), std::move(*curve), std::move(*times), {}, std::move(findings)};
  if (request.band) {
    auto band = MotionBand::make(method, source.file.track.keys, *request.band);
    if (!band) return bad_option("band", band.error().message);
    source.band = std::move(*band);
  }
  return source;
}

Expected<TruthReport> truth_report(const std::string& path, const Source& source, const io::ReadOptions& options) {
  const auto file = io::read_track_beside(source.file, path, options);
  if (!file) return tl::unexpected(file.error());
  warn(file->warnings);
  const Track& truth = file->track;
  const double shift = (truth.epoch - source.file.track.epoch).to_double();
  std::vector<double> times(truth.keys.times().begin(), truth.keys.times().end());
  for (double& t : times) t += shift;
  const auto keys = source.file.track.keys.times();
  const auto distance =
      distance_to_reference(source.curve.orientation, {times, truth.keys.orientations()}, {keys.front(), keys.back()});
  return TruthReport{path, distance, truth.time_of(distance.largest_at)};
}

SampleReport report_on(const Source& source, const SampleRequest& request, const io::SampleColumns& columns) {
  const Domain domain = source.curve.orientation.domain();
  const Track& track = source.file.track;
  return {.input = request.input.path,
          .output = request.output,
          .method = request.method.name,
          .method_text = text_of(request.method),
          .keys = track.keys.size(),
          .repairs = source.file.repairs,
          .keyframes = track.keys.report(),
          .columns = columns,
          .samples = source.times.size(),
          .extrapolation = request.extrapolation,
          .rate_orders = rate_orders_of(track.keys),
          .start = track.epoch + Decimal::from_double(domain.start),
          .end = track.epoch + Decimal::from_double(domain.end),
          .findings = source.findings,
          .band = request.band,
          .keys_held = true};
}

/// Samples the curve through all keys, which are in memory.
Expected<SampleReport> sample_whole(const SampleRequest& request, io::KeyReader keys) {
  const auto source = open_source(request, std::move(keys));
  if (!source) return tl::unexpected(source.error());
  const io::SampleColumns columns = with_positions(request.columns, source->curve.position.has_value());
  SampleReport report = report_on(*source, request, columns);
  if (request.truth) {
    auto truth = truth_report(*request.truth, *source, request.input.read);
    if (!truth) return tl::unexpected(std::move(truth.error()));
    report.truth = std::move(*truth);
  }
  const Sampling sampling{source->curve,         source->times,   columns,
                          request.extrapolation, request.threads, source->band ? &*source->band : nullptr};
  return open_samples(request.output, columns, source->times.size())
      .and_then([&](Noted<io::SampleWriter> output) {
        return write_samples(output.file, sampling, request.progress).and_then([&](std::size_t held) {
          report.held_samples = held;
          return put_in_place(std::move(output));
        });
      })
      .map([&] { return report; });
}

/// The curve through all keys as cubics, or its samples, in a file of skeletons.
Expected<void> sample_into_scene(const SampleOptions& options, const SampleRequest& request, io::KeyReader keys) {
  return open_source(request, std::move(keys)).and_then([&](const Source& source) {
    return write_curve_scene(options, request, {source.file.track.keys.size(), source.curve, source.times});
  });
}

Expected<void> sample_one(const SampleOptions& options) {
  if (asks_for_stored(options)) return options.inputs.folder ? sample_joints(options) : sample_stored(options);
  auto request = sample_request(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto input = io::KeyInput::open(request->input.path, request->input.read.recipe);
  if (!input) return tl::unexpected(std::move(input.error()));
  const auto warnings = settle_method(*request, *input);
  if (!warnings) return tl::unexpected(warnings.error());
  warn(*warnings);
  return io::KeyReader::open(std::move(*input), request->input.read)
      .and_then([&](io::KeyReader keys) -> Expected<void> {
        if (is_scene(request->output)) return sample_into_scene(options, *request, std::move(keys));
        request->columns = columns_for(options, keys.format());
        return (goes_in_pieces(*request, keys) ? sample_in_pieces(*request, std::move(keys))
                                               : sample_whole(*request, std::move(keys)))
            .and_then([&](const SampleReport& report) { return summarise(options.summary, report); });
      })
      .map_error([](Error error) { return or_all_of_them(std::move(error), "--output-folder without --method"); });
}

Expected<void> check_each(const SampleOptions& options) {
  if (options.times.list == io::standard_stream || options.truth == io::standard_stream)
    return usage_failure(
        "--output-folder: found '-' for --times or --truth, wanted a file, which is read again for each input");
  const auto request = asks_for_stored(options) ? stored_request(options) : sample_request(options);
  return request.map([](const SampleRequest&) {});
}

}  // namespace

Expected<void> sample(const SampleOptions& options) {
  return on_inputs(options, {.written = "samples", .check = check_each, .work = sample_one});
}

}  // namespace orispline::cli
