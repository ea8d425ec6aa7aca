// SPDX-License-Identifier: Apache-2.0
#include "commands/tune/tune_report.hpp"

#include <algorithm>
#include <cmath>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>

#include "commands/tune/tune.hpp"
#include "options/quantity.hpp"
#include "output/summary.hpp"

namespace orispline::cli {
namespace {

std::string energy_line(const TuneReport& report) {
  const auto& [before, after] = std::pair(report.tuning.energy_before, report.tuning.energy_after);
  const auto name =
      std::ranges::find(objective_choices, report.objective, &Choice<orispline::Objective>::second)->first;
  std::string line = formatted("{}: {:.8g} before, {:.8g} after {}", name, before, after, unit_of(report.objective));
  if (before > 0.0) line += formatted(" ({:+.2f} %)", 100.0 * (after / before - 1.0));
  if (report.objective == orispline::Objective::fit)
    line += formatted("; RMS {:.4g}° before, {:.4g}° after", std::sqrt(before) * degrees, std::sqrt(after) * degrees);
  return line + "\n";
}

}  // namespace

std::string_view unit_of(orispline::Objective objective) {
  switch (objective) {
    case orispline::Objective::torque:
      return "N^2 m^2 s";
    case orispline::Objective::jerk:
      return "rad^2/s^5";
    case orispline::Objective::fit:
      return "rad^2";
    default:
      return "rad^2/s^3";
  }
}

std::string text_of(const TuneReport& report) {
  std::string text =
      formatted("{} from {}, {}\n", counted(report.times.size(), "key"), report.input, report.tuning.method.name);
  text += energy_line(report);
  for (const std::string& name : report.tuning.parameters) {
    const auto& values = report.tuning.method.options.parameters.find(name)->second;
    const auto [lowest, highest] = std::ranges::minmax(values);
    text += formatted("{}: {:.6g} to {:.6g}\n", name, lowest, highest);
  }
  return text + formatted("keys with tensions written to {}\n", destination(report.output));
}

}  // namespace orispline::cli
