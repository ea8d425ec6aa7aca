// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include <orispline/batch/sample.hpp>

namespace orispline::batch {

/// One sample's components of a span in either layout; an empty span is not wanted.
template <class T, int Components, class Vector>
void put(std::span<T> to, Layout layout, std::size_t samples, std::size_t at, const Vector& v) noexcept {
  if (to.empty()) return;
  for (int k = 0; k < Components; ++k) {
    const auto component = static_cast<std::size_t>(k);
    const std::size_t index = layout == Layout::planar ? component * samples + at : Components * at + component;
    to[index] = static_cast<T>(v[k]);
  }
}

/// Where the components of sample `at` begin; null for an empty span.
template <class T>
[[nodiscard]] T* place_of(std::span<T> span, Layout layout, std::size_t components, std::size_t at) noexcept {
  return span.empty() ? nullptr : span.data() + (layout == Layout::planar ? at : components * at);
}

/// The distance between the planes of samples, 0 where their components lie side by side.
template <class T>
[[nodiscard]] std::ptrdiff_t plane_distance(const Samples<T>& out) noexcept {
  return out.layout == Layout::planar ? static_cast<std::ptrdiff_t>(out.size()) : 0;
}

/// The time of the k-th sample of a run.
[[nodiscard]] inline double time_of(const Clock& clock, std::size_t k) noexcept {
  return clock.times ? clock.times[k] : (clock.first + static_cast<double>(k)) * clock.step + clock.start;
}

}  // namespace orispline::batch
