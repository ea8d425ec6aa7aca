// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/jobs/task_list.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline::cli {

/// Writes a scene into a file that appears complete or not at all, also when the command is interrupted, and says what
/// the format had no room for. Returns how many keys are in it.
[[nodiscard]] Expected<scenes::WrittenKeys> write_counted_scene(const std::string& path, const scenes::Scene& scene,
                                                                const scenes::SceneWriting& writing);
[[nodiscard]] Expected<void> write_scene(const std::string& path, const scenes::Scene& scene,
                                         const scenes::SceneWriting& writing);
/// A scene with what the task `clip` made of it; a rate that was asked for is that of the frames of BVH too.
[[nodiscard]] Expected<void> write_edited_scene(const std::string& path, scenes::Scene scene,
                                                scenes::SceneWriting writing, const jobs::TaskOutcome& outcome);

}  // namespace orispline::cli
