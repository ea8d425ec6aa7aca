// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_report.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/math/degrees.hpp>

#include "output/findings_text.hpp"
#include "output/repairs_text.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

constexpr std::size_t many_keys = 1'000'000;  // some hundred megabytes, worth a word

std::string keys_line(const SampleReport& report) {
  std::string line = formatted("{} from {}, {} to {} s", counted(report.keys, "key"), printable(report.input),
                               report.start.to_string(), report.end.to_string());
  const KeyframeReport& keyframes = report.keyframes;
  if (keyframes.sign_flips > 0) line += formatted("; sign flips in the file: {}", keyframes.sign_flips);
  if (keyframes.non_unit_keys > 0) line += formatted("; {} normalised", keyframes.non_unit_keys);
  return line + "\n";
}

std::string rates_lines(const SampleReport& report) {
  constexpr std::array names{"angular velocities", "accelerations", "jerks"};
  std::string lines;
  if (report.rate_orders > 0)
    lines += formatted("rates taken from the keys: {}\n", joined(std::span(names).first(report.rate_orders), ", "));
  return lines;
}

std::string truth_line(const TruthReport& truth) {
  const DistanceStatistics& d = truth.distance;
  if (d.count == 0)
    return formatted("distance to {}: none of its times lies between the keys\n", printable(truth.path));
  return formatted("distance to {}: RMS {:.4g}°, mean {:.4g}°, largest {:.4g}° at {} s; {} compared\n",
                   printable(truth.path), d.rms * degrees, d.mean * degrees, d.largest * degrees,
                   truth.largest_time.to_string(), counted(d.count, "orientation"));
}

std::string outside_text(const SampleReport& report) {
  const auto how = std::ranges::find(words<Extrapolation>, static_cast<int>(report.extrapolation), &Word::value);
  return formatted("{} outside the curve {}", counted(report.held_samples, "sample"), how->sentence);
}

}  // namespace

std::string text_of(const SampleReport& report) {
  std::string text = keys_line(report);
  if (const std::string repairs = text_of(report.repairs); !repairs.empty()) text += repairs + "\n";
  text += rates_lines(report);
  text += formatted("{} with {} written to {}\n", counted(report.samples, "sample"), report.method_text,
                    destination(report.output));
  if (report.findings) text += "the keys say: " + text_of(*report.findings) + "\n";
  if (report.method == default_method && report.keys >= families::least_weighed)
    text +=
        "if the keys are a recording, --method measured finds how noisy they are, and --band 0.9 how far off it may "
        "be\n";
  if (report.band) text += formatted("the band is meant to hold {:.4g} % of the true motion\n", 100.0 * *report.band);
  if (report.held_samples > 0) text += outside_text(report) + "\n";
  if (report.truth) text += truth_line(*report.truth);
  if (report.keys_held && report.keys >= many_keys)
    text += "all keys were held in memory; 'orispline sample --help' says what goes through in pieces\n";
  return text;
}

std::string line_of(const SampleReport& report) {
  std::string line = formatted("{}: {} with {} from {}", printable(report.output), counted(report.samples, "sample"),
                               report.method_text, counted(report.keys, "key"));
  line += clauses_of(report.repairs);
  if (report.held_samples > 0) line += "; " + outside_text(report);
  if (report.truth && report.truth->distance.count > 0)
    line += formatted("; RMS {:.4g}° and at most {:.4g}° from {}", report.truth->distance.rms * degrees,
                      report.truth->distance.largest * degrees, printable(report.truth->path));
  return line;
}

}  // namespace orispline::cli
