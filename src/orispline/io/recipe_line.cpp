// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/recipe_line.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/io/blending_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::string_view label = "orispline:", blanks = " \t";
/// The last word, which takes the rest of the line.
constexpr std::string_view blending_word = "blending=";
constexpr std::string_view method_word = "method=", signs_word = "signs=", gap_word = "gap=", jumps_word = "jumps",
                           shortest = "shortest", as_given = "as-given";

std::string_view without_blanks_before(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
  return text;
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  while (!(text = without_blanks_before(text)).empty()) {
    words.push_back(text.substr(0, text.find_first_of(blanks)));
    text.remove_prefix(words.back().size());
  }
  return words;
}

tl::unexpected<Error> not_understood(std::string_view word) {
  return mended_by("recipe",
                   formatted("found {} in the comment that names the method of the keys, wanted method=NAME, and "
                             "signs=as-given or signs=shortest, gap=SECONDS and jumps, each once",
                             in_quotes(word)));
}

}  // namespace

bool is_recipe_line(std::string_view comment) noexcept {
  return comment.starts_with('#') && without_blanks_before(comment.substr(1)).starts_with(label);
}

std::string recipe_line(const Recipe& recipe) {
  if (recipe.is_empty() && !recipe.counts_turns && !recipe.gap && !recipe.jumps) return {};
  std::string line = formatted("# {}", label);
  if (!recipe.is_empty()) line += formatted(" {}{}", method_word, recipe.method);
  if (recipe.signs == Signs::as_given) line += formatted(" {}{}", signs_word, as_given);
  if (recipe.gap) line += formatted(" {}{}", gap_word, *recipe.gap);
  if (recipe.jumps) line += formatted(" {}", jumps_word);
  if (recipe.blending) line += formatted(" {}{}", blending_word, blending_json(*recipe.blending));
  return line + "\n";
}

Expected<std::optional<Recipe>> recipe_in(std::string_view comment) {
  if (!is_recipe_line(comment)) return std::nullopt;
  const std::string_view text = without_blanks_before(comment.substr(1));
  std::optional<std::string_view> named, signed_as;
  std::string_view words = text.substr(label.size());
  std::shared_ptr<const BlendingData> blending;
  if (const std::size_t place = words.find(blending_word);
      place == 0 || (place != words.npos && blanks.find(words[place - 1]) != blanks.npos)) {
    auto data = blending_from_json(words.substr(place + blending_word.size()));
    if (!data) return mended_by("recipe", formatted("the blending functions of the keys: {}", data.error().message));
    blending = std::make_shared<const BlendingData>(std::move(*data));
    words = words.substr(0, place);
  }
  std::optional<double> gap;
  bool jumps = false;
  for (const std::string_view word : words_of(words)) {
    if (word.starts_with(gap_word)) {
      const auto seconds = Fraction::parse(word.substr(gap_word.size()));
      if (gap || !seconds || !seconds->is_positive()) return not_understood(word);
      gap = seconds->to_double();
      continue;
    }
    if (word == jumps_word) {
      if (std::exchange(jumps, true)) return not_understood(word);
      continue;
    }
    const bool is_method = word.starts_with(method_word);
    if (!is_method && !word.starts_with(signs_word)) return not_understood(word);
    const std::string_view value = word.substr(is_method ? method_word.size() : signs_word.size());
    auto& place = is_method ? named : signed_as;
    const bool is_known = is_method ? !value.empty() : value == as_given || value == shortest;
    if (place || !is_known) return not_understood(word);
    place = value;
  }
  if (!named && !gap && !jumps && signed_as != as_given) return not_understood(text);
  return Recipe{.method = std::string(named.value_or("")),
                .signs = signed_as == as_given ? Signs::as_given : Signs::shortest,
                .blending = std::move(blending),
                .gap = gap,
                .jumps = jumps};
}

}}}  // namespace orispline::io
