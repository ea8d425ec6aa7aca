// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/tune.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/fields/field_json.hpp>
#include <orispline/jobs/words.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/tune/tension_model.hpp>
#include <orispline/tune/tune.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::string energy_line(const TuneOutcome& outcome) {
  const Objective objective = outcome.request.options.objective;
  const auto [before, after] = std::pair(outcome.tuning.energy_before, outcome.tuning.energy_after);
  std::string line =
      formatted("{}: {:.8g} before, {:.8g} after {}", word_of(objective), before, after, unit_of(objective));
  if (before > 0.0) line += formatted(" ({:+.2f} %)", 100.0 * (after / before - 1.0));
  if (objective == Objective::fit)
    line += formatted("; RMS {:.4g}° before, {:.4g}° after", std::sqrt(before) * degrees, std::sqrt(after) * degrees);
  return line + "\n";
}

}  // namespace

bool has_tensions(const FamilyInfo& family) { return !tunable_parameters(family).empty(); }

const std::vector<double>& TuneOutcome::values(const std::string& parameter) const {
  return tuning.method.options.parameters.find(parameter)->second;
}

Expected<TuneOutcome> tune(TuneRequest request, const Progress& progress) {
  const Track& keys = *request.keys;
  if (auto whole = check_without_gaps(keys); !whole) return tl::unexpected(std::move(whole.error()));
  TuneOptions options = request.options;
  std::vector<double> times;  // of the reference, counted as those of the keys
  if (const Track* reference = request.reference.get()) {
    times = shifted(reference->keys.times(), (reference->epoch - keys.epoch).to_double());
    options.reference = {times, reference->keys.orientations()};
  }
  auto tuning = orispline::tune(keys, request.method.method, options, progress);
  if (!tuning) return tl::unexpected(placed(keys, std::move(tuning.error())));
  std::vector<Warning> warnings = request.method.warnings;
  std::ranges::move(std::exchange(tuning->warnings, {}), std::back_inserter(warnings));
  return TuneOutcome{std::move(request), std::move(*tuning), std::move(warnings)};
}

Json document_of(const TuneOutcome& outcome) {
  const Track& keys = *outcome.request.keys;
  const Objective objective = outcome.request.options.objective;
  Json json{{"method", outcome.tuning.method.name},
            {"objective", word_of(objective)},
            {"unit", unit_of(objective)},
            {"keys", keys.keys.size()}};
  put(json, outcome.tuning);
  Json times = Json::array();
  for (std::size_t key = 0; key < keys.keys.size(); ++key) times.push_back(keys.time_of(key).to_string());
  json["t_s"] = std::move(times);
  for (const std::string& name : outcome.tuning.parameters) json[name] = outcome.values(name);
  return json;
}

std::string summary_of(const TuneOutcome& outcome) {
  std::string text =
      formatted("{}, {}\n", keys_text(*outcome.request.keys), outcome.tuning.method.name) + energy_line(outcome);
  for (const std::string& name : outcome.tuning.parameters) {
    const auto [lowest, highest] = std::ranges::minmax(outcome.values(name));
    text += formatted("{}: {:.6g} to {:.6g}\n", name, lowest, highest);
  }
  return text;
}

}}}  // namespace orispline::jobs
