// SPDX-License-Identifier: Apache-2.0
#include "commands/tune/tune_options.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/fields.hpp>
#include <orispline/jobs/tune.hpp>

namespace orispline::cli {

namespace {

constexpr auto tune_footer = R"(Examples:
  orispline tune keys.csv -o tuned.csv
  orispline tune keys.csv --method quintic --objective linearised -o tuned.csv
  orispline tune keys.csv --method timed-c2 --objective torque --inertia=1,2,2.5 --bounds=0,3 -o tuned.csv
  orispline tune keys.csv --method tcb --objective fit --reference recording.csv -o tuned.csv
  orispline sample tuned.csv --rate 100 -o motion.csv

--objective acceleration makes the integral of the squared angular acceleration least; linearised does so nearly, by a
closed form. jerk and torque do the same with the jerk, and with the torque on a body of --inertia. curvature bends the
path least, whatever its speed. fit makes the distance
to --reference least. The output is INPUT as CSV with a column for each tension (tension, tension2, nu, ...). A comment
in it names the method and its ends, and 'sample' takes them from there. docs/tune.md says more.)";

}  // namespace

void add_tune_options(Command& app, TuneArguments& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.method,
                 formatted("Method whose tensions to find [as INPUT says, else {}]", jobs::usual_tuned.name))
      ->type_name(method_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_fields(app, o.tuning, fields_of<orispline::TuneOptions>(), "Tuning");
  add_output_file(app, o.output);
  add_summary_options(app, o.summary);
  app.footer = tune_footer;
}

}  // namespace orispline::cli
