// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include <orispline/jobs/difference.hpp>
#include <orispline/scenes/scene_file.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "options/input_options.hpp"
#include "options/output_options.hpp"

namespace orispline::cli {

/// Whether a name ends as those of files of skeletons do.
[[nodiscard]] bool is_scene(const std::string& path);

/// The format of skeletons that an input is stated to have, else that of its name; null if it is none of them.
[[nodiscard]] const scenes::SceneFormat* scene_format_of(const InputRequest& input);
[[nodiscard]] bool is_scene(const InputRequest& input);

/// Whether a typed path, read as the options say, is a file of skeletons.
[[nodiscard]] bool is_scene(const InputOptions& options, const std::string& path);

/// How it is to be read.
[[nodiscard]] scenes::SceneReading scene_reading(const InputRequest& input);

/// A file of skeletons with all its clips, read as it was typed for INPUT. Errors: bad_argument; those of
/// scenes::read_scene().
[[nodiscard]] Expected<scenes::Scene> read_scene_as_typed(InputOptions options, const std::string& path);

/// The chosen clips of a file of skeletons; of a file of keys the scene of one joint that moves as they say. Errors
/// name the file; bad_argument where one joint of many is chosen.
[[nodiscard]] Expected<scenes::Scene> open_scene(const InputRequest& input);

/// The clips of a file as a task takes them.
[[nodiscard]] std::shared_ptr<const MotionFile> motion_of(const std::string& name, const scenes::Scene& scene);

/// An error that asks for one clip or one joint, with the output that takes all of them, such as `-o all.glb`; any
/// other as it is.
[[nodiscard]] Error with_output_for_all(Error error, std::string_view output);

/// How a scene is to be written, by the options of the output. Error: bad_argument.
/// A word of --compress.
[[nodiscard]] Expected<KeyCompression> compression_in(OptionText option);

[[nodiscard]] Expected<scenes::SceneWriting> scene_writing(const OutputOptions& options);

}  // namespace orispline::cli
