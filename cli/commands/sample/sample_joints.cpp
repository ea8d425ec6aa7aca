// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_joints.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/jobs/sample_steps.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "commands/sample/sample_report.hpp"
#include "commands/sample/sample_request.hpp"
#include "options/scene_input.hpp"
#include "output/standard_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

/// Names of clips and joints as those of files: no two are the same.
class FileNames {
 public:
  [[nodiscard]] std::string unused(std::string_view name) {
    std::string safe = printable(name, '_');
    std::ranges::replace(safe, '/', '_');
    if (safe.empty() || safe.starts_with('.')) safe.insert(0, "_");
    safe.resize(length_within(safe, longest));
    std::size_t& number = next_.try_emplace(safe, 1).first->second;
    std::string free;
    do {
      free = number == 1 ? safe : formatted("{}_{}", safe, number);
      ++number;
    } while (!used_.insert(free).second);
    return free;
  }

 private:
  /// With the number of a second one, the extension and `.part` it is a name that file systems take [bytes].
  static constexpr std::size_t longest = 200;

  /// Of whole characters of UTF-8.
  static std::size_t length_within(std::string_view name, std::size_t length) {
    if (name.size() <= length) return name.size();
    while (length > 0 && (static_cast<unsigned char>(name[length]) & 0xc0) == 0x80) --length;
    return length;
  }

  std::set<std::string> used_;
  std::map<std::string, std::size_t> next_;  ///< number to try for a name
};

JointSpace space_of(const SampleRequest& request) {
  return request.input.read.scene.space == io::SceneTrack::Space::world ? JointSpace::world : JointSpace::local;
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

/// A joint of a clip, and the file for it.
struct JointFile {
  const Clip* clip;
  std::size_t joint;
  std::string path;
};

/// OUT, or OUT/STEM of several inputs.
std::string folder_of(const SampleArguments& options) {
  const SeveralInputs& inputs = options.inputs;
  const bool is_only_one = !inputs.list && inputs.paths.size() == 1 && inputs.paths.front() == options.input.path;
  return is_only_one ? *inputs.folder : std::filesystem::path(options.output.path).replace_extension().string();
}

Expected<std::vector<JointFile>> files_of(const SampleArguments& options, const SampleRequest& request,
                                          const scenes::Scene& scene) {
  const auto& named = request.input.read.scene.joint;
  std::vector<JointFile> list;
  const std::string extension = std::filesystem::path(request.output).extension().string();
  FileNames folders;
  for (const Clip& clip : scene.clips) {
    if (named && !scene.skeleton.find(*named)) return tl::unexpected(scenes::joint_in(scene, clip, named).error());
    const std::string folder = formatted("{}/{}", folder_of(options), folders.unused(clip.name));
    FileNames files;
    for (const std::size_t joint : jobs::moved_joints(scene.skeleton, clip, space_of(request))) {
      const std::string& name = scene.skeleton[joint].name;
      if (named.value_or(name) == name)
        list.push_back({&clip, joint, formatted("{}/{}{}", folder, files.unused(name), extension)});
    }
  }
  if (!list.empty()) return list;
  return failure(ErrorCode::bad_data, "found no joint that moves, wanted one at least", {.file = request.input.path});
}

Error located(Error error, const std::string& file) {
  if (error.where.file.empty()) error.where.file = file;
  return error;
}

/// The chosen clips.
Expected<scenes::Scene> opened(const InputRequest& input) {
  return scenes::read_scene(input.path, scene_reading(input)).and_then([&](scenes::Scene scene) {
    warn(scene.warnings);
    return scenes::with_clips(std::move(scene), input.read.scene.clips);
  });
}

/// The motion of one joint, and when it is to be sampled.
struct JointMotion {
  PoseCurve curve;
  jobs::TimesOnCurve on_curve;
};

Expected<JointMotion> motion_of(const SampleRequest& request, const scenes::Scene& scene, const Clip& clip,
                                std::size_t joint) {
  auto curve = joint_curve(scene.skeleton, clip, joint, space_of(request), request.input.read.frames);
  if (!curve) return tl::unexpected(located(std::move(curve.error()), request.input.path));
  return jobs::times_on_curve(request.rows.times, Decimal(), curve->orientation.domain(), request.rows.extrapolation)
      .map([&](jobs::TimesOnCurve times) {
        return JointMotion{std::move(*curve), std::move(times)};
      });
}

Expected<SampleReport> write_joint(const SampleRequest& request, const JointMotion& motion) {
  return write_samples(request, {.outcome = jobs::outcome_of_joint(request.input.path, motion.curve)}, motion.curve,
                       motion.on_curve.times);
}

}  // namespace

Expected<void> sample_joint(const SampleArguments& options) {
  const auto request = stored_request(options);
  if (!request) return tl::unexpected(request.error());
  const auto scene = opened(request->input);
  if (!scene) return tl::unexpected(scene.error());
  return scenes::only_clip(*scene)
      .and_then([&](const Clip* clip) {
        return scenes::joint_in(*scene, *clip, request->input.read.scene.joint).and_then([&](std::size_t joint) {
          return motion_of(*request, *scene, *clip, joint);
        });
      })
      .and_then([&](const JointMotion& motion) {
        warn(motion.on_curve.warnings);
        return write_joint(*request, motion);
      })
      .map_error([](Error error) { return with_output_for_all(std::move(error), "--output-folder FOLDER"); })
      .and_then([&](const SampleReport& report) { return summarise(options.summary, report); });
}

Expected<void> sample_joints(const SampleArguments& options) {
  auto request = stored_request(options);
  if (!request) return tl::unexpected(std::move(request.error()));
  const auto scene = opened(request->input);
  if (!scene) return tl::unexpected(scene.error());
  const auto files = files_of(options, *request, *scene);
  if (!files) return tl::unexpected(files.error());
  std::vector<Warning> warnings;
  std::size_t warned = 0;
  for (const JointFile& file : *files) {
    auto able = motion_of(*request, *scene, *file.clip, file.joint);
    if (!able) return tl::unexpected(std::move(able.error()));
    if (!able->on_curve.warnings.empty() && warned++ == 0) warnings = std::move(able->on_curve.warnings);
  }
  for (Warning& warning : warnings)
    if (warned > 1)
      warning.message += formatted("; so it is with {} other {}", warned - 1, warned == 2 ? "joint" : "joints");
  warn(warnings);
  JointsReport report{.input = request->input.path, .folder = folder_of(options), .files = files->size()};
  for (const JointFile& file : *files) {
    request->output = file.path;
    const auto sampled = motion_of(*request, *scene, *file.clip, file.joint).and_then([&](const JointMotion& motion) {
      return write_joint(*request, motion);
    });
    if (!sampled) return tl::unexpected(sampled.error());
    report.samples += sampled->outcome.samples;
  }
  return summarise(options.summary, report);
}

}  // namespace orispline::cli
