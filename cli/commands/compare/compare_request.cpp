// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_request.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/fields.hpp>

#include "options/method_options.hpp"
#include "options/threads.hpp"

namespace orispline::cli {

namespace {

constexpr std::size_t default_step = 8;
constexpr std::string_view all_of_them = "all", methods_option = "--methods";

Expected<jobs::LabelledMethod> named_method(const std::string& text, const OwnFamilies& own) {
  return method_from_text(text, own)
      .map([&](Method method) {
        return jobs::LabelledMethod{text, std::move(method)};
      })
      .map_error([](Error error) {
        if (!std::exchange(error.option, {}).empty())
          error.message = formatted("{}: {}", methods_option, error.message);
        return error;
      });
}

/// The methods of a name, which may be `all`.
Expected<std::vector<jobs::LabelledMethod>> methods_named(const std::string& name, const OwnFamilies& own) {
  if (name == all_of_them) return jobs::all_methods();
  return named_method(name, own).map([](jobs::LabelledMethod method) { return std::vector{std::move(method)}; });
}

Expected<std::vector<jobs::LabelledMethod>> methods_in(std::span<const std::string> names, const OwnFamilies& own) {
  if (names.empty()) return jobs::all_methods();
  std::vector<jobs::LabelledMethod> methods;
  std::vector<std::string> labels;
  for (const std::string& name : names) {
    auto named = methods_named(name, own);
    if (!named) return tl::unexpected(std::move(named.error()));
    for (jobs::LabelledMethod& method : *named) {
      labels.push_back(method.label);
      methods.push_back(std::move(method));
    }
  }
  return check_differ(methods_option, labels).map([&] { return std::move(methods); });
}

Expected<std::vector<std::size_t>> steps_in(const CompareArguments& options) {
  std::vector<std::size_t> steps;
  for (const std::string& list : options.keep_every)
    for (const std::string_view piece : pieces_of(list, ',')) {
      const auto step = count_in({"--keep-every", piece}, 2);
      if (!step) return tl::unexpected(step.error());
      if (std::ranges::find(steps, *step) != steps.end())
        return usage_failure(formatted("--keep-every: found {} twice, wanted each number once", *step));
      steps.push_back(*step);
    }
  if (steps.empty()) steps.push_back(default_step);
  return steps;
}

Expected<std::vector<Decimation>> decimations_in(const CompareArguments& options) {
  const bool decimates = !options.keep_every.empty() || options.jitter || options.random;
  if (options.reference && decimates)
    return usage_failure(
        "found --reference and --keep-every, --jitter or --random, wanted a dense reference or samples of INPUT for "
        "it");
  if (options.reference) return std::vector<Decimation>();
  FirstError checked;
  const auto steps = checked(steps_in(options));
  const auto seed =
      checked(if_given("--random", options.random, [](OptionText text) { return count_in(text, 0); })).value_or(1);
  const Spacing spacing = options.jitter ? Spacing::jittered : options.random ? Spacing::random : Spacing::even;
  std::vector<Decimation> decimations;
  for (const std::size_t step : steps) decimations.push_back({step, spacing, seed});
  return std::move(checked).or_else(std::move(decimations));
}

Expected<MeasureOptions> measures_in(const CompareArguments& options) {
  return options_in<MeasureOptions>(options.measured).and_then([](const MeasureOptions& read) {
    return check(read).map([&] { return read; });
  });
}

/// What the options ask of each other.
Expected<void> agree(const CompareArguments& options, const CompareRequest& request) {
  if (options.json && options.csv) return usage_failure("found --json and --csv, wanted one of them");
  std::vector<OtherFile> others{{"INPUT", options.input.path}};
  if (options.reference) others.push_back({"that of --reference", *options.reference});
  if (auto fits = check_report(options.report, others); !fits) return fits;
  if (options.reference == io::standard_stream && options.input.path == io::standard_stream)
    return usage_failure("found '-' for INPUT and --reference, wanted it for one at most");
  return jobs::check(request.job);
}

}  // namespace

Expected<CompareRequest> compare_request(const CompareArguments& options) {
  FirstError checked;
  const OwnFamilies own = checked(own_families(options.blending));
  const auto named = checked(method_texts(methods_option, options.methods, own));
  CompareRequest request{.input = checked(input_request(options.input)),
                         .job = {.decimations = checked(decimations_in(options)),
                                 .methods = checked(methods_in(named, own)),
                                 .named = named,
                                 .tune = options.tune,
                                 .align = options.align,
                                 .measured = checked(measures_in(options)),
                                 .has_inertia = is_given(options.measured, "inertia")}};
  if (options.sort) request.job.sort = checked(measure_of_word(*options.sort)).word;
  request.job.threads = static_cast<unsigned>(checked(threads_in(options.inputs.threads)));
  if (auto agreed = agree(options, request); !agreed) static_cast<void>(checked(agreed.map([] { return 0; })));
  auto read = std::move(checked).or_else(std::move(request));
  if (!read) return read;
  read->input.read.rate_orders = 1;
  read->input.read.world_rates = true;
  for (const jobs::LabelledMethod& method : read->job.methods) {
    read->input.read = with_columns_of(method.method, std::move(read->input.read));
    if (!options.reference) continue;
    for (std::string& name : open_parameters(method.method)) {
      auto& parameters = read->input.read.parameters;
      if (std::ranges::find(parameters, name) == parameters.end()) parameters.push_back(std::move(name));
    }
  }
  return read;
}

}  // namespace orispline::cli
