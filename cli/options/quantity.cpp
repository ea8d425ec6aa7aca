// SPDX-License-Identifier: Apache-2.0
#include "options/quantity.hpp"

#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline::cli {
namespace {

std::string names_of(std::span<const Unit> units) {
  std::string names;
  for (std::size_t i = 0; i < units.size(); ++i)
    names += formatted("{}{}", i == 0 ? "" : i + 1 == units.size() ? " or " : ", ", units[i].name);
  return names;
}

}  // namespace

Expected<double> quantity_in(OptionText option, std::span<const Unit> units) {
  for (const Unit& unit : units) {
    if (!option.text.ends_with(unit.name)) continue;
    const auto number = io::number_of(option.text.substr(0, option.text.size() - unit.name.size()));
    if (number && std::isfinite(*number) && *number > 0.0) return *number * unit.size;
  }
  return wanted(option,
                formatted("a number greater than 0 with its unit, {}, such as 1{}", names_of(units), units[0].name));
}

}  // namespace orispline::cli
