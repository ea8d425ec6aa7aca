// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_made.hpp>

#include <numeric>
#include <utility>

#include <orispline/scenes/gltf_bones.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

template <class Vector>
Json list_of(const Vector& numbers) {
  Json list = Json::array();
  for (const double number : numbers) list.push_back(number);
  return list;
}

/// Only what is not as it is without being said.
Json node_of(const Joint& joint) {
  Json node = Json::object();
  if (!joint.name.empty()) node["name"] = joint.name;
  const JointPose& pose = joint.rest;
  if (!pose.translation.isZero(0.0)) node["translation"] = list_of(pose.translation);
  if (!pose.rotation.coeffs().isApprox(Eigen::Quaterniond::Identity().coeffs(), 0.0))
    node["rotation"] = list_of(pose.rotation.coeffs());
  if (pose.scale != Eigen::Vector3d::Ones()) node["scale"] = list_of(pose.scale);
  return node;
}

Json document_of_nodes(const Skeleton& skeleton) {
  Json nodes = Json::array(), roots = Json::array();
  for (const Joint& joint : skeleton.joints()) {
    const std::size_t index = nodes.size();
    nodes.push_back(node_of(joint));
    (joint.parent == no_parent ? roots : nodes[joint.parent]["children"]).push_back(index);
  }
  Json json{{"asset", {{"generator", "orispline"}, {"version", "2.0"}}}};
  if (nodes.empty()) return json;
  json["scene"] = 0;
  json["scenes"] = Json::array({{{"nodes", std::move(roots)}}});
  json["nodes"] = std::move(nodes);
  return json;
}

}  // namespace

Source made_source(const Skeleton& skeleton, const SceneWriting& writing) {
  Document document{.json = document_of_nodes(skeleton)};
  if (writing.bones) document = with_bones(std::move(document), skeleton);
  Nodes nodes{.skeleton = skeleton, .node_of_joint = std::vector<std::size_t>(skeleton.size())};
  std::iota(nodes.node_of_joint.begin(), nodes.node_of_joint.end(), std::size_t{0});
  nodes.joint_of_node = nodes.node_of_joint;
  return Source(std::move(document), std::move(nodes), {});
}

}}}  // namespace orispline::scenes::gltf
