// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/method_text.hpp>

#include <algorithm>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/base/number_text.hpp>
#include <orispline/base/pieces.hpp>
#include <orispline/curve/end_rate_names.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/families/setting_quantity.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::string_view ends = "ends", closed_option = "closed", period = "period";

/// A number, or one with a unit of the quantity behind it, as in `0.1deg`, in the unit of the library.
std::optional<double> number_of(std::string_view text, const Quantity* quantity) {
  if (quantity)
    for (const Unit& unit : quantity->typed_units)
      if (text.ends_with(unit.name))
        if (const auto number = number_in(text.substr(0, text.size() - unit.name.size()))) return *number * unit.size;
  return number_in(text);
}

Expected<std::vector<double>> numbers_of(std::string_view option, std::string_view text,
                                         const Quantity* quantity = nullptr) {
  std::vector<double> numbers;
  for (const std::string_view piece : pieces_of(text, ',')) {
    const auto number = number_of(piece, quantity);
    if (!number && quantity)
      return bad_option(option,
                        formatted("found '{}', wanted an {} such as {}", text, quantity->name, quantity->example));
    if (!number) return bad_option(option, formatted("found '{}', wanted numbers with commas between them", text));
    numbers.push_back(*number);
  }
  return numbers;
}

Expected<Method> with_rate_text(Method method, CurveEnd end, std::string_view option, std::string_view text) {
  const auto numbers = numbers_of(option, text);
  if (!numbers || numbers->size() != 3)
    return bad_option(option, formatted("found '{}', wanted three numbers with commas between them", text));
  return with_end_rate(std::move(method), end, Eigen::Vector3d(numbers->data()));
}

Expected<Method> with_period_text(Method method, std::string_view text) {
  const auto seconds = number_in(text);
  if (!seconds || *seconds <= 0.0)
    return bad_option(period, formatted("found '{}', wanted a number of seconds greater than 0", text));
  return with_loop(std::move(method), {.period = seconds});
}

/// The name of a setting, such as `rest-angle`, which languages without hyphens in their names write as `rest_angle`.
std::string setting_named(std::string_view typed, const FamilyInfo& family) {
  std::string hyphened(typed);
  std::ranges::replace(hyphened, '_', '-');
  return has_name(family.parameters, hyphened) ? hyphened : std::string(typed);
}

/// `SETTING=VALUE`, or `closed`.
Expected<Method> with_piece(Method method, std::string_view piece) {
  if (piece == closed_option) return with_loop(std::move(method), {});
  const std::size_t equals = piece.find('=');
  if (equals == 0 || equals == std::string_view::npos || equals + 1 == piece.size())
    return bad_option("settings", formatted("found '{}', wanted NAME=VALUE", piece));
  const std::string_view name = piece.substr(0, equals), value = piece.substr(equals + 1);
  if (name == ends) return with_ends(std::move(method), value);
  if (name == start_rate_name) return with_rate_text(std::move(method), CurveEnd::start, name, value);
  if (name == end_rate_name) return with_rate_text(std::move(method), CurveEnd::end, name, value);
  if (name == period) return with_period_text(std::move(method), value);
  return with_setting(std::move(method), name, value);
}

std::string closing_methods() {
  std::vector<std::string_view> names;
  for (const FamilyInfo& family : families_info())
    if (family.closes) names.push_back(family.name);
  return joined(names, ", ");
}

std::string ends_text(const CurveOptions& options) {
  if (options.start.rule == EndRule::none && options.end.rule == EndRule::none) return {};
  if (options.start.rule == options.end.rule) return formatted(":{}={}", ends, name_of(options.start.rule));
  return formatted(":{}={},{}", ends, name_of(options.start.rule), name_of(options.end.rule));
}

std::string rate_text(std::string_view name, const End& end) {
  const Eigen::Vector3d& w = end.angular_velocity;
  return end.rule == EndRule::clamped ? formatted(":{}={},{},{}", name, w.x(), w.y(), w.z()) : std::string();
}

bool has_ends(const FamilyInfo& family, std::string_view rule) {
  return std::ranges::find(family.ends, rule, name_of) != family.ends.end();
}

/// A method that has the end rule: of those that depend on a few keys and are C2 on any, else of all, the one with the
/// most rules.
const FamilyInfo* with_end_rule(std::string_view rule) {
  const FamilyInfo* found = nullptr;
  const auto rank = [](const FamilyInfo& family) {
    return std::pair(!family.is_global() && family.continuity_uneven >= 2, family.ends.size());
  };
  for (const FamilyInfo& family : families_info())
    if (has_ends(family, rule) && (!found || rank(family) > rank(*found))) found = &family;
  return found;
}

/// The rule, or which method has it where this one does not.
Expected<EndRule> end_rule_in(const FamilyInfo& family, std::string_view name) {
  return end_rule_by_name(family, name).or_else([&](const Error& error) -> Expected<EndRule> {
    const FamilyInfo* const other = with_end_rule(name);
    if (!other) return tl::unexpected(error);
    if (family.ends.empty())
      return bad_option(ends, formatted("{} has no end rules; for ends '{}' take another method, such as {}",
                                        family.name, name, other->name));
    return bad_option(ends, formatted("{}; {} has it", error.message, other->name));
  });
}

/// The method that a recipe names, with the blending functions that it states.
Expected<Method> method_in(const Recipe& recipe) {
  if (!recipe.blending) return method_from_text(recipe.method);
  return BlendingFamily::make(*recipe.blending).and_then([&](std::shared_ptr<const OwnFamily> family) {
    return method_from_text(recipe.method, {&family, 1});
  });
}

bool same_blending(const Method& one, const Method& other) {
  const BlendingData *const a = blending_of(one), *const b = blending_of(other);
  return a && b ? *a == *b : a == b;
}

}  // namespace

Expected<Method> with_setting(Method method, std::string_view setting, std::string_view value) {
  const auto family = family_of_method(method);
  if (!family) return tl::unexpected(family.error());
  const std::string name = setting_named(setting, **family);
  CurveOptions& options = method.options;
  if (options.parameters.contains(name) || options.choices.contains(name))
    return bad_option(setting, formatted("'{}' is given twice, wanted it once", name));
  if (has_name((*family)->parameters, name))
    return numbers_of(setting, value, quantity_of_setting(name)).map([&](std::vector<double> values) {
      options.parameters.emplace(name, std::move(values));
      return std::move(method);
    });
  options.choices.emplace(name, value);
  const CurveOptions alone{.choices = {{name, std::string(value)}}};
  return settle(**family, alone, 1).map([&](const FamilySettings&) { return std::move(method); });
}

Expected<Method> with_ends(Method method, std::string_view rules) {
  const auto family = family_of_method(method);
  if (!family) return tl::unexpected(family.error());
  const auto names = pieces_of(rules, ',');
  if (names.size() > 2) return bad_option(ends, formatted("found '{}', wanted RULE or START,END", rules));
  const auto rule_of = [&](std::string_view name) {
    return name == name_of(EndRule::none) && names.size() == 2 ? Expected<EndRule>(EndRule::none)
                                                               : end_rule_in(**family, name);
  };
  const auto start = rule_of(names.front()), end = rule_of(names.back());
  for (const auto& rule : {start, end})
    if (!rule) return bad_option(ends, rule.error().message);
  method.options.start.rule = *start;
  method.options.end.rule = *end;
  return method;
}

Expected<Method> with_end_rate(Method method, CurveEnd end, const Eigen::Vector3d& rate) {
  const std::string_view option = end == CurveEnd::start ? start_rate_name : end_rate_name;
  const auto family = family_of_method(method);
  if (!family) return tl::unexpected(family.error());
  End& changed = end == CurveEnd::start ? method.options.start : method.options.end;
  if (changed.rule != EndRule::none && changed.rule != EndRule::clamped)
    return bad_option(option, formatted("a rate needs the end rule clamped, found {}", name_of(changed.rule)));
  if (const auto known = end_rule_in(**family, name_of(EndRule::clamped)); !known)
    return bad_option(option, known.error().message);
  changed = {EndRule::clamped, rate};
  return method;
}

Expected<Method> with_loop(Method method, Loop loop) {
  const auto family = family_of_method(method);
  if (!family) return tl::unexpected(family.error());
  if (!(*family)->closes)
    return failure(ErrorCode::bad_argument,
                   formatted("{}: this method has no closed curves, wanted one of {}", method.name, closing_methods()));
  if (loop.period && !(*loop.period > 0.0))
    return bad_option(period, formatted("found {}, wanted a number of seconds greater than 0", *loop.period));
  method.options.loop = loop;
  return method;
}

Expected<Method> method_from_text(std::string_view text, std::span<const std::shared_ptr<const OwnFamily>> own) {
  const auto pieces = pieces_of(text, ':');
  const auto mine = std::ranges::find(own, pieces.front(), [](const auto& family) { return family->info().name; });
  const auto family = mine != own.end() ? &(*mine)->info() : find_family(pieces.front());
  if (!family) return tl::unexpected(family.error());
  Expected<Method> method = Method(**family);
  for (const std::string_view piece : std::span(pieces).subspan(1))
    method = std::move(method).and_then([&](Method so_far) { return with_piece(std::move(so_far), piece); });
  return method;
}

std::string text_of(const Method& method) {
  const CurveOptions& options = method.options;
  std::string text = method.name;
  for (const auto& [name, values] : options.parameters) text += formatted(":{}={}", name, joined(values, ","));
  for (const auto& [name, word] : options.choices) text += formatted(":{}={}", name, word);
  text += ends_text(options) + rate_text(start_rate_name, options.start) + rate_text(end_rate_name, options.end);
  if (options.loop && options.loop->period) text += formatted(":{}={}", period, *options.loop->period);
  else if (options.loop) text += formatted(":{}", closed_option);
  return text;
}

Method without(Method method, std::span<const std::string> names) {
  CurveOptions& stated = method.options;
  for (const std::string& name : names) {
    stated.parameters.erase(name);
    stated.choices.erase(name);
    if (name == "ends") stated.start.rule = stated.end.rule = EndRule::none;
    if (name == start_rate_name) stated.start = {};
    if (name == end_rate_name) stated.end = {};
    if (name == "closed" || name == "period") stated.loop.reset();
  }
  return method;
}

Recipe recipe_for(const Method& method, const Track& track) {
  Method shared = method;
  for (const auto& [name, values] : track.settings) shared.options.parameters.erase(name);
  const BlendingData* const blending = blending_of(method);
  return {.method = text_of(shared),
          .signs = track.recipe.signs,
          .blending = blending ? std::make_shared<const BlendingData>(*blending) : nullptr,
          .gap = track.recipe.gap,
          .jumps = track.keys.data().jumps};
}

Expected<std::optional<Method>> method_of(const Recipe& recipe, std::string_view file) {
  if (recipe.method.empty()) return std::nullopt;
  auto method = method_in(recipe);
  if (method) return std::optional(std::move(*method));
  const std::string& option = method.error().option;
  return mended_by("recipe",
                   formatted("the file says that its keys are for '{}': {}{}", recipe.method,
                             option.empty() ? "" : formatted("{}: ", option), method.error().message),
                   {.file = std::string(file), .line = recipe.line});
}

std::optional<Warning> recipe_set_aside(const Recipe& recipe, const Method& used, std::string_view file) {
  const auto stated = recipe.method.empty() ? Expected<Method>(used) : method_in(recipe);
  const bool same_words = stated && text_of(*stated) == text_of(used);
  if (same_words && same_blending(*stated, used)) return std::nullopt;
  const bool is_from_file = recipe.line > 0;
  return Warning{.code = "recipe_set_aside",
                 .message = formatted("{} keys are for {}, and they are used for {}",
                                      is_from_file ? "the file says that its" : "these", recipe.method,
                                      same_words ? "other blending functions of that name" : text_of(used)),
                 .where = is_from_file ? Where{.file = std::string(file), .line = recipe.line} : Where{}};
}

}}  // namespace orispline
