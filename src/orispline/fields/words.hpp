// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include <orispline/base/abi.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A word of a vocabulary and what it stands for.
struct Word {
  std::string_view word;
  int value;                    ///< of the enumeration
  std::string_view sentence{};  ///< for people
};

template <class E>
[[nodiscard]] constexpr Word word(std::string_view text, E value, std::string_view sentence = {}) {
  return {text, static_cast<int>(value), sentence};
}

/// THE words of an enumeration. Specialised for each that has some.
template <class E>
inline constexpr std::span<const Word> words{};

/// The word that stands for a value; empty where none does.
[[nodiscard]] constexpr std::string_view word_of(std::span<const Word> vocabulary, int value) {
  const auto found = std::ranges::find(vocabulary, value, &Word::value);
  return found == vocabulary.end() ? std::string_view() : found->word;
}
template <class E>
[[nodiscard]] constexpr std::string_view word_of(E value) {
  return word_of(words<E>, static_cast<int>(value));
}

/// `body|world`
[[nodiscard]] inline std::string one_of(std::span<const Word> vocabulary) {
  std::string text;
  for (const Word& word : vocabulary) text.append(text.empty() ? "" : "|").append(word.word);
  return text;
}

}}  // namespace orispline
