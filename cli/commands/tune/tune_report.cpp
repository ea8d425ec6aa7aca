// SPDX-License-Identifier: Apache-2.0
#include "commands/tune/tune_report.hpp"

#include <algorithm>
#include <cmath>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/tune/tune_fields.hpp>

#include "output/summary.hpp"

namespace orispline::cli {

namespace {

std::string energy_line(const TuneReport& report) {
  const auto& [before, after] = std::pair(report.tuning.energy_before, report.tuning.energy_after);
  std::string line = formatted("{}: {:.8g} before, {:.8g} after {}", word_of(report.objective), before, after,
                               unit_of(report.objective));
  if (before > 0.0) line += formatted(" ({:+.2f} %)", 100.0 * (after / before - 1.0));
  if (report.objective == orispline::Objective::fit)
    line += formatted("; RMS {:.4g}° before, {:.4g}° after", std::sqrt(before) * degrees, std::sqrt(after) * degrees);
  return line + "\n";
}

}  // namespace

std::string text_of(const TuneReport& report) {
  std::string text = formatted("{} from {}, {}\n", counted(report.times.size(), "key"), printable(report.input),
                               report.tuning.method.name);
  text += energy_line(report);
  for (const std::string& name : report.tuning.parameters) {
    const auto& values = report.tuning.method.options.parameters.find(name)->second;
    const auto [lowest, highest] = std::ranges::minmax(values);
    text += formatted("{}: {:.6g} to {:.6g}\n", name, lowest, highest);
  }
  return text + formatted("keys with tensions written to {}\n", destination(report.output));
}

}  // namespace orispline::cli
