// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <orispline/jobs/reduce_scene.hpp>
#include <orispline/pages/task_pages.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

report::SkeletonPage page_of(const ReduceSceneOutcome& outcome, std::string after, const pages::PageHead& head) {
  const ReduceSceneRequest& request = outcome.request;
  return pages::reduced_clips_page(
      {request.file.name, request.skeleton, request.clips}, std::move(after), outcome.reductions, outcome.options,
      {.metres = outcome.metres(), .are_known = outcome.knows_metres(), .shell = outcome.options.shell}, head,
      request.threads);
}

}}}  // namespace orispline::jobs
