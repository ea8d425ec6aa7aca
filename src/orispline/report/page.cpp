// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page.hpp>

#include <orispline/base/expect.hpp>
#include <orispline/report/page_document.hpp>
#include <orispline/report/page_json.hpp>
#include <orispline/report/page_template.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

std::string with_data(const std::string& json) { return page_with(page_template(), data_marker, json); }

/// What stands between the first of these and the first end behind it. Precondition: the page has both.
std::string between(std::string_view start, std::string_view end, const std::string& html) {
  const std::size_t before = html.find(start);
  ORISPLINE_EXPECT(before != std::string::npos);
  const std::size_t from = before + start.size(), to = html.find(end, from);
  ORISPLINE_EXPECT(to != std::string::npos);
  return html.substr(from, to - from);
}

}  // namespace

std::string document(const Page& page) { return with_data(data_of(page)); }
std::string data_of(const Page& page) { return json_of(page); }

PageModule page_module() {
  const std::string html = with_data("");
  return {between("<script type=\"module\">", "</script>", html), between("<style id=\"viewer\">", "</style>", html)};
}

std::string skeleton_document(const SkeletonPage& page) { return with_data(json_of(page)); }

}}}  // namespace orispline::report
