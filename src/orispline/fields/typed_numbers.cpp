// SPDX-License-Identifier: Apache-2.0
#include <orispline/fields/typed_numbers.hpp>

#include <algorithm>
#include <charconv>
#include <string>

#include <orispline/base/decimal.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/number_text.hpp>
#include <orispline/base/pieces.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace typed {

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

/// Positive numbers or fractions with commas between them, and no others; else none.
std::vector<double> positive_numbers(std::string_view text) {
  std::vector<double> all;
  for (const std::string_view piece : pieces_of(text, ',')) {
    const auto one = positive(piece);
    if (!one) return {};
    all.push_back(*one);
  }
  return all;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

tl::unexpected<Error> wanted(std::string_view text, std::string_view what) {
  return failure(ErrorCode::bad_argument, formatted("found '{}', wanted {}", text, what));
}

std::string_view without_unit(std::string_view text, std::string_view unit) {
  const bool has_unit = !unit.empty() && text.size() > unit.size() && text.ends_with(unit);
  if (!has_unit) return text;
  const std::string_view before = without_blanks_behind(text.substr(0, text.size() - unit.size()));
  return !before.empty() && is_digit(before.back()) ? before : text;
}

Expected<double> number(std::string_view text) {
  const auto found = number_in(text);
  if (!found) return wanted(text, "a number");
  return *found;
}

Expected<double> quotient(std::string_view text) {
  if (text.find('/') == std::string_view::npos) return number(text);
  const auto fraction = Fraction::parse(text);
  if (!fraction) return wanted(text, "a number, or a fraction such as 1/24");
  return fraction->to_double();
}

Expected<double> positive(std::string_view text, std::string_view what) {
  const auto found = quotient(text);
  if (!found || !(*found > 0.0)) return wanted(text, what);
  return *found;
}

Expected<std::vector<double>> numbers(std::string_view text) {
  std::vector<double> all;
  for (const std::string_view piece : pieces_of(text, ',')) {
    const auto one = number_in(piece);
    if (!one) return wanted(text, "numbers with commas between them");
    all.push_back(*one);
  }
  return all;
}

Expected<std::vector<double>> vector(std::string_view text) {
  auto all = numbers(text);
  if (!all || all->size() != 3) return wanted(text, "three numbers with commas between them");
  return all;
}

Expected<std::uint64_t> count(std::string_view text, std::uint64_t lowest) {
  std::uint64_t found = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), found);
  if (error != std::errc{} || end != text.data() + text.size() || found < lowest)
    return wanted(text, formatted("a whole number from {} on", lowest));
  return found;
}

Expected<Measured> measured(std::string_view text, std::span<const Unit> units, std::size_t most) {
  for (const Unit& unit : units) {
    if (!text.ends_with(unit.name)) continue;
    auto sizes = positive_numbers(without_blanks_behind(text.substr(0, text.size() - unit.name.size())));
    if (sizes.size() != 1 && sizes.size() != most) continue;
    for (double& size : sizes) size *= unit.size;
    return Measured{std::move(sizes), unit};
  }
  const bool has_bare = std::ranges::find(units, std::string_view(), &Unit::name) != units.end();
  const std::string_view how = has_bare ? "" : " with its unit";
  return wanted(
      text,
      formatted("a number greater than 0{}, {}{}, such as 1{}{}", how, has_bare ? "in " : "", names_of(units),
                units[0].name,
                most == 1 ? "" : formatted(", or three with commas between them, such as 1,2,3{}", units[0].name)));
}

}}}  // namespace orispline::typed
