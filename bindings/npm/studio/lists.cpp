// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/task_list.hpp>
#include <orispline/scenes/scene_tracks.hpp>

// What the module of the studio has in the place of two lists of the library: of the tasks it runs one, of files it
// reads those of keys.

namespace orispline { inline namespace ORISPLINE_ABI {

std::vector<jobs::TaskInfo> jobs::tasks_info() { return {reduce_tracks_info()}; }

void scenes::join_formats() {}

}}  // namespace orispline
