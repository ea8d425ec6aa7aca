// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/reduce.hpp>
#include <orispline/pages/task_pages.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

report::Page page_of(const ReduceOutcome& outcome, const pages::PageHead& head) {
  const auto& smoothed = outcome.smoothed;
  return pages::reduce_page(outcome.reduced(), outcome.reductions, outcome.options, head,
                            smoothed ? std::optional(smoothed->smoothing.smoothing_time) : std::nullopt);
}

}}}  // namespace orispline::jobs
