// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace report {

/// A word or a number.
using Cell = std::variant<std::string, double>;

/// How the numbers of a column are printed.
enum class Notation { shortest, fixed, scientific };

struct Column {
  std::string name;  ///< with the unit, if there is one
  Notation notation = Notation::shortest;
  int digits = 6;          ///< of shortest numbers all, else those after the point
  int rank = 0;            ///< where there is no room for all, those of the highest rank are left out first; 0: never
  std::size_t widest = 0;  ///< of the first column: a longer word has a line of its own above its row; 0: none has
};

struct Table {
  std::string title;
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows{};  ///< a cell per column; missing ones at the end are empty
  std::vector<std::string> notes{};       ///< what a reader has to know, a sentence or two each
};

/// The table for people: words to the left, numbers to the right, notes below.
[[nodiscard]] ORISPLINE_EXPORT std::string text_of(const Table& table);

/// The table for people in lines of so many characters at most: units below the names, and no column for which there
/// is no room. A note begins with `left_out` and names those. What fits as it is stays so.
[[nodiscard]] ORISPLINE_EXPORT std::string text_of(Table table, std::size_t longest, std::string_view left_out);

}}}  // namespace orispline::report
