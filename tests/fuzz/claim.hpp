// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdio>
#include <cstdlib>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <orispline/base/expected.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/base/warning.hpp>

namespace orispline::fuzz {

/// What is being tried, told only where a claim is broken.
class Situation {
 public:
  explicit Situation(std::function<std::string()> text) { all().push_back(std::move(text)); }
  ~Situation() { all().pop_back(); }
  Situation(const Situation&) = delete;
  Situation& operator=(const Situation&) = delete;

  [[nodiscard]] static std::vector<std::function<std::string()>>& all() {
    static std::vector<std::function<std::string()>> situations;
    return situations;
  }
};

/// Says in which situation what was found, and ends the program as fuzzers want it.
[[noreturn]] inline void broken(const std::string& found) {
  std::fprintf(stderr, "\nfuzz: broken: %s\n", found.c_str());
  for (const auto& text : Situation::all()) std::fprintf(stderr, "%s\n", text().c_str());
  std::fflush(stderr);
  std::abort();
}

/// The only way to assert: the text says what was found where something else was wanted.
template <class... T>
void claim(bool holds, fmt::format_string<T...> found, T&&... values) {
  if (!holds) broken(fmt::format(found, std::forward<T>(values)...));
}

/// Text that a terminal shows as one line.
[[nodiscard]] inline bool is_one_printable_line(std::string_view text) {
  return !text.empty() && printable(text) == text;
}

/// A refusal in plain words.
inline void claim_plain(const Error& error) {
  claim(!error.message.empty(), "an error without a message");
  const std::string text = describe(error);
  claim(is_one_printable_line(text), "an error that is not one printable line: '{}'", text);
}

/// Words for people, and a code for programs.
inline void claim_plain(const std::vector<Warning>& warnings) {
  for (const Warning& warning : warnings) {
    claim(!warning.code.empty(), "a warning without a code");
    claim(is_one_printable_line(describe(warning)), "a warning that is not one printable line: '{}'",
          describe(warning));
  }
}

}  // namespace orispline::fuzz
