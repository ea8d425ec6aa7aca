// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/report/table.hpp>

#include "papers/dice.hpp"

namespace orispline::cli {

/// An equation and how far its sides are apart for one draw of what it speaks of.
struct Identity {
  std::string_view number, statement;
  double (*error)(Dice&);
};

/// A statement that is not true as printed.
struct Misprint {
  std::string_view number, printed;
  double (*error_as_printed)(Dice&);
  std::string_view right;
  double (*error_corrected)(Dice&);
};

inline constexpr int draws_of_identities = 1000;

/// The identities in rows, each with the largest error of all draws, which are the same on every machine.
[[nodiscard]] report::Table identities_table(std::string title, std::span<const std::span<const Identity>> parts,
                                             std::vector<std::string> notes);
[[nodiscard]] report::Table misprints_table(std::span<const Misprint> misprints);

/// Eberly, sections 3 to 6: calculus, slerp, squad and its spline.
[[nodiscard]] std::span<const Identity> interpolation_identities() noexcept;
[[nodiscard]] std::span<const Misprint> interpolation_misprints() noexcept;

}  // namespace orispline::cli
