// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/document.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// Quaternions of files in 16 bits and less are this far from norm 1 at most.
constexpr double widest_norm_error = 0.02;
/// A matrix in single precision, made by products of others, is this far from one of rotation and scale at most.
constexpr double widest_shear = 1e-3;

struct NamedNode {
  Object object;
  std::string name;
};

Expected<NamedNode> node_of(const Object& root, std::size_t index) {
  return root.entry("nodes", "node", index).and_then([&](const Object& object) {
    return object.text_or("name", "").map([&](std::string name) {
      return NamedNode{object, name.empty() ? formatted("node {}", index) : std::move(name)};
    });
  });
}

tl::unexpected<Error> node_fault(std::string_view name, std::string_view message) {
  return failure(ErrorCode::bad_data, formatted("node {}: {}", in_quotes(name), message));
}

/// Three columns at right angles, of which some may be zero, as a rotation of their lengths.
JointPose pose_of_columns(Eigen::Matrix3d columns) {
  JointPose pose;
  pose.scale = columns.colwise().norm();
  if (columns.determinant() < 0.0) pose.scale.x() = -pose.scale.x();
  int known = -1, missing = -1, missing_count = 0;
  for (int i = 0; i < 3; ++i) {
    const bool is_missing = pose.scale[i] == 0.0;
    (is_missing ? missing : known) = i;
    missing_count += is_missing ? 1 : 0;
    if (!is_missing) columns.col(i) /= pose.scale[i];
  }
  if (missing_count == 3) return pose;
  if (missing_count == 2) columns.col((known + 1) % 3) = columns.col(known).unitOrthogonal();
  if (missing_count == 2) missing = (known + 2) % 3;
  if (missing_count > 0)
    columns.col(missing) = columns.col((missing + 1) % 3).cross(columns.col((missing + 2) % 3)).normalized();
  pose.rotation = Eigen::Quaterniond(columns).normalized();
  return pose;
}

Expected<JointPose> pose_of_matrix(const std::array<double, 16>& numbers, std::string_view name) {
  const Eigen::Map<const Eigen::Matrix4d> matrix(numbers.data());
  if (matrix.row(3) != Eigen::RowVector4d(0.0, 0.0, 0.0, 1.0))
    return node_fault(name, "found a matrix whose last row is not 0 0 0 1, wanted translation, rotation and scale");
  const Eigen::Matrix3d columns = matrix.topLeftCorner<3, 3>();
  for (const auto& [a, b] : {std::pair(0, 1), std::pair(1, 2), std::pair(2, 0)}) {
    const double lengths = columns.col(a).norm() * columns.col(b).norm();
    if (!(std::abs(columns.col(a).dot(columns.col(b))) <= widest_shear * lengths))
      return node_fault(name, "found a matrix with shear, wanted translation, rotation and scale");
  }
  JointPose pose = pose_of_columns(columns);
  pose.translation = matrix.topRightCorner<3, 1>();
  return pose;
}

Expected<JointPose> pose_of(const NamedNode& node) {
  const auto matrix = node.object.numbers<16>("matrix");
  if (!matrix) return tl::unexpected(matrix.error());
  const auto translation = node.object.numbers<3>("translation"), scale = node.object.numbers<3>("scale");
  if (!translation) return tl::unexpected(translation.error());
  if (!scale) return tl::unexpected(scale.error());
  const auto rotation = node.object.numbers<4>("rotation");
  if (!rotation) return tl::unexpected(rotation.error());
  if (*matrix && (*translation || *scale || *rotation))
    return node_fault(node.name, "found a matrix and a pose in parts, wanted one of them");
  if (*matrix) return pose_of_matrix(**matrix, node.name);
  JointPose pose;
  if (*translation) pose.translation = Eigen::Vector3d((*translation)->data());
  if (*scale) pose.scale = Eigen::Vector3d((*scale)->data());
  if (!*rotation) return pose;
  pose.rotation = Eigen::Quaterniond((*rotation)->data());
  if (const std::string fault = norm_fault(pose.rotation.norm()); !fault.empty()) return node_fault(node.name, fault);
  pose.rotation.normalize();
  return pose;
}

struct Family {
  std::vector<std::size_t> parents;
  std::vector<std::vector<std::size_t>> children;
};

Expected<Family> family_of(const Object& root, std::size_t count) {
  Family family{std::vector<std::size_t>(count, no_parent), {}};
  for (std::size_t i = 0; i < count; ++i) {
    auto children =
        root.entry("nodes", "node", i).and_then([&](const Object& node) { return node.indices("children", count); });
    if (!children) return tl::unexpected(std::move(children.error()));
    for (const std::size_t child : *children) {
      if (family.parents[child] != no_parent)
        return failure(ErrorCode::bad_data,
                       formatted("node {}: found as a child of node {} and of node {}, wanted one parent", child,
                                 family.parents[child], i));
      family.parents[child] = i;
    }
    family.children.push_back(std::move(*children));
  }
  return family;
}

/// Every node after its parent, near its siblings. Errors: nodes that no root leads to are in a circle.
Expected<std::vector<std::size_t>> order_of(const Family& family) {
  const std::size_t count = family.parents.size();
  std::vector<std::size_t> order, waiting;
  std::vector<bool> seen(count);
  for (std::size_t root = 0; root < count; ++root) {
    if (family.parents[root] != no_parent) continue;
    waiting.push_back(root);
    while (!waiting.empty()) {
      const std::size_t node = waiting.back();
      const auto& children = family.children[node];
      waiting.pop_back();
      order.push_back(node);
      seen[node] = true;
      waiting.insert(waiting.end(), children.rbegin(), children.rend());
    }
  }
  if (order.size() == count) return order;
  return failure(ErrorCode::bad_data, formatted("node {}: found among its own ancestors, wanted no circle",
                                                std::ranges::find(seen, false) - seen.begin()));
}

/// The corners of an octahedron: its two ends, then four around the axis, against the clock seen from the second end.
using Octahedron = std::array<Eigen::Vector3d, 6>;
constexpr std::array<std::uint16_t, 24> triangles{1, 2, 3, 1, 3, 4, 1, 4, 5, 1, 5, 2,
                                                  0, 3, 2, 0, 4, 3, 0, 5, 4, 0, 2, 5};
constexpr std::size_t corner_bytes = 3 * sizeof(float);
constexpr int for_vertices = 34962, for_indices = 34963;

/// From the joint to a point, thickest near the joint.
Octahedron bone_to(const Eigen::Vector3d& tip) {
  const Eigen::Vector3d axis = tip.normalized(), side = axis.unitOrthogonal(), up = axis.cross(side);
  const double width = 0.1 * tip.norm();
  const Eigen::Vector3d waist = width * axis;
  return {Eigen::Vector3d::Zero(), tip, waist + width * side, waist + width * up, waist - width * side,
          waist - width * up};
}

/// Longest along x, where its nose is, and higher than deep: every attitude looks different.
Octahedron craft() {
  return {Eigen::Vector3d(-0.4, 0.0, 0.0),  Eigen::Vector3d(0.6, 0.0, 0.0),   Eigen::Vector3d(-0.2, 0.3, 0.0),
          Eigen::Vector3d(-0.2, 0.0, 0.15), Eigen::Vector3d(-0.2, -0.3, 0.0), Eigen::Vector3d(-0.2, 0.0, -0.05)};
}

/// What each joint is shown by; nothing where it has no length.
std::vector<std::optional<Octahedron>> shapes_of(const Skeleton& skeleton) {
  std::vector<Eigen::Vector3d> tips(skeleton.size(), Eigen::Vector3d::Zero());
  std::vector<bool> is_alone(skeleton.size(), true);
  for (const Joint& joint : skeleton.joints()) {
    if (joint.parent == no_parent) continue;
    const auto index = static_cast<std::size_t>(&joint - skeleton.joints().data());
    is_alone[index] = is_alone[joint.parent] = false;
    Eigen::Vector3d& tip = tips[joint.parent];
    if (joint.rest.translation.norm() > tip.norm()) tip = joint.rest.translation;
  }
  std::vector<std::optional<Octahedron>> found(skeleton.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double length = tips[i].norm();
    if (is_alone[i]) found[i] = craft();
    if (length > 1e-30 && length < 1e30) found[i] = bone_to(tips[i]);
  }
  return found;
}

std::string corners_of(const Octahedron& shape) {
  std::string bytes;
  for (const Eigen::Vector3d& corner : shape) {
    const Eigen::Vector3f single = corner.cast<float>();
    std::array<char, corner_bytes> raw{};
    std::memcpy(raw.data(), single.data(), corner_bytes);
    bytes.append(raw.data(), corner_bytes);
  }
  return bytes;
}

Json corner_accessor(const Octahedron& shape, std::size_t offset) {
  Json least = Json::array(), most = Json::array();
  for (int axis = 0; axis < 3; ++axis) {
    const auto single = [axis](const Eigen::Vector3d& corner) { return static_cast<float>(corner[axis]); };
    const auto [low, high] = std::ranges::minmax(shape, {}, single);
    least.push_back(static_cast<double>(single(low)));
    most.push_back(static_cast<double>(single(high)));
  }
  Json accessor{{"bufferView", 1},         {"componentType", static_cast<int>(ComponentType::f32)},
                {"count", shape.size()},   {"type", "VEC3"},
                {"min", std::move(least)}, {"max", std::move(most)}};
  if (offset > 0) accessor["byteOffset"] = offset;
  return accessor;
}

std::string triangle_bytes() {
  std::string bytes(sizeof triangles, '\0');
  std::memcpy(bytes.data(), triangles.data(), bytes.size());
  return bytes;
}

Json views_of(std::size_t corner_length) {
  return Json::array({{{"buffer", 0}, {"byteLength", sizeof triangles}, {"target", for_indices}},
                      {{"buffer", 0},
                       {"byteOffset", sizeof triangles},
                       {"byteLength", corner_length},
                       {"byteStride", corner_bytes},
                       {"target", for_vertices}}});
}

/// A document of one node per joint and of nothing else, with a few triangles at each joint, so that a viewer shows it:
/// a bone to the farthest child, and a small craft where there is but one joint.
Document with_bones(Document document, const Skeleton& skeleton) {
  Json meshes = Json::array(), accessors = Json::array();
  accessors.push_back({{"bufferView", 0},
                       {"componentType", static_cast<int>(ComponentType::u16)},
                       {"count", triangles.size()},
                       {"type", "SCALAR"}});
  std::string corners;
  std::map<std::string, std::size_t> mesh_of;
  const auto octahedra = shapes_of(skeleton);
  for (std::size_t i = 0; i < octahedra.size(); ++i) {
    if (!octahedra[i]) continue;
    std::string bytes = corners_of(*octahedra[i]);
    const auto [found, is_new] = mesh_of.try_emplace(std::move(bytes), meshes.size());
    document.json["nodes"][i]["mesh"] = found->second;
    if (!is_new) continue;
    meshes.push_back(
        {{"primitives", Json::array({{{"attributes", {{"POSITION", accessors.size()}}}, {"indices", 0}}})}});
    accessors.push_back(corner_accessor(*octahedra[i], corners.size()));
    corners += found->first;
  }
  if (meshes.empty()) return document;
  document.binary = triangle_bytes() + corners;
  document.views = {View{.offset = 0, .length = sizeof triangles},
                    View{.offset = sizeof triangles, .length = corners.size(), .stride = corner_bytes}};
  document.json["bufferViews"] = views_of(corners.size());
  document.json["accessors"] = std::move(accessors);
  document.json["meshes"] = std::move(meshes);
  return document;
}

Json document_of_nodes(const Skeleton& skeleton) {
  Json nodes = Json::array(), roots = Json::array();
  for (const Joint& joint : skeleton.joints()) {
    const std::size_t index = nodes.size();
    Json node = Json::object();
    if (!joint.name.empty()) node["name"] = joint.name;
    nodes.push_back(with_pose(std::move(node), joint.rest));
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

void take_matrices_apart(Json& json, const Nodes& nodes) {
  const auto animations = json.find("animations");
  if (animations == json.end()) return;
  for (const Json& animation : *animations)
    for (const Json& channel : animation.value("channels", Json::array())) {
      const Json& target = channel["target"];
      if (!target.contains("node") || !property_of(target["path"].get<std::string>())) continue;
      const std::size_t index = target["node"];
      Json& node = json["nodes"][index];
      if (node.erase("matrix") > 0) node = with_pose(std::move(node), nodes.skeleton[nodes.joint_of_node[index]].rest);
    }
}

Json with_pose(Json node, const JointPose& pose) {
  const auto list = [](const auto& numbers) { return Json(std::vector<double>(numbers.begin(), numbers.end())); };
  if (!pose.translation.isZero(0.0)) node["translation"] = list(pose.translation);
  if (pose.rotation.coeffs() != Eigen::Quaterniond::Identity().coeffs())
    node["rotation"] = list(pose.rotation.coeffs());
  if (!pose.scale.isOnes(0.0)) node["scale"] = list(pose.scale);
  return node;
}

std::string norm_fault(double norm) {
  if (std::abs(norm - 1.0) <= widest_norm_error) return {};
  return formatted("found a quaternion of norm {}, wanted norm 1", static_cast<float>(norm));
}

Expected<Nodes> nodes_of(const Document& document) {
  const Object root = document.root();
  const auto family = family_of(root, root.list("nodes").value()->size());
  if (!family) return tl::unexpected(family.error());
  const auto& parents = family->parents;
  auto order = order_of(*family);
  if (!order) return tl::unexpected(std::move(order.error()));
  Nodes nodes{.joint_of_node = std::vector<std::size_t>(parents.size())};
  std::vector<Joint> joints;
  for (const std::size_t index : *order) {
    const auto node = node_of(root, index);
    if (!node) return tl::unexpected(node.error());
    const auto pose = pose_of(*node);
    if (!pose) return tl::unexpected(pose.error());
    nodes.joint_of_node[index] = joints.size();
    const std::size_t parent = parents[index] == no_parent ? no_parent : nodes.joint_of_node[parents[index]];
    joints.push_back({.name = node->name, .parent = parent, .rest = *pose});
  }
  nodes.node_of_joint = std::move(*order);
  return Skeleton::make(std::move(joints)).map([&](Skeleton skeleton) {
    nodes.skeleton = std::move(skeleton);
    return std::move(nodes);
  });
}

Source made_source(const Skeleton& skeleton, const SceneWriting& writing) {
  Document document{.json = document_of_nodes(skeleton)};
  if (writing.bones) document = with_bones(std::move(document), skeleton);
  Nodes nodes{.skeleton = skeleton, .node_of_joint = std::vector<std::size_t>(skeleton.size())};
  std::iota(nodes.node_of_joint.begin(), nodes.node_of_joint.end(), std::size_t{0});
  nodes.joint_of_node = nodes.node_of_joint;
  return Source(std::move(document), std::move(nodes), {});
}

}}}  // namespace orispline::scenes::gltf
