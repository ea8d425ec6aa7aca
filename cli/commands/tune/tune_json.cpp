// SPDX-License-Identifier: Apache-2.0
#include "commands/tune/tune_report.hpp"

#include "commands/tune/tune.hpp"
#include "output/json_document.hpp"

namespace orispline::cli {

std::string json_of(const TuneReport& report) {
  Json json{{"input", report.input},
            {"output", report.output},
            {"method", report.tuning.method.name},
            {"objective", word_of(objective_choices, report.objective)},
            {"unit", unit_of(report.objective)},
            {"keys", report.times.size()},
            {"energy_before", report.tuning.energy_before},
            {"energy_after", report.tuning.energy_after},
            {"iterations", report.tuning.iterations},
            {"stationarity", report.tuning.stationarity},
            {"t", report.times}};
  for (const std::string& name : report.tuning.parameters)
    json[name] = report.tuning.method.options.parameters.find(name)->second;
  return document(json);
}

}  // namespace orispline::cli
