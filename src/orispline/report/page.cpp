// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page.hpp>

#include <orispline/report/page_json.hpp>
#include <orispline/report/page_template.hpp>

namespace orispline::inline ORISPLINE_ABI::report {

std::string document(const Page& page) {
  std::string html;
  for (const std::string_view piece : page_template()) html += piece;
  return html.replace(html.find(data_marker), data_marker.size(), json_of(page));
}

}  // namespace orispline::inline ORISPLINE_ABI::report
