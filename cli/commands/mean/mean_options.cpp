// SPDX-License-Identifier: Apache-2.0
#include "commands/mean/mean_options.hpp"

#include <orispline/fields.hpp>
#include <orispline/jobs/mean.hpp>

namespace orispline::cli {

namespace {

constexpr auto mean_footer = R"(Examples:
  orispline mean shots.csv
  orispline mean shots.csv --kind median
  orispline mean shots.csv --columns weight=confidence --json
  orispline mean shots.csv -o base.csv
  orispline mean monday.csv tuesday.csv
  orispline mean shots --output-folder means
  orispline mean recording.csv --every 0.5s -o means.csv

The rows of INPUT are a set: without --every a column of times is not needed, and what it has does not count. A column
'weight' weighs the rows; --columns weight=NAME takes another one. Signs of quaternions do not count. Positions have
their arithmetic mean, or their geometric median. The rows of several files are one set; with --output-folder each file
has a mean of its own. Without -o what was found is printed. docs/mean.md says more.)";

}  // namespace

void add_mean_options(Command& app, MeanArguments& o) {
  add_several_inputs(app, o.inputs, "mean", "whose rows are one set; with --output-folder each has a mean of its own");
  add_reading_options(app, o.input);
  add_fields(app, o.mean, fields_of<orispline::MeanOptions>(), "Mean");
  add_made_output(
      app, o.output, o.summary,
      "File to write the mean into, one row, or one for each window; it appears complete or not at all [the mean is "
      "printed]");
  add_input_threads(app, o.inputs);
  app.footer = mean_footer;
}

}  // namespace orispline::cli
