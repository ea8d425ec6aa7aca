// SPDX-License-Identifier: Apache-2.0
// A glTF file, after bytes of options: what the jobs of clips promise of every file that can be read.
#include <fuzz/claim.hpp>
#include <fuzz/fuzz_input.hpp>
#include <fuzz/gltf_mutator.hpp>
#include <fuzz/outcome_claims.hpp>
#include <orispline/jobs/difference.hpp>
#include <orispline/jobs/reduce.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline::fuzz {

const std::size_t option_bytes = 4;

namespace {

using scenes::Scene;

/// Of a rotation that single precision has rounded [rad], and of a length.
constexpr double stored_rounding = 1e-6;

/// Lengths whose products along a chain of joints are finite. Beyond, distances in the world may have no number.
bool has_finite_places(const Scene& scene) {
  constexpr std::size_t most_joints = 64;
  constexpr double longest = 1e30, widest = 1e3;
  const auto within = [](double most) {
    return [most](const Eigen::Vector3d& v) { return v.cwiseAbs().maxCoeff() <= most; };
  };
  const auto are_within = [&](const std::vector<VectorChannel>& channels, double most) {
    return std::ranges::all_of(channels, [&](const VectorChannel& channel) {
      return std::ranges::all_of(channel.values, within(most)) &&
             std::ranges::all_of(channel.in_tangents, within(most)) &&
             std::ranges::all_of(channel.out_tangents, within(most));
    });
  };
  return scene.skeleton.size() <= most_joints &&
         std::ranges::all_of(scene.skeleton.joints(),
                             [&](const Joint& joint) {
                               return within(longest)(joint.rest.translation) && within(widest)(joint.rest.scale);
                             }) &&
         std::ranges::all_of(scene.clips, [&](const Clip& clip) {
           return are_within(clip.translations, longest) && are_within(clip.scales, widest);
         });
}

void claim_sound(const Skeleton& skeleton, const Clip& clip) {
  const auto sound = check_clip(skeleton, clip);
  claim(sound.has_value(), "a clip that is not sound: {}", sound ? "" : describe(sound.error()));
}

std::vector<std::size_t> all_joints(const Skeleton& skeleton) {
  std::vector<std::size_t> joints(skeleton.size());
  for (std::size_t i = 0; i < joints.size(); ++i) joints[i] = i;
  return joints;
}

bool warns_of(const std::vector<Warning>& warnings, std::string_view option) {
  return std::ranges::any_of(warnings, [&](const Warning& warning) { return warning.option == option; });
}

ClipReduceOptions fuzzed_reduction(FuzzInput& input) {
  constexpr std::array methods{"cubicspline", "hermite-c1", "slerp", "auto", "timed-c2", "squad-timed"};
  ClipReduceOptions options{.method = Method(methods[input.below(methods.size())])};
  const double size = std::pow(10.0, -static_cast<double>(input.below(7)));
  Flags flags(input);
  const unsigned bounds = flags.next(4);
  if (bounds != 1) options.tolerance = size;
  if (bounds == 1 || bounds == 2) options.world_tolerance = size;
  if (bounds == 3) options.position_tolerance = 10.0 * size;
  if (flags.next()) options.between = BetweenSamples::stored;
  options.closed = flags.next();
  return options;
}

/// At every key that a channel had, and in the world at all times of keys.
void claim_within(const jobs::ReduceSceneOutcome& outcome, const Clip& before, const Clip& after) {
  const Skeleton& skeleton = outcome.request.skeleton;
  const ClipReduceOptions& options = outcome.request.options;
  claim_sound(skeleton, after);
  claim(after.rotations.size() <= before.rotations.size(), "there are more channels than before");
  const ClipMotion motion(skeleton, after), motion_before(skeleton, before);
  if (std::isfinite(options.tolerance) && !warns_of(outcome.warnings, "tolerance"))
    for (const RotationChannel& channel : before.rotations)
      for (std::size_t k = 0; k < channel.size(); ++k) {
        const double off =
            angular_distance(motion.local_pose(channel.joint, channel.times[k]).rotation, channel.values[k]);
        claim(off <= options.tolerance + stored_rounding, "joint {}, key {}: off by {} rad, allowed {}", channel.joint,
              k, off, options.tolerance);
      }
  const std::vector<double> times = key_times(before);
  if (!std::isfinite(options.world_tolerance) || warns_of(outcome.warnings, "world_tolerance") || times.empty()) return;
  const auto worst = differences(motion_before, motion, all_joints(skeleton), times, options.shell);
  for (std::size_t i = 0; i < worst.size(); ++i)
    claim(worst[i].distance.value <= options.world_tolerance * (1.0 + 1e-9),
          "joint {} is off by {} in the world, allowed {}", i, worst[i].distance.value, options.world_tolerance);
}

void try_reduce(FuzzInput& input, const Scene& scene) {
  jobs::ReduceSceneRequest request{.file = {.name = "a.glb", .format = {.file = "a glTF file", .holds_floats = true}},
                                   .skeleton = scene.skeleton,
                                   .clips = scene.clips,
                                   .options = fuzzed_reduction(input),
                                   .threads = 1};
  const Situation situation([options = request.options] {
    return fmt::format("reduce to {} rad, {} m, {} m in the world by {}", options.tolerance, options.position_tolerance,
                       options.world_tolerance, options.method.name);
  });
  const auto outcome = jobs::reduce_scene(std::move(request));
  if (!outcome) return claim_plain(outcome.error());
  claim_told(*outcome);
  claim(outcome->reductions.size() == scene.clips.size(), "{} clips", outcome->reductions.size());
  for (std::size_t i = 0; i < scene.clips.size(); ++i)
    claim_within(*outcome, scene.clips[i], outcome->reductions[i].clip);
}

void try_smooth(FuzzInput& input, const Scene& scene) {
  jobs::SmoothClipsRequest request{.name = "a.glb", .skeleton = scene.skeleton, .clips = scene.clips, .threads = 1};
  request.options.loss = std::array{Loss::robust, Loss::l2, Loss::huber, Loss::tukey}[input.below(4)];
  request.options.penalty = std::array{Penalty::acceleration, Penalty::jerk}[input.below(2)];
  if (const std::size_t stated = input.below(4); stated > 0)
    request.options.noise = std::pow(10.0, -static_cast<double>(stated));
  const auto outcome = jobs::smooth_clips(std::move(request));
  if (!outcome) return claim_plain(outcome.error());
  claim_told(*outcome);
  claim(outcome->clips.size() == scene.clips.size(), "{} clips", outcome->clips.size());
  for (const ClipSmoothing& clip : outcome->clips) claim_sound(scene.skeleton, clip.clip);
}

/// A file beside itself.
void try_difference(FuzzInput& input, const Scene& scene) {
  const MotionFile file{.name = "a.glb", .skeleton = scene.skeleton, .clips = scene.clips};
  jobs::DifferenceRequest request{.first = file, .second = file, .threads = 1};
  if (input.below(2) == 1) request.rate = 30.0;
  const double longest = 100.0;  // [s]
  if (std::ranges::any_of(scene.clips,
                          [&](const Clip& clip) { return clip.domain().end - clip.domain().start > longest; }))
    request.rate.reset();
  const auto outcome = jobs::difference(std::move(request));
  if (!outcome) return claim_plain(outcome.error());
  claim_numbers(document_of(*outcome));
  claim(!summary_of(*outcome).empty(), "there is no summary");
  claim(outcome->counterparts.only_in_first == 0, "{} joints without a counterpart",
        outcome->counterparts.only_in_first);
  for (const jobs::ClipDifference& clip : outcome->clips)
    for (const JointDifference& worst : clip.worst)
      claim(worst.angle.value == 0.0 && worst.translation.value == 0.0 && worst.distance.value == 0.0,
            "it differs from itself by {} rad, {} m", worst.angle.value, worst.distance.value);
}

}
}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  FuzzInput input(data, size);
  FuzzInput options = input.part(option_bytes);
  const auto scene = scenes::gltf_format.read(input.rest(), "/nowhere/fuzzed.gltf", {});
  if (!scene) return claim_plain(scene.error()), 0;
  for (const Clip& clip : scene->clips)
    if (!check_clip(scene->skeleton, clip)) return 0;
  if (!has_finite_places(*scene)) return 0;
  const std::size_t job = options.below(4);
  if (job < 2) try_reduce(options, *scene);
  if (job == 2) try_smooth(options, *scene);
  if (job == 3) try_difference(options, *scene);
  return 0;
}
