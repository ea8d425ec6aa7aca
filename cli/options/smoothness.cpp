// SPDX-License-Identifier: Apache-2.0
#include "options/smoothness.hpp"

#include <numbers>

#include "options/command_options.hpp"
#include "options/quantity.hpp"

namespace orispline::cli {

Expected<double> positive_in(OptionText option) {
  const auto number = number_in(option);
  if (!number || !(*number > 0.0)) return wanted(option, "a number greater than 0");
  return *number;
}

Expected<orispline::SmoothOptions> smoothing_in(const SmoothnessOptions& options) {
  const int stated = options.noise.has_value() + options.smoothing_time.has_value() + options.cutoff.has_value();
  if (stated > 1)
    return usage_failure("found several of --noise, --smoothing-time and --cutoff, wanted one: each says how smooth");
  FirstError checked;
  orispline::SmoothOptions smoothing;
  smoothing.noise = checked(if_given("--noise", options.noise, quantity_of(angle_units)));
  smoothing.smoothing_time = checked(if_given("--smoothing-time", options.smoothing_time, positive_in));
  if (const auto cutoff = checked(if_given("--cutoff", options.cutoff, positive_in)))
    smoothing.smoothing_time = 1.0 / (2.0 * std::numbers::pi * *cutoff);
  return std::move(checked).or_else(std::move(smoothing));
}

void add_smoothness_options(CLI::App& app, SmoothnessOptions& o) {
  const std::string group = "Smoothing";
  app.add_option("--noise", o.noise, "Standard deviation of the orientations per axis, such as 1deg or 0.02rad")
      ->type_name("ANGLE")
      ->group(group);
  app.add_option("--smoothing-time", o.smoothing_time, "Smoothing time tau [chosen]")->type_name("S")->group(group);
  app.add_option("--cutoff", o.cutoff, "The same as frequency 1/(2 pi tau), where half of a motion is left")
      ->type_name("HZ")
      ->group(group);
}

}  // namespace orispline::cli
