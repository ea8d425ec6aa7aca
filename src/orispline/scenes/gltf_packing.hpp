// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <orispline/scenes/gltf_document.hpp>
#include <orispline/scenes/gltf_key_store.hpp>
#include <orispline/scenes/gltf_uses.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

/// The lists of a document and its only buffer.
struct Packed {
  Json accessors = Json::array(), views = Json::array();
  std::string bytes{};
};

/// What stays of a document, with the new keys. No accessor and no bufferView that stays gets another number, for
/// extensions may refer to them: their places are taken by new ones.
///
/// Errors (bad_data): a bufferView whose data only an extension knows; more than 2 GiB.
[[nodiscard]] Expected<Packed> packed(const Document& document, const Uses& uses, KeyStore store);

}}}  // namespace orispline::scenes::gltf
