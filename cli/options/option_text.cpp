// SPDX-License-Identifier: Apache-2.0
#include "options/option_text.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/fields/typed_numbers.hpp>

namespace orispline::cli {

namespace {

/// An error in the text of an option begins with the name of that option.
template <class T>
Expected<T> naming_option(OptionText option, Expected<T> read) {
  return std::move(read).map_error([&](Error error) {
    error.message = formatted("{}: {}", option.option, error.message);
    return error;
  });
}

/// An error or a warning in the words of the command.
template <class Note>
Note told(Note note) {
  note.message = with_flags(note.message);
  if (!note.option.empty()) note.message = formatted("{}: {}", flag_of(note.option), note.message);
  note.option.clear();
  return note;
}

}  // namespace

std::string flag_of(std::string_view name) {
  std::string flag = formatted("--{}", name);
  std::ranges::replace(flag, '_', '-');
  return flag;
}

std::string with_flags(std::string_view text) {
  const auto pieces = pieces_of(text, '`');
  if (pieces.size() % 2 == 0) return std::string(text);
  std::string result;
  for (std::size_t i = 0; i < pieces.size(); ++i) result += i % 2 == 0 ? std::string(pieces[i]) : flag_of(pieces[i]);
  return result;
}

Error with_flags(Error error) { return told(std::move(error)); }

Warning with_flags(Warning warning) { return told(std::move(warning)); }

tl::unexpected<Error> usage_failure(std::string message) {
  return failure(ErrorCode::bad_argument, std::move(message));
}

tl::unexpected<Error> wanted(OptionText option, std::string_view what) {
  return tl::unexpected(naming_option(option, Expected<void>(typed::wanted(option.text, what))).error());
}

OptionText without_unit(OptionText option, std::string_view unit) {
  return {option.option, typed::without_unit(option.text, unit)};
}

Expected<Eigen::Vector3d> vector_in(OptionText option) {
  return naming_option(option, typed::vector(option.text)).map([](const std::vector<double>& v) {
    return Eigen::Vector3d(v.data());
  });
}

Expected<std::size_t> count_in(OptionText option, std::size_t lowest) {
  return naming_option(option, typed::count(option.text, lowest)).map([](std::uint64_t count) {
    return static_cast<std::size_t>(count);
  });
}

Expected<Fraction> fraction_in(OptionText option, std::string_view what) {
  const auto fraction = Fraction::parse(option.text);
  if (fraction && fraction->is_positive()) return *fraction;
  return wanted(option, what.empty() ? "a number greater than 0, or a fraction such as 30000/1001" : what);
}

Expected<double> positive_in(OptionText option, std::string_view what) {
  return naming_option(option, typed::positive(option.text, what));
}

Expected<std::pair<std::string_view, std::string_view>> assignment_in(OptionText option) {
  const std::size_t equals = option.text.find('=');
  if (equals == 0 || equals == std::string_view::npos || equals + 1 == option.text.size())
    return wanted(option, "NAME=VALUE");
  return std::pair{option.text.substr(0, equals), option.text.substr(equals + 1)};
}

}  // namespace orispline::cli
