// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_writer.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <system_error>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>

#include <orispline/scenes/gltf_animation.hpp>
#include <orispline/scenes/gltf_container.hpp>
#include <orispline/scenes/gltf_made.hpp>
#include <orispline/scenes/gltf_packing.hpp>
#include <orispline/scenes/gltf_written_animations.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

void set_list(Json& json, const char* key, Json list) {
  if (list.empty()) json.erase(key);
  else json[key] = std::move(list);
}

/// What the first buffer said beside where it was, for the only one there is now.
Json only_buffer(const Document& document, std::size_t length) {
  const Json& buffers = *document.root().list("buffers").value();
  Json buffer = buffers.empty() ? Json::object() : buffers[0];
  buffer.erase("uri");
  buffer["byteLength"] = length;
  return buffer;
}

/// A pose in parts, without those that say nothing.
void state_pose(Json& node, const JointPose& pose) {
  const auto list = [](const auto& numbers) { return Json(std::vector<double>(numbers.begin(), numbers.end())); };
  node.erase("matrix");
  if (!pose.translation.isZero(0.0)) node["translation"] = list(pose.translation);
  if (pose.rotation.coeffs() != Eigen::Quaterniond::Identity().coeffs())
    node["rotation"] = list(pose.rotation.coeffs());
  if (!pose.scale.isOnes(0.0)) node["scale"] = list(pose.scale);
}

/// A node that is animated must not have a matrix, for then nothing says what of it moves.
void take_matrices_apart(Json& json, const Nodes& nodes) {
  const auto animations = json.find("animations");
  if (animations == json.end()) return;
  for (const Json& animation : *animations)
    for (const Json& channel : animation.value("channels", Json::array())) {
      const Json& target = channel["target"];
      if (!target.contains("node") || !property_of(target["path"].get<std::string>())) continue;
      const std::size_t index = target["node"];
      Json& node = json["nodes"][index];
      if (node.contains("matrix")) state_pose(node, nodes.skeleton[nodes.joint_of_node[index]].rest);
    }
}

/// The bytes of a file. Names of strangers need not be UTF-8: what is not is replaced.
Expected<std::string> file_of(Json json, const std::string& binary, const std::string& path) {
  const auto text = [&](int indent) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); };
  if (!std::string_view(path).ends_with('f') && !std::string_view(path).ends_with('F')) return glb_of(text(-1), binary);
  if (!binary.empty()) json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64_of(binary);
  return text(2) + "\n";
}

/// Images stay where they are: what is missing beside a file in another folder.
std::vector<Warning> warnings_of_images(const Json& json, const std::string& from, const std::string& to) {
  namespace fs = std::filesystem;
  const auto images = json.find("images");
  if (images == json.end() || !images->is_array() || from.empty()) return {};
  std::error_code none;
  const fs::path here = fs::absolute(from, none).parent_path(), there = fs::absolute(to, none).parent_path();
  if (here.lexically_normal() == there.lexically_normal()) return {};
  const auto count = std::ranges::count_if(*images, [](const Json& image) {
    const auto uri = image.is_object() ? image.find("uri") : image.end();
    return image.is_object() && uri != image.end() && uri->is_string() &&
           !uri->get_ref<const std::string&>().starts_with("data:");
  });
  if (count == 0) return {};
  return {{.code = "images_elsewhere",
           .message = formatted(
               "found {} in files beside the input, which the output looks for in its own folder; copy them there",
               counted(static_cast<std::size_t>(count), "image")),
           .where = {.file = to}}};
}

Expected<SceneWritten> written_from(const Source& source, const Scene& scene, const std::string& path) {
  const Document& document = source.document();
  const auto plan = plan_of(document, scene.clips);
  if (!plan) return tl::unexpected(plan.error());
  const Uses uses = uses_of(document, plan->kept);
  KeyStore store(uses.free_accessors, document.root().list("accessors").value()->size());
  auto animations = written_animations(scene, source, *plan, std::move(store));
  if (!animations) return tl::unexpected(std::move(animations.error()));
  auto lists = packed(document, uses, std::move(animations->store));
  if (!lists) return tl::unexpected(std::move(lists.error()));
  Json json = document.json;
  set_list(json, "animations", std::move(animations->list));
  set_list(json, "accessors", std::move(lists->accessors));
  set_list(json, "bufferViews", std::move(lists->views));
  take_matrices_apart(json, source.nodes());
  const std::size_t length = lists->bytes.size();
  set_list(json, "buffers", length == 0 ? Json::array() : Json::array({only_buffer(document, length)}));
  std::ranges::move(warnings_of_images(json, scene.name, path), std::back_inserter(animations->warnings));
  return file_of(std::move(json), lists->bytes, path).map([&](std::string bytes) {
    return SceneWritten{std::move(bytes), std::move(animations->warnings)};
  });
}

}  // namespace

Expected<SceneWritten> written_scene(const Scene& scene, const std::string& path, const SceneWriting& writing) {
  const auto* source = dynamic_cast<const Source*>(scene.source.get());
  const bool is_ours = source != nullptr && source->nodes().skeleton.size() == scene.skeleton.size();
  return (is_ours ? written_from(*source, scene, path)
                  : written_from(made_source(scene.skeleton, writing), scene, path))
      .map_error([&](Error error) {
        error.where.file = path;
        return error;
      });
}

}}}  // namespace orispline::scenes::gltf
