// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include <orispline/fields/field_info.hpp>
#include <orispline/reduce/clip_reduction.hpp>
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

template <>
inline constexpr std::array words<BetweenSamples>{
    word("smooth", BetweenSamples::smooth, "The motion between the keys of the input is the curve auto through them"),
    word("stored", BetweenSamples::stored, "It is what the input says, such as straight lines")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<ClipReduceOptions>() noexcept;

/// The tolerances that are given: `0.1°, 0.02 m in the world`.
///
/// `metres`: in the skeleton's unit of length; `unit`: what follows a length, such as ` m`.
[[nodiscard]] ORISPLINE_EXPORT std::string tolerance_text(const ClipReduceOptions& options, double metres,
                                                          std::string_view unit);

}}  // namespace orispline
