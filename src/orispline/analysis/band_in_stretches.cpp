// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/band_in_stretches.hpp>

#include <algorithm>
#include <limits>
#include <utility>

#include <orispline/analysis/curve_in_stretches.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

Expected<BandInStretches> BandInStretches::make(const Method& method, const Keyframes& keys,
                                                std::span<const Stretch> stretches, double share) {
  const Stretch whole{0, keys.size()};
  if (stretches.empty()) stretches = {&whole, 1};
  BandInStretches bands;
  for (const Stretch& stretch : stretches) {
    auto own = keys_of_stretch(keys, stretch);
    if (!own) return tl::unexpected(std::move(own.error()));
    auto band = MotionBand::make(method_for_stretch(method, stretch, keys.size()), *own, share);
    if (!band) return tl::unexpected(std::move(band.error()));
    bands.parts_.push_back({own->times().front(), own->times().back(), std::move(*band)});
  }
  return bands;
}

double BandInStretches::operator()(double t) const noexcept {
  const auto next =
      std::lower_bound(parts_.begin(), parts_.end(), t, [](const Part& part, double time) { return part.end < time; });
  if (next == parts_.end()) return parts_.back().band(t);
  const bool is_in_gap = next != parts_.begin() && t < next->start;
  return is_in_gap ? std::numeric_limits<double>::quiet_NaN() : next->band(t);
}

}}  // namespace orispline
