// SPDX-License-Identifier: Apache-2.0
#include "output/scene_output.hpp"

#include <utility>

#include <orispline/scenes/scene_file.hpp>

#include "output/gathered_output.hpp"
#include "output/noted_output.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

Expected<scenes::WrittenKeys> write_counted_scene(const std::string& path, const scenes::Scene& scene,
                                                  const scenes::SceneWriting& writing) {
  auto written = scenes::written_scene(scene, path, writing);
  if (!written) return tl::unexpected(std::move(written.error()));
  return open_output(path)
      .and_then([&](Noted<io::OutputFile> output) {
        return output.file.write(written->bytes).and_then([&] { return put_in_place(std::move(output)); });
      })
      .map([&] {
        warn(written->warnings);
        return written->keys;
      });
}

Expected<void> write_scene(const std::string& path, const scenes::Scene& scene, const scenes::SceneWriting& writing) {
  return write_counted_scene(path, scene, writing).map([](const scenes::WrittenKeys&) {});
}

Expected<void> write_edited_scene(const std::string& path, scenes::Scene scene, scenes::SceneWriting writing,
                                  const jobs::TaskOutcome& outcome) {
  if (!writing.rate && scenes::scene_format_of(path) == &scenes::bvh_format)
    writing.rate = jobs::found<jobs::ClipOutcome>(outcome).request.edits.rate;
  return write_scene(path, scenes::with_motion(std::move(scene), outcome.scenes.front()), writing);
}

}  // namespace orispline::cli
