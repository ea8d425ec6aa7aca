// SPDX-License-Identifier: Apache-2.0
#include "commands/reduce/reduce_options.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/fields.hpp>

namespace orispline::cli {

namespace {

constexpr auto reduce_footer = R"(Examples:
  orispline reduce flight.csv --tolerance 0.1deg -o keys.csv
  orispline reduce poses.tum --tolerance 0.5deg --position-tolerance 1mm -o keys.tum
  orispline reduce flight.csv --tolerance 0.1deg --method auto --refit -o keys.csv --json
  orispline reduce noisy.csv --smooth --tolerance 0.5deg -o keys.csv
  orispline reduce mage.glb --tolerance 0.05deg -o small.glb
  orispline reduce mage.glb --world-tolerance 2mm -o small.glb --report small.html
  orispline reduce hips.csv head.csv arm.csv --tolerance 0.5deg --output-folder keys
  orispline reduce flight.csv --tolerance 0.1deg --method timed-c3 --tension=0.2 --ends rest -o keys.csv
  orispline sample keys.csv --rate 100 -o motion.csv

The curve of the method that is named in the summary is within the tolerance at every sample. The keys
of slerp are the fewest that its curve can have among the samples; those of auto and timed-c2 are found by insertion and
pruning. hermite-c1 mostly needs fewer: its keys have rates too, wx,wy,wz in a CSV. docs/reduce.md says more.)";

}  // namespace

void add_reduce_options(Command& app, ReduceArguments& o) {
  add_several_inputs(app, o.inputs, "keys");
  add_reading_options(app, o.input);
  const std::string group = "Reduction";
  const auto fields = fields_of<orispline::ReduceOptions>();
  for (const std::string_view name : {"tolerance", "position_tolerance"})
    add_field(app, o.reduction, field_named(fields, name), group);
  app.option("--tolerance").is_required = false;  // of clips the world's may stand for it
  app.add_option("--method", o.method,
                 formatted("Method of the curve, a local one through its keys, or {}; of glTF also {} [{}; of glTF {}]",
                           smallest_method, cubicspline_method, smallest_method, cubicspline_method))
      ->type_name(method_type)
      ->group(group);
  const auto of_clips = fields_of<orispline::ClipReduceOptions>();
  for (const std::string_view name : {"world_tolerance", "shell", "between"})
    add_field(app, o.scene, field_named(of_clips, name), "Clips");
  app.add_option("--position-scale", o.position_scale,
                 "Metres in one unit of length of the file, such as 0.01 [1 for glTF; a BVH file has no unit]")
      ->type_name("X")
      ->group("Clips");
  app.add_flag(
         "--closed", o.closed,
         "Give channels that end as they begin the same tangents at both ends, so that the speed of loops does not "
         "jump there")
      ->group("Clips");
  add_method_options(app, o.shape);
  add_word_flag(app, o.reduction, field_named(fields, "values"), "refit", group);
  app.add_flag("--smooth", o.smooth,
               "Smooth the recording first, as 'orispline smooth' does; implied by the options below")
      ->group("Smoothing");
  add_smoothness_options(app, o.smoothness);
  o.output.scenes = {&scenes::gltf_format};
  add_output_options(app, o.output);
  add_report_option(app, o.report);
  app.add_option("--threads", o.inputs.threads,
                 "Threads that work on inputs and methods, with the same results [all cores]")
      ->type_name("N")
      ->group("Output");
  add_summary_options(app, o.summary);
  app.footer = reduce_footer;
}

}  // namespace orispline::cli
