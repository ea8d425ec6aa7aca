// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/scenes/gltf_document.hpp>
#include <orispline/scenes/gltf_nodes.hpp>
#include <orispline/scenes/scene_format.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// All that the file of a scene holds, with the node of each joint.
class Source final : public SceneSource {
 public:
  Source(Document document, Nodes nodes, SceneReading reading)
      : document_(std::move(document)), nodes_(std::move(nodes)), reading_(reading) {}

  [[nodiscard]] const Document& document() const noexcept { return document_; }
  [[nodiscard]] const Nodes& nodes() const noexcept { return nodes_; }
  [[nodiscard]] const SceneReading& reading() const noexcept { return reading_; }

 private:
  Document document_;
  Nodes nodes_;
  SceneReading reading_;
};

}}}  // namespace orispline::scenes::gltf
