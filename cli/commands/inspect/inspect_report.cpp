// SPDX-License-Identifier: Apache-2.0
#include "commands/inspect/inspect_report.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/math/degrees.hpp>

#include "output/findings_text.hpp"

namespace orispline::cli {

namespace {

constexpr std::size_t places_shown = 3;

/// `key 4 (line 6, 5.2 s)`
std::string place(const InspectReport& report, std::size_t key) {
  const auto& lines = report.file.track.lines;
  const std::string line = lines.empty() ? "" : formatted("line {}, ", lines[key]);
  return formatted("key {} ({}{} s)", key, line, report.time_of(key).to_string());
}

std::string keys_lines(const InspectReport& report) {
  const std::size_t last = report.keys() - 1;
  std::string text =
      formatted("{}\nkeys          {}, {} to {} s, span {} s\n", printable(report.file.track.name), last + 1,
                report.time_of(0).to_string(), report.time_of(last).to_string(), report.statistics.span);
  if (const auto& spacing = report.statistics.spacing)
    text += formatted("spacing       min {:.6g} s, median {:.6g} s, max {:.6g} s after {}\n", spacing->smallest,
                      spacing->median, spacing->largest, place(report, spacing->largest_at));
  if (const auto& step = report.statistics.step)
    text += formatted("steps         median {:.4g}°, max {:.4g}° after {}\n", step->median * degrees,
                      step->largest * degrees, place(report, step->largest_at));
  return text;
}

std::string recipe_line(const Recipe& recipe) {
  if (recipe.is_empty()) return "";
  return formatted("keys for      {}{}, as line {} says\n", printable(recipe.method),
                   recipe.signs == Signs::as_given ? ", signs as given" : "", recipe.line);
}

std::string half_turn_line(const InspectReport& report) {
  const auto& steps = report.statistics.near_half_turns;
  std::string line = formatted("near 180°     {}", steps.size());
  for (std::size_t i = 0; i < std::min(steps.size(), places_shown); ++i)
    line += formatted("{} after {}", i == 0 ? ":" : ",", place(report, steps[i]));
  if (steps.size() > places_shown) line += ", …";
  return line + (steps.empty() ? "\n" : "; the curve may turn the wrong way there: put a key in between\n");
}

std::string quality_lines(const InspectReport& report) {
  const KeyframeReport& keyframes = report.keyframes;
  const io::RepairReport& repairs = report.file.repairs;
  return formatted(
      "sign flips    {}\n"
      "non-unit      {}, of which {} are farther than {:g} from 1; largest error {:.3g}\n"
      "duplicates    {}\n"
      "out of order  {}\n"
      "invalid rows  {}\n",
      keyframes.sign_flips, keyframes.non_unit_keys, report.wrong_norms, norm_error_limit, keyframes.largest_norm_error,
      repairs.duplicates_dropped, repairs.rows_moved, repairs.invalid_dropped);
}

template <class Jump>
std::string jump_cell(const Jump& jump) {
  if (jump.relative == 0.0) return formatted("{:>10.2e}  {:>8}", jump.largest, "none");
  return formatted("{:>10.3g}  {:>8.1e}", jump.largest, jump.relative);
}

std::string methods_table(const InspectReport& report) {
  if (report.methods.empty()) return "";
  std::string table = formatted(
      "\nLargest jumps at the keys, absolute and relative to the largest rate\n{:20}{:>5}  "
      "{:>20}  {:>20}  {:>20}\n",
      "method", "order", "ω [rad/s]", "α [rad/s²]", "jerk [rad/s³]");
  for (const auto& [method, c, shape, findings] : report.methods)
    table += formatted("{:20}{:>5}  {}  {}  {}\n", method, formatted("C{}", c.order()), jump_cell(c.angular_velocity),
                       jump_cell(c.angular_acceleration), jump_cell(c.angular_jerk));
  return table;
}

std::string order_cell(std::optional<int> order) { return order ? formatted("G{}", *order) : "–"; }

/// Why a method has no order, or nothing.
std::string rest_line(const InspectReport& report, const MethodReport& method) {
  const ShapeContinuity& shape = method.shape;
  if (shape.rests == 0) return "";
  const std::string others = shape.rests > 1 ? formatted(" and {} more", shape.rests - 1) : "";
  const std::string elsewhere =
      shape.order_in_motion() ? formatted("; at the other keys it is {}", order_cell(shape.order_in_motion())) : "";
  return formatted("{} rests at {}{}: its shape is undefined there{}\n", method.name, place(report, shape.first_rest),
                   others, elsewhere);
}

std::string shapes_table(const InspectReport& report) {
  if (report.methods.empty()) return "";
  std::string table = formatted(
      "\nThe same of the shape, whatever the speed: how the path turns by the angle travelled\n{:20}{:>5}  "
      "{:>20}  {:>20}  {:>20}\n",
      "method", "shape", "direction", "curvature [1/rad]", "its change [1/rad²]");
  for (const auto& [method, continuity, s, findings] : report.methods)
    table += formatted("{:20}{:>5}  {}  {}  {}\n", method, order_cell(s.order()), jump_cell(s.direction),
                       jump_cell(s.curvature), jump_cell(s.curvature_rate));
  for (const MethodReport& method : report.methods) table += rest_line(report, method);
  return table;
}

std::string findings_lines(const InspectReport& report) {
  std::string lines;
  for (const MethodReport& method : report.methods)
    if (method.findings)
      lines += formatted("\nThe keys say to {}: {}\nwhich as settings are '{}'\n", method.name,
                         text_of(*method.findings), text_of(with_findings(method.name, *method.findings)));
  return lines;
}

}  // namespace

std::string text_of(const InspectReport& report) {
  std::string text =
      keys_lines(report) + recipe_line(report.file.track.recipe) + half_turn_line(report) + quality_lines(report);
  if (report.defect) text += formatted("defect        {}\n", *report.defect);
  return text + methods_table(report) + shapes_table(report) + findings_lines(report);
}

}  // namespace orispline::cli
