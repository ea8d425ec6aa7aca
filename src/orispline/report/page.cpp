// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page.hpp>

#include <orispline/report/page_document.hpp>
#include <orispline/report/page_json.hpp>
#include <orispline/report/page_template.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

namespace {

std::string with_data(const std::string& json) { return page_with(page_template(), data_marker, json); }

}  // namespace

std::string document(const Page& page) { return with_data(data_of(page)); }
std::string data_of(const Page& page) { return json_of(page); }
std::string skeleton_document(const SkeletonPage& page) { return with_data(json_of(page)); }

}}}  // namespace orispline::report
