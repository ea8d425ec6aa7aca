// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/method.hpp>

#include <orispline/curve/own_family.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

OwnFamily::~OwnFamily() = default;

Method::Method(const FamilyInfo& family, CurveOptions given)
    : name(family.name), options(std::move(given)), own(family.own ? family.own->shared_from_this() : nullptr) {}

Method::Method(std::shared_ptr<const OwnFamily> family, CurveOptions given)
    : name(family->info().name), options(std::move(given)), own(std::move(family)) {}

Method Method::at(std::span<const std::size_t> indices, std::size_t keys) const {
  Method picked = *this;
  for (auto& [parameter, values] : picked.options.parameters) {
    if (values.size() < keys || values.size() == 1) continue;
    const std::size_t ghosts = (values.size() - keys) / 2;  // beyond either end, which keep theirs
    std::vector<double> some(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(ghosts));
    for (const std::size_t i : indices) some.push_back(values[ghosts + i]);
    some.insert(some.end(), values.end() - static_cast<std::ptrdiff_t>(ghosts), values.end());
    values = std::move(some);
  }
  return picked;
}

}}  // namespace orispline
