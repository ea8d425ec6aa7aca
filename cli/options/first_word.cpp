// SPDX-License-Identifier: Apache-2.0
#include "options/first_word.hpp"

#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/base/suggestion.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

namespace {

constexpr std::array<std::string_view, 3> flags{"--help", "-h", "--version"};  // of the program itself

Expected<void> check_command(const std::deque<Command>& commands, const std::string& word) {
  if (word.starts_with('-')) {
    if (std::ranges::find(flags, word) != flags.end()) return {};
    if (const auto nearest = nearest_word(word, flags))
      return usage_failure(formatted("unknown option {}; did you mean '{}'?", in_quotes(word), *nearest));
    return usage_failure(
        formatted("found the option {} first, wanted a command before it, such as sample; "
                  "'orispline help' lists them",
                  in_quotes(word)));
  }
  std::vector<std::string_view> names;
  for (const Command& command : commands) names.push_back(command.name);
  if (std::ranges::find(names, word) != names.end()) return {};
  return usage_failure(unknown_word("command", word, names));
}

/// The parser would take the next word for the value of `--option=`.
Expected<void> check_values(const std::vector<std::string>& words) {
  for (const std::string_view word : words)
    if (word.starts_with("--") && word.size() > 3 && word.find('=') == word.size() - 1)
      return usage_failure(formatted("{} wanted a value after it", printable(word)));
  return {};
}

/// The parser would take an option for the value of the one before it.
Expected<void> check_no_option_is_a_value(const std::deque<Command>& commands, const std::vector<std::string>& words) {
  const auto command = std::ranges::find(commands, words.front(), &Command::name);
  if (command == commands.end()) return {};
  for (std::size_t i = 1; i + 1 < words.size() && words[i] != "--"; ++i) {
    const Option* const option = words[i].starts_with('-') ? command->find(words[i]) : nullptr;
    if (!option || option->is_flag()) continue;
    if (words[i + 1].starts_with('-') && command->find(words[i + 1]))
      return usage_failure(
          formatted("{}: found the option {} after it, wanted {}", words[i], words[i + 1], option->argument));
    ++i;  // its value
  }
  return {};
}

}  // namespace

Expected<std::vector<std::string>> understood_words(const std::deque<Command>& commands,
                                                    std::vector<std::string> words) {
  const bool asks_for_help = words.front() == help_command && (words.size() == 1 || !words[1].starts_with('-'));
  const bool is_about_all = words.size() == 3 && words.back() == all_options;
  if (asks_for_help && words.size() > 2 && !is_about_all)
    return usage_failure(formatted("help: found {} words, wanted one command", words.size() - 1));
  if (asks_for_help) {
    words.erase(words.begin());
    words.emplace_back("--help");
  }
  return check_command(commands, words.front())
      .and_then([&] { return check_values(words); })
      .and_then([&] { return check_no_option_is_a_value(commands, words); })
      .map([&] { return std::move(words); });
}

}  // namespace orispline::cli
