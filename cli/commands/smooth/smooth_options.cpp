// SPDX-License-Identifier: Apache-2.0
#include "commands/smooth/smooth_options.hpp"

namespace orispline::cli {

namespace {

constexpr auto smooth_footer = R"(Examples:
  orispline smooth noisy.csv -o keys.csv
  orispline smooth noisy.csv --noise 1deg --gap 0.5 -o keys.csv
  orispline smooth noisy.csv --cutoff 8 --loss l2 --rate 200 -o motion.csv
  orispline smooth imu.csv --gyro -o keys.csv
  orispline smooth poses.csv --gyro-file imu.csv -o keys.csv
  orispline smooth noisy.csv --sigma -o keys.csv
  orispline smooth walk.bvh -o clean.bvh --report clean.html
  orispline smooth recordings --output-folder smoothed
  orispline sample keys.csv --method hermite-c2 --rate 500 -o motion.csv

Without --noise, --smoothing-time or --cutoff the smoothing is chosen by generalised cross-validation. The output has an
orientation with its rates (wx,wy,wz,ax,ay,az) at every time of INPUT, of which 'sample --method hermite-c2' makes a C2
curve; with --rate it has samples of that curve. docs/smooth.md says more.)";

}  // namespace

void add_smooth_options(Command& app, SmoothArguments& o) {
  add_several_inputs(app, o.inputs, "keys");
  add_input_threads(app, o.inputs);
  add_reading_options(app, o.input);
  app.remove("--gap");  // which it has for itself
  add_smoothing_options(app, o.smoothness);
  app.add_option("--gyro-file", o.gyro_file,
                 "Use the rates t, wx, wy, wz of this file as those of a gyro, with a clock of its own")
      ->type_name(file_type)
      ->group("Smoothing");
  add_time_options(app, o.rows, "Samples in the place of keys (one of --rate, --count, --times)",
                   "Write samples at so many per second instead of keys");
  o.output.scenes = scenes_written();
  add_output_options(app, o.output);
  add_row_options(app, o.rows);
  add_report_option(app, o.report);
  add_summary_options(app, o.summary);
  app.footer = smooth_footer;
}

}  // namespace orispline::cli
