// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_scene.hpp"

#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "commands/sample/sampling.hpp"
#include "options/scene_input.hpp"
#include "output/gathered_output.hpp"
#include "output/noted_output.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

Error located(Error error, const std::string& file) {
  if (error.where.file.empty()) error.where.file = file;
  return error;
}

/// What does not fit to it.
Expected<void> check_stored(const SampleArguments& options) {
  if (any_given(options.shape))
    return usage_failure(
        formatted("{}: found the motion that the file says, which has its shape, wanted --method as well",
                  first_given(options.shape)));
  if (options.band) return usage_failure("--band: found the motion that the file says, wanted --method measured");
  if (options.truth) return usage_failure("--truth: found the motion that the file says, wanted --method as well");
  if (is_scene(options.output.path))
    return usage_failure("-o: found a file of skeletons, wanted one of samples, or 'orispline convert' for the keys");
  return {};
}

}  // namespace

bool asks_for_stored(const SampleArguments& options) {
  return is_scene(options.input, options.input.path) &&
         options.method.value_or(std::string(stored_method)) == stored_method;
}

Expected<SampleRequest> stored_request(const SampleArguments& options) {
  if (auto fits = check_stored(options); !fits) return tl::unexpected(std::move(fits.error()));
  SampleArguments without_method = options;
  without_method.method.reset();
  return sample_request(without_method);
}

Expected<scenes::Scene> opened(const InputRequest& input) {
  return scenes::read_scene(input.path, scene_reading(input)).and_then([&](scenes::Scene scene) {
    warn(scene.warnings);
    return scenes::with_clips(std::move(scene), input.read.scene.clips);
  });
}

Expected<JointSamples> joint_samples(const SampleRequest& request, const scenes::Scene& scene, const Clip& clip,
                                     std::size_t joint) {
  const bool in_world = request.input.read.scene.space == io::SceneTrack::Space::world;
  auto curve = joint_curve(scene.skeleton, clip, joint, in_world ? JointSpace::world : JointSpace::local,
                           request.input.read.frames);
  if (!curve) return tl::unexpected(located(std::move(curve.error()), request.input.path));
  const Domain domain = curve->orientation.domain();
  const TimeRequest wanted = anchored(request.times, Decimal());
  auto times = SampleTimes::make(wanted, Decimal(), domain);
  if (!times) return tl::unexpected(std::move(times.error()));
  JointSamples samples{*std::move(curve), *std::move(times)};
  if (request.extrapolation == Extrapolation::hold) samples.warnings = range_warnings(wanted, Decimal(), domain);
  if (request.extrapolation == Extrapolation::error)
    if (auto stray = samples.times.outside(domain)) return tl::unexpected(std::move(*stray));
  return samples;
}

Expected<SampleReport> write_joint(const SampleRequest& request, const JointSamples& samples) {
  const auto& [curve, times, warnings] = samples;
  const Domain domain = curve.orientation.domain();
  SampleReport report{.outcome = {.source = request.input.path,
                                  .method = std::string(stored_method),
                                  .method_text = "the motion that is stored",
                                  .keys = curve.orientation.knots().times().size(),
                                  .start = Decimal::from_double(domain.start),
                                  .end = Decimal::from_double(domain.end),
                                  .samples = times.size(),
                                  .extrapolation = request.extrapolation},
                      .input = request.input.path,
                      .output = request.output,
                      .columns = with_positions(request.columns, curve.position.has_value()),
                      .keys_held = true};
  const Sampling sampling{.curve = curve,
                          .times = times,
                          .columns = report.columns,
                          .extrapolation = request.extrapolation,
                          .outside = request.outside,
                          .threads = request.threads};
  return open_samples(request.output, report.columns, times.size())
      .and_then([&](Noted<io::SampleWriter> output) {
        return write_samples(output.file, sampling, request.progress).and_then([&](const RowCounts& counts) {
          count_rows(report.outcome, request, counts);
          return put_in_place(std::move(output));
        });
      })
      .map([&] { return report; });
}

Expected<void> sample_stored(const SampleArguments& options) {
  const auto request = stored_request(options);
  if (!request) return tl::unexpected(request.error());
  const auto scene = opened(request->input);
  if (!scene) return tl::unexpected(scene.error());
  return scenes::only_clip(*scene)
      .and_then([&](const Clip* clip) {
        return scenes::joint_in(*scene, *clip, request->input.read.scene.joint).and_then([&](std::size_t joint) {
          return joint_samples(*request, *scene, *clip, joint).and_then([&](const JointSamples& samples) {
            warn(samples.warnings);
            return write_joint(*request, samples);
          });
        });
      })
      .map_error([](Error error) { return or_all_of_them(std::move(error), "--output-folder FOLDER"); })
      .and_then([&](const SampleReport& report) { return summarise(options.summary, report); });
}

}  // namespace orispline::cli
