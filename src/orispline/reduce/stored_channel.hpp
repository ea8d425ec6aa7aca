// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>

#include <orispline/clip/finite_keys.hpp>
#include <orispline/clip/single_precision.hpp>
#include <orispline/reduce/clip_reduction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The channel as a reader finds it in a file of that precision; nothing where no such file can hold it.
template <CurvePoint P>
[[nodiscard]] std::optional<Channel<P>> stored(Channel<P> channel, KeyPrecision precision) {
  if (precision == KeyPrecision::float32) return held_in_single_precision(std::move(channel));
  return is_finite(channel) ? std::optional(std::move(channel)) : std::nullopt;
}

}}  // namespace orispline
