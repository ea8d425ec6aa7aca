// SPDX-License-Identifier: Apache-2.0
#include "commands/plot/plot_options.hpp"

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

namespace {

constexpr auto plot_footer = R"(Examples:
  orispline plot keys.csv -o motion.svg
  orispline plot keys.csv --method auto,quintic --method slerp -o methods.svg
  orispline plot keys.csv --method quintic:tension=0.3,0.7,0.9,0.4 --method sextic -o two.svg
  orispline plot robot.csv --set hold=1 --axis z -o tool.svg
  orispline plot flight.csv --ghosts 20 -o flight.svg

The picture shows the angle from the start, |w|, |alpha| and |jerk| over time, with the keys marked, and the path of a
body axis on the unit sphere. It shows 6 methods at most, each in its own colour. --ghosts adds the body itself.)";

}  // namespace

void add_plot_options(Command& app, PlotArguments& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.methods,
                 formatted("Methods to draw; repeatable, each time one or a list with commas [as INPUT says, else {}]",
                           default_method))
      ->repeated()
      ->type_name(methods_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_loop_options(app, o.shape);
  const std::string group = "Output";
  app.add_option("-o,--output", o.path, "SVG file to write; it appears complete or not at all [standard output]")
      ->type_name(file_type)
      ->group(group);
  app.add_option("--axis", o.axis, "Body axis whose path on the sphere is drawn [x]")
      ->type_name(one_of(axis_choices))
      ->group(group);
  app.add_option("--ghosts", o.ghosts, "Draw the body at N even times too, a row per method [none]")
      ->type_name("N")
      ->group(group);
  app.usual = {"--axis", "--ghosts"};
  app.footer = plot_footer;
}

}  // namespace orispline::cli
