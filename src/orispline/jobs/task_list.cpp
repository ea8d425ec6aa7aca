// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/task_list.hpp>

// Alone, so that a program with fewer tasks is linked with a list of its own.

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

std::vector<TaskInfo> tasks_info() {
  return {smooth_info(), tune_info(),    reduce_info(),  retime_info(),     bake_info(), mean_info(),
          align_info(),  compare_info(), inspect_info(), difference_info(), clip_info()};
}

}}}  // namespace orispline::jobs
