// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/scene_tracks.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip_motion.hpp>
#include <orispline/clip/joint_named.hpp>
#include <orispline/io/line_reader.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

namespace {

/// The first few of many names: `'a', 'b', 'c' and 40 more`.
std::string some_of(const std::vector<std::string>& names) {
  constexpr std::size_t shown = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(shown, names.size()); ++i)
    text += formatted("{}{}", i == 0 ? "" : ", ", in_quotes(names[i]));
  if (names.size() > shown) text += formatted(" and {} more", names.size() - shown);
  return text;
}

std::vector<std::string> names_of(const std::vector<Clip>& clips) {
  std::vector<std::string> names;
  names.reserve(clips.size());
  for (const Clip& clip : clips) names.push_back(clip.name);
  return names;
}

std::vector<std::string> names_of_joints(const Scene& scene, const Clip& clip) {
  std::vector<std::string> names;
  names.reserve(clip.rotations.size());
  for (const RotationChannel& channel : clip.rotations) names.push_back(scene.skeleton[channel.joint].name);
  return names;
}

bool moves(const VectorChannel* channel) {
  return channel && std::ranges::any_of(channel->values, [&](const auto& v) { return v != channel->values.front(); });
}

/// What is lost where a joint moves at other times than it turns.
std::vector<Warning> warnings_of(const Scene& scene, const Clip& clip, std::size_t joint) {
  const RotationChannel* const rotation = channel_of(clip.rotations, joint);
  const VectorChannel* const translation = channel_of(clip.translations, joint);
  if (!rotation || !moves(translation)) return {};
  const auto lost = std::ranges::count_if(translation->times,
                                          [&](double t) { return !std::ranges::binary_search(rotation->times, t); });
  if (lost == 0) return {};
  return {
      {.code = "translation_keys_left_out",
       .message = formatted("{}: {} of its translation are at other times than those of its rotation, and are left out",
                            place_of(scene.skeleton, clip, joint), counted(static_cast<std::size_t>(lost), "key")),
       .where = {.file = scene.name}}};
}

Expected<KeyframeData> local_keys(const Scene& scene, const Clip& clip, std::size_t joint) {
  const RotationChannel* const rotation = channel_of(clip.rotations, joint);
  if (!rotation)
    return failure(ErrorCode::bad_data,
                   formatted("{}: found no keys of its rotation, wanted some", place_of(scene.skeleton, clip, joint)));
  KeyframeData data{.times = rotation->times, .orientations = rotation->values};
  const Eigen::Vector3d& rest = scene.skeleton[joint].rest.translation;
  if (const VectorChannel* const translation = channel_of(clip.translations, joint)) {
    const ChannelCurve<Eigen::Vector3d> path(*translation);
    for (const double t : data.times) data.positions.push_back(path.at(t));
  } else if (!rest.isZero(0.0)) {
    data.positions.assign(data.times.size(), rest);
  }
  return data;
}

Expected<KeyframeData> world_keys(const Scene& scene, const Clip& clip, std::size_t joint) {
  return joint_curve(scene.skeleton, clip, joint, JointSpace::world).map([](const PoseCurve& curve) {
    const auto times = curve.orientation.knots().times();
    KeyframeData data{.times = {times.begin(), times.end()}};
    for (const double t : times) {
      data.orientations.push_back(curve.orientation(t));
      data.positions.push_back(curve.position->linear_motion(t).position);
    }
    return data;
  });
}

/// One track of a file, as a format of io reads it.
Expected<std::vector<io::KeyFile>> tracks_in(io::LineReader lines, const io::ReadOptions& options) {
  const SceneFormat* const stated = options.format ? scene_format_named(options.format->id) : nullptr;
  return read_scene(lines.input(), {.drop_duplicates = options.drop_duplicates,
                                    .signs = options.scene.signs,
                                    .format = stated,
                                    .salvage = options.scene.salvage,
                                    .rest_frame = options.scene.rest_frame})
      .and_then([&](const Scene& scene) { return keys_of(scene, options.scene); })
      .map_error([&](Error error) {
        if (error.where.file.empty()) error.where.file = lines.path();
        return error;
      })
      .map([&](io::KeyFile file) {
        file.data = in_frames(std::move(file.data), NewFrames(options.frames));
        file.path = lines.path();
        file.format = options.format ? options.format : io::format_of_extension(file.path);
        if (options.keep_exact_times)
          for (const double t : file.data.times) file.exact_times.push_back(Decimal::from_double(t));
        std::vector<io::KeyFile> one;
        one.push_back(std::move(file));
        return one;
      });
}

io::FormatInfo entry(const SceneFormat& format) {
  return {.id = format.id,
          .title = format.title,
          .file = format.file,
          .summary = format.summary,
          .extensions = format.extensions,
          .reading = {.tracks = tracks_in}};
}

}  // namespace

void join_formats() {
  static const std::vector<io::FormatInfo> entries = [] {
    std::vector<io::FormatInfo> all;
    for (const SceneFormat* format : scene_formats()) all.push_back(entry(*format));
    return all;
  }();
  std::vector<const io::FormatInfo*> list;
  list.reserve(entries.size());
  for (const io::FormatInfo& format : entries) list.push_back(&format);
  io::add_formats(list);
}

Expected<Scene> with_clips(Scene scene, const std::vector<std::string>& names) {
  if (names.empty()) return scene;
  std::vector<Clip> chosen;
  for (const std::string& name : names) {
    if (std::ranges::find(scene.clips, name, &Clip::name) == scene.clips.end())
      return failure(ErrorCode::bad_data,
                     formatted("found no clip {}, wanted one of {}", in_quotes(name), some_of(names_of(scene.clips))),
                     {.file = scene.name});
    if (std::ranges::find(chosen, name, &Clip::name) != chosen.end()) continue;
    std::ranges::copy_if(scene.clips, std::back_inserter(chosen), [&](const Clip& clip) { return clip.name == name; });
  }
  scene.clips = std::move(chosen);
  return scene;
}

Expected<const Clip*> only_clip(const Scene& scene) {
  if (scene.clips.size() == 1) return &scene.clips.front();
  if (scene.clips.empty()) return failure(ErrorCode::bad_data, "found no clip, wanted one", {.file = scene.name});
  const auto is_first = [&](const Clip& clip) { return clip.name == scene.clips.front().name; };
  if (std::ranges::all_of(scene.clips, is_first))
    return failure(ErrorCode::bad_data,
                   formatted("found {} clips named {}, wanted a name of its own for each", scene.clips.size(),
                             in_quotes(scene.clips.front().name)),
                   {.file = scene.name});
  return mended_by("clip",
                   formatted("found {} clips, wanted one of {}", scene.clips.size(), some_of(names_of(scene.clips))),
                   {.file = scene.name});
}

Expected<std::size_t> joint_in(const Scene& scene, const Clip& clip, const std::optional<std::string>& name) {
  const std::vector<std::string> names = names_of_joints(scene, clip);
  if (!name && names.size() == 1) return clip.rotations.front().joint;
  if (!name && names.empty())
    return failure(ErrorCode::bad_data, formatted("clip {}: found no rotation, wanted one", in_quotes(clip.name)),
                   {.file = scene.name});
  if (!name)
    return mended_by(
        "joint",
        formatted("clip {}: found {} joints, wanted one of {}", in_quotes(clip.name), names.size(), some_of(names)),
        {.file = scene.name});
  const auto joint = joint_named(scene.skeleton, *name);
  if (joint) return *joint;
  if (scene.skeleton.find(*name)) return failure(ErrorCode::bad_data, joint.error().message, {.file = scene.name});
  return failure(ErrorCode::bad_data,
                 formatted("found no joint {}, wanted one of {}", in_quotes(*name), some_of(names)),
                 {.file = scene.name});
}

Expected<io::KeyFile> keys_of(const Scene& scene, const io::SceneTrack& track) {
  return with_clips(scene, track.clips).and_then([&](const Scene& chosen) {
    const bool is_local = track.space == io::SceneTrack::Space::local;
    return only_clip(chosen).and_then([&](const Clip* clip) {
      std::size_t joint = no_parent;
      return joint_in(chosen, *clip, track.joint)
          .and_then([&](std::size_t found) {
            joint = found;
            return is_local ? local_keys(chosen, *clip, joint) : world_keys(chosen, *clip, joint);
          })
          .map([&](KeyframeData data) {
            io::KeyFile file{.data = std::move(data)};
            if (is_local) file.warnings = warnings_of(chosen, *clip, joint);
            return file;
          });
    });
  });
}

Expected<Scene> scene_of(const Track& track) {
  const Keyframes& keys = track.keys;
  Clip clip{.name = std::string(file_name_of(track.name))};
  clip.name = clip.name.substr(0, clip.name.rfind('.'));
  const std::vector<double> times(keys.times().begin(), keys.times().end());
  clip.rotations.push_back({.times = times, .values = {keys.orientations().begin(), keys.orientations().end()}});
  if (!keys.positions().empty())
    clip.translations.push_back({.times = times, .values = {keys.positions().begin(), keys.positions().end()}});
  return Skeleton::make({{.name = "body"}}).map([&](Skeleton skeleton) {
    Scene scene{.name = track.name, .skeleton = std::move(skeleton)};
    scene.clips.push_back(std::move(clip));
    return scene;
  });
}

}}}  // namespace orispline::scenes
