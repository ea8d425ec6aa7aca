// SPDX-License-Identifier: Apache-2.0
#include "method_options.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <tuple>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "option_text.hpp"

namespace orispline::cli {
namespace {

/// Shorter closing steps than this share of the shortest one between keys are worth a warning.
constexpr double closing_share = 1e-3;

/// What the command line says about one name: `--set NAME=TEXT`, or an option that is short for it.
struct Setting {
  std::string option;
  std::string_view name, text;
};

template <class Named>
bool has_name(std::span<const Named> list, std::string_view name) {
  return std::ranges::find(list, name, &Named::name) != list.end();
}

/// The setting in its place: numbers for a parameter, else a word for a choice, which the family has to know.
Expected<CurveOptions> with_setting(const FamilyInfo& family, CurveOptions shape, const Setting& setting) {
  const std::string name(setting.name);
  if (shape.parameters.contains(name) || shape.choices.contains(name))
    return usage_failure(fmt::format("{}: '{}' is given twice, wanted it once", setting.option, name));
  if (has_name(family.parameters, name))
    return numbers_in({setting.option, setting.text}).map([&](std::vector<double> values) {
      shape.parameters.emplace(name, std::move(values));
      return std::move(shape);
    });
  shape.choices.emplace(name, setting.text);
  const CurveOptions alone{.choices = {{name, std::string(setting.text)}}};
  return settle(family, alone, 1).map([&](const FamilySettings&) { return std::move(shape); });
}

/// Parameters and choices.
Expected<CurveOptions> settings_in(const FamilyInfo& family, const MethodOptions& options) {
  std::vector<Setting> settings;
  if (options.tension) settings.push_back({"--tension", "tension", *options.tension});
  for (const std::string& text : options.settings) {
    const auto assignment = assignment_in({"--set", text});
    if (!assignment) return tl::unexpected(assignment.error());
    settings.push_back({fmt::format("--set {}", assignment->first), assignment->first, assignment->second});
  }
  Expected<CurveOptions> shape;
  for (const Setting& setting : settings)
    shape = std::move(shape).and_then(
        [&](CurveOptions so_far) { return with_setting(family, std::move(so_far), setting); });
  return shape;
}

/// A rule of the family; a complaint begins with the option that asks for it.
Expected<EndRule> rule_in(const FamilyInfo& family, OptionText option) {
  return end_rule_by_name(family, option.text).map_error([&](Error error) {
    error.message = fmt::format("{}: {}", option.option, error.message);
    return error;
  });
}

/// The rules for both ends that `--ends RULE` or `--ends START,END` names.
Expected<std::pair<EndRule, EndRule>> rules_in(const FamilyInfo& family, OptionText option) {
  const auto names = pieces_of(option.text, ',');
  if (names.size() > 2) return wanted(option, "RULE or START,END");
  const auto rule = [&](std::string_view name) { return rule_in(family, {option.option, name}); };
  return rule(names.front()).and_then([&](EndRule start) {
    return rule(names.back()).map([&](EndRule end) { return std::pair(start, end); });
  });
}

/// An end from its rule, if `--ends` names one, and its rate: a rate alone means clamped.
Expected<End> end_in(const FamilyInfo& family, std::optional<EndRule> rule, std::string_view option,
                     const std::optional<std::string>& rate) {
  if (!rate && rule == EndRule::clamped) return usage_failure(fmt::format("--ends clamped: wanted {} as well", option));
  if (!rate) return End{.rule = rule.value_or(EndRule::none)};
  if (rule.value_or(EndRule::clamped) != EndRule::clamped)
    return usage_failure(fmt::format("{}: a rate needs the end rule clamped, found {}", option, name_of(*rule)));
  if (auto known = rule_in(family, {option, name_of(EndRule::clamped)}); !known)
    return tl::unexpected(std::move(known.error()));
  return vector_in({option, *rate}).map([](const Eigen::Vector3d& w) { return End{EndRule::clamped, w}; });
}

std::string closing_methods() {
  std::vector<std::string_view> names;
  for (const FamilyInfo& family : families_info())
    if (family.closes) names.push_back(family.name);
  return fmt::format("{}", fmt::join(names, ", "));
}

Expected<std::optional<Loop>> loop_in(const FamilyInfo& family, const MethodOptions& options) {
  if (!options.period && !options.closed) return std::nullopt;
  if (!family.closes)
    return usage_failure(fmt::format("{}: this method has no closed curves, wanted --method with one of {}",
                                     family.name, closing_methods()));
  if (!options.period) return Loop{};
  const OptionText period{"--period", *options.period};
  const auto seconds = number_in(period);
  if (!seconds || *seconds <= 0.0) return wanted(period, "a number of seconds greater than 0");
  return Loop{.period = *seconds};
}

/// With the place in the file, unless the command line alone is at fault.
Error placed(const io::KeyFile& file, Error error) {
  const bool concerns_file = error.code == ErrorCode::bad_data || error.where.key;
  return concerns_file ? located(file, std::move(error)) : error;
}

}  // namespace

Expected<MethodRequest> method_request(const std::string& method, const MethodOptions& options) {
  const auto family = find_family(method);
  if (!family) return tl::unexpected(family.error());
  FirstError checked;
  const auto rules =
      checked(if_given("--ends", options.ends, [&](OptionText text) { return rules_in(**family, text); }));
  std::optional<EndRule> start_rule, end_rule;
  if (rules) std::tie(start_rule, end_rule) = *rules;
  CurveOptions shape = checked(settings_in(**family, options));
  shape.start = checked(end_in(**family, start_rule, "--start-rate", options.start_rate));
  shape.end = checked(end_in(**family, end_rule, "--end-rate", options.end_rate));
  shape.loop = checked(loop_in(**family, options));
  return std::move(checked).or_else(MethodRequest{*family, std::move(shape)});
}

Expected<std::vector<MethodRequest>> method_requests(const std::vector<std::string>& lists,
                                                     const MethodOptions& options) {
  std::vector<MethodRequest> requests;
  for (const std::string& list : lists)
    for (const std::string_view name : pieces_of(list, ',')) {
      auto request = method_request(std::string(name), options);
      if (!request) return tl::unexpected(std::move(request.error()));
      requests.push_back(std::move(*request));
    }
  return requests;
}

io::ReadOptions read_for(std::span<const MethodRequest> methods, io::ReadOptions read) {
  std::set<std::string> parameters;
  read.rate_orders = 0;
  for (const MethodRequest& method : methods) {
    for (std::string& name : open_parameters(method)) parameters.insert(std::move(name));
    read.rate_orders = std::max(read.rate_orders, method.family->rate_orders);
  }
  read.parameters = {parameters.begin(), parameters.end()};
  read.world_rates = true;
  return read;
}

std::vector<std::string> open_parameters(const MethodRequest& request) {
  std::vector<std::string> names;
  for (const Parameter& parameter : request.family->parameters)
    if (!request.options.parameters.contains(parameter.name)) names.emplace_back(parameter.name);
  return names;
}

CurveOptions completed(const MethodRequest& request, const io::KeyFile& file) {
  CurveOptions shape = request.options;
  for (const std::string& name : open_parameters(request))
    if (const auto column = file.parameters.find(name); column != file.parameters.end())
      shape.parameters.insert(*column);
  return shape;
}

std::optional<std::string> closing_step_warning(const MethodRequest& request, const Keyframes& keys) {
  const auto times = keys.times();
  if (!request.options.loop || !request.options.loop->period || times.size() < 2) return std::nullopt;
  const double closing_step = *request.options.loop->period - (times.back() - times.front());
  double shortest = times[1] - times[0];
  for (std::size_t i = 1; i < times.size(); ++i) shortest = std::min(shortest, times[i] - times[i - 1]);
  if (closing_step <= 0.0 || closing_step >= closing_share * shortest) return std::nullopt;
  return fmt::format(
      "--period: {:.2g} s from the last key back to the first make huge rates, the other steps are {:.4g} s and more; "
      "--closed is for a last key that is the first one again",
      closing_step, shortest);
}

std::optional<std::string> overwound_tangent_warning(const MethodRequest& request, const Keyframes& keys,
                                                const io::KeyFile& file) {
  const auto wound = overwound_tangent(request.family->name, keys, completed(request, file));
  if (!wound || !*wound) return std::nullopt;
  const std::string what = fmt::format(
      "a handle of {} turns by {:.4g} degrees, wanted less than a full turn: the angular velocity may jump "
      "there; timed-c1 has no such limit",
      request.family->name, (*wound)->turn / full_turn * 360.0);
  return describe(located(file, {ErrorCode::bad_data, what, {.key = (*wound)->key}}));
}

std::vector<std::string> known_settings() {
  std::set<std::string> settings;
  for (const FamilyInfo& family : families_info()) {
    for (const Parameter& parameter : family.parameters) settings.insert(fmt::format("{}=", parameter.name));
    for (const auto& [name, words] : family.choices)
      for (const std::string_view word : words) settings.insert(fmt::format("{}={}", name, word));
  }
  return {settings.begin(), settings.end()};
}

std::vector<std::string> known_end_rules() {
  std::set<std::string> rules;
  for (const FamilyInfo& family : families_info())
    for (const EndRule rule : family.ends) rules.emplace(name_of(rule));
  return {rules.begin(), rules.end()};
}

Expected<PoseCurve> shaped_curve(const MethodRequest& request, const Keyframes& keys, const io::KeyFile& file) {
  // The command line answers for itself first; what fails after that is the fault of the file's columns.
  const auto settled = settle(*request.family, request.options, keys.size());
  if (!settled) return tl::unexpected(placed(file, settled.error()));
  const CurveOptions shape = completed(request, file);
  const bool has_columns = shape.parameters.size() > request.options.parameters.size();
  return make_pose_curve(request.family->name, keys, shape).map_error([&](Error error) {
    if (has_columns) error.code = ErrorCode::bad_data;
    return placed(file, std::move(error));
  });
}

}  // namespace orispline::cli
