// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/method_json.hpp>
#include <orispline/families/registry.hpp>

#include "errors.hpp"
#include "json_text.hpp"
#include "keys.hpp"

namespace orispline::c { namespace {

Json columns_json(const Track& track) {
  Json list = Json::array();
  for (const ColumnOfKeys& column : columns_of(track)) list.push_back({{"name", column.name}, {"width", column.width}});
  return list;
}

Json json_of(const Track& track) {
  const KeyframeReport& report = track.keys.report();
  return {{"count", track.keys.size()},
          {"columns", columns_json(track)},
          {"name", track.name},
          {"epoch", track.epoch.to_string()},
          {"method", track.recipe.is_empty() ? Json(nullptr) : Json(track.recipe.method)},
          {"sign_flips", report.sign_flips},
          {"non_unit_keys", report.non_unit_keys},
          {"largest_norm_error", report.largest_norm_error},
          {"near_half_turns", report.near_half_turns}};
}

/// With the members that say how the file was read.
std::string json_text_of(const Keys& keys) {
  std::string text = json_text(json_of(*keys.track));
  if (!keys.read.empty()) text.insert(text.size() - 1, "," + keys.read);
  return text;
}

}  // namespace

}  // namespace orispline::c

using namespace orispline;
using namespace orispline::c;

orispline_code orispline_keys_json(const orispline_keys* keys, char** json, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(json, "json").and_then([&] { return checked(keys); }).map([&](const Keys* body) {
      *json = text_of_c(json_text_of(*body));
    });
  });
}

orispline_code orispline_methods_json(char** json, orispline_error** error) {
  return guarded(error, [&] {
    return cleared(json, "json").map([&] { *json = text_of_c(json_text(methods_json(families_info()))); });
  });
}
