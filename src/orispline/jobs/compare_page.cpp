// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/compare.hpp>
#include <orispline/jobs/compare_title.hpp>
#include <orispline/pages/task_pages.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

report::Page page_of(const CompareOutcome& outcome, const pages::PageHead& head) {
  pages::ComparedCurves curves{.methods = outcome.methods,
                               .recording = outcome.data.recording(),
                               .epoch = outcome.data.epoch,
                               .named = outcome.request.named,
                               .measures = outcome.measures(),
                               .sorted_by = outcome.request.sort,
                               .inertia = outcome.request.inertia()};
  for (const ComparedKeys& keys : outcome.data.key_sets)
    curves.key_sets.push_back(keys.decimation ? name_of(*keys.decimation) : "");
  pages::PageHead titled = head;
  if (titled.title.empty()) titled.title = title_of(outcome, 0);
  return pages::compare_page(curves, titled, outcome.request.threads);
}

}}}  // namespace orispline::jobs
