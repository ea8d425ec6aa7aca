// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_nodes.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

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

}  // namespace

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

}}}  // namespace orispline::scenes::gltf
