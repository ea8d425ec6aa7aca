// SPDX-License-Identifier: Apache-2.0
#include "options/reading_flags.hpp"

#include <string>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/io/file_option.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

namespace {

constexpr std::string_view sort_rows = "sort_rows";  // of compare, where --sort is for its table

const io::FileOption<io::Reading>* option_for(std::string_view member) {
  return io::reading_option_of(member == sort_rows ? "sort" : member);
}

/// What is typed to mend an error, and what that does.
std::string cure(const io::FileOption<io::Reading>& option, std::string_view member) {
  std::string text = flag_of(member == sort_rows ? sort_rows : option.name);
  if (option.argument) text += formatted(" {}", option.argument());
  if (!option.use.empty()) text += formatted(" {}", option.use);
  return text;
}

}  // namespace

Error with_reading_flags(Error error) {
  if (const auto* const fault = option_for(error.option)) {
    error.message = formatted("{}: {}", flag_of(fault->name), error.message);
    error.option.clear();
  }
  if (const auto* const remedy = option_for(error.remedy)) {
    error.message += formatted(" ({})", cure(*remedy, error.remedy));
    error.remedy.clear();
  }
  return error;
}

}  // namespace orispline::cli
