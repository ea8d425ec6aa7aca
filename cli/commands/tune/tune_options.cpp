// SPDX-License-Identifier: Apache-2.0
#include "commands/tune/tune_options.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {
namespace {

constexpr auto tune_footer = R"(Examples:
  orispline tune keys.csv -o tuned.csv
  orispline tune keys.csv --method quintic --objective linearised -o tuned.csv
  orispline tune keys.csv --method timed-c2 --objective torque --inertia=1,2,2.5 --bounds=0,3 -o tuned.csv
  orispline tune keys.csv --method tcb --objective fit --reference recording.csv -o tuned.csv
  orispline sample tuned.csv --method quintic --rate 100 -o motion.csv

Objectives: linearised (closed form), acceleration (angular acceleration squared, integrated), torque (of a body with
--inertia), jerk, fit (distance to --reference). The output is INPUT as CSV with a column for each tension (tension,
tension2, tension3, nu), which 'sample' reads with the same --method, --ends and reading options. docs/tune.md says more.)";

}  // namespace

void add_tune_options(CLI::App& app, TuneOptions& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.method, formatted("Method whose tensions are sought [{}]", default_tuned_method))
      ->type_name(method_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  const std::string group = "Tuning";
  app.add_option("--objective", o.objective, "What is made least [acceleration]")
      ->type_name(one_of(objective_choices))
      ->group(group);
  app.add_option("--inertia", o.inertia, "Principal moments [kg m^2], or JXX,JYY,JZZ,JXY,JXZ,JYZ; for torque")
      ->type_name("JX,JY,JZ")
      ->group(group);
  app.add_option("--reference", o.reference, "Dense recording to be near to; for fit")
      ->type_name(file_type)
      ->group(group);
  app.add_option("--bounds", o.bounds, "Of every tension [none but what the method accepts]")
      ->type_name("LOWEST,HIGHEST")
      ->group(group);
  app.add_option("--free", o.free, "Tensions that may vary, such as tension2 [all of the method]")
      ->type_name("NAME,...")
      ->group(group);
  add_output_file(app, o.output);
  add_summary_options(app, o.summary);
  app.footer(tune_footer);
}

}  // namespace orispline::cli
