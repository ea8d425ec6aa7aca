// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/io/track_file.hpp>
#include <orispline/scenes/scene_file.hpp>

// One joint of a scene as a track: the door for whoever reads files of keys.

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

/// From now on io::read_keys() and all that is built on it read one track of files of skeletons too.
ORISPLINE_EXPORT void join_formats();

/// The scene with the clips that are chosen, all where none is. Error (bad_data, mended by `clip`): one that is not
/// there.
[[nodiscard]] ORISPLINE_EXPORT Expected<Scene> with_clips(Scene scene, const std::vector<std::string>& names);

/// The only clip. Error (bad_data, mended by `clip`): there are none, or several.
[[nodiscard]] ORISPLINE_EXPORT Expected<const Clip*> only_clip(const Scene& scene);

/// The joint of that name, or the only one that has a channel of rotations in the clip. Error (bad_data, mended by
/// `joint`): there is none, or several.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::size_t> joint_in(const Scene& scene, const Clip& clip,
                                                              const std::optional<std::string>& name);

/// The keys of one joint of one clip. In the frame of its parent: those of its rotation, with positions unless it
/// is at the origin throughout. In the world: at the times of all keys of the joint and of those above it.
///
/// Errors (bad_data): those of with_clips(), only_clip() and joint_in(); no keys; in the world, a scale above the joint
/// that is not the same along all axes, or negative.
[[nodiscard]] ORISPLINE_EXPORT Expected<io::KeyFile> keys_of(const Scene& scene, const io::SceneTrack& track);

/// A scene of one joint that moves as the keys say from key to key by geodesics: `body`, in a clip that is named like
/// the file of the track.
[[nodiscard]] ORISPLINE_EXPORT Expected<Scene> scene_of(const Track& track);

}}}  // namespace orispline::scenes
