// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <orispline/curve/keyframe.hpp>

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

}}  // namespace orispline
