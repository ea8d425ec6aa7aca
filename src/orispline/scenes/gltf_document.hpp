// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/warning.hpp>
#include <orispline/scenes/gltf_json.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// A stretch of the binary.
struct View {
  std::size_t offset = 0, length = 0;
  std::size_t stride = 0;  ///< from element to element; 0 where they follow each other
};

/// A document whose buffers are merged into one.
struct Document {
  Json json = Json::object();  ///< an object, whose lists of bufferViews, accessors, nodes and animations are lists
  std::string binary{};
  std::vector<std::optional<View>> views{};  ///< each within the binary; none where the buffer has no data

  [[nodiscard]] Object root() const { return Object::of(json, "").value(); }
};

/// Reads the document of a file with its buffers, also those in files beside it.
///
/// Errors: bad_data; bad_access for a file beside it.
[[nodiscard]] Expected<Document> document_of(std::string_view bytes, const std::string& path);

/// Required extensions that are not known to leave nodes, animations and buffers alone. Errors (bad_data): one that is
/// known not to.
[[nodiscard]] Expected<std::vector<Warning>> extension_warnings(const Document& document);

}}}  // namespace orispline::scenes::gltf
