// SPDX-License-Identifier: Apache-2.0
#include <orispline/base/suggestion.hpp>

#include <algorithm>
#include <array>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t longest_word = 64;  // [bytes] no vocabulary has a longer one
constexpr std::size_t letters_per_mistake = 3;
constexpr std::size_t shortest_beginning = 4;  // of one word only, that stands for it: `--max-acc`

char small(char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

}  // namespace

// Optimal string alignment: Levenshtein's table, and an exchange of neighbours as one step (Boytsov 2011, 2.2).
std::size_t edit_distance(std::string_view one, std::string_view other) {
  std::array<std::vector<std::size_t>, 3> rows;  // of this letter of `one` and of the two before
  for (auto& row : rows) row.resize(other.size() + 1);
  for (std::size_t j = 0; j <= other.size(); ++j) rows[0][j] = j;
  for (std::size_t i = 1; i <= one.size(); ++i) {
    auto& row = rows[i % 3];
    const auto &before = rows[(i + 2) % 3], &two_before = rows[(i + 1) % 3];
    row[0] = i;
    for (std::size_t j = 1; j <= other.size(); ++j) {
      const char a = small(one[i - 1]), b = small(other[j - 1]);
      row[j] = std::min({before[j] + 1, row[j - 1] + 1, before[j - 1] + (a == b ? 0 : 1)});
      if (i > 1 && j > 1 && a == small(other[j - 2]) && b == small(one[i - 2]))
        row[j] = std::min(row[j], two_before[j - 2] + 1);
    }
  }
  return rows[one.size() % 3][other.size()];
}

std::optional<std::string_view> nearest_word(std::string_view typed, std::span<const std::string_view> words) {
  if (typed.empty() || typed.size() > longest_word) return std::nullopt;
  const auto begins = [&](std::string_view word) {
    return typed.size() >= shortest_beginning && word.starts_with(typed);
  };
  if (std::ranges::count_if(words, begins) == 1) return *std::ranges::find_if(words, begins);
  std::optional<std::string_view> nearest;
  std::size_t least = 0;
  for (const std::string_view word : words) {
    const std::size_t mistakes = edit_distance(typed, word), length = std::max(typed.size(), word.size());
    if (mistakes * letters_per_mistake > length || (nearest && mistakes >= least)) continue;
    nearest = word;
    least = mistakes;
  }
  return nearest;
}

std::string unknown_word(std::string_view kind, std::string_view typed, std::span<const std::string_view> words) {
  if (const auto nearest = nearest_word(typed, words))
    return formatted("unknown {} {}; did you mean '{}'?", kind, in_quotes(typed), *nearest);
  return formatted("unknown {} '{}', wanted one of {}", kind, printable(typed), joined(words, ", "));
}

}}  // namespace orispline
