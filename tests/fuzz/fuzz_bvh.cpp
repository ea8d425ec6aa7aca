// SPDX-License-Identifier: Apache-2.0
// A BVH file: what is read is sound, and written it is the same file; as a scene from elsewhere it has the same motion.
#include <algorithm>
#include <set>

#include <fuzz/claim.hpp>
#include <fuzz/fuzz_input.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline::fuzz { namespace {

using namespace scenes;

Scene read_again(const SceneWritten& written) {
  const Situation situation([&] { return "written as\n" + written.bytes; });
  auto scene = bvh_format.read(written.bytes, "again.bvh", {});
  claim(scene.has_value(), "what was written is refused: {}", scene ? "" : describe(scene.error()));
  claim(check_clip(scene->skeleton, scene->clips.at(0)).has_value(), "the clip is not sound");
  return std::move(*scene);
}

void claim_plain_with_line(const Error& error) {
  claim_plain(error);
  claim(!error.where.file.empty() && error.where.line.value_or(0) > 0, "no line: {}", describe(error));
}

/// Written as it was read, with the same hierarchy and the same bits.
void claim_same(const Scene& scene, std::string_view text) {
  const auto written = bvh_format.write(scene, "out.bvh", {});
  claim(written.has_value(), "cannot be written: {}", written ? "" : describe(written.error()));
  claim(written->warnings.empty(), "a warning about what was only read");
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  const std::size_t size = std::min(written->bytes.find("MOTION\n"), written->bytes.find("MOTION\r\n"));
  claim(text.starts_with(std::string_view(written->bytes).substr(0, size)), "another hierarchy:\n{}", written->bytes);
  const Scene again = read_again(*written);
  const Clip &found = again.clips[0], &wanted = scene.clips[0];
  for (std::size_t c = 0; c < wanted.rotations.size(); ++c) {
    claim(found.rotations[c].times == wanted.rotations[c].times, "other times");
    for (std::size_t k = 0; k < wanted.rotations[c].size(); ++k)
      claim(found.rotations[c].values[k].coeffs() == wanted.rotations[c].values[k].coeffs(), "another rotation");
  }
  for (std::size_t c = 0; c < wanted.translations.size(); ++c)
    claim(found.translations[c].values == wanted.translations[c].values, "other translations");
}

/// Whether joints can be told by their names in what is written.
bool has_plain_names(const Skeleton& skeleton) {
  std::set<std::string_view> names;
  for (const Joint& joint : skeleton.joints())
    if (joint.name.find_first_of(" \t\v\f") != std::string::npos || !names.insert(joint.name).second) return false;
  return true;
}

/// Without what the file said beside skeleton and clip.
void claim_same_motion_from_elsewhere(Scene scene) {
  scene.source.reset();
  const auto written = bvh_format.write(scene, "out.bvh", {});
  if (!written) return claim_plain(written.error());
  const Scene again = read_again(*written);
  if (!has_plain_names(scene.skeleton)) return;
  const Clip& clip = again.clips[0];
  for (const RotationChannel& wanted : scene.clips[0].rotations) {
    const auto joint = again.skeleton.find(scene.skeleton[wanted.joint].name);
    claim(joint.has_value(), "a joint is lost");
    const auto found = std::ranges::find(clip.rotations, *joint, &RotationChannel::joint);
    claim(found != clip.rotations.end() && found->size() == wanted.size(), "frames are lost");
    for (std::size_t k = 0; k < wanted.size(); ++k) {
      const double off = angular_distance(found->values[k], wanted.values[k]);
      claim(off <= 1e-12, "a rotation is {} rad off", off);
    }
  }
}

}}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  const std::string_view text = FuzzInput(data, size).rest();
  const auto scene = scenes::bvh_format.read(text, "fuzzed.bvh", {});
  if (!scene) return claim_plain_with_line(scene.error()), 0;
  claim(scene->clips.size() == 1, "{} clips", scene->clips.size());
  const auto sound = check_clip(scene->skeleton, scene->clips[0]);
  claim(sound.has_value(), "not sound: {}", sound ? "" : describe(sound.error()));
  claim_plain(scene->warnings);
  claim_same(*scene, text);
  claim_same_motion_from_elsewhere(*scene);
  return 0;
}
