// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/scenes/scene_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

/// A file larger than this is not read [bytes].
inline constexpr std::size_t largest_scene_file = std::size_t{2} << 30;

/// All bytes of a file. Errors (bad_access): it cannot be read; it is larger than `largest_scene_file`.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::string> bytes_of_file(const std::string& path);

/// Reads the skeleton and the clips of a file, in the format of its extension, and checks them by check_clip().
///
/// Errors name the file: bad_access; bad_data; bad_argument for an extension of no format.
[[nodiscard]] ORISPLINE_EXPORT Expected<Scene> read_scene(const std::string& path, const SceneReading& reading = {});

/// The bytes of a file in the format of the extension of `path`; what the scene's file held besides is passed on where
/// that is the same format.
///
/// Errors: bad_argument for an extension of no format; bad_data for what the format cannot hold.
[[nodiscard]] ORISPLINE_EXPORT Expected<SceneWritten> written_scene(const Scene& scene, const std::string& path,
                                                                    const SceneWriting& writing = {});

/// Writes a scene in the format of the extension of `path`; what the scene's file held besides is passed on where that
/// is the same format. The file appears complete or not at all. Returns what the format had no room for.
///
/// Errors: bad_access; bad_argument for an extension of no format; bad_data for what the format cannot hold.
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<Warning>> write_scene(const Scene& scene, const std::string& path,
                                                                          const SceneWriting& writing = {});

}}}  // namespace orispline::scenes
