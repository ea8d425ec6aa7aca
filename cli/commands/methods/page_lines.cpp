// SPDX-License-Identifier: Apache-2.0
#include "commands/methods/page_lines.hpp"

#include <algorithm>
#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/io/orientation_form.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

namespace {

constexpr std::size_t page_width = 100;

/// Characters on the screen: of UTF-8 every byte that begins one.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

}  // namespace

std::string wrapped(const std::string& head, std::string_view words) {
  std::string text = head;
  std::size_t column = width_of(head);
  const std::size_t indent = column;
  for (const std::string_view word : pieces_of(words, ' ')) {
    if (column > indent && column + 1 + width_of(word) > page_width) {
      text += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > indent) {
      text += " ";
      ++column;
    }
    text += word;
    column += width_of(word);
  }
  return text + "\n";
}

std::string_view rate_columns_of(const FamilyInfo& family) {
  constexpr std::array<std::string_view, 4> columns{"", "wx,wy,wz", "wx,wy,wz[,ax,ay,az]",
                                                    "wx,wy,wz[,ax,ay,az[,jx,jy,jz]]"};
  return columns[static_cast<std::size_t>(family.rate_orders)];
}

std::string inner_columns_of(const FamilyInfo& family) {
  if (!family.takes_inner_quaternions()) return "";
  return formatted("{}, {}", joined(io::inner_names[0], ","), joined(io::inner_names[1], ","));
}

}  // namespace orispline::cli
