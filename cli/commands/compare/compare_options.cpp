// SPDX-License-Identifier: Apache-2.0
#include "commands/compare/compare_options.hpp"

#include <orispline/analysis.hpp>
#include <orispline/fields.hpp>

namespace orispline::cli {

namespace {

constexpr auto compare_footer = R"(Examples:
  orispline compare flight.csv
  orispline compare flight.csv --keep-every 8 --methods auto,slerp,quintic --json
  orispline compare flight.csv --keep-every 4,16,64 --random 7 --sort max
  orispline compare keys.csv --reference truth.csv --report report.html
  orispline compare flights --methods auto,slerp,squad --output-folder tables
  orispline compare flight.csv --methods auto,quintic:tension=0.6,timed-c2:ends=repeat --inertia=1,2,2.5 --sort torque
  orispline compare keys.csv --reference truth.csv --methods auto --methods quintic:tension=0.3,0.7,0.9,0.4

--keep-every N keeps the samples 0, N, 2N, ... of INPUT as keys, the last one only if it falls on the grid; the curves
through them are compared with all samples from the first to the last key. With columns wx,wy,wz the angular velocities
are compared too. Errors are full rotation angles. A setting may have a number for each key that is kept. A method that fails stands in the table with the reason; the exit code
is 0 if one worked. --leave-out is an estimate from the keys alone: it says how large the error is, not which method is
the best (docs/compare.md).)";

/// `rms|mean|…`
std::string sort_words() {
  std::string words;
  for (const MeasureInfo& measure : measures_info())
    if (!measure.word.empty()) words.append(words.empty() ? "" : "|").append(measure.word);
  return words;
}

}  // namespace

void add_compare_options(Command& app, CompareArguments& o) {
  add_several_inputs(app, o.inputs, "table");
  add_reading_options(app, o.input);
  app.option("--sort").names = "--sort-rows";  // for --sort means the table here
  const std::string group = "Keys and reference";
  app.add_option("--keep-every", o.keep_every, "Keep every N-th sample of INPUT as a key; repeatable, or a list [8]")
      ->repeated()
      ->type_name("N,...")
      ->group(group);
  app.add_flag("--jitter", o.jitter, "Move those keys by up to 35 % of N, at random")->group(group);
  app.add_option("--random", o.random, "Steps of N/4, N/2, N, 2N drawn with this seed; of --jitter the seed")
      ->type_name("SEED")
      ->group(group);
  app.add_option("--reference", o.reference, "Dense recording that curves through all keys of INPUT are compared with")
      ->type_name(file_type)
      ->group(group);
  app.add_flag("--align", o.align,
               "Bring the keys onto the reference first: axes, clock, and scale and place of positions; 'orispline "
               "align' does so alone, with a choice")
      ->group(group);
  const std::string measures = "Methods and measures";
  app.add_option("--methods", o.methods,
                 "Methods, also NAME:SETTING=VALUE:ends=RULE; repeatable, each time one or a list [all]")
      ->repeated()
      ->type_name(methods_type)
      ->group(measures);
  add_blending_option(app, o.blending);
  app.add_flag("--tune", o.tune, "Each method that has tensions also with those of the least angular acceleration")
      ->group(measures);
  add_fields(app, o.measured, fields_of<MeasureOptions>(), measures);
  app.add_option("--sort", o.sort, "Measure to sort by, best first [rms]")->type_name(sort_words())->group(measures);
  app.add_option("--threads", o.inputs.threads, "Threads that work on the methods; 1 for undisturbed times [all cores]")
      ->type_name("N")
      ->group(measures);
  const std::string output = "Output";
  app.add_flag("--json", o.json, "Print one JSON array")->group(output);
  app.add_flag("--csv", o.csv, "Print one CSV table")->group(output);
  add_report_option(app, o.report);
  app.add_flag("--quiet", o.summary.quiet, "No progress bar")->group(output);
  app.footer = compare_footer;
}

}  // namespace orispline::cli
