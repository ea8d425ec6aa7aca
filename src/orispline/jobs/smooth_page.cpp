// SPDX-License-Identifier: Apache-2.0
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/jobs/smooth.hpp>
#include <orispline/pages/task_pages.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

report::Page page_of(const SmoothOutcome& outcome, pages::PageHead head) {
  for (Warning warning : outcome.warnings) {
    warning.where = {};
    head.notes.push_back(formatted("Warning: {}.", describe(warning)));
  }
  return pages::smooth_page(*outcome.request.recording, outcome.smoothing, head);
}

}}}  // namespace orispline::jobs
