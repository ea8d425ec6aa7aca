// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/fields/field_info.hpp>
#include <orispline/retime/retime.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <>
inline constexpr std::array words<Slowing>{
    word("uniform", Slowing::uniform, "All intervals between keys are slowed alike"),
    word("per-interval", Slowing::per_interval, "Each interval between keys is slowed by itself")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<RetimeOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Retiming>() noexcept;

}}  // namespace orispline
