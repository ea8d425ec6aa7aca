// SPDX-License-Identifier: Apache-2.0
#include "commands/inspect/inspect_options.hpp"

namespace orispline::cli {

namespace {

constexpr auto inspect_footer = R"(Examples:
  orispline inspect keys.csv
  orispline inspect keys.csv --method auto,quintic --method slerp
  orispline inspect keys.csv --method sextic --json
  orispline inspect keys.csv --method quintic:tension=0.3,0.7,0.9,0.4 --method quintic
  orispline inspect mage.glb --report mage.html
  orispline inspect mage.glb --clip Walking_A --joint hand.r --method auto

Faults that 'sample' refuses are repaired and counted: duplicate or decreasing times, rows that are not numbers, norms
far from 1. The JSON is described in docs/inspect-json.md.)";

}  // namespace

void add_inspect_options(Command& app, InspectArguments& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.methods,
                 "Methods whose continuity to measure; repeatable, each time one or a list with commas")
      ->repeated()
      ->type_name(methods_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_loop_options(app, o.shape);
  app.add_flag("--json", o.json, "Print one JSON document");
  app.add_option(
         "--report", o.report.path,
         "Write a page to look at in a browser: the motion of the clips in space, or that of curves through keys")
      ->type_name(file_type);
  app.footer = inspect_footer;
}

}  // namespace orispline::cli
