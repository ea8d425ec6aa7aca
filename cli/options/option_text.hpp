// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/base/expected.hpp>
#include <orispline/base/first_error.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/base/warning.hpp>
#include <orispline/fields/words.hpp>
#include <orispline/math/eigen.hpp>

// What the text after an option means. Every error is bad_argument and begins with the option.

namespace orispline::cli {

/// An option as the user typed it.
struct OptionText {
  std::string_view option;
  std::string_view text;
};

[[nodiscard]] tl::unexpected<Error> usage_failure(std::string message);

/// `--rate: found 'fast', wanted a number`.
[[nodiscard]] tl::unexpected<Error> wanted(OptionText option, std::string_view what);

/// The option for a name of the library: `gyro_noise` is --gyro-noise.
[[nodiscard]] std::string flag_of(std::string_view name);

/// A text of the library with the options that it names between backquotes as those of the command.
[[nodiscard]] std::string with_flags(std::string_view text);
/// An error or a warning with the options it names as those of the command; it begins with the one that is at fault.
[[nodiscard]] Error with_flags(Error error);
[[nodiscard]] Warning with_flags(Warning warning);

/// An option's text without the unit that the number is in anyhow, if it is typed behind it: `0.5 s` is `0.5`.
[[nodiscard]] OptionText without_unit(OptionText option, std::string_view unit);

/// A finite number above 0, or a fraction.
[[nodiscard]] Expected<double> positive_in(OptionText option, std::string_view what = "a number greater than 0");
/// Three finite numbers between commas.
[[nodiscard]] Expected<Eigen::Vector3d> vector_in(OptionText option);
/// A whole number from `lowest` on.
[[nodiscard]] Expected<std::size_t> count_in(OptionText option, std::size_t lowest);
/// A number or a fraction greater than 0: `24`, `30000/1001`. `what` is asked for where it is none, by default that.
[[nodiscard]] Expected<Fraction> fraction_in(OptionText option, std::string_view what = {});
/// The two sides of `NAME=VALUE`, neither empty.
[[nodiscard]] Expected<std::pair<std::string_view, std::string_view>> assignment_in(OptionText option);

/// One word of an option's vocabulary and what it stands for.
template <class T>
using Choice = std::pair<std::string_view, T>;

/// `body|world`: the vocabulary as the help shows it.
template <class T, std::size_t N>
[[nodiscard]] std::string one_of(const std::array<Choice<T>, N>& choices) {
  std::string words;
  for (const auto& [word, value] : choices) words.append(words.empty() ? "" : "|").append(word);
  return words;
}

/// The word that stands for a value.
template <class T, std::size_t N>
[[nodiscard]] std::string_view word_of(const std::array<Choice<T>, N>& choices, T value) {
  return std::ranges::find(choices, value, &Choice<T>::second)->first;
}

/// Reads a word of the vocabulary.
template <class T, std::size_t N>
[[nodiscard]] auto choice_of(const std::array<Choice<T>, N>& choices) {
  return [&choices](OptionText option) -> Expected<T> {
    for (const auto& [word, value] : choices)
      if (word == option.text) return value;
    return wanted(option, one_of(choices));
  };
}

/// Reads a word of an enumeration of the library.
template <class E>
[[nodiscard]] Expected<E> word_in(OptionText option) {
  const std::span<const Word> vocabulary = words<E>;
  const auto found = std::ranges::find(vocabulary, option.text, &Word::word);
  if (found == vocabulary.end()) return wanted(option, one_of(vocabulary));
  return static_cast<E>(found->value);
}

/// Reads an option only if the user typed it.
template <class Read>
[[nodiscard]] auto if_given(std::string_view option, const std::optional<std::string>& text, Read read)
    -> Expected<std::optional<typename std::invoke_result_t<Read, OptionText>::value_type>> {
  using Value = typename std::invoke_result_t<Read, OptionText>::value_type;
  if (!text) return std::optional<Value>();
  return read(OptionText{option, *text}).map([](Value value) { return std::optional<Value>(std::move(value)); });
}

}  // namespace orispline::cli
