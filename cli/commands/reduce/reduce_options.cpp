// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce_options.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {
namespace {

constexpr auto reduce_footer = R"(Examples:
  orispline reduce flight.csv --tolerance 0.1deg -o keys.csv
  orispline reduce poses.tum --tolerance 0.5deg --position-tolerance 1mm -o keys.tum
  orispline reduce flight.csv --tolerance 0.1deg --method auto --refit -o keys.csv --json
  orispline reduce noisy.csv --smooth --tolerance 0.5deg -o keys.csv
  orispline reduce hips.csv head.csv arm.csv --tolerance 0.5deg --output-folder keys
  orispline reduce flight.csv --tolerance 0.1deg --method timed-c3 --tension=0.2 --ends rest -o keys.csv
  orispline sample keys.csv --method auto --rate 100 -o motion.csv

The curve of the method that is named in the summary is within the tolerance at every sample. slerp needs no fewer keys
among the samples; auto and timed-c2 are found by insertion and pruning. docs/reduce.md says more.)";

}  // namespace

void add_reduce_options(CLI::App& app, ReduceOptions& o) {
  app.add_option("INPUT", o.inputs, "CSV, TUM or EuRoC file, several with --output-folder; '-' is standard input")
      ->required()
      ->type_name(file_type);
  add_reading_options(app, o.input);
  const std::string group = "Reduction";
  app.add_option("--tolerance", o.tolerance, "Largest angle between the curve and a sample, such as 0.1deg or 2e-3rad")
      ->required()
      ->type_name("ANGLE")
      ->group(group);
  app.add_option("--position-tolerance", o.position_tolerance,
                 "Largest distance between the path and a sample, such as 1mm or 0.5m [positions are not bounded]")
      ->type_name("LENGTH")
      ->group(group);
  app.add_option(
         "--method", o.method,
         formatted("Method of the curve, a local one through its keys, or {} [{}]", smallest_method, smallest_method))
      ->type_name(method_type)
      ->group(group);
  add_method_options(app, o.shape);
  app.add_flag("--refit", o.refit, "Move keys where that saves some; else they are samples")->group(group);
  app.add_flag("--smooth", o.smooth,
               "Smooth the recording first, as 'orispline smooth' does; also said by what follows")
      ->group("Smoothing");
  add_smoothness_options(app, o.smoothness);
  add_output_options(app, o.output);
  add_report_option(app, o.report);
  app.add_option("--output-folder", o.folder,
                 "Of several inputs: keys into files of the same names there, when all are found")
      ->type_name(folder_type)
      ->group("Output");
  app.add_option("--threads", o.threads, "Threads that work on inputs and methods, with the same results [all cores]")
      ->type_name("N")
      ->group("Output");
  add_summary_options(app, o.summary);
  app.footer(reduce_footer);
}

}  // namespace orispline::cli
