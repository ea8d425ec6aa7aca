// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <orispline/reduce/clip_reduction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Of all clips together; its members are those of the clips.
struct ClipTotals {
  std::size_t rotation_keys = 0, rotation_keys_before = 0, rotation_tracks = 0, open_tracks = 0;
  std::size_t translation_keys = 0, translation_keys_before = 0;
  /// The clips where these are largest, of equals the first; null where no clip has one.
  const ClipReduction *angle = nullptr, *translation = nullptr, *distance = nullptr;
  const ClipReduction *from_smooth = nullptr, *from_stored = nullptr;
};

/// The totals point to the reductions, which outlive them.
[[nodiscard]] ORISPLINE_EXPORT ClipTotals totals_of(std::span<const ClipReduction> reductions);

}}  // namespace orispline
