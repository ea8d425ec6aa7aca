// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <orispline/base/expected.hpp>

namespace orispline::cli {

/// The type name of arguments that are files.
inline constexpr auto file_type = "FILE", folder_type = "FOLDER";
/// Of arguments whose words the registry knows.
inline constexpr auto method_type = "METHOD", methods_type = "METHOD,...", ends_type = "RULE|START,END",
                      setting_type = "NAME=VALUE", command_type = "COMMAND";

/// The command that prints the help of another one: `help sample` is `sample --help`.
inline constexpr std::string_view help_command = "help";
/// Behind such a word: the help shows all options, also those that few people use.
inline constexpr std::string_view all_options = "--all";

/// Where the text goes that the user types behind an option; of a flag, that it was given.
using Typed = std::variant<bool*, std::string*, std::optional<std::string>*, std::vector<std::string>*>;

/// What the user may type, and what the help says about it.
struct Option {
  std::string names;  ///< `--method`, `-o,--output`, `INPUT`
  std::string sentence;
  Typed typed;
  std::string stands_for{};  ///< of a flag whose place is for a text: that text
  std::string argument{};    ///< what is typed behind it: `FILE`, `csv|tum`; empty for a flag
  std::string section{};     ///< of the help
  bool is_required = false;
  bool is_repeated = false;  ///< it takes one text each time, else all words that follow

  Option* type_name(std::string name) { return argument = std::move(name), this; }
  Option* group(std::string name) { return section = std::move(name), this; }
  Option* required() { return is_required = true, this; }
  Option* repeated() { return is_repeated = true, this; }
  [[nodiscard]] bool is_flag() const noexcept { return std::holds_alternative<bool*>(typed) || !stands_for.empty(); }
};

/// A command: its name, its options, and what it does once they are typed.
struct Command {
  std::string name, description, footer{};
  std::function<Expected<void>()> run{};
  std::deque<Option> options{};           // which stay where they are
  std::vector<std::string_view> usual{};  ///< names of those that most people use; none: all of them are shown

  /// One that was added.
  Option& option(std::string_view names) { return *std::ranges::find(options, names, &Option::names); }
  /// The one that the user types by this name; null if there is none.
  [[nodiscard]] const Option* find(std::string_view typed) const;
  void remove(std::string_view names) {
    std::erase_if(options, [names](const Option& option) { return option.names == names; });
  }
  Option* add(Option option) { return &options.emplace_back(std::move(option)); }
  template <class T>
  Option* add_option(std::string names, T& typed, std::string sentence) {
    const Typed place = &typed;
    return add({.names = std::move(names), .sentence = std::move(sentence), .typed = place});
  }
  Option* add_flag(std::string names, bool& typed, std::string sentence) {
    return add_option(std::move(names), typed, std::move(sentence));
  }
  /// One whose place is for a text, which becomes `true`.
  Option* add_flag(std::string names, std::optional<std::string>& typed, std::string sentence) {
    Option* const flag = add_option(std::move(names), typed, std::move(sentence));
    flag->stands_for = "true";
    return flag;
  }
};

/// What the help says about the program.
struct Program {
  std::string name, description, footer, version;
};

/// What the user wants: a command, or else the text of the help or the version.
struct Wanted {
  const Command* command = nullptr;
  std::string text{};
};

/// Takes the words behind the name of the program into the options of the command that it names. Error: bad_argument.
[[nodiscard]] Expected<Wanted> parsed(const std::deque<Command>& commands, const Program& program,
                                      std::vector<std::string> words);

}  // namespace orispline::cli
