// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/scenes/scene_format.hpp>
#include <orispline/scenes/scene_tracks.hpp>

#include "options/input_options.hpp"
#include "options/output_options.hpp"

namespace orispline::cli {

/// Whether a name ends as those of files of skeletons do.
[[nodiscard]] bool is_scene(const std::string& path);

/// The same of an input, or that it is stated to be one.
[[nodiscard]] bool is_scene(const InputRequest& input);

/// How it is to be read.
[[nodiscard]] scenes::SceneReading scene_reading(const InputRequest& input);

/// The chosen clips of a file of skeletons; of a file of keys the scene of one joint that moves as they say. Errors
/// name the file; bad_argument where one joint of many is chosen.
[[nodiscard]] Expected<scenes::Scene> open_scene(const InputRequest& input);

/// How a scene is to be written, by the options of the output. Error: bad_argument.
[[nodiscard]] Expected<scenes::SceneWriting> scene_writing(const OutputOptions& options);

}  // namespace orispline::cli
