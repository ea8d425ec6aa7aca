// SPDX-License-Identifier: Apache-2.0
#include "commands/help/roff.hpp"

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/base/utf8.hpp>

namespace orispline::cli {

namespace {

/// From this length on man may break a word behind its commas and bars.
constexpr std::size_t long_word = 25;

/// The number of a character of several bytes.
unsigned code_point(std::string_view character) {
  const auto first = static_cast<unsigned char>(character.front());
  unsigned code = first & (0xFFu >> (character.size() + 1));
  for (const char next : character.substr(1)) code = code << 6u | (static_cast<unsigned char>(next) & 0x3Fu);
  return code;
}

/// By its number; as it is typed where the fonts of paper lack it.
std::string large_in_roff(std::string_view character) {
  constexpr unsigned superscript_four = 0x2074;
  const unsigned code = code_point(character);
  return code == superscript_four ? "\\(ha4" : formatted("\\[u{:04X}]", code);
}

std::string_view escape_of(char sign) {
  switch (sign) {
    case '\\':
      return "\\(rs";
    case '-':
      return "\\-";
    case '\'':
      return "\\(aq";
    case '"':
      return "\\(dq";
    case '`':
      return "\\(ga";
    case '^':
      return "\\(ha";
    case '~':
      return "\\(ti";
    default:
      return {};
  }
}

std::string word_in_roff(std::string_view word) {
  std::string text;
  for (std::size_t i = 0, bytes = 1; i < word.size(); i += bytes) {
    bytes = std::max<std::size_t>(character_bytes(word.substr(i)), 1);
    const std::string_view escape = escape_of(word[i]);
    if (bytes > 1) text += large_in_roff(word.substr(i, bytes));
    else if (!escape.empty()) text += escape;
    else text += word[i];
    if (word.size() >= long_word && (word[i] == ',' || word[i] == '|')) text += "\\:";
  }
  return text;
}

/// A line of a page, which would be a request to man if it began with a dot.
std::string line_in_roff(std::string_view line) {
  return (line.starts_with('.') ? "\\&" : "") + roff_text(line) + "\n";
}

}  // namespace

std::string roff_text(std::string_view text) {
  std::string result;
  for (const std::string_view word : pieces_of(text, ' '))
    result.append(result.empty() ? "" : " ").append(word_in_roff(word));
  return result;
}

std::string roff_filled(std::string_view lines) {
  std::string text;
  for (const std::string_view line : pieces_of(lines, '\n')) text += line_in_roff(line);
  return text;
}

std::string roff_bold(std::string_view text) { return "\\fB" + roff_text(text) + "\\fR"; }

std::string roff_italic(std::string_view text) { return "\\fI" + roff_text(text) + "\\fR"; }

std::string roff_section(std::string_view title) { return formatted(".SH \"{}\"\n", roff_text(title)); }

std::string roff_part(std::string_view title) { return formatted(".SS \"{}\"\n", roff_text(title)); }

std::string roff_term(std::string_view term, std::string_view words) {
  return formatted(".TP\n{}\n{}", term, roff_filled(words));
}

std::string roff_paragraph(std::string_view lines) { return ".PP\n" + roff_filled(lines); }

std::string roff_lines(std::string_view lines) { return formatted(".RS 4\n.EX\n{}.EE\n.RE\n", roff_filled(lines)); }

}  // namespace orispline::cli
