// SPDX-License-Identifier: Apache-2.0
#include "method_options.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "option_text.hpp"

namespace orispline::cli {
namespace {

using Parameters = std::map<std::string, std::vector<double>, std::less<>>;

Expected<Parameters> parameters_in(const MethodOptions& options) {
  Parameters parameters;
  if (options.tension) {
    auto values = numbers_in({"--tension", *options.tension});
    if (!values) return tl::unexpected(std::move(values.error()));
    parameters.emplace("tension", std::move(*values));
  }
  for (const std::string& setting : options.settings) {
    const auto assignment = assignment_in({"--set", setting});
    if (!assignment) return tl::unexpected(assignment.error());
    const auto& [name, text] = *assignment;
    auto values = numbers_in({fmt::format("--set {}", name), text});
    if (!values) return tl::unexpected(std::move(values.error()));
    if (!parameters.emplace(name, std::move(*values)).second)
      return usage_failure(fmt::format("--set {}: '{}' is given twice, wanted it once", name, name));
  }
  return parameters;
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
  CurveOptions shape{.parameters = checked(parameters_in(options)),
                     .start = checked(end_in(**family, start_rule, "--start-rate", options.start_rate)),
                     .end = checked(end_in(**family, end_rule, "--end-rate", options.end_rate))};
  return std::move(checked).or_else(MethodRequest{*family, std::move(shape)});
}

std::vector<std::string> open_parameters(const MethodRequest& request) {
  std::vector<std::string> names;
  for (const Parameter& parameter : request.family->parameters)
    if (!request.options.parameters.contains(parameter.name)) names.emplace_back(parameter.name);
  return names;
}

Expected<PoseCurve> shaped_curve(const MethodRequest& request, const Keyframes& keys, const io::KeyFile& file) {
  // The command line answers for itself first; what fails after that is the fault of the file's columns.
  const auto settled = settle(*request.family, request.options, keys.size());
  if (!settled) return tl::unexpected(placed(file, settled.error()));
  CurveOptions shape = request.options;
  bool has_columns = false;
  for (const std::string& name : open_parameters(request))
    if (const auto column = file.parameters.find(name); column != file.parameters.end()) {
      shape.parameters.insert(*column);
      has_columns = true;
    }
  return make_pose_curve(request.family->name, keys, shape).map_error([&](Error error) {
    if (has_columns) error.code = ErrorCode::bad_data;
    return placed(file, std::move(error));
  });
}

}  // namespace orispline::cli
