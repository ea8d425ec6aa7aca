// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/retime.hpp>
#include <orispline/pages/task_pages.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

report::Page page_of(const RetimeOutcome& outcome, const pages::PageHead& head) {
  return pages::retime_page(*outcome.request.keys, outcome.retiming, outcome.request.options.limits, head);
}

}}}  // namespace orispline::jobs
