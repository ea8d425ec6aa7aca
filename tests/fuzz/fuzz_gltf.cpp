// SPDX-License-Identifier: Apache-2.0
// A glTF file, after a byte of options: what is read is sound, and written and read again it is the same motion.
#include <algorithm>
#include <cmath>

#include <fuzz/claim.hpp>
#include <fuzz/fuzz_input.hpp>
#include <fuzz/gltf_mutator.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline::fuzz {

const std::size_t option_bytes = 1;

namespace {

using namespace scenes;

double distance_of(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return (a - b).norm(); }
/// Of either sign, for signs of neighbours are aligned.
double distance_of(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
}

double allowed_for(const Eigen::Vector3d& value) { return 1e-6 * value.norm(); }
double allowed_for(const Eigen::Quaterniond&) { return 1e-6; }

/// Of a channel that does not move one key is left, or its first and its last.
template <CurvePoint P>
void claim_same(const Channel<P>& found, const Channel<P>& wanted) {
  claim(found.joint == wanted.joint, "a channel of another joint");
  claim(found.size() == wanted.size() || found.size() <= 2, "{} keys of {}", found.size(), wanted.size());
  for (std::size_t k = 0; k < found.size(); ++k) {
    const auto at = std::ranges::lower_bound(wanted.times, found.times[k]);
    claim(at != wanted.times.end() && *at == found.times[k], "a key at another time, {}", found.times[k]);
    const P& value = wanted.values[static_cast<std::size_t>(at - wanted.times.begin())];
    claim(distance_of(found.values[k], value) <= allowed_for(value), "another value of key {}", k);
  }
}

template <CurvePoint P>
void claim_same(const std::vector<Channel<P>>& found, const std::vector<Channel<P>>& wanted) {
  claim(found.size() == wanted.size(), "{} channels of {}", found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) claim_same(found[i], wanted[i]);
}

bool is_sound(const Scene& scene) {
  for (const Clip& clip : scene.clips) {
    const auto sound = check_clip(scene.skeleton, clip);
    if (!sound) return claim_plain(sound.error()), false;
  }
  return true;
}

void claim_same_when_written(const Scene& scene, const std::string& path, KeyCompression compression) {
  const auto written = gltf_format.write(scene, path, {.compression = compression});
  if (!written) return claim_plain(written.error());
  claim_plain(written->warnings);
  const auto again = gltf_format.read(written->bytes, path, {});
  claim(again.has_value(), "what was written is refused: {}", again ? "" : describe(again.error()));
  claim(is_sound(*again), "what was written is not sound");
  claim(again->skeleton.size() == scene.skeleton.size(), "{} joints", again->skeleton.size());
  claim(again->clips.size() + written->warnings.size() >= scene.clips.size(), "{} clips", again->clips.size());
  if (again->clips.size() == scene.clips.size())
    for (std::size_t i = 0; i < scene.clips.size(); ++i) {
      claim_same(again->clips[i].rotations, scene.clips[i].rotations);
      claim_same(again->clips[i].translations, scene.clips[i].translations);
      claim_same(again->clips[i].scales, scene.clips[i].scales);
      claim(again->clips[i].domain().end == scene.clips[i].domain().end, "another end");
    }
  // A number of no accessor may be that of a new one, which then stays.
  const auto twice = gltf_format.write(*again, path, {.compression = compression});
  claim(twice.has_value() && twice->bytes.size() <= written->bytes.size() + 512, "the file grows when written again");
}

}
}  // namespace orispline::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  FuzzInput input(data, size);
  FuzzInput options = input.part(option_bytes);
  Flags flags(options);
  const scenes::SceneReading reading{.drop_duplicates = flags.next()};
  const std::string path = flags.next() ? "scene.gltf" : "scene.glb";
  const bool is_from_elsewhere = flags.next();
  const auto compression = flags.next() && has_meshopt() ? KeyCompression::meshopt : KeyCompression::none;
  auto scene = scenes::gltf_format.read(input.rest(), "/nowhere/fuzzed.gltf", reading);
  if (!scene) return claim_plain(scene.error()), 0;
  claim_plain(scene->warnings);
  if (!is_sound(*scene)) return 0;
  if (is_from_elsewhere) scene->source.reset();
  claim_same_when_written(*scene, path, compression);
  return 0;
}
