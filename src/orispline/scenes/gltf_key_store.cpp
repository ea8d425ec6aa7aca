// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_key_store.hpp>

#include <cstring>

#include <orispline/scenes/gltf_accessor.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

std::size_t KeyStore::add(std::string_view type, std::size_t components, const std::vector<float>& numbers) {
  std::string key(type);
  const std::size_t head = key.size();
  key.resize(head + numbers.size() * sizeof(float));
  std::memcpy(key.data() + head, numbers.data(), numbers.size() * sizeof(float));
  const auto [found, is_new] = entry_of_bytes_.try_emplace(std::move(key), entries_.size());
  if (is_new) {
    entries_.push_back({type, bytes_.size(), numbers.size() / components, numbers.front(), numbers.back()});
    bytes_.append(found->first, head);
  }
  return slot(found->second);
}

Json KeyStore::accessor(std::size_t entry, std::size_t view) const {
  const Entry& data = entries_[entry];
  Json json{{"bufferView", view},
            {"componentType", static_cast<int>(ComponentType::f32)},
            {"count", data.count},
            {"type", data.type}};
  if (data.offset > 0) json["byteOffset"] = data.offset;
  if (data.type != "SCALAR") return json;
  json["min"] = Json::array({static_cast<double>(data.first)});
  json["max"] = Json::array({static_cast<double>(data.last)});
  return json;
}

}}}  // namespace orispline::scenes::gltf
