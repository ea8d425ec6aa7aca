// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/studio.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

#include <orispline/base/base64.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/version.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/report/page_document.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

constexpr int studio_version = 1;
constexpr std::string_view marker = "__ORISPLINE_STUDIO_DATA__";  // as it is, the page begins with its start screen
constexpr std::string_view behind = "</script>";                  // tells its place from the script that asks for it

std::string method_json(const Method* method) { return method ? report::text_json(text_of(*method)) : "null"; }

std::string data_of(const StudioRequest& request) {
  const Method* const named = request.method.by == NamedBy::user ? &request.method.method : nullptr;
  return formatted(R"({{"studio":{},"version":{},"name":{},"content":"{}","method":{},"beside":{}}})", studio_version,
                   report::text_json(version), report::text_json(request.name), base64_of(request.bytes),
                   method_json(named), method_json(request.beside ? &*request.beside : nullptr));
}

}  // namespace

Expected<StudioOutcome> studio(const StudioRequest& request) {
  StudioOutcome outcome{.data = data_of(request), .warnings = request.method.warnings};
  const Track& keys = *request.keys;
  for (const Method* const method : {&request.method.method, request.beside ? &*request.beside : nullptr}) {
    if (!method) continue;
    if (auto curve = shaped_curve(*method, keys); !curve) return tl::unexpected(std::move(curve.error()));
    std::ranges::move(warnings_of(*method, keys), std::back_inserter(outcome.warnings));
  }
  const std::size_t count = keys.keys.size();
  if (count > most_edited_keys)
    outcome.warnings.push_back(
        {.code = "many_keys",
         .message = formatted("found {} keys, wanted {} at most to edit: the page will offer to reduce them", count,
                              most_edited_keys),
         .where = {.file = keys.name}});
  return outcome;
}

std::string studio_page(std::span<const std::string_view> pieces, std::string_view data) {
  return report::page_with(pieces, formatted("{}{}", marker, behind),
                           formatted("{}{}", data.empty() ? marker : data, behind));
}

}}}  // namespace orispline::jobs
