// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/family.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/base/suggestion.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/curve/value_counts.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::array<std::string_view, 12> end_rule_names{"none", "repeat", "natural", "quadratic", "cubic",  "clamped",
                                                          "rest", "key",    "phantom", "reflect",   "handle", "secant"};

Error argument_error(std::string message, std::optional<std::size_t> key = {}) {
  return {ErrorCode::bad_argument, std::move(message), {.key = key}};
}

/// What is said of a word that the family lacks; `known`: those that it has.
Error unknown_in(const FamilyInfo& family, std::string_view kind, std::string_view word,
                 const std::vector<std::string_view>& known) {
  const std::string said = known.empty() ? formatted("unknown {0} '{1}': this method has no {0}s", kind, word)
                                         : unknown_word(kind, word, known);
  return argument_error(formatted("{}: {}", family.name, said));
}

Error unknown_end_rule(const FamilyInfo& family, std::string_view name) {
  std::vector<std::string_view> names;
  for (EndRule rule : family.ends) names.push_back(name_of(rule));
  return unknown_in(family, "end rule", name, names);
}

std::string wanted_values(const Parameter& parameter, std::size_t keys, std::size_t with_ghosts) {
  if (parameter.tensor) return "1, 3 (its diagonal) or 6 (xx,yy,zz,xy,xz,yz)";
  if (!parameter.per_key) return "1";
  if (with_ghosts == keys) return formatted("1 or one per key ({})", keys);
  return formatted("1, one per key ({}) or one per key and ghost key ({})", keys, with_ghosts);
}

/// Ghost keys beyond either end, of which a loop has none.
std::size_t ghosts_of(const Parameter& parameter, const CurveOptions& options) {
  return options.loop ? 0 : static_cast<std::size_t>(parameter.ghosts);
}

std::optional<Error> check_count_of(const FamilyInfo& family, const Parameter& parameter,
                                    const std::vector<double>& values, std::size_t keys, std::size_t ghosts) {
  const std::size_t with_ghosts = keys + 2 * ghosts;
  const bool right_count = values.size() == 1 ||
                           (parameter.per_key && (values.size() == keys || values.size() == with_ghosts)) ||
                           (parameter.tensor && (values.size() == 3 || values.size() == 6));
  if (right_count) return std::nullopt;
  return argument_error(formatted("{}: found {} values of {}, wanted {}", family.name, values.size(), parameter.name,
                                  wanted_values(parameter, keys, with_ghosts)));
}

std::optional<Error> check_values(const FamilyInfo& family, const Parameter& parameter,
                                  const std::vector<double>& values, std::size_t keys, std::size_t ghosts) {
  if (auto error = check_count_of(family, parameter, values, keys, ghosts)) return error;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(parameter.lowest <= values[i] && values[i] <= parameter.highest)) {
      Error error = argument_error(formatted("{}: {} is {}, wanted {} to {}", family.name, parameter.name, values[i],
                                             parameter.lowest, parameter.highest));
      return values.size() == 1 || parameter.tensor ? error : at_value(std::move(error), i, values.size(), keys);
    }
  return std::nullopt;
}

Error unknown_parameter(const FamilyInfo& family, std::string_view name) {
  std::vector<std::string_view> names;
  for (const Parameter& p : family.parameters) names.push_back(p.name);
  for (const Choice& c : family.choices) names.push_back(c.name);
  return unknown_in(family, "parameter", name, names);
}

/// The chosen word as the family spells it.
Expected<std::string_view> settle_word(const FamilyInfo& family, const Choice& choice, const CurveOptions& options) {
  const auto given = options.choices.find(choice.name);
  if (given == options.choices.end()) return choice.words.front();
  const auto word = std::ranges::find(choice.words, given->second);
  if (word != choice.words.end()) return *word;
  return tl::unexpected(argument_error(formatted("{}: {} is '{}', wanted one of {}", family.name, choice.name,
                                                 given->second, joined(choice.words, ", "))));
}

Expected<End> settle_end(const FamilyInfo& family, End end, std::size_t keys) {
  if (end.rule == EndRule::none && !family.ends.empty()) end.rule = family.ends.front();
  if (end.rule != EndRule::none && std::ranges::find(family.ends, end.rule) == family.ends.end())
    return tl::unexpected(unknown_end_rule(family, name_of(end.rule)));
  if (keys < keys_needed(end.rule))
    return failure(ErrorCode::bad_data, formatted("{}: ends '{}' need {} keys, found {}", family.name,
                                                  name_of(end.rule), keys_needed(end.rule), keys));
  if (!end.angular_velocity.allFinite())
    return tl::unexpected(
        argument_error(formatted("{}: an end rate is not finite, wanted finite numbers", family.name)));
  if (!is_in_range(end.angular_velocity))
    return tl::unexpected(
        argument_error(formatted("{}: an end rate has a component of {:g} rad/s, wanted {:g} at most", family.name,
                                 end.angular_velocity.cwiseAbs().maxCoeff(), largest_component)));
  if (end.rule != EndRule::clamped && !end.angular_velocity.isZero(0.0))
    return tl::unexpected(argument_error(
        formatted("{}: an end rate needs the end rule clamped, found {}", family.name, name_of(end.rule))));
  return end;
}

std::optional<Error> check_count(const FamilyInfo& family, std::size_t keys) {
  const auto least = static_cast<std::size_t>(family.min_keys);
  const std::size_t stride = family.key_use.stride;
  if (keys < least)
    return Error{ErrorCode::bad_data, formatted("{} needs {} keys, found {}", family.name, least, keys), {}};
  if (family.key_use.cut(keys) == keys) return std::nullopt;
  return Error{ErrorCode::bad_data,
               formatted("{} needs {}k+1 keys ({}, {}, {}, ...), found {}", family.name, stride, least, least + stride,
                         least + 2 * stride, keys),
               {}};
}

std::optional<Error> check_loop(const FamilyInfo& family, const CurveOptions& options) {
  if (!family.closes) return argument_error(formatted("{}: this method has no closed curves", family.name));
  if (options.start.rule != EndRule::none || options.end.rule != EndRule::none)
    return argument_error(formatted("{}: a closed curve has no ends, found an end rule", family.name));
  return std::nullopt;
}

}  // namespace

std::string_view name_of(EndRule rule) noexcept { return end_rule_names[static_cast<std::size_t>(rule)]; }

std::size_t keys_needed(EndRule rule) noexcept {
  return rule == EndRule::quadratic ? 3 : rule == EndRule::cubic ? 4 : 2;
}

Expected<EndRule> end_rule_by_name(const FamilyInfo& family, std::string_view name) {
  for (EndRule rule : family.ends)
    if (name_of(rule) == name) return rule;
  return tl::unexpected(unknown_end_rule(family, name));
}

std::optional<std::size_t> keys_beside(const FamilyInfo& family, const FamilySettings& settings) {
  if (family.keys_beside) return family.keys_beside(settings);
  if (family.is_global()) return std::nullopt;
  return family.reach() + family.key_use.further_times;
}

Expected<int> FamilySettings::whole(std::string_view name) const {
  const double value = per_key(name)[0];
  if (value == std::round(value)) return static_cast<int>(value);
  return tl::unexpected(argument_error(formatted("{}: {} is {}, wanted a whole number", method, name, value)));
}

Error at_value(Error error, std::size_t value, std::size_t values, std::size_t keys) {
  const std::size_t ghosts = (values - keys) / 2;  // beyond either end
  if (ghosts <= value && value < ghosts + keys) {
    error.where.key = value - ghosts;
  } else {
    error.where.key.reset();
    error.message = formatted("ghost key {} key {}: {}", value < ghosts ? "before" : "after",
                              value < ghosts ? 0 : keys - 1, error.message);
  }
  return error;
}

Expected<void> check_value_counts(const FamilyInfo& family, const CurveOptions& options, std::size_t keys) {
  for (const Parameter& parameter : family.parameters)
    if (const auto given = options.parameters.find(parameter.name); given != options.parameters.end())
      if (auto error = check_count_of(family, parameter, given->second, keys, ghosts_of(parameter, options)))
        return tl::unexpected(std::move(*error));
  return {};
}

Expected<FamilySettings> settle(const FamilyInfo& family, const CurveOptions& options, std::size_t keys) {
  FamilySettings settings{.method = family.name};
  for (const auto& [name, values] : options.parameters)
    if (!has_name(family.parameters, name)) return tl::unexpected(unknown_parameter(family, name));
  for (const auto& [name, word] : options.choices)
    if (!has_name(family.choices, name)) return tl::unexpected(unknown_parameter(family, name));
  for (const Choice& choice : family.choices) {
    const auto word = settle_word(family, choice, options);
    if (!word) return tl::unexpected(word.error());
    settings.choices.emplace(choice.name, *word);
  }
  for (const Parameter& parameter : family.parameters) {
    const auto given = options.parameters.find(parameter.name);
    std::vector<double> values = given != options.parameters.end() ? given->second : std::vector{parameter.initial};
    if (auto error = check_values(family, parameter, values, keys, ghosts_of(parameter, options)))
      return tl::unexpected(std::move(*error));
    settings.parameters.emplace(parameter.name, PerKey(std::move(values)));
  }
  const bool closes = options.loop && family.closes;  // of any family with the keys that closed_keys() wants
  if (keys != 1 && !closes)
    if (auto error = check_count(family, keys)) return tl::unexpected(std::move(*error));
  if (options.loop) {
    if (auto error = check_loop(family, options)) return tl::unexpected(std::move(*error));
    return settings;
  }
  if (keys == 1) return settings;
  auto start = settle_end(family, options.start, keys);
  if (!start) return tl::unexpected(std::move(start.error()));
  auto end = settle_end(family, options.end, keys);
  if (!end) return tl::unexpected(std::move(end.error()));
  settings.start = *start;
  settings.end = *end;
  return settings;
}

}}  // namespace orispline
