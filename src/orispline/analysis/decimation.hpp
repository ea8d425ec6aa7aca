// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orispline/analysis/distance.hpp>
#include <orispline/curve/family.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/fields/field_info.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// How the samples are spaced that stay.
enum class Spacing {
  even,      ///< 0, N, 2N, …
  jittered,  ///< those but the first moved by up to 35 % of N, at random
  random,    ///< steps of N/4, N/2, N and 2N at random, at least 1
};

/// Which samples of a recording are kept as keys.
struct Decimation {
  std::size_t keep_every = 8;  ///< N, at least 1
  Spacing spacing = Spacing::even;
  std::uint64_t seed = 1;  ///< of what is random: the same samples on every machine

  friend bool operator==(const Decimation&, const Decimation&) = default;
};

/// The indices of the samples that are kept, strictly rising from 0; the last sample only if it falls on the grid.
[[nodiscard]] ORISPLINE_EXPORT std::vector<std::size_t> kept_samples(const Decimation& decimation, std::size_t samples);

/// The keys at those indices, with all that they carry.
[[nodiscard]] ORISPLINE_EXPORT KeyframeData kept_keys(const KeyframeData& data, std::span<const std::size_t> kept);

/// `every 8th`, `every 8th, jittered (seed 1)`
[[nodiscard]] ORISPLINE_EXPORT std::string name_of(const Decimation& decimation);

/// How far a method misses keys that it is not given [rad]: every 4th inner key is left out, four times over, so that
/// each is left out once; the curve through the others is compared with those.
///
/// An estimate of the size of the error between the keys where nothing denser is known. It is not fit for choosing a
/// method: without some of its keys a motion looks rougher than it is, and stiff methods look better than they are.
/// On recordings, taking the method of the least leave-out error ends farther from the truth than always taking `auto`.
///
/// Parameters with a value per key are refused, for the keys are others. Errors: those of make_curve(); bad_data for
/// fewer than 3 keys.
[[nodiscard]] ORISPLINE_EXPORT Expected<DistanceStatistics> leave_out_error(const Keyframes& keys,
                                                                            const Method& method = {});

template <>
inline constexpr std::array words<Spacing>{
    word("even", Spacing::even, "the samples 0, N, 2N, … are keys"),
    word("jittered", Spacing::jittered, "all of these but the first are moved by up to 35 % of N, at random"),
    word("random", Spacing::random, "steps of N/4, N/2, N and 2N are drawn at random")};

template <>
ORISPLINE_EXPORT std::span<const FieldInfo> fields_of<Decimation>() noexcept;

}}  // namespace orispline
