// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/fields/field_info.hpp>

// What people type where numbers are wanted. Every error is bad_argument: what was found, and what was wanted.

namespace orispline { inline namespace ORISPLINE_ABI { namespace typed {

/// `found 'fast', wanted a number`.
[[nodiscard]] tl::unexpected<Error> wanted(std::string_view text, std::string_view what);

/// A number's text without the unit that the number is in anyhow, if it is typed behind it: `0.5 s` is `0.5`.
[[nodiscard]] std::string_view without_unit(std::string_view text, std::string_view unit);

/// A finite number.
[[nodiscard]] Expected<double> number(std::string_view text);
/// A finite number, or a fraction.
[[nodiscard]] Expected<double> quotient(std::string_view text);
/// A finite number above 0, or a fraction.
[[nodiscard]] Expected<double> positive(std::string_view text, std::string_view what = "a number greater than 0");
/// Finite numbers between commas.
[[nodiscard]] Expected<std::vector<double>> numbers(std::string_view text);
/// Three finite numbers between commas.
[[nodiscard]] Expected<std::vector<double>> vector(std::string_view text);
/// A whole number from `lowest` on.
[[nodiscard]] Expected<std::uint64_t> count(std::string_view text, std::uint64_t lowest);
/// A finite number above 0, or a fraction, with one of the units behind it, as in `0.1deg`, in the unit of the library;
/// or `most` of them with commas between them and one unit, as in `90,60,120deg/s`.
[[nodiscard]] Expected<Measured> measured(std::string_view text, std::span<const Unit> units, std::size_t most);

}}}  // namespace orispline::typed
