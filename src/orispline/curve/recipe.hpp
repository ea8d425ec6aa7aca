// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// What keys say about the curve that they are for: with it a file of keys carries its meaning.
struct Recipe {
  std::string method{};           ///< the method's text form, read by method_from_text(); empty: none is named
  Signs signs = Signs::shortest;  ///< how the signs of the keys are to be read
  std::size_t line = 0;           ///< of the file, from 1; 0: not from a file

  [[nodiscard]] bool is_empty() const noexcept { return method.empty(); }
};

}}  // namespace orispline
