// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/analysis/comparison.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/fields/field_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <>
inline constexpr std::array words<Spacing>{
    word("even", Spacing::even, "the samples 0, N, 2N, … are keys"),
    word("jittered", Spacing::jittered, "all of these but the first are moved by up to 35 % of N, at random"),
    word("random", Spacing::random, "steps of N/4, N/2, N and 2N are drawn at random")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<MeasureOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Decimation>() noexcept;

}}  // namespace orispline
