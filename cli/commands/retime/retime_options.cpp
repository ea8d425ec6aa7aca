// SPDX-License-Identifier: Apache-2.0
#include "commands/retime/retime_options.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {
namespace {

constexpr auto retime_footer = R"(Examples:
  orispline retime keys.csv --max-rate 90deg/s -o slow.csv
  orispline retime keys.csv --max-rate 90deg/s --max-acceleration 200deg/s2 --per-interval -o slow.csv
  orispline retime tuned.csv --method timed-c2 --ends rest --max-rate 90deg/s -o slow.csv
  orispline retime keys.csv --max-torque 0.5Nm --inertia=1,2,2.5 --method timed-c2 -o slow.csv --json

The limits hold everywhere on the curve of --method, with its settings, through the keys that are written, by bounds and
not by samples. A motion that is within them stays as it is. Settings with a value per key are columns of INPUT and of
the output. Positions go along with their keys, their speed is not limited. docs/retime.md
says more.)";

}  // namespace

void add_retime_options(CLI::App& app, RetimeOptions& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.method, formatted("Method of the curve [{}]", default_method))
      ->type_name(method_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  const std::string group = "Limits";
  app.add_option("--max-rate", o.rate, "Largest angular velocity, such as 90deg/s")->type_name("RATE")->group(group);
  app.add_option("--max-acceleration", o.acceleration, "Largest angular acceleration, such as 200deg/s2")
      ->type_name("ACCELERATION")
      ->group(group);
  app.add_option("--max-torque", o.torque, "Largest torque, such as 0.5Nm; needs --inertia")
      ->type_name("TORQUE")
      ->group(group);
  app.add_option("--inertia", o.inertia, "Principal moments [kg m^2], or JXX,JYY,JZZ,JXY,JXZ,JYZ; for the torque")
      ->type_name("JX,JY,JZ")
      ->group(group);
  app.add_flag("--per-interval", o.per_interval, "Slow each interval between keys by itself; else all alike")
      ->group(group);
  add_output_options(app, o.output);
  add_report_option(app, o.report);
  add_summary_options(app, o.summary);
  app.footer(retime_footer);
}

}  // namespace orispline::cli
