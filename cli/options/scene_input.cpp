// SPDX-License-Identifier: Apache-2.0
#include "options/scene_input.hpp"

#include <algorithm>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline::cli {

namespace {

/// The option that asks for other frames, of which there is one at least.
std::string_view option_of(const FrameChange& frames) {
  if (!frames.world.axes.is_none()) return "world_axes";
  if (!frames.body.axes.is_none()) return "body_axes";
  return frames.world.rotation ? "world_rotation" : "body_rotation";
}

}  // namespace

bool is_scene(const std::string& path) { return scenes::scene_format_of(path) != nullptr; }

const scenes::SceneFormat* scene_format_of(const InputRequest& input) {
  return input.read.format ? scenes::scene_format_named(input.read.format->id) : scenes::scene_format_of(input.path);
}

bool is_scene(const InputRequest& input) { return scene_format_of(input) != nullptr; }

bool is_scene(const InputOptions& options, const std::string& path) {
  const auto typed = options.reading.find("input_format");
  const bool is_stated = typed != options.reading.end() && typed->second.once;
  return is_stated ? scenes::scene_format_named(*typed->second.once) != nullptr : is_scene(path);
}

scenes::SceneReading scene_reading(const InputRequest& input) {
  return {.drop_duplicates = input.read.drop_duplicates,
          .signs = input.read.scene.signs,
          .format = input.read.format ? scene_format_of(input) : nullptr,
          .salvage = input.read.scene.salvage,
          .rest_frame = input.read.scene.rest_frame};
}

Expected<scenes::Scene> read_scene_as_typed(InputOptions options, const std::string& path) {
  options.path = path;
  return input_request(options).and_then(
      [](const InputRequest& input) { return scenes::read_scene(input.path, scene_reading(input)); });
}

Expected<scenes::Scene> open_scene(const InputRequest& input) {
  if (!is_scene(input))
    return io::read_track(input.path, input.read, input.signs).and_then([](const io::TrackFile& file) {
      return jobs::check_without_gaps(file.track).and_then([&] { return scenes::scene_of(file.track); });
    });
  if (input.read.scene.joint)
    return usage_failure("--joint: found an output that holds all joints, wanted one of a single track, such as CSV");
  if (input.read.scene.space == io::SceneTrack::Space::world)
    return usage_failure("--space: found an output that holds all joints, wanted one of a single track, such as CSV");
  if (!input.read.frames.is_none())
    return usage_failure(
        formatted("{}: found a skeleton as a whole, wanted --joint NAME and an output of one track, "
                  "such as CSV",
                  flag_of(option_of(input.read.frames))));
  return scenes::read_scene(input.path, scene_reading(input)).and_then([&](scenes::Scene scene) {
    return scenes::with_clips(std::move(scene), input.read.scene.clips);
  });
}

Error with_output_for_all(Error error, std::string_view output) {
  if (error.remedy == "clip" || error.remedy == "joint") error.message += formatted("; {} takes all of them", output);
  return error;
}

Expected<KeyCompression> compression_in(OptionText option) {
  auto compression = key_compression_in(option.text);
  if (!compression) return wanted(option, one_of(words<KeyCompression>));
  return compression;
}

Expected<scenes::SceneWriting> scene_writing(const OutputOptions& options) {
  scenes::SceneWriting writing;
  const auto scale = if_given("--position-scale", options.position_scale, [](OptionText o) { return positive_in(o); });
  if (!scale) return tl::unexpected(scale.error());
  writing.position_scale = *scale;
  const auto compression = if_given("--compress", options.compress, compression_in);
  if (!compression) return tl::unexpected(compression.error());
  writing.compression = compression->value_or(KeyCompression::none);
  for (const auto& [name, text] : options.writing) {
    if (!text) continue;
    if (name == "output_format") {
      if (scene_format_in(*text) == scenes::scene_format_of(options.path)) continue;
      return wanted({"--output-format", *text},
                    formatted("another name than '{}', which is that of {}", printable(options.path),
                              scenes::scene_format_of(options.path)->file));
    }
    if (name != "output_euler")
      return usage_failure(
          formatted("{}: found a file of skeletons as the output, which takes --output-euler alone", flag_of(name)));
    writing.euler = euler_order_of(*text);
    if (!writing.euler || writing.euler->is_proper())
      return wanted({"--output-euler", *text}, "three different axes, such as ZYX");
  }
  return writing;
}

std::shared_ptr<const MotionFile> motion_of(const std::string& name, const scenes::Scene& scene) {
  MotionFile file = scenes::motion_file_of(scene);
  file.name = name;
  return std::make_shared<const MotionFile>(std::move(file));
}

}  // namespace orispline::cli
