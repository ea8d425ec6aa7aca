// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <orispline/base/expected.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Something noteworthy about a result, or about what it was made from.
struct ORISPLINE_EXPORT Warning {
  std::string_view code{};  ///< what programs go by: `closing_step`
  std::string message{};    ///< one sentence for people, in the manner of an Error's
  Where where{};
  std::vector<std::pair<std::string_view, double>> numbers{};  ///< those of the sentence, by names with units
  std::string option{};                                        ///< as an Error's

  /// One of the numbers; 0 where it has none of that name.
  [[nodiscard]] double number(std::string_view name) const noexcept;
};

/// As an Error is described.
[[nodiscard]] ORISPLINE_EXPORT std::string describe(const Warning& warning);

}}  // namespace orispline
