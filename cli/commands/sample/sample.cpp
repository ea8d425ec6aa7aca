// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample.hpp"

#include <algorithm>
#include <utility>

#include <orispline/analysis.hpp>
#include <orispline/jobs/sample.hpp>

#include "commands/sample/sample_curve_scene.hpp"
#include "commands/sample/sample_joints.hpp"
#include "commands/sample/sample_report.hpp"
#include "commands/sample/sample_request.hpp"
#include "commands/sample/sample_scene.hpp"
#include "commands/sample/sample_stream.hpp"
#include "commands/sample/sampling.hpp"
#include "options/scene_input.hpp"
#include "output/each_input.hpp"
#include "output/gathered_output.hpp"
#include "output/noted_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

/// The keys, read and turned into a curve.
struct Source {
  io::TrackFile file;
  jobs::CurveOfKeys shaped;
  SampleTimes times;
  std::optional<BandInStretches> band;
};

Expected<io::TrackFile> track_of(io::KeyReader reader, Signs signs) {
  auto file = reader.next();
  if (!file) return tl::unexpected(std::move(file.error()));
  auto keys = Keyframes::make(std::exchange(file->data, {}), signs);
  if (!keys) return tl::unexpected(located(*file, std::move(keys.error())));
  file->recipe.signs = signs;
  return io::track_file(std::move(*file), *keys);
}

Expected<Source> open_source(const SampleRequest& request, io::KeyReader keys) {
  auto file = track_of(std::move(keys), *request.input.signs);
  if (!file) return tl::unexpected(std::move(file.error()));
  const Track& track = file->track;
  auto shaped = jobs::curve_of_keys(request.method, track);
  if (!shaped) return tl::unexpected(std::move(shaped.error()));
  warn(file->warnings);
  warn(shaped->warnings);
  const Domain domain = shaped->curve.orientation.domain();
  const TimeRequest wanted = anchored(request.times, track.epoch);
  auto times = SampleTimes::make(wanted, track.epoch, domain);
  if (!times) return tl::unexpected(std::move(times.error()));
  warn(times->warnings());
  if (request.extrapolation == Extrapolation::hold) warn(range_warnings(wanted, track.epoch, domain));
  if (request.extrapolation == Extrapolation::error)
    if (auto stray = times->outside(domain)) return tl::unexpected(std::move(*stray));
  Source source{std::move(*file), std::move(*shaped), std::move(*times), {}};
  if (request.band) {
    auto band = stretches_of(source.file.track).and_then([&](const std::vector<Stretch>& stretches) {
      return BandInStretches::make(source.shaped.method, source.file.track.keys, stretches, *request.band);
    });
    if (!band) return bad_option("band", band.error().message);
    source.band = std::move(*band);
  }
  return source;
}

/// How far the curve is from the file of --truth.
Expected<jobs::TruthDistance> truth_distance(const SampleRequest& request, const io::TrackFile& keys,
                                             const PoseCurve& curve) {
  auto truth = io::read_track_beside(keys, *request.truth, request.input.read);
  if (!truth) return tl::unexpected(std::move(truth.error()));
  warn(truth->warnings);
  if (!request.align) return jobs::distance_to_truth(curve, keys.track, truth->track);
  return jobs::distance_to_aligned_truth(curve, std::make_shared<const Track>(keys.track),
                                         std::make_shared<const Track>(std::move(truth->track)))
      .map([](jobs::TruthDistance distance) {
        warn(distance.alignment->warnings);
        return distance;
      });
}

/// Samples the curve through all keys, which are in memory.
Expected<SampleReport> sample_whole(const SampleRequest& request, io::KeyReader keys) {
  const auto source = open_source(request, std::move(keys));
  if (!source) return tl::unexpected(source.error());
  const auto& [file, shaped, times, band] = *source;
  const io::SampleColumns columns = with_positions(request.columns, shaped.curve.position.has_value());
  SampleReport report{.outcome = outcome_of(file.track, request.method, shaped),
                      .input = request.input.path,
                      .output = request.output,
                      .repairs = file.repairs,
                      .columns = columns,
                      .keys_held = true};
  report.outcome.samples = times.size();
  report.outcome.extrapolation = request.extrapolation;
  report.outcome.band = request.band;
  if (request.truth) {
    auto distance = truth_distance(request, file, shaped.curve);
    if (!distance) return tl::unexpected(std::move(distance.error()));
    report.outcome.truth = std::move(*distance);
  }
  const Sampling sampling{.curve = shaped.curve,
                          .times = times,
                          .columns = columns,
                          .extrapolation = request.extrapolation,
                          .outside = request.outside,
                          .gaps = !file.track.recipe.gap ? GapRows::none
                                  : request.mark_gaps    ? GapRows::empty
                                                         : GapRows::left_out,
                          .threads = request.threads,
                          .band = band ? &*band : nullptr};
  return open_samples(request.output, columns, times.size())
      .and_then([&](Noted<io::SampleWriter> output) {
        return write_samples(output.file, sampling, request.progress).and_then([&](const RowCounts& counts) {
          count_rows(report.outcome, request, counts);
          return put_in_place(std::move(output));
        });
      })
      .map([&] { return report; });
}

/// The curve through all keys as cubics, or its samples, in a file of skeletons.
Expected<void> sample_into_scene(const SampleArguments& options, const SampleRequest& request, io::KeyReader keys) {
  return open_source(request, std::move(keys)).and_then([&](const Source& source) {
    return jobs::check_without_gaps(source.file.track).and_then([&] {
      return write_curve_scene(options, request, {source.file.track.keys.size(), source.shaped.curve, source.times});
    });
  });
}

Expected<void> sample_one(const SampleArguments& options) {
  if (asks_for_stored(options)) return options.inputs.folder ? sample_joints(options) : sample_stored(options);
  auto request = sample_request(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  auto input = io::KeyInput::open(request->input.path, request->input.read);
  if (!input) return tl::unexpected(std::move(input.error()));
  const auto warnings = settle_method(*request, *input);
  if (!warnings) return tl::unexpected(warnings.error());
  warn(*warnings);
  return io::KeyReader::open(std::move(*input), request->input.read)
      .and_then([&](io::KeyReader keys) -> Expected<void> {
        if (is_scene(request->output)) return sample_into_scene(options, *request, std::move(keys));
        request->columns = columns_for(options, keys.format());
        const auto two_tracks = keys.holds_two_tracks();
        if (!two_tracks) return tl::unexpected(two_tracks.error());
        return (!*two_tracks && goes_in_pieces(*request, keys) ? sample_in_pieces(*request, std::move(keys))
                                                               : sample_whole(*request, std::move(keys)))
            .and_then([&](const SampleReport& report) { return summarise(options.summary, report); });
      })
      .map_error([](Error error) { return or_all_of_them(std::move(error), "--output-folder without --method"); });
}

Expected<void> check_each(const SampleArguments& options) {
  if (options.times.list == io::standard_stream || options.truth == io::standard_stream)
    return usage_failure(
        "--output-folder: found '-' for --times or --truth, wanted a file, which is read again for each input");
  const auto request = asks_for_stored(options) ? stored_request(options) : sample_request(options);
  return request.map([](const SampleRequest&) {});
}

}  // namespace

Expected<void> sample(const SampleArguments& options) {
  return on_inputs(options, {.written = "samples", .check = check_each, .work = sample_one});
}

}  // namespace orispline::cli
