// SPDX-License-Identifier: Apache-2.0
#include "command_options.hpp"

#include <fmt/format.h>

namespace orispline::cli {
namespace {

constexpr auto sample_footer = R"(Examples:
  orispline sample keys.csv --rate 100 -o motion.csv
  orispline sample keys.csv --method quintic --tension=0.4 --ends natural --count 500 | head
  orispline sample flight.csv --method timed-c2 --start-rate=0,0,0.5 --times frames.csv -o motion.csv
  orispline sample keys.csv --method squad-timed --set variant=boyle --rate 100 -o motion.csv
  orispline sample robot.csv --set hold=1 --rate 100 -o motion.csv
  orispline sample loop.csv --method timed-c2 --closed --rate 100 -o lap.csv
  orispline sample trajectory.tum --drop-duplicates --rate 200 -o smooth.tum
  orispline sample data.csv --rate 200 --output-orientation euler -o motion.csv
  orispline sample keys.csv --rate 100000 -o motion.npy
  orispline sample ck.csv --columns t=sclk,qw=q0,qx=q1,qy=q2,qz=q3 --conjugate --rate 10 --frame world

INPUT has the columns t,qw,qx,qy,qz and optionally px,py,pz, wx,wy,wz[,ax,ay,az[,jx,jy,jz]] (for methods that take
rates) and one column per parameter of the method (a value per key); a parameter on the command line wins over its
column. Instead of the quaternion: roll,pitch,yaw; e1,e2,e3 with --euler; r11,r12,...,r33; rx,ry,rz.
'-' is standard input or output.
Columns out: t,qw,qx,qy,qz[,px,py,pz][,wx,wy,wz[,ax,ay,az[,jx,jy,jz]]][,vx,vy,vz[,apx,apy,apz]]
in s, m, rad/s, rad/s^2, rad/s^3, m/s, m/s^2; angular rates in the body frame, positions and theirs in the world frame.
TUM and EuRoC files always have positions: zeros when the keys have none.
A NumPy file (-o motion.npy) is one array of doubles, shape (samples, columns), with the columns of the CSV.
Without -o the samples go to standard output as CSV; summaries and warnings go to standard error.)";

constexpr auto convert_footer = R"(Examples:
  orispline convert data.csv -o trajectory.tum
  orispline convert trajectory.tum -o data.csv --output-format euroc
  orispline convert attitude.csv --euler ZXZ --angle-unit deg -o keys.csv
  orispline convert keys.csv --output-orientation matrix -o matrices.csv

Times are exact; EuRoC has whole nanoseconds. Quaternions keep their digits and signs; norms that are off are made 1 and
counted. Positions are kept, angular velocities too where the output is CSV; other columns are named and left out.)";

constexpr auto inspect_footer = R"(Examples:
  orispline inspect keys.csv
  orispline inspect keys.csv --method auto,quintic --method slerp
  orispline inspect keys.csv --method sextic --json

Faults that 'sample' refuses (duplicate or decreasing times, rows that are not numbers, norms far from 1) are repaired
and counted. The JSON is described in docs/inspect-json.md.)";

constexpr auto plot_footer = R"(Examples:
  orispline plot keys.csv -o motion.svg
  orispline plot keys.csv --method auto,quintic --method slerp -o methods.svg
  orispline plot robot.csv --set hold=1 --axis z -o tool.svg

Over time: the angle from the start, |w|, |alpha| and |jerk|, the keys marked; and the way of a body axis over the unit
sphere. At most 6 methods, each in a colour of its own.)";

void add_loop_options(CLI::App& app, MethodOptions& o) {
  const std::string group = "Shape of the curve";
  app.add_flag("--closed", o.closed, "A loop: the last key is the first one again, and joins it smoothly")
      ->group(group);
  app.add_option("--period", o.period, "A loop whose first key returns T seconds after it")
      ->type_name("T")
      ->group(group);
}

void add_time_options(CLI::App& app, TimeOptions& o) {
  const std::string group = "Times (one of --rate, --count, --times)";
  app.add_option("--rate", o.rate, "Samples per second, from the start up to the end")->type_name("HZ")->group(group);
  app.add_option("--count", o.count, "Number of samples, both ends included")->type_name("N")->group(group);
  app.add_option("--times", o.list, "File with one time a line, in any order")->type_name(file_type)->group(group);
  app.add_option("--from", o.from, "Start [s], in the time of INPUT [of the curve]")->type_name("T")->group(group);
  app.add_option("--to", o.to, "End [s], in the time of INPUT [of the curve]")->type_name("T")->group(group);
}

}  // namespace

void add_input_options(CLI::App& app, InputOptions& o, std::string_view default_signs) {
  app.add_option("INPUT", o.path, "CSV, TUM or EuRoC file of keyframes; '-' is standard input")
      ->required()
      ->type_name(file_type);
  add_reading_options(app, o, default_signs);
}

void add_reading_options(CLI::App& app, InputOptions& o, std::string_view default_signs) {
  const std::string group = "Reading";
  app.add_option("--input-format", o.format, "Format of INPUT [by extension and content]")
      ->type_name(one_of(format_choices))
      ->group(group);
  app.add_option("--columns", o.columns, "Other names of columns: t=sclk_ticks,qw=q0_w,...")
      ->allow_extra_args(false)
      ->type_name("NAME=COLUMN,...")
      ->group(group);
  app.add_option("--order", o.order, "Order of the quaternion columns when there is no header")
      ->type_name(one_of(order_choices))
      ->group(group);
  app.add_option("--input-orientation", o.orientation, "What states the orientation [quaternion, else what is there]")
      ->type_name(one_of(orientation_choices))
      ->group(group);
  app.add_option("--euler", o.euler, "Order of Euler angles: ZYX, XYZ, ZXZ, ... body axes; zyx, ... world axes [ZYX]")
      ->type_name("ORDER")
      ->group(group);
  app.add_option("--angle-unit", o.angle_unit, "Of Euler angles whose column does not end in _deg or _rad")
      ->type_name(one_of(angle_unit_choices))
      ->group(group);
  app.add_option("--time-scale", o.time_scale, "Seconds per unit of the time column [by its name, else 1]")
      ->type_name("X")
      ->group(group);
  app.add_flag("--conjugate", o.conjugate, "The file holds world to body (SPICE, CCSDS)")->group(group);
  app.add_option("--signs", o.signs, fmt::format("Negate quaternions for the shortest way, or not [{}]", default_signs))
      ->type_name(one_of(sign_choices))
      ->group(group);
  app.add_flag("--drop-duplicates", o.drop_duplicates, "Of equal times keep the first row")->group(group);
  app.add_flag("--drop-invalid", o.drop_invalid, "Drop rows with NaN, infinite or empty cells")->group(group);
  app.add_flag("--sort", o.sort, "Sort the rows by time")->group(group);
}

void add_method_options(CLI::App& app, MethodOptions& o) {
  const std::string group = "Shape of the curve";
  app.add_option("--tension", o.tension, "Short for --set tension=X[,X...]")->type_name("X[,X...]")->group(group);
  app.add_option("--set", o.settings, "A number, or one per key with commas; or a word where it is a choice")
      ->allow_extra_args(false)
      ->type_name(setting_type)
      ->group(group);
  app.add_option("--ends", o.ends, "End rule for both ends, or for each; see 'orispline methods'")
      ->type_name(ends_type)
      ->group(group);
  app.add_option("--start-rate", o.start_rate, "Body rate at the first key [rad/s]; means --ends clamped there")
      ->type_name("WX,WY,WZ")
      ->group(group);
  app.add_option("--end-rate", o.end_rate, "Body rate at the last key [rad/s]; means --ends clamped there")
      ->type_name("WX,WY,WZ")
      ->group(group);
}

void add_output_file(CLI::App& app, std::string& path) {
  app.add_option("-o,--output", path, "File to write, complete or not at all [standard output]")
      ->type_name(file_type)
      ->group("Output");
}

void add_summary_options(CLI::App& app, SummaryOptions& o) {
  app.add_flag("--json", o.json, "Print the summary as JSON on standard output; needs -o")->group("Output");
  app.add_flag("--quiet", o.quiet, "No summary")->group("Output");
}

void add_report_option(CLI::App& app, ReportOptions& o) {
  app.add_option("--report", o.path, "Write a page to look at in a browser: measures, plots and a view in space")
      ->type_name(file_type)
      ->group("Output");
}

void add_output_options(CLI::App& app, OutputOptions& o) {
  const std::string group = "Output";
  add_output_file(app, o.path);
  app.add_option("--output-format", o.format, "Format of the output [tum for .tum, npy for .npy, else csv]")
      ->type_name(one_of(output_format_choices))
      ->group(group);
  app.add_option("--output-orientation", o.orientation,
                 "Columns that state the orientation, in CSV and npy [quaternion]")
      ->type_name(one_of(orientation_choices))
      ->group(group);
  app.add_option("--output-euler", o.euler, "Order of Euler angles that are written [ZYX: roll, pitch, yaw]")
      ->type_name("ORDER")
      ->group(group);
  app.add_option("--output-angle-unit", o.angle_unit, "Unit of Euler angles that are written [deg]")
      ->type_name(one_of(angle_unit_choices))
      ->group(group);
}

void add_sample_options(CLI::App& app, SampleOptions& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.method, fmt::format("Method [{}]; see 'orispline methods'", default_method))
      ->type_name(method_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_loop_options(app, o.shape);
  add_time_options(app, o.times);
  app.add_option("--extrapolate", o.extrapolate, "Outside the curve hold the end orientation, or fail [hold]")
      ->type_name(one_of(extrapolation_choices))
      ->group("Times (one of --rate, --count, --times)");
  add_output_options(app, o.output);
  const std::string group = "Output";
  app.add_option("--derivatives", o.derivatives, "Highest order of the rates [2 for CSV and npy, else 0]")
      ->type_name("0|1|2|3")
      ->group(group);
  app.add_option("--frame", o.frame, "Frame of the angular rates [body]")
      ->type_name(one_of(frame_choices))
      ->group(group);
  app.add_option("--threads", o.threads, "Threads that make the samples, which are the same on any number [all cores]")
      ->type_name("N")
      ->group(group);
  app.add_option("--truth", o.truth, "Key file that the curve is compared with, in the summary")
      ->type_name(file_type)
      ->group(group);
  app.add_flag("--json", o.summary.json, "Print the summary as JSON on standard output; needs -o")->group(group);
  app.add_flag("--quiet", o.summary.quiet, "No summary, no progress bar")->group(group);
  app.footer(sample_footer);
}

void add_convert_options(CLI::App& app, ConvertOptions& o) {
  add_input_options(app, o.input, "as-given");
  add_output_options(app, o.output);
  add_summary_options(app, o.summary);
  app.footer(convert_footer);
}

void add_inspect_options(CLI::App& app, InspectOptions& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.methods, "Methods whose continuity is measured; repeatable, or a list with commas")
      ->allow_extra_args(false)
      ->type_name(methods_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_loop_options(app, o.shape);
  app.add_flag("--json", o.json, "Print one JSON document");
  app.footer(inspect_footer);
}

void add_plot_options(CLI::App& app, PlotOptions& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.methods,
                 fmt::format("Methods to draw [{}]; repeatable, or a list with commas", default_method))
      ->allow_extra_args(false)
      ->type_name(methods_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_loop_options(app, o.shape);
  const std::string group = "Output";
  app.add_option("-o,--output", o.path, "SVG file to write, complete or not at all [standard output]")
      ->type_name(file_type)
      ->group(group);
  app.add_option("--axis", o.axis, "Body axis whose way over the sphere is drawn [x]")
      ->type_name(one_of(axis_choices))
      ->group(group);
  app.footer(plot_footer);
}

}  // namespace orispline::cli
