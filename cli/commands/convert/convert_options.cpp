// SPDX-License-Identifier: Apache-2.0
#include "commands/convert/convert_options.hpp"

namespace orispline::cli {
namespace {

constexpr auto convert_footer = R"(Examples:
  orispline convert data.csv -o trajectory.tum
  orispline convert trajectory.tum -o data.csv --output-format euroc
  orispline convert attitude.csv --euler ZXZ --angle-unit deg -o keys.csv
  orispline convert keys.csv --output-orientation matrix -o matrices.csv

Times stay exact; EuRoC alone rounds them to whole nanoseconds. Quaternions keep their digits and signs; those whose norm
is off are scaled to 1 and counted. Positions are kept, and angular velocities where the output is CSV or NumPy. Other
columns are left out, and the summary names them.)";

}  // namespace

void add_convert_options(Command& app, ConvertOptions& o) {
  add_input_options(app, o.input, "as-given");
  add_output_options(app, o.output);
  add_summary_options(app, o.summary);
  app.footer = convert_footer;
}

}  // namespace orispline::cli
