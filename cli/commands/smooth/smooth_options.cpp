// SPDX-License-Identifier: Apache-2.0
#include "commands/smooth/smooth_options.hpp"

namespace orispline::cli {
namespace {

constexpr auto smooth_footer = R"(Examples:
  orispline smooth noisy.csv -o keys.csv
  orispline smooth noisy.csv --noise 1deg --gap 0.5 -o keys.csv
  orispline smooth noisy.csv --cutoff 8 --loss l2 --rate 200 -o motion.csv
  orispline smooth imu.csv --gyro -o keys.csv
  orispline sample keys.csv --method hermite-c2 --rate 500 -o motion.csv

Without --noise, --smoothing-time or --cutoff the smoothing is chosen by generalised cross-validation. The output has an
orientation with its rates (wx,wy,wz,ax,ay,az) at every time of INPUT, of which 'sample --method hermite-c2' makes a C2
curve; with --rate it has samples of that curve. docs/smooth.md says more.)";

}  // namespace

void add_smooth_options(CLI::App& app, SmoothOptions& o) {
  add_input_options(app, o.input);
  const std::string group = "Smoothing";
  app.add_option("--penalty", o.penalty, "What is kept small, squared and integrated [acceleration]")
      ->type_name(one_of(penalty_choices))
      ->group(group);
  add_smoothness_options(app, o.smoothness);
  app.add_option("--loss", o.loss, "robust rejects outliers; l2 trusts every sample [robust]")
      ->type_name(one_of(loss_choices))
      ->group(group);
  app.add_flag("--gyro", o.gyro, "wx,wy,wz of INPUT are those of a gyro, with a constant bias that is estimated")
      ->group(group);
  app.add_option("--gyro-noise", o.gyro_noise, "Standard deviation of its rates per axis, such as 0.1deg/s [estimated]")
      ->type_name("RATE")
      ->group(group);
  app.add_option("--gap", o.gap, "Nothing is smoothed over longer intervals [bridged]")->type_name("S")->group(group);
  app.add_option("--rate", o.rate, "Write samples at so many per second instead of keys")
      ->type_name("HZ")
      ->group("Output");
  add_output_file(app, o.output.path);
  add_report_option(app, o.report);
  add_summary_options(app, o.summary);
  app.footer(smooth_footer);
}

}  // namespace orispline::cli
