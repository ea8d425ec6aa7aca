// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/words.hpp>

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/measured.hpp>
#include <orispline/families/method_text.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

/// A model in the words of the summary.
std::string name_of_model(std::size_t model) {
  if (model == 0) return "spline";
  if (model < families::noise_models) return formatted("key noise {}", families::noise_shares[model]);
  const auto& [twice_smoothness, length] = families::velocity_shapes[model - families::noise_models];
  return formatted("{} velocity {}", twice_smoothness == 1 ? "rough" : "smooth", length);
}

}  // namespace

std::string keys_text(const Track& keys, std::string_view one) {
  const std::string count = counted(keys.keys.size(), one);
  return keys.name.empty() ? count : formatted("{} from {}", count, printable(keys.name));
}

std::vector<double> shifted(std::span<const double> times, double shift) {
  std::vector<double> moved(times.begin(), times.end());
  for (double& t : moved) t += shift;
  return moved;
}

std::string shown_name(std::string_view file, std::string_view otherwise) {
  return file.empty() ? std::string(otherwise) : printable(file_name_of(file));
}

std::string findings_text(const KeyFindings& findings) {
  constexpr double least_shown = 0.05;
  const auto& shares = findings.belief.models;
  std::vector<std::size_t> models;
  for (std::size_t m = 0; m < shares.size(); ++m)
    if (shares[m] >= least_shown) models.push_back(m);
  std::ranges::stable_sort(models, std::greater<>(), [&](std::size_t m) { return shares[m]; });
  std::string text;
  double rest = 1.0;
  for (const std::size_t m : models) {
    text += formatted("{}: {:.0f} %, ", name_of_model(m), 100.0 * shares[m]);
    rest -= shares[m];
  }
  if (rest >= 0.005) text += formatted("others: {:.0f} %, ", 100.0 * rest);
  text.replace(text.size() - 2, 2, "; ");
  return text + formatted("polynomial believed {:.2g}, of nine keys {:.2g}; trust {:.2g}", findings.belief.polynomial,
                          findings.belief.polynomial9, findings.trust);
}

Json findings_json(const std::optional<KeyFindings>& findings) {
  if (!findings) return nullptr;
  const Method given = with_findings(std::string(families::Measured::info.name), *findings);
  Json settings;
  for (const Parameter& parameter : families::Measured::parameters)
    settings[parameter.name] = given.options.parameters.find(parameter.name)->second.front();
  return {{"settings", std::move(settings)},
          {"trust", findings->trust},
          {"given", findings->given},
          {"method_text", text_of(given)}};
}

Json rotation_json(const Eigen::Quaterniond& q) { return {{"qw", q.w()}, {"qx", q.x()}, {"qy", q.y()}, {"qz", q.z()}}; }

Places places_of(const Track& track) {
  return {track.lines, [&track](std::size_t sample) { return track.time_of(sample); }};
}

}}}  // namespace orispline::jobs
