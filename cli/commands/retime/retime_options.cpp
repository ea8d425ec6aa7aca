// SPDX-License-Identifier: Apache-2.0
#include "commands/retime/retime_options.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/fields.hpp>

namespace orispline::cli {

namespace {

constexpr auto retime_footer = R"(Examples:
  orispline retime keys.csv --max-rate 90deg/s -o slow.csv
  orispline retime keys.csv --max-rate 90deg/s --max-acceleration 200deg/s2 --per-interval -o slow.csv
  orispline retime keys.csv --max-rate 90,60,120deg/s --max-jerk 2000deg/s^3 --max-speed 0.5m/s -o slow.csv
  orispline retime keys.csv --duration 30s -o slow.csv
  orispline retime keys.csv --max-rate 90deg/s --max-acceleration 200deg/s2 --fastest-keys -o fast.csv
  orispline retime keys.csv --constant-rate 10deg/s --ease 1s -o even.csv
  orispline retime poses --max-rate 90deg/s --output-folder slow
  orispline retime tuned.csv --method timed-c2 --ends rest --max-rate 90deg/s -o slow.csv
  orispline retime keys.csv --max-torque 0.5Nm --inertia=1,2,2.5 --method timed-c2 -o slow.csv --json

The limits hold everywhere on the curve of --method, with its settings, through the keys that are written. They are
certified by bounds, not by samples. A motion that is within them stays as it is. Equal keys are rests and keep their
duration; where no method is named, the body stands still in them. docs/retime.md says more.)";

}  // namespace

void add_retime_options(Command& app, RetimeArguments& o) {
  add_several_inputs(app, o.inputs, "keys");
  add_input_threads(app, o.inputs);
  add_reading_options(app, o.input);
  app.add_option("--method", o.method,
                 formatted("Method of the curve [the one named in INPUT, else {}]", default_method))
      ->type_name(method_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  const std::string_view group = "Limits";
  for (const FieldInfo& field : fields_of<orispline::RetimeOptions>())
    if (field.name == "slowing")
      for (const std::string_view word : {"per-interval", "fastest-keys"})
        add_word_flag(app, o.retiming, field, word, group);
    else add_field(app, o.retiming, field, group);
  add_output_options(app, o.output);
  add_report_option(app, o.report);
  add_summary_options(app, o.summary);
  app.footer = retime_footer;
}

}  // namespace orispline::cli
