// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/uniform.hpp>

namespace orispline::families {

Expected<AnyCurve> UniformFamily::curve(const Keyframes& keys, const FamilySettings& settings) {
  return with_basis<AnyCurve>(settings, [&](auto basis) { return four_key_curve(keys, settings, std::move(basis)); });
}

Expected<AnyPath> UniformFamily::path(const Keyframes& keys, const FamilySettings& settings) {
  return with_basis<AnyPath>(settings, [&](auto basis) { return four_key_path(keys, settings, std::move(basis)); });
}

}  // namespace orispline::families
