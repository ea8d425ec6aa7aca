// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample.hpp"

#include <filesystem>
#include <system_error>
#include <utility>

#include <orispline/base/file_name.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_reader.hpp>
#include <orispline/io/track_file.hpp>
#include <orispline/jobs/curve_clip.hpp>
#include <orispline/jobs/sample_stream.hpp>

#include "commands/sample/sample_joints.hpp"
#include "commands/sample/sample_report.hpp"
#include "commands/sample/sample_request.hpp"
#include "commands/sample/sample_skeleton.hpp"
#include "options/scene_input.hpp"
#include "output/each_input.hpp"
#include "output/rows_file.hpp"
#include "output/scene_output.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

namespace fs = std::filesystem;

/// The keys, read and turned into a curve.
struct Source {
  io::TrackFile file;
  jobs::CurveOfKeys shaped;
  jobs::SampleTimes times;
  std::optional<jobs::Band> band{};
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
  auto wanted = jobs::times_on_curve(request.rows.times, track.epoch, shaped->curve.orientation.domain(),
                                     request.rows.extrapolation);
  if (!wanted) return tl::unexpected(std::move(wanted.error()));
  warn(wanted->warnings);
  Source source{std::move(*file), std::move(*shaped), std::move(wanted->times)};
  if (!request.rows.band) return source;
  return jobs::band_of(source.file.track, source.shaped.method, *request.rows.band).map([&](jobs::Band band) {
    source.band = std::move(band);
    return std::move(source);
  });
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
  SampleReport report{.outcome = outcome_of(file.track, request.method, shaped), .repairs = file.repairs};
  report.outcome.band = request.rows.band;
  if (request.truth) {
    auto distance = truth_distance(request, file, shaped.curve);
    if (!distance) return tl::unexpected(std::move(distance.error()));
    report.outcome.truth = std::move(*distance);
  }
  return write_samples(request, std::move(report), shaped.curve, times, file.track.recipe.gap.has_value(),
                       band ? &*band : nullptr);
}

/// The size of a file in bytes; absent for a pipe.
std::optional<std::size_t> size_of_file(const std::string& path) {
  std::error_code none;
  const auto size = fs::file_size(path, none);
  return path == io::standard_stream || none ? std::nullopt : std::optional(static_cast<std::size_t>(size));
}

/// Where samples go into the very file that keys are read from, all keys are read before the first sample is written.
bool writes_into_input(const SampleRequest& request) {
  std::error_code unknown;  // such as on systems without these names
  const std::string input = request.input.path == io::standard_stream ? "/dev/stdin" : request.input.path;
  return request.output == io::standard_stream && fs::equivalent(input, "/dev/stdout", unknown);
}

jobs::StreamRequest stream_request(const SampleRequest& request, const io::KeyColumns& columns) {
  jobs::StreamRequest stream{.source = request.input.path,
                             .method = request.method,
                             .signs = *request.input.signs,
                             .times = request.rows.times,
                             .extrapolation = request.rows.extrapolation,
                             .warn = [](std::vector<Warning> warnings) { warn(std::move(warnings)); }};
  for (const io::ParameterColumn& column : columns.parameters) stream.settings.push_back(column.name);
  return stream;
}

/// Whether the samples can be made while the keys are read: where nothing asks for all keys at once.
Expected<bool> goes_in_pieces(const SampleRequest& request, io::KeyReader& keys) {
  return keys.holds_two_tracks().map([&](bool two_tracks) {
    const io::ReadOptions& read = request.input.read;
    // A header that counts the rows stands before them; in a pipe that cannot be done later.
    const bool counts_later = !request.rows.columns.format->writing.counts_rows || !io::is_stream(request.output);
    return !two_tracks && keys.columns() && counts_later && !request.truth && !request.rows.band && !read.sort &&
           !read.session && !keys.recipe().gap && !keys.recipe().jumps && !writes_into_input(request) &&
           jobs::can_stream(stream_request(request, *keys.columns()));
  });
}

/// The next keys, with what is to be said of them.
Expected<jobs::KeyPiece> next_piece(io::KeyReader& keys, const SampleRequest& request, io::RepairReport& repairs) {
  constexpr std::size_t keys_of_a_piece = 16384;
  return keys.next(keys_of_a_piece).map([&](io::KeyFile file) {
    repairs = file.repairs;
    if (keys.is_at_end() && file.turns)
      for (Warning& warning : file.turns->warnings(*request.input.signs, file.euler)) {
        warning.where.file = request.input.path;
        file.warnings.push_back(std::move(warning));
      }
    return jobs::KeyPiece{std::move(file.data), std::move(file.parameters), std::move(file.lines),
                          file.epoch,           std::move(file.warnings),   keys.is_at_end()};
  });
}

/// Reads the keys and writes the samples piece by piece, in memory that grows with neither.
Expected<SampleReport> sample_in_pieces(const SampleRequest& request, io::KeyReader keys) {
  SampleReport report{.input = request.input.path,
                      .output = request.output,
                      .columns = with_positions(request.rows.columns, keys.columns()->position.has_value())};
  std::optional<Progress> through_file, through_samples;
  if (const auto bytes = size_of_file(request.input.path)) through_file.emplace(*bytes, request.progress);
  jobs::StreamRequest stream = stream_request(request, *keys.columns());
  stream.next = [&] {
    if (through_file) through_file->advance_to(keys.bytes_read());
    return next_piece(keys, request, report.repairs);
  };
  stream.ended = [&](std::size_t samples) {
    through_file.reset();
    through_samples.emplace(samples, request.progress);
  };
  RowWriting writing = row_writing(request.rows, false, request.threads);
  writing.written = [&](std::size_t samples) {
    if (through_samples) through_samples->advance_to(samples);
  };
  jobs::StreamSamples samples(std::move(stream));
  return write_rows(request.output, report.columns, samples, writing).map([&](const jobs::RowCounts& counts) {
    report.outcome = samples.outcome();
    count_rows(report.outcome, writing.policy, counts);
    return report;
  });
}

jobs::CurveClipRequest clip_request(const SampleRequest& request, const Source& source) {
  const std::string_view file = file_name_of(request.input.path);
  jobs::CurveClipRequest wanted{.name = std::string(file.substr(0, file.rfind('.'))),
                                .source = request.input.path,
                                .method = request.method.name,
                                .keys = source.file.track.keys.size(),
                                .tolerance = request.tolerance,
                                .position_tolerance = request.position_tolerance};
  if (!request.tolerance)
    for (std::size_t k = 0; k < source.times.size(); ++k) wanted.sample_times.push_back(source.times[k].t);
  return wanted;
}

/// A curve in a file of skeletons, as the motion of one joint: as cubics within the tolerance, or its samples.
Expected<void> sample_into_scene(const SampleArguments& options, const SampleRequest& request, io::KeyReader keys) {
  const auto source = open_source(request, std::move(keys));
  if (!source) return tl::unexpected(source.error());
  if (auto whole = jobs::check_without_gaps(source->file.track); !whole) return whole;
  const auto writing = scene_writing(options.output);
  if (!writing) return tl::unexpected(writing.error());
  if (scenes::scene_format_of(request.output) != &scenes::gltf_format)
    return usage_failure(
        "-o: found a file that holds every frame, wanted glTF, such as motion.glb; 'orispline convert "
        "--rate' makes BVH of it");
  if (!request.tolerance)
    if (auto fault = source->times.fault_as_keys()) return tl::unexpected(std::move(*fault));
  CurveSceneReport report{jobs::curve_clip(clip_request(request, *source), source->shaped.curve), request.output};
  report.outcome.written_to = destination(request.output);
  warn(report.outcome.warnings);
  return Skeleton::make({{.name = "body"}}).and_then([&](Skeleton skeleton) {
    scenes::Scene scene{.skeleton = std::move(skeleton), .clips = {report.outcome.clip}};
    return write_scene(request.output, scene, *writing).and_then([&] { return summarise(options.summary, report); });
  });
}

/// Samples the curve through keys: while they are read where that can be done, else through all of them in memory.
Expected<void> sample_keys(const SampleArguments& options) {
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
        request->rows.columns = columns_for(options.rows, options.output, keys.format());
        const auto in_pieces = goes_in_pieces(*request, keys);
        if (!in_pieces) return tl::unexpected(in_pieces.error());
        return (*in_pieces ? sample_in_pieces(*request, std::move(keys)) : sample_whole(*request, std::move(keys)))
            .and_then([&](const SampleReport& report) { return summarise(options.summary, report); });
      })
      .map_error([](Error error) { return with_output_for_all(std::move(error), "--output-folder without --method"); });
}

Expected<void> sample_one(const SampleArguments& options) {
  if (!asks_for_stored_motion(options)) return sample_keys(options);
  if (is_scene(options.output.path) && !options.inputs.folder) return sample_skeleton(options);
  return options.inputs.folder ? sample_joints(options) : sample_joint(options);
}

Expected<void> check_each(const SampleArguments& options) {
  if (options.rows.list == io::standard_stream || options.truth == io::standard_stream)
    return usage_failure(
        "--output-folder: found '-' for --times or --truth, wanted a file, which is read again for each input");
  const auto request = asks_for_stored_motion(options) ? stored_request(options) : sample_request(options);
  return request.map([](const SampleRequest&) {});
}

}  // namespace

Expected<void> sample(const SampleArguments& options) {
  return on_inputs(options, {.written = "samples", .check = check_each, .work = sample_one});
}

}  // namespace orispline::cli
