// SPDX-License-Identifier: Apache-2.0
#include "commands/convert/convert_report.hpp"

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

#include "output/repairs_text.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

std::string text_of(const ConvertReport& report) {
  std::string text =
      formatted("{} from {} ({}) written to {} ({})", counted(report.keys, "key"), printable(report.input),
                report.input_format->title, destination(report.output), report.output_format->title);
  if (report.keyframes.sign_flips > 0) text += formatted("; sign flips in the file: {}", report.keyframes.sign_flips);
  if (report.keyframes.non_unit_keys > 0) text += formatted("; {} normalised", report.keyframes.non_unit_keys);
  text += "\n";
  if (const std::string repairs = text_of(report.repairs); !repairs.empty()) text += repairs + "\n";
  if (!report.dropped_columns.empty())
    text += formatted("left out, having no place in the output: {}\n", printable(joined(report.dropped_columns, ", ")));
  if (report.positions == ConvertReport::Positions::zero)
    text += "zeros are written as positions, for the input has none\n";
  return text;
}

}  // namespace orispline::cli
