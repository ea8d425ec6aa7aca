// SPDX-License-Identifier: Apache-2.0
#include "commands/studio/studio_options.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

namespace {

constexpr auto studio_footer = R"(Examples:
  orispline studio keys.csv
  orispline studio keys.csv --method timed-c2:tension=0.6 --beside squad
  orispline studio keys.csv --no-open -o keys.html
  orispline studio

The page is one file that needs neither a server nor a network. It has the keys in it and cannot write to INPUT: its Save
gives you a new file, as a download. Its path is printed; without a display nothing is opened. Without -o the page is a new
file in the folder for temporary files (TMPDIR), which only you can read. docs/studio.md says more.)";

}  // namespace

void add_studio_options(Command& app, StudioArguments& o) {
  app.add_option("INPUT", o.keys,
                 formatted("{} file of keyframes; '-' is standard input [begin with templates]",
                           io::any_of(io::formats_read())))
      ->type_name(file_type);
  add_reading_options(app, o.reading);
  const std::string shape = "Shape of the curve", output = "Output";
  app.add_option("--method", o.method,
                 formatted("Method of the curve [the one named in INPUT, else {}]", default_method))
      ->type_name(method_type)
      ->group(shape);
  app.add_option("--beside", o.beside, "Method of a second curve, shown beside it [the page's choice]")
      ->type_name(method_type)
      ->group(shape);
  app.add_option("-o,--output", o.output,
                 "Page to write; it appears complete or not at all [a new file in the folder for temporary files]")
      ->type_name(file_type)
      ->group(output);
  app.add_flag("--no-open", o.no_open, "Do not open the page in the browser")->group(output);
  app.usual = {"--beside", "--no-open"};
  app.footer = studio_footer;
}

}  // namespace orispline::cli
