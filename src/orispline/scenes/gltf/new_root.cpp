// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/document.hpp>

#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// The only joint whose parent is the first one of a skeleton which is another one but for that first joint;
/// `no_parent` where it is not.
std::size_t below_new_root(const Skeleton& before, const Skeleton& after) {
  if (after.size() != before.size() + 1 || after[0].parent != no_parent) return no_parent;
  std::size_t below = no_parent;
  for (std::size_t j = 0; j < before.size(); ++j) {
    const std::size_t parent = before[j].parent, now = after[j + 1].parent;
    if (after[j + 1].name != before[j].name) return no_parent;
    if (now == 0 && parent == no_parent && below == no_parent) below = j;
    else if (now != (parent == no_parent ? no_parent : parent + 1)) return no_parent;
  }
  return below;
}

/// Of every scene that has the one, in its place the other.
void replace_in_scenes(Json& json, std::size_t node, std::size_t by) {
  const auto scenes = json.find("scenes");
  if (scenes == json.end()) return;
  for (Json& scene : *scenes) {
    const auto roots = scene.is_object() ? scene.find("nodes") : scene.end();
    if (!scene.is_object() || roots == scene.end() || !roots->is_array()) continue;
    for (Json& root : *roots)
      if (root == node) root = by;
  }
}

}  // namespace

std::optional<Source> with_new_root(const Source& source, const Skeleton& skeleton) {
  Nodes nodes = source.nodes();
  const std::size_t below = below_new_root(nodes.skeleton, skeleton);
  if (below == no_parent) return std::nullopt;
  Document document = source.document();
  const std::size_t node = nodes.node_of_joint[below], root = nodes.joint_of_node.size();
  Json made = with_pose({{"name", skeleton[0].name}}, skeleton[0].rest);
  made["children"] = Json::array({node});
  document.json["nodes"].push_back(std::move(made));
  replace_in_scenes(document.json, node, root);
  for (std::size_t& joint : nodes.joint_of_node) ++joint;
  nodes.joint_of_node.push_back(0);
  nodes.node_of_joint.insert(nodes.node_of_joint.begin(), root);
  nodes.skeleton = skeleton;
  return Source(std::move(document), std::move(nodes), source.reading());
}

}}}  // namespace orispline::scenes::gltf
