// SPDX-License-Identifier: Apache-2.0
// An FBX or Collada file, after a byte that says which: what assimp reads of it is a sound scene, or the error is
// plain.
#include <fuzz/claim.hpp>
#include <fuzz/fuzz_input.hpp>
#include <orispline/scenes/assimp.hpp>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace orispline;
  using namespace orispline::fuzz;
  FuzzInput input(data, size);
  Flags flags(input);
  const scenes::SceneFormat& format = *scenes::assimp_formats()[flags.next() ? 1 : 0];
  const scenes::SceneReading reading{.drop_duplicates = flags.next()};
  const auto scene = format.read(input.rest(), "fuzzed" + std::string(format.extensions.front()), reading);
  if (!scene) return claim_plain(scene.error()), 0;
  for (const Warning& warning : scene->warnings)
    claim(is_one_printable_line(describe(warning)), "a warning that is not one printable line");
  for (const Clip& clip : scene->clips)
    if (const auto sound = check_clip(scene->skeleton, clip); !sound) return claim_plain(sound.error()), 0;
  const auto written = scenes::gltf_format.write(*scene, "scene.glb", {});
  if (!written) claim_plain(written.error());
  return 0;
}
