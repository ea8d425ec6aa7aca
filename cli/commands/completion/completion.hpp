// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/base/expected.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

/// What an option's argument is, as far as a shell can help. A setting is a choice among `NAME=WORD` and `NAME=`.
enum class Argument { none, word, choice, setting, file };

/// An option or, without a dash in front of its name, a positional argument.
struct OptionOutline {
  std::vector<std::string> names;
  std::string description;
  Argument argument = Argument::none;
  std::vector<std::string> choices{};
};

struct CommandOutline {
  std::string name, description;
  std::vector<OptionOutline> options;
};

enum class Shell { bash, zsh, fish };

inline constexpr std::array shell_choices{Choice<Shell>{"bash", Shell::bash}, Choice<Shell>{"zsh", Shell::zsh},
                                          Choice<Shell>{"fish", Shell::fish}};

/// The text inside single quotes of a shell.
[[nodiscard]] std::string shell_word(std::string_view text);

/// `orispline completion SHELL`: a script for that shell, made from the commands themselves.
[[nodiscard]] Expected<void> completion(const std::string& shell, const std::vector<CommandOutline>& commands);

}  // namespace orispline::cli
