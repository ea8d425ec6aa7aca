// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline::inline ORISPLINE_ABI::report {

/// A word or a number.
using Cell = std::variant<std::string, double>;

/// How the numbers of a column are printed.
enum class Notation { shortest, fixed, scientific };

struct Column {
  std::string name;  ///< with the unit, if there is one
  Notation notation = Notation::shortest;
  int digits = 6;  ///< of shortest numbers all, else those after the point
};

struct Table {
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows{};  ///< a cell per column; missing ones at the end are empty
  std::vector<std::string> notes{};       ///< what a reader has to know, a sentence or two each
};

/// The table for people: words to the left, numbers to the right, notes below.
[[nodiscard]] ORISPLINE_EXPORT std::string text_of(const Table& table);

}  // namespace orispline::inline ORISPLINE_ABI::report
