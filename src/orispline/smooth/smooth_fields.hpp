// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/fields/field_info.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <>
inline constexpr std::array words<Penalty>{word("acceleration", Penalty::acceleration, "∫|α|² dt"),
                                           word("jerk", Penalty::jerk, "∫|dα/dt|² dt")};
template <>
inline constexpr std::array words<Loss>{word("robust", Loss::robust,
                                             "every sample counts, except that one or two are left out that lie "
                                             "farther than 5 σ from what those beside them predict"),
                                        word("l2", Loss::l2, "squares: every sample counts in full"),
                                        word("huber", Loss::huber, "Huber's loss: far samples count less"),
                                        word("tukey", Loss::tukey, "Tukey's loss: very far samples do not count")};
template <>
inline constexpr std::array words<SmoothingCriterion>{
    word("gcv", SmoothingCriterion::gcv, "generalised cross-validation"),
    word("ubre", SmoothingCriterion::ubre, "unbiased risk estimate from the given noise (UBRE)"),
    word("reml", SmoothingCriterion::reml, "restricted likelihood (REML)")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<SmoothOptions>() noexcept;
template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Smoothing>() noexcept;

}}  // namespace orispline
