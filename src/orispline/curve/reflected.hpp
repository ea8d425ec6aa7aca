// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>

#include <orispline/math/geodesic.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A time mirrored at another one.
[[nodiscard]] inline double mirrored(double at, double t) noexcept { return 2.0 * at - t; }

/// Points or times continued beyond their ends by reflection: element -k mirrors element k at the first one, and so at
/// the last.
template <class Element>
class Reflected {
 public:
  explicit Reflected(std::span<const Element> elements) : elements_(elements) {}

  [[nodiscard]] Element operator[](std::ptrdiff_t i) const {
    const auto last = static_cast<std::ptrdiff_t>(elements_.size()) - 1;
    if (i < 0) return mirrored(elements_.front(), (*this)[-i]);
    if (i > last) return mirrored(elements_.back(), (*this)[2 * last - i]);
    return elements_[static_cast<std::size_t>(i)];
  }

 private:
  std::span<const Element> elements_;
};

template <class Element>
[[nodiscard]] Reflected<Element> reflected(std::span<const Element> elements) {
  return Reflected<Element>(elements);
}

}}  // namespace orispline
