// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/scenes/gltf/document.hpp>
#include <orispline/scenes/gltf/packing.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// Sets a list, or takes it out where it is empty, which glTF has not.
void set_list(Json& json, const char* key, Json list);

/// Sets the accessors, the bufferViews and the buffers of a document, and names the extensions by which they are
/// compressed. Takes the accessors and the bufferViews out of the lists.
void set_lists(Json& json, const Document& document, Packed& lists);

}}}  // namespace orispline::scenes::gltf
