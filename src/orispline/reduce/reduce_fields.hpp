// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/fields/field_info.hpp>
#include <orispline/reduce/reduce.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <>
inline constexpr std::array words<KeyValues>{
    word("sampled", KeyValues::sampled, "Every key is a sample"),
    word("refit", KeyValues::refitted, "Keys are moved off the samples where that saves keys")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<ReduceOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Reduction>() noexcept;

}}  // namespace orispline
