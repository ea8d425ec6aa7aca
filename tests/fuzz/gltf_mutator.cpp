// SPDX-License-Identifier: Apache-2.0
// How a fuzzer changes a glTF file behind bytes of options: as the tree that its document is, and as the numbers that
// its buffer is. Bytes alone hardly ever make another file that is read to its end.
#include <fuzz/gltf_mutator.hpp>

#include <algorithm>
#include <array>
#include <cstring>

#include <orispline/math/so3.hpp>
#include <orispline/scenes/gltf/document.hpp>
#include <support/specimens.hpp>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace orispline::fuzz { namespace {

using scenes::gltf::Json;

class Chance {
 public:
  explicit Chance(unsigned seed) : dice_(seed) {}
  std::size_t below(std::size_t count) { return static_cast<std::size_t>(dice_() * static_cast<double>(count)); }
  template <class List>
  auto& of(List& list) {
    return list[below(std::size(list))];
  }
  Eigen::Vector3d vector() { return dice_.vector(); }

 private:
  testing_support::Dice dice_;
};

/// Members that a reader of animations looks at, with values that suit a small file.
const Json& known_members() {
  static const Json members = Json::parse(R"([
    {"children": [1]}, {"children": [0, 1]}, {"rotation": [0, 0.6, 0, 0.8]}, {"translation": [1, 2, 3]}, {"scale": [2, -1, 0]},
    {"matrix": [0, 2, 0, 0, -3, 0, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1]}, {"name": "arm"}, {"name": ""}, {"name": "a/\u001b\n"},
    {"interpolation": "STEP"}, {"interpolation": "LINEAR"}, {"interpolation": "CUBICSPLINE"}, {"normalized": true},
    {"componentType": 5120}, {"componentType": 5121}, {"componentType": 5122}, {"componentType": 5123},
    {"componentType": 5125}, {"componentType": 5126}, {"type": "SCALAR"}, {"type": "VEC3"}, {"type": "VEC4"}, {"type": "MAT4"},
    {"byteStride": 16}, {"byteStride": 4}, {"byteOffset": 4}, {"count": 1}, {"count": 2}, {"count": 0},
    {"path": "rotation"}, {"path": "translation"}, {"path": "scale"}, {"path": "weights"}, {"path": "pointer"},
    {"sparse": {"count": 1, "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 1}}},
    {"extensions": {"KHR_animation_pointer": {"pointer": "/nodes/0/rotation"}}}, {"extensionsRequired": ["EXT_mesh_gpu_instancing"]},
    {"extensionsUsed": ["KHR_draco_mesh_compression"]}, {"scenes": [{"nodes": [0]}]}, {"scene": 0}, {"skin": 0}, {"mesh": 0},
    {"skins": [{"joints": [0, 1], "inverseBindMatrices": 1}]}, {"uri": "data:,"}, {"uri": "beside.bin"}, {"extras": {"a": []}},
    {"extensions": {"EXT_meshopt_compression": {"buffer": 0, "byteLength": 48, "byteStride": 8, "count": 3, "mode": "ATTRIBUTES", "filter": "QUATERNION"}}},
    {"mode": "TRIANGLES"}, {"mode": "ATTRIBUTES"}, {"filter": "QUATERNION"}, {"filter": "EXPONENTIAL"}, {"filter": "OCTAHEDRAL"}, {"buffer": 1},
    {"animations": []}, {"nodes": []}, {"target": {"path": "rotation"}}, {"channels": []}, {"min": [0]}, {"max": [1]}])");
  return members;
}

Json hostile_number(Chance& chance) {
  constexpr std::array reals{0.5, -0.0, -1.0, 1e-30, 1e30, 1e308, 1e-320, 0.1};
  constexpr std::array<std::uint64_t, 14> wholes{0,  1,    2,    3,    4,     7,           12,
                                                 16, 5120, 5121, 5126, 65536, 4294967295u, std::uint64_t{1} << 53};
  if (chance.below(3) == 0) return reals[chance.below(reals.size())];
  return wholes[chance.below(wholes.size())];
}

class Tree {
 public:
  Tree(Json& root, Chance& chance) : root_(root), chance_(chance) {}

  void change() {
    switch (chance_.below(11)) {
      case 0:
      case 1:
        return change_number();
      case 2:
      case 3:
        return put_member();
      case 4:
        return drop();
      case 5:
        return repeat();
      case 6:
        return graft();
      case 7:
        return swap_elements();
      case 8:
        return hang_node();
      case 9:
        return add_channel();
      case 10:
        return add_animation();
    }
  }

 private:
  /// Every value that `is_wanted`, but the bytes of buffers.
  template <class Is>
  std::vector<Json*> values(Is is_wanted) {
    std::vector<Json*> found, open{&root_};
    while (!open.empty()) {
      Json* const value = open.back();
      open.pop_back();
      if (is_wanted(*value)) found.push_back(value);
      if (value->is_structured())
        for (Json& inner : *value) open.push_back(&inner);
    }
    return found;
  }
  template <class Is>
  Json* any(Is is_wanted) {
    const auto found = values(is_wanted);
    return found.empty() ? nullptr : found[chance_.below(found.size())];
  }
  /// A list of the document, which is made where it is not there.
  Json& list(Json& of, const char* name) {
    if (!of.is_object() || !of.contains(name) || !of[name].is_array()) of[name] = Json::array();
    return of[name];
  }

  void change_number() {
    Json* const number = any([](const Json& value) { return value.is_number(); });
    if (!number) return;
    if (chance_.below(2) == 0) *number = hostile_number(chance_);
    else if (number->is_number_unsigned()) *number = number->get<std::uint64_t>() + (chance_.below(2) == 0 ? 1u : ~0u);
    else *number = number->get<double>() * (chance_.below(2) == 0 ? -1.0 : 1.5);
  }
  /// One that the object has, if it has any of the known ones; or a new one.
  void put_member() {
    Json* const object = any([](const Json& value) { return value.is_object(); });
    const auto& members = known_members();
    for (std::size_t tries = chance_.below(24) + 1; object && tries > 0; --tries) {
      const auto member = members[chance_.below(members.size())].begin();
      if (tries > 1 && !object->contains(member.key())) continue;
      (*object)[member.key()] = member.value();
      return;
    }
  }
  void drop() {
    Json* const of = any([](const Json& value) { return value.is_structured() && !value.empty(); });
    if (of && chance_.below(4) == 0) of->clear();
    else if (of) of->erase(std::next(of->begin(), static_cast<std::ptrdiff_t>(chance_.below(of->size()))));
  }
  void repeat() {
    Json* const of = any([](const Json& value) { return value.is_array() && !value.empty(); });
    if (of) of->push_back(Json(chance_.of(*of)));
  }
  void graft() {
    const auto all = values([](const Json&) { return true; });
    const Json from = *all[chance_.below(all.size())];
    *all[chance_.below(all.size())] = from;
  }
  void swap_elements() {
    Json* const of = any([](const Json& value) { return value.is_array() && value.size() > 1; });
    if (of) std::swap(chance_.of(*of), chance_.of(*of));
  }

  /// A node like another one below a third one.
  void hang_node() {
    Json& nodes = list(root_, "nodes");
    Json node = nodes.empty() ? Json::object() : Json(chance_.of(nodes));
    if (!node.is_object()) return;
    node.erase("children");
    if (!nodes.empty() && chance_.below(4) > 0)
      if (Json& parent = chance_.of(nodes); parent.is_object()) list(parent, "children").push_back(nodes.size());
    nodes.push_back(std::move(node));
  }
  /// A channel of another node or property, of a sampler that is there.
  void add_channel() {
    Json& animations = list(root_, "animations");
    if (animations.empty() || !animations.front().is_object()) return;
    Json& animation = chance_.of(animations);
    if (!animation.is_object()) return;
    Json& samplers = list(animation, "samplers");
    const std::size_t nodes = list(root_, "nodes").size();
    if (samplers.empty() || nodes == 0) return;
    constexpr std::array paths{"rotation", "translation", "scale"};
    if (chance_.below(2) == 0) samplers.push_back(Json(chance_.of(samplers)));
    list(animation, "channels")
        .push_back({{"sampler", chance_.below(samplers.size())},
                    {"target", {{"node", chance_.below(nodes)}, {"path", chance_.of(paths)}}}});
  }
  void add_animation() {
    Json& animations = list(root_, "animations");
    if (!animations.empty()) animations.push_back(Json(chance_.of(animations)));
  }

  Json& root_;
  Chance& chance_;
};

/// Words of 4 bytes, of which most are floats.
void change_numbers(std::string& bytes, Chance& chance) {
  constexpr std::size_t word = sizeof(float);
  const std::size_t words = bytes.size() / word;
  if (words < 4) return;
  const auto put = [&](std::size_t at, float number) { std::memcpy(bytes.data() + word * at, &number, word); };
  constexpr float infinity = std::numeric_limits<float>::infinity();
  constexpr std::array hostile{
      0.0f, -0.0f, 1.0f, -1.0f, 1e-38f, 1e-45f, 3e38f, infinity, std::numeric_limits<float>::quiet_NaN(), 1e-7f, 1e6f};
  const std::size_t at = chance.below(words - 3);
  switch (chance.below(5)) {
    case 0:
      return put(at, hostile[chance.below(hostile.size())]);
    case 1: {  // a rotation
      const Eigen::Quaterniond q = exp<double>(3.0 * chance.vector());
      for (Eigen::Index k = 0; k < 4; ++k) put(at + static_cast<std::size_t>(k), static_cast<float>(q.coeffs()[k]));
      return;
    }
    case 2:
      return static_cast<void>(bytes.replace(word * at, 4 * word, bytes, word * chance.below(words - 3), 4 * word));
    case 3:
      return static_cast<void>(bytes.replace(word * at, word, bytes, word * chance.below(words), word));
    case 4: {
      char& byte = bytes[chance.below(bytes.size())];
      byte = static_cast<char>(static_cast<unsigned char>(byte) ^ 1u << chance.below(8));
      return;
    }
  }
}

/// The document of a file with the bytes of its buffers, if it is one.
std::optional<scenes::gltf::Document> parts_of(std::string_view file) {
  if (auto whole = scenes::gltf::document_of(file, "/nowhere/fuzzed.gltf")) return *std::move(whole);
  const auto container = scenes::gltf::container_of(file);
  if (!container) return std::nullopt;
  Json json = Json::parse(container->json, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  return scenes::gltf::Document{.json = std::move(json), .binary = std::string(container->binary.value_or(""))};
}

std::string changed(std::string_view file, Chance& chance) {
  auto parts = parts_of(file);
  if (!parts) return {};
  Json& json = parts->json;
  if (!parts->binary.empty()) json["buffers"] = Json::array({{{"byteLength", parts->binary.size()}}});
  for (std::size_t changes = 1 + chance.below(4); changes > 0; --changes)
    if (chance.below(3) == 0) change_numbers(parts->binary, chance);
    else if (json.is_object()) Tree(json, chance).change();
  const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  return parts->binary.empty() ? text : scenes::gltf::glb_of(text, parts->binary).value_or("");
}

}}  // namespace orispline::fuzz

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed) {
  using namespace orispline::fuzz;
  Chance chance(seed);
  const std::size_t kind = chance.below(16);
  if (kind == 0 || size <= option_bytes) return LLVMFuzzerMutate(data, size, most);
  if (kind == 1) return LLVMFuzzerMutate(data, option_bytes, option_bytes), size;
  const std::string file = changed({reinterpret_cast<const char*>(data) + option_bytes, size - option_bytes}, chance);
  if (file.empty() || option_bytes + file.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::ranges::copy(file, data + option_bytes);
  return option_bytes + file.size();
}
