// SPDX-License-Identifier: Apache-2.0
#include "commands/bake/bake_options.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/jobs/bake.hpp>

namespace orispline::cli {

namespace {

constexpr auto bake_footer = R"(Examples:
  orispline bake keys.csv --tolerance 1e-4deg -o motion.json
  orispline bake keys.csv --method timed-c2:tension=0.6 --tolerance 1e-3deg -o motion.bin

The file has polynomials in single precision, for orientations alone: what plays it, such as a web page, needs no library.
docs/bake.md says more.)";

}  // namespace

void add_bake_options(Command& app, BakeArguments& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.method,
                 formatted("Method of the curve [the one named in INPUT, else {}]", default_method))
      ->type_name(method_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_loop_options(app, o.shape);
  add_fields(app, o.baking, fields_of<jobs::BakeSettings>(), "Baking");
  app.add_option("-o,--output", o.output,
                 "File to write, .json or .bin; it appears complete or not at all [JSON on standard output]")
      ->type_name(file_type)
      ->group("Output");
  add_summary_options(app, o.summary);
  app.footer = bake_footer;
}

}  // namespace orispline::cli
