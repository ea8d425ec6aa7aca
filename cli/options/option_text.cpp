// SPDX-License-Identifier: Apache-2.0
#include "options/option_text.hpp"

#include <charconv>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/io/text_table.hpp>

namespace orispline::cli {
namespace {

/// One name for each unit, the first.
std::string names_of(std::span<const Unit> units) {
  std::vector<std::string_view> names;
  for (std::size_t i = 0; i < units.size(); ++i)
    if (!units[i].name.empty() && (i == 0 || units[i].size != units[i - 1].size)) names.push_back(units[i].name);
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i)
    list += formatted("{}{}", i == 0 ? "" : i + 1 == names.size() ? " or " : ", ", names[i]);
  return list;
}

std::string_view without_blanks_behind(std::string_view text) { return text.substr(0, text.find_last_not_of(' ') + 1); }

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
  return usage_failure(formatted("{}: found '{}', wanted {}", option.option, option.text, what));
}

OptionText without_unit(OptionText option, std::string_view unit) {
  const bool has_unit = !unit.empty() && option.text.size() > unit.size() && option.text.ends_with(unit);
  if (!has_unit) return option;
  const std::string_view number = without_blanks_behind(option.text.substr(0, option.text.size() - unit.size()));
  const bool is_number = !number.empty() && std::isdigit(static_cast<unsigned char>(number.back()));
  return is_number ? OptionText{option.option, number} : option;
}

Expected<double> number_in(OptionText option) {
  const auto number = io::number_of(option.text);
  if (!number || !std::isfinite(*number)) return wanted(option, "a number");
  return *number;
}

namespace {

/// Positive numbers or fractions with commas between them, and no others.
std::optional<std::vector<double>> positive_numbers(OptionText option) {
  std::vector<double> numbers;
  for (const std::string_view piece : pieces_of(option.text, ',')) {
    const auto number = quotient_in({option.option, piece});
    if (!number || !(*number > 0.0)) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

Expected<Measured> measured_in(OptionText option, std::span<const Unit> units, std::size_t most) {
  for (const Unit& unit : units) {
    if (!option.text.ends_with(unit.name)) continue;
    auto numbers = positive_numbers(
        {option.option, without_blanks_behind(option.text.substr(0, option.text.size() - unit.name.size()))});
    if (!numbers || (numbers->size() != 1 && numbers->size() != most)) continue;
    for (double& number : *numbers) number *= unit.size;
    return Measured{std::move(*numbers), unit};
  }
  const bool has_bare = std::ranges::find(units, std::string_view(), &Unit::name) != units.end();
  const std::string_view how = has_bare ? "" : " with its unit";
  return wanted(
      option,
      formatted("a number greater than 0{}, {}{}, such as 1{}{}", how, has_bare ? "in " : "", names_of(units),
                units[0].name,
                most == 1 ? "" : formatted(", or three with commas between them, such as 1,2,3{}", units[0].name)));
}

Expected<double> quantity_in(OptionText option, std::span<const Unit> units) {
  return measured_in(option, units, 1).map([](const Measured& measured) { return measured.numbers[0]; });
}

Expected<std::vector<double>> numbers_in(OptionText option) {
  std::vector<double> numbers;
  for (const std::string_view piece : pieces_of(option.text, ',')) {
    const auto number = number_in({option.option, piece});
    if (!number) return wanted(option, "numbers with commas between them");
    numbers.push_back(*number);
  }
  return numbers;
}

Expected<Eigen::Vector3d> vector_in(OptionText option) {
  const auto numbers = numbers_in(option);
  if (!numbers || numbers->size() != 3) return wanted(option, "three numbers with commas between them");
  return Eigen::Vector3d((*numbers)[0], (*numbers)[1], (*numbers)[2]);
}

Expected<std::size_t> count_in(OptionText option, std::size_t lowest) {
  std::size_t count = 0;
  const char* const end = option.text.data() + option.text.size();
  const auto [stop, error] = std::from_chars(option.text.data(), end, count);
  if (error != std::errc{} || stop != end || count < lowest)
    return wanted(option, formatted("a whole number from {} on", lowest));
  return count;
}

Expected<Fraction> fraction_in(OptionText option, std::string_view what) {
  const auto fraction = Fraction::parse(option.text);
  if (fraction && fraction->is_positive()) return *fraction;
  return wanted(option, what.empty() ? "a number greater than 0, or a fraction such as 30000/1001" : what);
}

Expected<double> quotient_in(OptionText option) {
  if (option.text.find('/') == std::string_view::npos) return number_in(option);
  const auto fraction = Fraction::parse(option.text);
  if (!fraction) return wanted(option, "a number, or a fraction such as 1/24");
  return fraction->to_double();
}

Expected<double> positive_in(OptionText option, std::string_view what) {
  const auto number = quotient_in(option);
  if (!number || !(*number > 0.0)) return wanted(option, what);
  return *number;
}

Expected<std::pair<std::string_view, std::string_view>> assignment_in(OptionText option) {
  const std::size_t equals = option.text.find('=');
  if (equals == 0 || equals == std::string_view::npos || equals + 1 == option.text.size())
    return wanted(option, "NAME=VALUE");
  return std::pair{option.text.substr(0, equals), option.text.substr(equals + 1)};
}

std::vector<std::string_view> pieces_of(std::string_view text, char separator) {
  return orispline::pieces_of(text, separator);
}

}  // namespace orispline::cli
