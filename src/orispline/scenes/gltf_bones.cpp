// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_bones.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>
#include <vector>

#include <orispline/scenes/gltf_accessor.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

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

}  // namespace

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
  document.json["buffers"] = Json::array({{{"byteLength", document.binary.size()}}});
  document.json["accessors"] = std::move(accessors);
  document.json["meshes"] = std::move(meshes);
  return document;
}

}}}  // namespace orispline::scenes::gltf
