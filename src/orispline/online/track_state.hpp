// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/online/state_bytes.hpp>
#include <orispline/online/track_sampler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The state of a TrackSampler as bytes and back: its method and options, the grid, the keys that are still needed.
class TrackState {
 public:
  [[nodiscard]] static std::vector<std::byte> bytes_of(const TrackSampler& sampler);
  /// Errors: bad_data for bytes that are no state.
  [[nodiscard]] static Expected<TrackSampler> sampler_from(std::span<const std::byte> bytes);

 private:
  [[nodiscard]] static Expected<void> read_rest(StateReader& in, TrackSampler& sampler);
};

}}  // namespace orispline
