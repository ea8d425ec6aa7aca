// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/written_lists.hpp>

#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <orispline/scenes/gltf/compressed_views.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

void set_list(Json& json, const char* key, Json list) {
  if (list.empty()) json.erase(key);
  else json[key] = std::move(list);
}

namespace {

/// What the first buffer said beside where it was, for the only one there is now that has data; behind it that which
/// compressed views stand for.
Json buffers_of(const Document& document, const Packed& lists) {
  if (lists.bytes.empty()) return Json::array();
  const Json& buffers = *document.root().list("buffers").value();
  Json buffer = buffers.empty() ? Json::object() : buffers[0];
  buffer.erase("uri");
  buffer["byteLength"] = lists.bytes.size();
  if (const auto extensions = buffer.find("extensions"); extensions != buffer.end() && extensions->is_object()) {
    for (const std::string_view name : meshopt_extensions) extensions->erase(std::string(name));
    if (extensions->empty()) buffer.erase("extensions");
  }
  Json all = Json::array({std::move(buffer)});
  if (lists.decoded_bytes == 0) return all;
  Json decoded{{"byteLength", lists.decoded_bytes}};
  for (const std::string& name : lists.extensions) decoded["extensions"][name] = {{"fallback", true}};
  all.push_back(std::move(decoded));
  return all;
}

/// The names of those extensions by which views are compressed, and no others of their kind; needed where there are no
/// other data.
void name_compression(Json& json, const Packed& lists) {
  const auto set = [&](const char* key, bool adds) {
    Json names = Json::array();
    std::set<std::string> left = adds ? lists.extensions : std::set<std::string>();
    if (const auto before = json.find(key); before != json.end() && before->is_array())
      for (const Json& name : *before) {
        const auto* const text = name.get_ptr<const Json::string_t*>();
        if (text != nullptr && is_meshopt(*text) && !lists.extensions.contains(*text)) continue;
        if (text != nullptr) left.erase(*text);
        names.push_back(name);
      }
    for (const std::string& name : left) names.push_back(name);
    set_list(json, key, std::move(names));
  };
  set("extensionsUsed", true);
  set("extensionsRequired", lists.decoded_bytes > 0);
}

}  // namespace

void set_lists(Json& json, const Document& document, Packed& lists) {
  set_list(json, "buffers", buffers_of(document, lists));
  name_compression(json, lists);
  set_list(json, "accessors", std::move(lists.accessors));
  set_list(json, "bufferViews", std::move(lists.views));
}

}}}  // namespace orispline::scenes::gltf
