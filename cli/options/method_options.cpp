// SPDX-License-Identifier: Apache-2.0
#include "options/method_options.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <span>

#include <orispline/base/formatted.hpp>
#include <orispline/families/blending/blending_family.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/io/blending_file.hpp>

#include "options/option_text.hpp"

namespace orispline::cli {

namespace {

/// An error that the library finds in the text of an option begins with the name of that option.
template <class T>
Expected<T> naming_flag(std::string_view option, Expected<T> result) {
  if (result || result.error().option.empty()) return result;
  result.error().message = formatted("{}: {}", option, result.error().message);
  result.error().option.clear();
  return result;
}

Expected<Method> with_end_rules(Method method, const MethodOptions& options) {
  return options.ends ? naming_flag("--ends", with_ends(std::move(method), *options.ends)) : method;
}

/// Parameters and choices.
Expected<Method> with_settings(Method method, const MethodOptions& options) {
  Expected<Method> shaped = std::move(method);
  if (options.tension) shaped = naming_flag("--tension", with_setting(std::move(*shaped), "tension", *options.tension));
  for (const std::string& text : options.settings) {
    const auto assignment = assignment_in({"--set", text});
    if (!assignment) return tl::unexpected(assignment.error());
    shaped = std::move(shaped).and_then([&](Method so_far) {
      const auto& [name, value] = *assignment;
      return naming_flag(formatted("--set {}", name), with_setting(std::move(so_far), name, value));
    });
  }
  return shaped;
}

/// A rate alone means clamped, and an end that `--ends` asks to be clamped wants one; a text states both.
Expected<Method> with_rate_option(Method method, CurveEnd end, const std::optional<std::string>& ends,
                                  std::string_view option, const std::optional<std::string>& rate) {
  const End& given = end == CurveEnd::start ? method.options.start : method.options.end;
  const bool lacks_rate = given.rule == EndRule::clamped && given.angular_velocity.isZero(0.0);
  if (!rate && lacks_rate && ends)
    return usage_failure(formatted("--ends clamped: found no rate for that end, wanted {} as well", option));
  if (!rate) return method;
  // Whether the end can have a rate at all comes before its numbers.
  if (auto able = naming_flag(option, with_end_rate(method, end, Eigen::Vector3d::Zero())); !able) return able;
  return vector_in({option, *rate}).and_then([&](const Eigen::Vector3d& w) {
    return with_end_rate(std::move(method), end, w);
  });
}

/// A method without the settings that options state.
Method without_stated(const MethodOptions& options, Method method) {
  std::vector<std::string> stated;
  for (const std::string& text : options.settings) stated.push_back(text.substr(0, text.find('=')));
  const auto add = [&](bool is_given, std::string_view name) {
    if (is_given) stated.emplace_back(name);
  };
  add(options.tension.has_value(), "tension");
  add(options.ends.has_value(), "ends");
  add(options.start_rate.has_value(), "start_rate");
  add(options.end_rate.has_value(), "end_rate");
  add(options.closed || options.period, "closed");
  return without(std::move(method), stated);
}

Expected<Method> with_loop_options(Method method, const MethodOptions& options) {
  if (!options.period && !options.closed) return method;
  auto loop = with_loop(method, {});  // whether the method has loops comes before the period
  if (!loop || !options.period) return loop;
  const OptionText period{"--period", *options.period};
  const auto seconds = positive_in(period, "a number of seconds greater than 0");
  if (!seconds) return tl::unexpected(seconds.error());
  return with_loop(std::move(method), {.period = *seconds});
}

Expected<Method> shaped(Method given, const MethodOptions& options) {
  return with_end_rules(std::move(given), options)
      .and_then([&](Method method) { return with_settings(std::move(method), options); })
      .and_then([&](Method method) {
        return with_rate_option(std::move(method), CurveEnd::start, options.ends, "--start-rate", options.start_rate);
      })
      .and_then([&](Method method) {
        return with_rate_option(std::move(method), CurveEnd::end, options.ends, "--end-rate", options.end_rate);
      })
      .and_then([&](Method method) { return with_loop_options(std::move(method), options); });
}

}  // namespace

std::string_view first_given(const MethodOptions& o) {
  const std::array given{std::pair(o.tension.has_value(), "--tension"),
                         std::pair(!o.settings.empty(), "--set"),
                         std::pair(o.ends.has_value(), "--ends"),
                         std::pair(o.start_rate.has_value(), "--start-rate"),
                         std::pair(o.end_rate.has_value(), "--end-rate"),
                         std::pair(o.period.has_value(), "--period"),
                         std::pair(o.closed, "--closed")};
  const auto* const first = std::ranges::find(given, true, &std::pair<bool, const char*>::first);
  return first == given.end() ? "" : first->second;
}

Expected<OwnFamilies> own_families(const std::vector<std::string>& files) {
  OwnFamilies families;
  for (const std::string& file : files) {
    auto family = io::read_blending(file).and_then(BlendingFamily::make);
    if (!family) {
      if (family.error().where.file.empty()) family.error().where.file = file;
      return tl::unexpected(std::move(family.error()));
    }
    const std::string_view name = (*family)->info().name;
    if (std::ranges::find(families, name, [](const auto& other) { return other->info().name; }) != families.end())
      return usage_failure(formatted("--blending: found the name '{}' twice, wanted each once", name));
    families.push_back(std::move(*family));
  }
  return families;
}

Expected<Method> method_request(std::string_view text, const MethodOptions& options, std::string_view option) {
  return own_families(options.blending)
      .and_then([&](const auto& own) { return naming_flag(option, method_from_text(text, own)); })
      .and_then([&](Method method) { return shaped(std::move(method), options); });
}

Expected<std::optional<Method>> named_method(const std::optional<std::string>& text, const MethodOptions& options) {
  if (!text) return std::nullopt;
  return method_request(*text, options).map([](Method method) { return std::optional(std::move(method)); });
}

Expected<jobs::ChosenMethod> chosen_method(const std::optional<Method>& named, const MethodOptions& options,
                                           const io::KeyInput& keys, const jobs::UsualMethod& usual) {
  return jobs::chosen_method(named, keys.recipe(), keys.path(), usual, [&](Method method, jobs::NamedBy by) {
    if (by == jobs::NamedBy::nobody) return shaped(std::move(method), options);
    return shaped(without_stated(options, std::move(method)), options);
  });
}

Expected<std::vector<std::string>> method_texts(std::string_view option, const std::vector<std::string>& typed,
                                                const OwnFamilies& own) {
  std::vector<std::string> all;
  for (const std::string& list : typed) {
    auto texts = naming_flag(option, method_texts_in(list, own));
    if (!texts) return texts;
    std::ranges::move(*texts, std::back_inserter(all));
  }
  return all;
}

Expected<void> check_differ(std::string_view option, std::span<const std::string> methods) {
  std::set<std::string_view> found;
  for (const std::string& method : methods)
    if (!found.insert(method).second)
      return usage_failure(formatted("{}: found '{}' twice, wanted each method once", option, method));
  return {};
}

Expected<std::vector<Method>> method_requests(const std::vector<std::string>& typed, const MethodOptions& options) {
  constexpr std::string_view option = "--method";
  const auto own = own_families(options.blending);
  if (!own) return tl::unexpected(own.error());
  const auto texts = method_texts(option, typed, *own);
  if (!texts) return tl::unexpected(texts.error());
  std::vector<Method> requests;
  std::vector<std::string> shaped_texts;
  for (const std::string& text : *texts) {
    auto request = method_request(text, options);
    if (!request) return tl::unexpected(std::move(request.error()));
    shaped_texts.push_back(text_of(*request));
    requests.push_back(std::move(*request));
  }
  return check_differ(option, shaped_texts).map([&] { return std::move(requests); });
}

io::ReadOptions with_columns_of(const Method& method, io::ReadOptions read) {
  const FamilyInfo& family = jobs::family_of(method);
  read.rate_orders = std::max(read.rate_orders, family.rate_orders);
  read.inner_quaternions |= family.takes_inner_quaternions();
  return read;
}

io::ReadOptions read_for(std::span<const Method> methods, io::ReadOptions read) {
  std::set<std::string> parameters;
  read.rate_orders = 0;
  for (const Method& method : methods) {
    for (std::string& name : open_parameters(method)) parameters.insert(std::move(name));
    read = with_columns_of(method, std::move(read));
  }
  read.parameters = {parameters.begin(), parameters.end()};
  read.world_rates = true;
  return read;
}

std::vector<std::string> open_parameters(const Method& method) {
  std::vector<std::string> names;
  for (const Parameter& parameter : jobs::family_of(method).parameters)
    if (!method.options.parameters.contains(parameter.name)) names.emplace_back(parameter.name);
  return names;
}

void read_band(io::ReadOptions& read) {
  read.parameters.insert(read.parameters.end(), band_columns.begin(), band_columns.end());
}

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

}  // namespace orispline::cli
