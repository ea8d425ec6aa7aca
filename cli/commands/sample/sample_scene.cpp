// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_scene.hpp"

#include <set>
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
#include "output/output_folder.hpp"
#include "output/scene_output.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {
namespace {

Error located(Error error, const std::string& file) {
  if (error.where.file.empty()) error.where.file = file;
  return error;
}

Expected<scenes::Scene> opened(const InputRequest& input) {
  return scenes::read_scene(input.path, scene_reading(input)).and_then([&](scenes::Scene scene) {
    warn(scene.warnings);
    return scenes::with_clips(std::move(scene), input.read.scene.clips);
  });
}

/// Writes the samples of one joint, as the file says that it moves.
Expected<SampleReport> sample_joint(const SampleRequest& request, const scenes::Scene& scene, const Clip& clip,
                                    std::size_t joint) {
  const bool in_world = request.input.read.scene.space == io::SceneTrack::Space::world;
  const auto curve = joint_curve(scene.skeleton, clip, joint, in_world ? JointSpace::world : JointSpace::local);
  if (!curve) return tl::unexpected(located(curve.error(), request.input.path));
  const Domain domain = curve->orientation.domain();
  const TimeRequest wanted = anchored(request.times, Decimal());
  const auto times = SampleTimes::make(wanted, Decimal(), domain);
  if (!times) return tl::unexpected(times.error());
  if (request.extrapolation == Extrapolation::hold) warn(range_warnings(wanted, Decimal(), domain));
  if (request.extrapolation == Extrapolation::error)
    if (auto stray = times->outside(domain)) return tl::unexpected(std::move(*stray));
  SampleReport report{.input = request.input.path,
                      .output = request.output,
                      .method = std::string(stored_method),
                      .method_text = "the motion that is stored",
                      .keys = curve->orientation.knots().times().size(),
                      .columns = with_positions(request.columns, curve->position.has_value()),
                      .samples = times->size(),
                      .extrapolation = request.extrapolation,
                      .start = Decimal::from_double(domain.start),
                      .end = Decimal::from_double(domain.end),
                      .keys_held = true};
  const Sampling sampling{*curve, *times, report.columns, request.extrapolation, request.threads, nullptr};
  return open_samples(request.output, report.columns, times->size())
      .and_then([&](Noted<io::SampleWriter> output) {
        return write_samples(output.file, sampling, request.progress).and_then([&](std::size_t held) {
          report.held_samples = held;
          return put_in_place(std::move(output));
        });
      })
      .map([&] { return report; });
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

/// What is to be sampled, without a method.
Expected<SampleRequest> stored_request(const SampleOptions& options) {
  if (auto fits = check_stored(options); !fits) return tl::unexpected(std::move(fits.error()));
  SampleOptions without_method = options;
  without_method.method.reset();
  return sample_request(without_method);
}

/// Names of clips and joints as those of files: no two are the same.
class FileNames {
 public:
  [[nodiscard]] std::string unused(std::string_view name) {
    std::string safe(name);
    for (char& letter : safe)
      if (letter == '/' || static_cast<unsigned char>(letter) < 0x20 || letter == 0x7f) letter = '_';
    if (safe.empty() || safe.starts_with('.')) safe.insert(0, "_");
    std::string free = safe;
    for (std::size_t number = 2; !used_.insert(free).second; ++number) free = formatted("{}_{}", safe, number);
    return free;
  }

 private:
  std::set<std::string> used_;
};

/// The joints that a clip moves, in the order of the skeleton: those with keys of their own, and in the world those
/// that these carry too.
std::vector<std::size_t> joints_of(const scenes::Scene& scene, const Clip& clip, io::SceneTrack::Space space) {
  std::vector<bool> moves(scene.skeleton.size());
  for (const RotationChannel& channel : clip.rotations) moves[channel.joint] = true;
  for (const auto* const channels : {&clip.translations, &clip.scales})
    for (const VectorChannel& channel : *channels) moves[channel.joint] = true;
  std::vector<std::size_t> joints;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const std::size_t parent = scene.skeleton[i].parent;
    if (space == io::SceneTrack::Space::world && parent != no_parent && moves[parent]) moves[i] = true;
    if (moves[i]) joints.push_back(i);
  }
  return joints;
}

/// The files of samples that were written, one for each joint that moves.
struct JointsReport {
  std::string input{}, folder{};
  std::size_t files = 0, samples = 0;
};

std::string text_of(const JointsReport& report) {
  return formatted("{} from {} written to {} in {}: CLIP/JOINT\n", counted(report.samples, "sample"),
                   printable(report.input), counted(report.files, "file"), printable(report.folder));
}

Json json_of(const JointsReport& report) {
  return {{"input", report.input}, {"output", report.folder}, {"files", report.files}, {"samples", report.samples}};
}

/// What was written into a file of skeletons.
struct CurveSceneReport {
  std::string input{}, output{}, method{};
  std::size_t keys = 0, keys_written = 0, positions_written = 0;
  std::optional<double> tolerance{}, largest{};             ///< [rad], of cubics
  double position_tolerance = 0.0, largest_position = 0.0;  ///< [m]
};

std::string text_of(const CurveSceneReport& report) {
  std::string text = formatted("{} from {}, {}\n", counted(report.keys, "key"), printable(report.input), report.method);
  if (!report.largest)
    return text + formatted("{} written to {}\n", counted(report.keys_written, "sample"), destination(report.output));
  text += formatted("{} of rotations, at most {:.4g}° from the curve (tolerance {:.4g}°)\n",
                    counted(report.keys_written, "key"), *report.largest * degrees, *report.tolerance * degrees);
  if (report.positions_written > 0)
    text += formatted("{} of positions, at most {:.4g} m from the path (tolerance {:.4g} m)\n",
                      counted(report.positions_written, "key"), report.largest_position, report.position_tolerance);
  text += formatted("written to {} as cubics\n", destination(report.output));
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
    if (report.positions_written > 0) json["position_error_max_m"] = report.largest_position;
  }
  return json;
}

CurveSceneReport add_cubics(Clip& clip, const PoseCurve& curve, const SampleRequest& request) {
  auto rotation = cubic_channel(curve.orientation, *request.tolerance);
  CurveSceneReport report{.keys_written = rotation.channel.size(),
                          .tolerance = request.tolerance,
                          .largest = rotation.largest_distance,
                          .position_tolerance = request.position_tolerance};
  clip.rotations.push_back(std::move(rotation.channel));
  if (!curve.position) return report;
  auto translation = cubic_channel(*curve.position, request.position_tolerance);
  report.positions_written = translation.channel.size();
  report.largest_position = translation.largest_distance;
  clip.translations.push_back(std::move(translation.channel));
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
  const auto request = stored_request(options);
  if (!request) return tl::unexpected(request.error());
  const auto scene = opened(request->input);
  if (!scene) return tl::unexpected(scene.error());
  return scenes::only_clip(*scene)
      .and_then([&](const Clip* clip) {
        return scenes::joint_in(*scene, *clip, request->input.read.scene.joint).and_then([&](std::size_t joint) {
          return sample_joint(*request, *scene, *clip, joint);
        });
      })
      .and_then([&](const SampleReport& report) { return summarise(options.summary, report); });
}

bool asks_for_all_joints(const SampleOptions& options) {
  return options.inputs.folder && options.inputs.paths.size() == 1 && is_scene(options.inputs.paths.front()) &&
         options.method.value_or(std::string(stored_method)) == stored_method;
}

Expected<void> sample_all_joints(const SampleOptions& options) {
  SampleOptions one = options;
  one.input.path = options.inputs.paths.front();
  auto request = stored_request(one);
  if (!request) return tl::unexpected(std::move(request.error()));
  const auto extension = folder_extension(options.output, "samples");
  if (!extension) return tl::unexpected(extension.error());
  const auto scene = opened(request->input);
  if (!scene) return tl::unexpected(scene.error());
  JointsReport report{.input = one.input.path, .folder = *options.inputs.folder};
  FileNames folders;
  for (const Clip& clip : scene->clips) {
    const std::string folder = formatted("{}/{}", *options.inputs.folder, folders.unused(clip.name));
    FileNames files;
    for (const std::size_t joint : joints_of(*scene, clip, request->input.read.scene.space)) {
      const std::string& name = scene->skeleton[joint].name;
      if (request->input.read.scene.joint.value_or(name) != name) continue;
      if (auto made = make_folder(folder); !made) return made;
      request->output = formatted("{}/{}{}", folder, files.unused(name), extension->empty() ? ".csv" : *extension);
      const auto sampled = sample_joint(*request, *scene, clip, joint);
      if (!sampled) return tl::unexpected(sampled.error());
      ++report.files;
      report.samples += sampled->samples;
    }
  }
  if (report.files > 0) return summarise(options.summary, report);
  return failure(ErrorCode::bad_data, "found no joint that moves, wanted one at least", {.file = one.input.path});
}

Expected<void> write_curve_scene(const SampleOptions& options, const SampleRequest& request, const CurveScene& source) {
  const auto writing = scene_writing(options.output);
  if (!writing) return tl::unexpected(writing.error());
  if (scenes::scene_format_of(request.output) != &scenes::gltf_format)
    return usage_failure(
        "-o: found a file that holds every frame, wanted glTF, such as motion.glb; 'orispline convert "
        "--rate' makes BVH of it");
  Clip clip{.name = std::string(file_name_of(request.input.path))};
  clip.name = clip.name.substr(0, clip.name.rfind('.'));
  CurveSceneReport report =
      request.tolerance ? add_cubics(clip, source.curve, request) : add_samples(clip, source.curve, source.times);
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
