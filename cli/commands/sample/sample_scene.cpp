// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_scene.hpp"

#include <algorithm>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/cubic_channel.hpp>
#include <orispline/clip/joint_curve.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "commands/sample/sample_report.hpp"
#include "commands/sample/sampling.hpp"
#include "options/scene_input.hpp"
#include "output/gathered_output.hpp"
#include "output/noted_output.hpp"
#include "output/scene_output.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {
namespace {

/// A joint of a file with the motion that the file says.
struct StoredMotion {
  PoseCurve curve;
  std::size_t keys;
};

Expected<StoredMotion> stored_motion(const InputRequest& input) {
  return scenes::read_scene(input.path, {.drop_duplicates = input.read.drop_duplicates})
      .and_then([&](scenes::Scene scene) {
        warn(scene.warnings);
        return scenes::with_clips(std::move(scene), input.read.scene.clips);
      })
      .and_then([&](const scenes::Scene& scene) {
        return scenes::only_clip(scene).and_then([&](const Clip* clip) {
          const bool in_world = input.read.scene.space == io::SceneTrack::Space::world;
          return scenes::joint_in(scene, *clip, input.read.scene.joint).and_then([&](std::size_t joint) {
            return joint_curve(scene.skeleton, *clip, joint, in_world ? JointSpace::world : JointSpace::local);
          });
        });
      })
      .map([](PoseCurve curve) {
        const std::size_t keys = curve.orientation.knots().times().size();
        return StoredMotion{std::move(curve), keys};
      })
      .map_error([&](Error error) {
        if (error.where.file.empty()) error.where.file = input.path;
        return error;
      });
}

/// What does not fit to it.
Expected<void> check_stored(const SampleOptions& options) {
  if (any_given(options.shape))
    return usage_failure(
        "found options that shape a curve, but what the file says has its shape; wanted --method as well");
  if (options.band) return usage_failure("--band: found the motion that the file says, wanted --method measured");
  if (options.truth) return usage_failure("--truth: found the motion that the file says, wanted --method as well");
  if (is_scene(options.output.path))
    return usage_failure("-o: found a file of skeletons, wanted one of samples, or 'orispline convert' for the keys");
  return {};
}

/// What was written into a file of skeletons.
struct CurveSceneReport {
  std::string input{}, output{}, method{};
  std::size_t keys = 0, keys_written = 0, positions_written = 0;
  std::optional<double> tolerance{}, largest{};  ///< [rad], of cubics
};

std::string text_of(const CurveSceneReport& report) {
  std::string text = formatted("{} from {}, {}\n", counted(report.keys, "key"), printable(report.input), report.method);
  if (report.largest)
    text += formatted("{} of cubics written to {}, at most {:.4g}° from the curve (tolerance {:.4g}°)\n",
                      counted(report.keys_written, "key"), destination(report.output), *report.largest * degrees,
                      *report.tolerance * degrees);
  else text += formatted("{} written to {}\n", counted(report.keys_written, "sample"), destination(report.output));
  return text;
}

Json json_of(const CurveSceneReport& report) {
  Json json{{"input", report.input},
            {"output", report.output},
            {"method", report.method},
            {"keys", report.keys},
            {"keys_written", report.keys_written}};
  if (report.positions_written > 0) json["position_keys_written"] = report.positions_written;
  if (report.largest) {
    json["tolerance_deg"] = *report.tolerance * degrees;
    json["error_max_deg"] = *report.largest * degrees;
  }
  return json;
}

/// As many metres as radians: 0.01° is 0.17 mm.
constexpr double metres_per_radian = 1.0;

CurveSceneReport add_cubics(Clip& clip, const PoseCurve& curve, double tolerance) {
  auto rotation = cubic_channel(curve.orientation, tolerance);
  CurveSceneReport report{
      .keys_written = rotation.channel.size(), .tolerance = tolerance, .largest = rotation.largest_distance};
  clip.rotations.push_back(std::move(rotation.channel));
  if (!curve.position) return report;
  clip.translations.push_back(cubic_channel(*curve.position, tolerance * metres_per_radian).channel);
  report.positions_written = clip.translations.back().size();
  return report;
}

CurveSceneReport add_samples(Clip& clip, const PoseCurve& curve, const SampleTimes& times) {
  RotationChannel rotation;
  VectorChannel translation;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double t = times[k].t;
    rotation.times.push_back(t);
    rotation.values.push_back(curve.orientation(t).normalized());
    if (curve.position) translation.values.push_back(curve.position->linear_motion(t).position);
  }
  CurveSceneReport report{.keys_written = rotation.size()};
  if (curve.position) {
    translation.times = rotation.times;
    report.positions_written = translation.size();
    clip.translations.push_back(std::move(translation));
  }
  clip.rotations.push_back(std::move(rotation));
  return report;
}

}  // namespace

bool asks_for_stored(const SampleOptions& options) {
  return is_scene(options.input.path) && options.method.value_or(std::string(stored_method)) == stored_method;
}

Expected<void> sample_stored(const SampleOptions& options) {
  if (auto fits = check_stored(options); !fits) return fits;
  SampleOptions without_method = options;
  without_method.method.reset();
  const auto request = sample_request(without_method);
  if (!request) return tl::unexpected(request.error());
  const auto source = stored_motion(request->input);
  if (!source) return tl::unexpected(source.error());
  const Domain domain = source->curve.orientation.domain();
  const TimeRequest wanted = anchored(request->times, Decimal());
  const auto times = SampleTimes::make(wanted, Decimal(), domain);
  if (!times) return tl::unexpected(times.error());
  if (request->extrapolation == Extrapolation::hold) warn(range_warnings(wanted, Decimal(), domain));
  if (request->extrapolation == Extrapolation::error)
    if (auto stray = times->outside(domain)) return tl::unexpected(std::move(*stray));
  const io::SampleColumns columns = with_positions(request->columns, source->curve.position.has_value());
  SampleReport report{.input = options.input.path,
                      .output = request->output,
                      .method = std::string(stored_method),
                      .method_text = std::string(stored_method),
                      .keys = source->keys,
                      .columns = columns,
                      .samples = times->size(),
                      .extrapolation = request->extrapolation,
                      .start = Decimal::from_double(domain.start),
                      .end = Decimal::from_double(domain.end),
                      .keys_held = true};
  const Sampling sampling{source->curve, *times, columns, request->extrapolation, request->threads, nullptr};
  return open_samples(request->output, columns, times->size())
      .and_then([&](Noted<io::SampleWriter> output) {
        return write_samples(output.file, sampling, request->progress).and_then([&](std::size_t held) {
          report.held_samples = held;
          return put_in_place(std::move(output));
        });
      })
      .and_then([&] { return summarise(options.summary, report); });
}

Expected<void> write_curve_scene(const SampleOptions& options, const SampleRequest& request, const CurveScene& source) {
  const auto writing = scene_writing(options.output);
  if (!writing) return tl::unexpected(writing.error());
  if (scenes::scene_format_of(request.output) != &scenes::gltf_format)
    return usage_failure("-o: found a file that holds every frame, wanted glTF, such as motion.glb");
  Clip clip{.name = std::string(file_name_of(request.input.path))};
  clip.name = clip.name.substr(0, clip.name.rfind('.'));
  CurveSceneReport report = request.tolerance ? add_cubics(clip, source.curve, *request.tolerance)
                                              : add_samples(clip, source.curve, source.times);
  report.input = request.input.path;
  report.output = request.output;
  report.method = request.method.name;
  report.keys = source.keys;
  return Skeleton::make({{.name = "body"}}).and_then([&](Skeleton skeleton) {
    scenes::Scene scene{.skeleton = std::move(skeleton)};
    scene.clips.push_back(std::move(clip));
    return write_scene(request.output, scene, *writing).and_then([&] { return summarise(options.summary, report); });
  });
}

}  // namespace orispline::cli
