// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/meshopt.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

std::optional<std::string> from_meshopt(std::string_view, const MeshoptElements&) { return std::nullopt; }
std::string to_meshopt(std::string_view, std::size_t) { return {}; }

}}}  // namespace orispline::scenes::gltf
