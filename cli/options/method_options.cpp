// SPDX-License-Identifier: Apache-2.0
#include "options/method_options.hpp"

#include <algorithm>
#include <set>
#include <span>

#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {
namespace {

/// What the library finds wrong with the text of an option begins with that option.
template <class T>
Expected<T> said_by(std::string_view option, Expected<T> result) {
  if (result || result.error().option.empty()) return result;
  result.error().message = formatted("{}: {}", option, result.error().message);
  result.error().option.clear();
  return result;
}

Expected<Method> with_end_rules(Method method, const MethodOptions& options) {
  return options.ends ? said_by("--ends", with_ends(std::move(method), *options.ends)) : method;
}

/// Parameters and choices.
Expected<Method> with_settings(Method method, const MethodOptions& options) {
  Expected<Method> shaped = std::move(method);
  if (options.tension) shaped = said_by("--tension", with_setting(std::move(*shaped), "tension", *options.tension));
  for (const std::string& text : options.settings) {
    const auto assignment = assignment_in({"--set", text});
    if (!assignment) return tl::unexpected(assignment.error());
    shaped = std::move(shaped).and_then([&](Method so_far) {
      const auto& [name, value] = *assignment;
      return said_by(formatted("--set {}", name), with_setting(std::move(so_far), name, value));
    });
  }
  return shaped;
}

/// A rate alone means clamped, and a clamped end wants one.
Expected<Method> with_rate_option(Method method, CurveEnd end, std::string_view option,
                                  const std::optional<std::string>& rate) {
  const EndRule rule = (end == CurveEnd::start ? method.options.start : method.options.end).rule;
  if (!rate && rule == EndRule::clamped) return usage_failure(formatted("--ends clamped: wanted {} as well", option));
  if (!rate) return method;
  // Whether the end can have a rate at all comes before its numbers.
  if (auto able = said_by(option, with_end_rate(method, end, Eigen::Vector3d::Zero())); !able) return able;
  return vector_in({option, *rate}).and_then([&](const Eigen::Vector3d& w) {
    return with_end_rate(std::move(method), end, w);
  });
}

Expected<Method> with_loop_options(Method method, const MethodOptions& options) {
  if (!options.period && !options.closed) return method;
  auto loop = with_loop(method, {});  // whether the method has loops comes before the period
  if (!loop || !options.period) return loop;
  const OptionText period{"--period", *options.period};
  const auto seconds = number_in(period);
  if (!seconds || *seconds <= 0.0) return wanted(period, "a number of seconds greater than 0");
  return with_loop(std::move(method), {.period = *seconds});
}

}  // namespace

Expected<Method> method_request(std::string_view text, const MethodOptions& options) {
  return said_by("--method", method_from_text(text))
      .and_then([&](Method method) { return with_end_rules(std::move(method), options); })
      .and_then([&](Method method) { return with_settings(std::move(method), options); })
      .and_then([&](Method method) {
        return with_rate_option(std::move(method), CurveEnd::start, "--start-rate", options.start_rate);
      })
      .and_then([&](Method method) {
        return with_rate_option(std::move(method), CurveEnd::end, "--end-rate", options.end_rate);
      })
      .and_then([&](Method method) { return with_loop_options(std::move(method), options); });
}

Expected<std::vector<Method>> method_requests(const std::vector<std::string>& lists, const MethodOptions& options) {
  std::vector<Method> requests;
  for (const std::string& list : lists)
    for (const std::string_view name : pieces_of(list, ',')) {
      auto request = method_request(name, options);
      if (!request) return tl::unexpected(std::move(request.error()));
      requests.push_back(std::move(*request));
    }
  return requests;
}

io::ReadOptions read_for(std::span<const Method> methods, io::ReadOptions read) {
  std::set<std::string> parameters;
  read.rate_orders = 0;
  for (const Method& method : methods) {
    for (std::string& name : open_parameters(method)) parameters.insert(std::move(name));
    read.rate_orders = std::max(read.rate_orders, family_of(method).rate_orders);
  }
  read.parameters = {parameters.begin(), parameters.end()};
  read.world_rates = true;
  return read;
}

const FamilyInfo& family_of(const Method& method) { return **find_family(method.name); }

std::vector<std::string> open_parameters(const Method& method) {
  std::vector<std::string> names;
  for (const Parameter& parameter : family_of(method).parameters)
    if (!method.options.parameters.contains(parameter.name)) names.emplace_back(parameter.name);
  return names;
}

Method completed(const Method& method, const Track& track) { return completed(method, family_of(method), track); }

std::vector<std::string> known_settings() {
  std::set<std::string> settings;
  for (const FamilyInfo& family : families_info()) {
    for (const Parameter& parameter : family.parameters) settings.insert(formatted("{}=", parameter.name));
    for (const auto& [name, words] : family.choices)
      for (const std::string_view word : words) settings.insert(formatted("{}={}", name, word));
  }
  return {settings.begin(), settings.end()};
}

std::vector<std::string> known_end_rules() {
  std::set<std::string> rules;
  for (const FamilyInfo& family : families_info())
    for (const EndRule rule : family.ends) rules.emplace(name_of(rule));
  return {rules.begin(), rules.end()};
}

Expected<PoseCurve> shaped_curve(const Method& method, const Track& track) {
  // The command line answers for itself first; what fails after that is the fault of the file's columns.
  const auto settled = settle(family_of(method), method.options, track.keys.size());
  if (!settled) return tl::unexpected(placed(track, settled.error()));
  const Method shaped = completed(method, track);
  const bool has_columns = shaped.options.parameters.size() > method.options.parameters.size();
  return make_pose_curve(shaped, track.keys).map_error([&](Error error) {
    if (has_columns) error.code = ErrorCode::bad_data;
    return placed(track, std::move(error));
  });
}

Error placed(const Track& track, Error error) {
  const bool concerns_file = error.code != ErrorCode::bad_argument || error.where.key;
  return concerns_file ? track.located(std::move(error)) : error;
}

}  // namespace orispline::cli
