// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <orispline/clip/skeleton.hpp>
#include <orispline/scenes/gltf_document.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// The nodes of a document as joints.
struct Nodes {
  Skeleton skeleton{};
  std::vector<std::size_t> node_of_joint{}, joint_of_node{};
};

/// Errors (bad_data): nodes in a circle or of two parents; a pose that is no translation, rotation and scale.
[[nodiscard]] Expected<Nodes> nodes_of(const Document& document);

/// What is wrong with the norm of a quaternion of a file, where values are rounded to a few digits; empty if nothing
/// is.
[[nodiscard]] std::string norm_fault(double norm);

}}}  // namespace orispline::scenes::gltf
