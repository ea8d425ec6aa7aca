// SPDX-License-Identifier: Apache-2.0
#include "commands/inspect/inspect_scene.hpp"

#include <algorithm>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/math/degrees.hpp>

#include "options/scene_input.hpp"
#include "output/scene_counts.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

std::string tracks_text(std::size_t tracks, std::size_t keys) {
  return tracks == 0 ? "none" : formatted("{} with {}", counted(tracks, "track"), counted(keys, "key"));
}

std::string rotations_text(const SceneCounts& counts) {
  const std::string text = tracks_text(counts.rotation_tracks, counts.rotation_keys);
  return counts.rotation_tracks == 0 ? text
                                     : formatted("{}, {} of them constant", text, counts.constant_rotation_tracks);
}

std::string step_text(const SceneCounts& counts) {
  if (counts.widest_step == 0.0) return "none";
  return formatted("{:.4g}° of joint {} after {:.6g} s", counts.widest_step * degrees,
                   in_quotes(counts.widest_step_joint), counts.widest_step_time);
}

std::string line_of(const Skeleton& skeleton, const Clip& clip, std::size_t width) {
  const SceneCounts counts = counts_of(skeleton, clip);
  const Domain domain = clip.whole_domain();
  return formatted("  {:<{}}{:>9.4g} s{:>8}{:>9}{:>7}{:>9.4g}°\n", printable(clip.name), width,
                   domain.end - domain.start, counts.rotation_tracks, counts.rotation_keys, counts.sign_flips,
                   counts.widest_step * degrees);
}

std::string text_of(const scenes::Scene& scene) {
  const SceneCounts counts = counts_of(scene);
  std::string text = formatted(
      "{} ({})\njoints        {}\nclips         {}\nrotations     {}\ntranslations  {}\n"
      "scales        {}\nsign flips    {}\nwidest step   {}\n",
      printable(scene.name), scene.format->title, scene.skeleton.size(), scene.clips.size(), rotations_text(counts),
      tracks_text(counts.translation_tracks, counts.translation_keys),
      tracks_text(counts.scale_tracks, counts.scale_keys), counts.sign_flips, step_text(counts));
  if (scene.clips.empty()) return text;
  std::size_t width = 4;
  for (const Clip& clip : scene.clips) width = std::max(width, printable(clip.name).size());
  text += formatted("\n  {:<{}}{:>11}{:>8}{:>9}{:>7}{:>10}\n", "clip", width, "duration", "tracks", "keys", "flips",
                    "max step");
  for (const Clip& clip : scene.clips) text += line_of(scene.skeleton, clip, width);
  return text;
}

Json json_of(const scenes::Scene& scene) {
  Json clips = Json::array(), joints = Json::array();
  for (const Joint& joint : scene.skeleton.joints()) joints.push_back(joint.name);
  for (const Clip& clip : scene.clips) {
    const Domain domain = clip.whole_domain();
    Json json{{"name", clip.name}, {"start_s", domain.start}, {"end_s", domain.end}};
    json.update(json_of(counts_of(scene.skeleton, clip)));
    clips.push_back(std::move(json));
  }
  Json json{{"input", scene.name}, {"input_format", scene.format->id}};
  json.update(json_of(counts_of(scene)));
  json["joints"] = std::move(joints);
  json["clips"] = std::move(clips);
  return json;
}

}  // namespace

bool is_about_scene(const InspectArguments& options, const InputRequest& input) {
  return is_scene(input) && options.methods.empty() && !input.read.scene.joint;
}

Expected<void> inspect_scene(const InspectArguments& options, const InputRequest& input) {
  if (input.read.scene.space == io::SceneTrack::Space::world)
    return usage_failure("--space: found no joint, wanted --joint NAME as well");
  const auto scene = open_scene(input);
  if (!scene) return tl::unexpected(scene.error());
  warn(scene->warnings);
  return print_document(options.json ? document(json_of(*scene)) : text_of(*scene));
}

}  // namespace orispline::cli
