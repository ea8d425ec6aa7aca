// SPDX-License-Identifier: Apache-2.0
#include "options/command_options.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {
namespace {

/// `tum for .tum, npy for .npy, else csv`: the format of an output by its name.
std::string formats_by_name() {
  std::vector<std::string> formats;
  for (const io::FormatInfo* const format : io::formats_written()) {
    const std::string_view extension = format->extensions.front();
    if (extension != io::csv_format.extensions.front())
      formats.push_back(formatted("{} for {}", format->id, extension));
  }
  return formatted("{}, else {}", joined(formats, ", "), io::csv_format.id);
}

}  // namespace

void add_input_options(Command& app, InputOptions& o, std::string_view default_signs) {
  app.add_option("INPUT", o.path,
                 formatted("{} file of keyframes; '-' is standard input", io::any_of(io::formats_read())))
      ->required()
      ->type_name(file_type);
  add_reading_options(app, o, default_signs);
}

void add_reading_options(Command& app, InputOptions& o, std::string_view default_signs) {
  const std::string group = "Reading";
  app.add_option("--input-format", o.format, "Format of INPUT [told by its extension and content]")
      ->type_name(one_of(io::formats_read()))
      ->group(group);
  app.add_option("--columns", o.columns, "Names of columns in your file, such as t=sclk_ticks,qw=q0_w")
      ->repeated()
      ->type_name("NAME=COLUMN,...")
      ->group(group);
  app.add_option("--order", o.order, "Order of the quaternion in a file without a header")
      ->type_name(one_of(order_choices))
      ->group(group);
  app.add_option("--input-orientation", o.orientation,
                 "Columns to read the orientation from [the quaternion, else the form that is there]")
      ->type_name(one_of(orientation_choices))
      ->group(group);
  app.add_option("--euler", o.euler,
                 "Order of Euler angles: capitals for turns about body axes (ZYX, ZXZ), small letters for world axes "
                 "(zyx) [ZYX]")
      ->type_name("ORDER")
      ->group(group);
  app.add_option("--angle-unit", o.angle_unit,
                 "Unit of Euler angles, if the names of their columns do not end in one such as _deg")
      ->type_name(one_of(angle_unit_choices))
      ->group(group);
  app.add_option("--time-scale", o.time_scale,
                 "Seconds in one unit of the time column, such as 1e-3 or 1/24 [told by the column's name or the size "
                 "of its numbers, else 1]")
      ->type_name("X")
      ->group(group);
  app.add_option("--fps", o.fps, "Frames per second, such as 24 or 30000/1001, if the times are a column 'frame'")
      ->type_name("N")
      ->group(group);
  app.add_option("--epoch", o.epoch,
                 "Date that counts as 0 s, if the times are dates of ISO 8601 [1970-01-01T00:00:00Z]")
      ->type_name("TIME")
      ->group(group);
  app.add_flag("--conjugate", o.conjugate,
               "Read orientations that turn world into body, as C-kernels of SPICE hold them")
      ->group(group);
  app.add_option("--signs", o.signs,
                 formatted("Turn the shortest way between keys, or the way that the signs of the quaternions say [{}]",
                           default_signs))
      ->type_name(one_of(sign_choices))
      ->group(group);
  app.add_flag("--ignore-recipe", o.ignore_recipe, "Ignore the comment in which the file names the method of its keys")
      ->group(group);
  app.add_flag("--normalise", o.normalise, "Accept quaternions of any norm but 0 [only norms within 2 % of 1]")
      ->group(group);
  app.add_flag("--drop-duplicates", o.drop_duplicates, "Keep only the first of several rows with the same time")
      ->group(group);
  app.add_flag("--drop-invalid", o.drop_invalid, "Drop rows with NaN, infinite or empty cells")->group(group);
  app.add_flag("--sort", o.sort, "Sort the rows by time")->group(group);
}

void add_method_options(Command& app, MethodOptions& o) {
  const std::string group = "Shape of the curve";
  app.add_option("--tension", o.tension, "Short for --set tension=X[,X...]")->type_name("X[,X...]")->group(group);
  app.add_option("--set", o.settings,
                 "Setting of the method: a number, one number per key with commas, or a word; 'orispline methods "
                 "METHOD' lists them")
      ->repeated()
      ->type_name(setting_type)
      ->group(group);
  app.add_option("--ends", o.ends, "End rule for both ends, or one for each; 'orispline methods METHOD' lists them")
      ->type_name(ends_type)
      ->group(group);
  app.add_option("--start-rate", o.start_rate,
                 "Angular velocity at the first key, in the body frame and rad/s; the end rule there becomes clamped")
      ->type_name("WX,WY,WZ")
      ->group(group);
  app.add_option("--end-rate", o.end_rate,
                 "Angular velocity at the last key, in the body frame and rad/s; the end rule there becomes clamped")
      ->type_name("WX,WY,WZ")
      ->group(group);
}

void add_loop_options(Command& app, MethodOptions& o) {
  const std::string group = "Shape of the curve";
  app.add_flag("--closed", o.closed,
               "Make a loop of keys whose last one repeats the first: the curve passes it smoothly")
      ->group(group);
  app.add_option("--period", o.period, "Make a loop that comes back to the first key T seconds after it began there")
      ->type_name("T")
      ->group(group);
}

void add_output_file(Command& app, std::string& path) {
  app.add_option("-o,--output", path, "File to write; it appears complete or not at all [standard output]")
      ->type_name(file_type)
      ->group("Output");
}

void add_summary_options(Command& app, SummaryOptions& o) {
  app.add_flag("--json", o.json, "Print the summary as JSON on standard output; needs -o")->group("Output");
  app.add_flag("--quiet", o.quiet, "Print no summary")->group("Output");
}

void add_report_option(Command& app, ReportOptions& o) {
  app.add_option("--report", o.path, "Write a page to look at in a browser: measures, plots and a view in space")
      ->type_name(file_type)
      ->group("Output");
}

void add_output_options(Command& app, OutputOptions& o) {
  const std::string group = "Output";
  add_output_file(app, o.path);
  app.add_option("--output-format", o.format, formatted("Format of the output [{}]", formats_by_name()))
      ->type_name(one_of(io::formats_written()))
      ->group(group);
  app.add_option("--output-orientation", o.orientation,
                 formatted("Form of the written orientations, in {} [quaternion]",
                           formats_that([](const auto& f) { return f.holds.forms; })))
      ->type_name(one_of(orientation_choices))
      ->group(group);
  app.add_option("--output-euler", o.euler, "Order of the written Euler angles [ZYX: roll, pitch, yaw]")
      ->type_name("ORDER")
      ->group(group);
  app.add_option("--output-angle-unit", o.angle_unit, "Unit of the written Euler angles [deg]")
      ->type_name(one_of(angle_unit_choices))
      ->group(group);
  app.add_flag("--output-conjugate", o.conjugate,
               "Write orientations that turn world into body, as C-kernels of SPICE hold them [body into world]")
      ->group(group);
}

}  // namespace orispline::cli
