// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/inspect_scene.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/jobs/clip.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::size_t keys_in(const std::vector<VectorChannel>& channels) {
  std::size_t keys = 0;
  for (const VectorChannel& channel : channels) keys += channel.size();
  return keys;
}

bool is_constant(const RotationChannel& channel) {
  return std::ranges::all_of(channel.values, [&](const Eigen::Quaterniond& value) {
    return value.coeffs() == channel.values.front().coeffs();
  });
}

void add_steps(SceneCounts& counts, const Skeleton& skeleton, const RotationChannel& channel) {
  for (std::size_t i = 0; i + 1 < channel.size(); ++i) {
    if (channel.values[i].dot(channel.values[i + 1]) < 0.0) ++counts.sign_flips;
    const double step = angular_distance(channel.values[i], channel.values[i + 1]);
    if (step <= counts.widest_step) continue;
    counts.widest_step = step;
    counts.widest_step_joint = skeleton[channel.joint].name;
    counts.widest_step_time = channel.times[i];
  }
}

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

std::string clips_table(const InspectSceneOutcome& outcome) {
  const std::vector<Clip>& clips = outcome.request.file.clips;
  if (clips.empty()) return "";
  std::size_t width = 4;
  for (const Clip& clip : clips) width = std::max(width, printable(clip.name).size());
  std::string table = formatted("\n  {:<{}}{:>11}{:>8}{:>9}{:>7}{:>10}{:>11}{:>15}\n", "clip", width, "duration",
                                "tracks", "keys", "flips", "max step", "seam", "seam rate");
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const SceneCounts& counts = outcome.clips[i];
    const Domain domain = clips[i].whole_domain();
    table += formatted("  {:<{}}{:>9.4g} s{:>8}{:>9}{:>7}{:>9.4g}°{:>10.4g}°{:>11.4g} °/s\n", printable(clips[i].name),
                       width, domain.end - domain.start, counts.rotation_tracks, counts.rotation_keys,
                       counts.sign_flips, counts.widest_step * degrees, outcome.seams[i].pose.value * degrees,
                       outcome.seams[i].rate.value * degrees);
  }
  return table;
}

}  // namespace

SceneCounts counts_of(const Skeleton& skeleton, std::span<const Clip> clips) {
  SceneCounts counts;
  for (const Clip& clip : clips) {
    counts.rotation_tracks += clip.rotations.size();
    counts.translation_tracks += clip.translations.size();
    counts.translation_keys += keys_in(clip.translations);
    counts.scale_tracks += clip.scales.size();
    counts.scale_keys += keys_in(clip.scales);
    for (const RotationChannel& channel : clip.rotations) {
      counts.rotation_keys += channel.size();
      if (is_constant(channel)) ++counts.constant_rotation_tracks;
      add_steps(counts, skeleton, channel);
    }
  }
  return counts;
}

Json json_of(const SceneCounts& counts) {
  Json json{{"rotation_tracks", counts.rotation_tracks},
            {"rotation_keys", counts.rotation_keys},
            {"constant_rotation_tracks", counts.constant_rotation_tracks},
            {"translation_tracks", counts.translation_tracks},
            {"translation_keys", counts.translation_keys},
            {"scale_tracks", counts.scale_tracks},
            {"scale_keys", counts.scale_keys},
            {"sign_flips", counts.sign_flips},
            {"widest_step_deg", counts.widest_step * degrees}};
  if (counts.widest_step == 0.0) return json;
  json["widest_step_joint"] = counts.widest_step_joint;
  json["widest_step_time_s"] = counts.widest_step_time;
  return json;
}

InspectSceneOutcome inspect_scene(InspectSceneRequest request) {
  InspectSceneOutcome outcome{.request = std::move(request)};
  const MotionFile& file = outcome.request.file;
  outcome.counts = counts_of(file.skeleton, file.clips);
  for (const Clip& clip : file.clips) {
    outcome.clips.push_back(counts_of(file.skeleton, {&clip, 1}));
    outcome.seams.push_back(seam_of(clip));
  }
  return outcome;
}

Json document_of(const InspectSceneOutcome& outcome) {
  const MotionFile& file = outcome.request.file;
  Json clips = Json::array(), joints = Json::array();
  for (const Joint& joint : file.skeleton.joints()) joints.push_back(joint.name);
  for (std::size_t i = 0; i < file.clips.size(); ++i) {
    const Domain domain = file.clips[i].whole_domain();
    Json clip{{"name", file.clips[i].name}, {"start_s", domain.start}, {"end_s", domain.end}};
    clip.update(json_of(outcome.clips[i]));
    clip.update(json_of(outcome.seams[i], file.skeleton));
    clips.push_back(std::move(clip));
  }
  Json json = json_of(outcome.counts);
  json["joints"] = std::move(joints);
  json["clips"] = std::move(clips);
  return json;
}

std::string summary_of(const InspectSceneOutcome& outcome) {
  const MotionFile& file = outcome.request.file;
  const SceneCounts& counts = outcome.counts;
  return formatted(
             "{} ({})\njoints        {}\nclips         {}\nrotations     {}\ntranslations  {}\n"
             "scales        {}\nsign flips    {}\nwidest step   {}\n",
             printable(file.name), file.format.title, file.skeleton.size(), file.clips.size(), rotations_text(counts),
             tracks_text(counts.translation_tracks, counts.translation_keys),
             tracks_text(counts.scale_tracks, counts.scale_keys), counts.sign_flips, step_text(counts)) +
         clips_table(outcome);
}

}}}  // namespace orispline::jobs
