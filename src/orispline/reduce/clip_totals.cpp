// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/clip_reduction.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

template <auto Member>
void take_larger(const ClipReduction*& worst, const ClipReduction& other) {
  if (!(other.*Member).is_known()) return;
  if (!worst || (other.*Member).largest.value > (worst->*Member).largest.value) worst = &other;
}

}  // namespace

ClipTotals totals_of(std::span<const ClipReduction> reductions) {
  ClipTotals totals;
  for (const ClipReduction& reduction : reductions) {
    totals.rotation_keys += reduction.rotation_keys;
    totals.rotation_keys_before += reduction.rotation_keys_before;
    totals.rotation_tracks += reduction.rotation_tracks;
    totals.open_tracks += reduction.open_tracks;
    totals.translation_keys += reduction.translation_keys;
    totals.translation_keys_before += reduction.translation_keys_before;
    totals.cuts += reduction.cuts;
    totals.tracks_before += reduction.tracks_before;
    totals.tracks_left_out += reduction.tracks_left_out;
    take_larger<&ClipReduction::angle>(totals.angle, reduction);
    take_larger<&ClipReduction::translation>(totals.translation, reduction);
    take_larger<&ClipReduction::distance>(totals.distance, reduction);
    take_larger<&ClipReduction::from_smooth>(totals.from_smooth, reduction);
    take_larger<&ClipReduction::from_stored>(totals.from_stored, reduction);
  }
  return totals;
}

}}  // namespace orispline
