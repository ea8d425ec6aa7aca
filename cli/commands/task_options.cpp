// SPDX-License-Identifier: Apache-2.0
// What may be typed for each command that runs a task, and what its help says.
#include "commands/task_command.hpp"

#include <algorithm>
#include <array>

#include <orispline/base/formatted.hpp>
#include <orispline/fields.hpp>
#include <orispline/jobs.hpp>

#include "options/command_options.hpp"
#include "options/scene_input.hpp"
#include "options/smoothness.hpp"

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

void add_inspect_options(Command& app, TaskArguments& o) {
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
  app.usual = {"--euler", "--drop-duplicates", "--drop-invalid", "--closed"};
  app.footer = inspect_footer;
}

constexpr auto difference_footer = R"(Examples:
  orispline difference mage.glb small.glb
  orispline difference walk.bvh walk.glb --rate 240
  orispline difference mage.glb small.glb --clip Walking_A --shell 10cm
  orispline difference mage.glb small.glb --report difference.html

The joints of both files go by their place in the tree, then by their names; the clips go by their names, unless each
file has one only. The shell distance
is the largest distance in the world between the same points in both motions: the joint itself, and three points that
are --shell off it along its axes. docs/skeletons.md says more.)";

void add_difference_options(Command& app, TaskArguments& o) {
  app.add_option("FIRST", o.input.path, "File of a skeleton with its clips, at whose key times the two are compared")
      ->required()
      ->type_name("FILE");
  app.add_option("SECOND", o.second, "File of the same skeleton")->required()->type_name("FILE");
  app.add_option("--clip", o.clips, "Clip to compare, by its name; repeatable [all of them]")
      ->repeated()
      ->type_name("NAME");
  add_scene_reading_options(app, o.input);
  add_field(app, o.fields, field_named(fields_of<orispline::ClipReduceOptions>(), "shell"), "");
  app.add_option("--rate", o.fields["rate"],
                 "Look between keys too: at so many times per second, and beside the largest differences [at the keys "
                 "of FIRST only]")
      ->type_name("HZ");
  app.add_flag("--json", o.json, "Print one JSON document");
  app.add_option("--report", o.report.path,
                 "Write a page to look at in a browser: both motions in space, and how far they differ")
      ->type_name(file_type);
  app.footer = difference_footer;
}

constexpr auto clip_footer = R"(Examples:
  orispline clip walk.bvh --from 0.4 --to 1.6 --shift 0 -o step.glb
  orispline clip mage.glb --clip Walking_A --clip Running_A --speed 1.5 -o faster.glb
  orispline clip run.glb --clip Run --loop --root hips -o loop.glb
  orispline clip a.glb --append b.glb --blend 0.1s -o ab.glb
  orispline clip walk.glb --in-place hips -o here.glb
  orispline clip walk.bvh --loop --root Hips --period-from 0.8 --period-to 1.4 --shift 0 -o cycle.bvh

Every clip that is chosen is cut, turned round, made faster, continued by another one, closed, freed from the way of a
joint, and shifted, in this order. A cut has exact ends, and what lies between the keys stays as it was. docs/clip.md says more.)";

void add_clip_options(Command& app, TaskArguments& o) {
  app.add_option("INPUT", o.input.path, "File of a skeleton with its clips")->required()->type_name("FILE");
  app.add_option("--clip", o.clips, "Clip to edit, by its name; repeatable, the others are left out [all of them]")
      ->repeated()
      ->type_name("NAME");
  add_scene_reading_options(app, o.input);
  add_fields(app, o.fields, fields_of<orispline::ClipEdits>(), "Clips");
  app.add_option("--append", o.files["append"], "File of the same skeleton, whose clip comes behind")
      ->type_name(file_type)
      ->group("Clips");
  const auto add_name = [&](std::string_view field, std::string type, std::string sentence) {
    app.add_option(flag_of(field), o.fields[field], std::move(sentence))->type_name(std::move(type))->group("Clips");
  };
  add_name("append_clip", "NAME", "Clip of that file, by its name [the only one]");
  add_name("root", "JOINT",
           "Joint whose way a loop keeps, and goes on in the appended clip [none; the first that travels]");
  add_name("extract_root", "JOINT", "Joint whose way across and heading about up go into a node above it");
  add_name("root_node", "JOINT", "That node [the topmost one]");
  add_name("in_place", "JOINT", "Joint whose way across and heading about up are taken out");
  o.output.scenes = scenes_written();
  add_output_options(app, o.output);
  add_gltf_options(app, o.output);
  add_report_option(app, o.report);
  app.add_option("--threads", o.inputs.threads, "Threads that work on the clips, with the same results [all cores]")
      ->type_name("N")
      ->group("Output");
  add_summary_options(app, o.summary);
  app.usual = {"--clip", "--from", "--to", "--shift", "--speed", "--append", "--loop", "--root", "--in-place"};
  app.footer = clip_footer;
}

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

void add_compare_options(Command& app, TaskArguments& o) {
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
  app.add_option("--reference", o.files["reference"],
                 "Dense recording that curves through all keys of INPUT are compared with")
      ->type_name(file_type)
      ->group(group);
  app.add_flag("--align", o.fields["align"],
               "Bring the keys onto the reference first: axes, clock, and scale and place of positions; 'orispline "
               "align' does so alone, with a choice")
      ->group(group);
  const std::string measures = "Methods and measures";
  app.add_option("--methods", o.methods,
                 "Methods, also NAME:SETTING=VALUE:ends=RULE; repeatable, each time one or a list [all]")
      ->repeated()
      ->type_name(methods_type)
      ->group(measures);
  add_blending_option(app, o.shape.blending);
  app.add_flag("--tune", o.fields["tune"],
               "Each method that has tensions also with those of the least angular acceleration")
      ->group(measures);
  add_fields(app, o.fields, fields_of<MeasureOptions>(), measures);
  app.add_option("--sort", o.fields["sort"], "Measure to sort by, best first [rms]")
      ->type_name(sort_words())
      ->group(measures);
  app.add_option("--threads", o.inputs.threads, "Threads that work on the methods; 1 for undisturbed times [all cores]")
      ->type_name("N")
      ->group(measures);
  const std::string output = "Output";
  app.add_flag("--json", o.json, "Print one JSON array")->group(output);
  app.add_flag("--csv", o.csv, "Print one CSV table")->group(output);
  add_report_option(app, o.report);
  app.add_flag("--quiet", o.summary.quiet, "No progress bar")->group(output);
  app.usual = {"--keep-every", "--reference", "--align", "--methods", "--tune", "--sort", "--csv"};
  app.footer = compare_footer;
}

constexpr auto align_footer = R"(Examples:
  orispline align estimate.csv truth.csv
  orispline align estimate.csv truth.csv -o aligned.csv
  orispline align headset.csv mocap.csv --offset 0
  orispline align camera.tum truth.tum --no-body-turn --no-scale -o aligned.tum
  orispline align imu.csv robot.csv --json
  orispline align gyro.csv poses.csv
  orispline align gyro.csv other_gyro.csv -o aligned_rates.csv

INPUT and REFERENCE are two recordings of one motion, at least as far as they overlap. What is found turns the world and
the body of INPUT, shifts its clock, and moves and scales its positions where both have some. A file with wx, wy, wz and
no orientations is the recording of a gyro: beside another gyro or orientations the turn of the body, the clock and the
bias are found. A tenth of bad rows in
either file does no harm. What the motion cannot tell, such as which of two sides turns where all turns have one axis, is
said. The reading options hold for REFERENCE too as far as they fit. docs/align.md says more.)";

void add_align_options(Command& app, TaskArguments& o) {
  o.output.path.clear();  // nothing is written without -o
  add_input_options(app, o.input);
  app.add_option("REFERENCE", o.second, "Recording of the same motion, or gyro of the same body, which stays as it is")
      ->required()
      ->type_name(file_type);
  add_fields(app, o.fields, fields_of<orispline::AlignOptions>(), "Alignment");
  add_made_output(
      app, o.output, o.summary,
      "File to write INPUT into as it is beside REFERENCE; it appears complete or not at all [what was found is "
      "printed]");
  app.usual = {"--no-world-turn", "--no-body-turn", "--offset", "--no-scale", "--no-translation"};
  app.footer = align_footer;
}

constexpr auto smooth_footer = R"(Examples:
  orispline smooth noisy.csv -o keys.csv
  orispline smooth noisy.csv --noise 1deg --gap 0.5 -o keys.csv
  orispline smooth noisy.csv --cutoff 8 --loss l2 --rate 200 -o motion.csv
  orispline smooth imu.csv --gyro -o keys.csv
  orispline smooth poses.csv --gyro-file imu.csv -o keys.csv
  orispline smooth noisy.csv --sigma -o keys.csv
  orispline smooth noisy.csv --rate 100 --band 0.9 -o motion.csv
  orispline smooth walk.bvh -o clean.bvh --report clean.html
  orispline smooth recordings --output-folder smoothed
  orispline sample keys.csv --method hermite-c2 --rate 500 -o motion.csv

Without --noise, --smoothing-time or --cutoff the smoothing is chosen by generalised cross-validation. The output has an
orientation with its rates (wx,wy,wz,ax,ay,az) at every time of INPUT, of which 'sample --method hermite-c2' makes a C2
curve; with --rate it has samples of that curve, and with --band how far off they may be. docs/smooth.md says more.)";

void add_smooth_options(Command& app, TaskArguments& o) {
  add_several_inputs(app, o.inputs, "keys");
  add_input_threads(app, o.inputs);
  add_reading_options(app, o.input);
  app.remove("--gap");  // which it has for itself
  add_smoothing_options(app, o.fields);
  app.add_option("--gyro-file", o.files["gyro"],
                 "Use the rates t, wx, wy, wz of this file as those of a gyro, with a clock of its own")
      ->type_name(file_type)
      ->group("Smoothing");
  add_time_options(app, o.rows, "Samples in the place of keys (one of --rate, --count, --times)",
                   "Write samples at so many per second instead of keys");
  o.output.scenes = scenes_written();
  add_output_options(app, o.output);
  add_gltf_options(app, o.output);
  add_row_options(app, o.rows);
  add_band_option(app, o.rows);
  add_report_option(app, o.report);
  add_summary_options(app, o.summary);
  app.usual = {"--noise", "--smoothing-time", "--cutoff", "--gap", "--gyro", "--gyro-file", "--sigma", "--rate"};
  app.footer = smooth_footer;
}

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

void add_mean_options(Command& app, TaskArguments& o) {
  o.output.path.clear();  // nothing is written without -o
  add_several_inputs(app, o.inputs, "mean", "whose rows are one set; with --output-folder each has a mean of its own");
  add_reading_options(app, o.input);
  add_fields(app, o.fields, fields_of<orispline::MeanOptions>(), "Mean");
  add_made_output(
      app, o.output, o.summary,
      "File to write the mean into, one row, or one for each window; it appears complete or not at all [the mean is "
      "printed]");
  add_input_threads(app, o.inputs);
  app.usual = {"--kind", "--every"};
  app.footer = mean_footer;
}

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

void add_tune_options(Command& app, TaskArguments& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.method,
                 formatted("Method whose tensions to find [as INPUT says, else {}]", jobs::usual_tuned.name))
      ->type_name(method_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  for (const FieldInfo& field : fields_of<orispline::TuneOptions>())
    add_field(app, field.type == FieldType::recording ? o.files : o.fields, field, "Tuning");
  add_output_file(app, o.output.path);
  add_summary_options(app, o.summary);
  app.usual = {"--objective", "--reference", "--bounds", "--inertia"};
  app.footer = tune_footer;
}

constexpr auto reduce_footer = R"(Examples:
  orispline reduce flight.csv --tolerance 0.1deg -o keys.csv
  orispline reduce poses.tum --tolerance 0.5deg --position-tolerance 1mm -o keys.tum
  orispline reduce flight.csv --tolerance 0.1deg --method auto --refit -o keys.csv --json
  orispline reduce noisy.csv --smooth --tolerance 0.5deg -o keys.csv
  orispline reduce mage.glb --tolerance 0.05deg -o small.glb
  orispline reduce mage.glb --world-tolerance 2mm -o small.glb --report small.html
  orispline reduce mage.glb --world-tolerance 2mm --compress meshopt -o smallest.glb
  orispline reduce hips.csv head.csv arm.csv --tolerance 0.5deg --output-folder keys
  orispline reduce flight.csv --tolerance 0.1deg --method timed-c3 --tension=0.2 --ends rest -o keys.csv
  orispline sample keys.csv --rate 100 -o motion.csv

The curve of the method that is named in the summary is within the tolerance at every sample. The keys
of slerp are the fewest that its curve can have among the samples; those of auto and timed-c2 are found by insertion and
pruning. hermite-c1 mostly needs fewer: its keys have rates too, wx,wy,wz in a CSV. docs/reduce.md says more.)";

void add_reduce_options(Command& app, TaskArguments& o) {
  add_several_inputs(app, o.inputs, "keys");
  add_reading_options(app, o.input);
  const std::string group = "Reduction";
  const auto fields = fields_of<orispline::ReduceOptions>();
  for (const std::string_view name : {"tolerance", "position_tolerance"})
    add_field(app, o.fields, field_named(fields, name), group);
  app.option("--tolerance").is_required = false;  // of clips the world's may stand for it
  app.add_option(
         "--method", o.method,
         formatted("Method of the curve, a local one through its keys, or {}; of glTF also {} [{}; of glTF {}, with "
                   "--compress {}, for gltf-transform's meshopt slerp]",
                   smallest_method, cubicspline_method, smallest_method, cubicspline_method, smallest_method))
      ->type_name(method_type)
      ->group(group);
  const auto of_clips = fields_of<orispline::ClipReduceOptions>();
  for (const std::string_view name : {"world_tolerance", "shell", "between", "compress", "for"})
    add_field(app, o.fields, field_named(of_clips, name), "Clips");
  app.add({.names = "--cuts",
           .sentence =
               "Take single steps of joints that neither side of them foretells as cuts, as is done anyway with "
               "--between smooth",
           .typed = &o.fields["cuts"],
           .stands_for = "steps",
           .section = "Clips"});
  app.add({.names = "--no-cuts",
           .sentence = "Take every jump as motion, also between keys that are at most 2 ms apart",
           .typed = &o.fields["cuts"],
           .stands_for = "none",
           .section = "Clips"});
  app.add_option("--position-scale", o.fields["position_scale"],
                 "Metres in one unit of length of a BVH file, such as 0.01, for tolerances of lengths and for glTF, "
                 "whose lengths are in metres [lengths are kept as they are]")
      ->type_name("X")
      ->group("Clips");
  app.add_flag(
         "--closed", o.fields["closed"],
         "Give channels that end as they begin the same tangents at both ends, so that the speed of loops does not "
         "jump there")
      ->group("Clips");
  add_field(app, o.fields, field_named(of_clips, "keep_constant"), "Clips");
  add_method_options(app, o.shape);
  add_word_flag(app, o.fields, field_named(fields, "values"), "refit", group);
  app.add_flag("--smooth", o.fields["smooth"],
               "Smooth the recording first, as 'orispline smooth' does; implied by the options below")
      ->group("Smoothing");
  add_smoothness_options(app, o.fields);
  o.output.scenes = {&scenes::gltf_format};
  add_output_options(app, o.output);
  add_report_option(app, o.report);
  app.add_option("--threads", o.inputs.threads,
                 "Threads that work on inputs and methods, with the same results [all cores]")
      ->type_name("N")
      ->group("Output");
  add_summary_options(app, o.summary);
  app.usual = {"--tolerance", "--position-tolerance", "--world-tolerance", "--refit", "--smooth", "--closed"};
  app.footer = reduce_footer;
}

constexpr auto retime_footer = R"(Examples:
  orispline retime keys.csv --max-rate 90deg/s -o slow.csv
  orispline retime keys.csv --max-rate 90deg/s --max-acceleration 200deg/s2 --per-interval -o slow.csv
  orispline retime keys.csv --max-rate 90,60,120deg/s --max-jerk 2000deg/s^3 --max-speed 0.5m/s -o slow.csv
  orispline retime keys.csv --duration 30s -o slow.csv
  orispline retime keys.csv --max-rate 90deg/s --max-acceleration 200deg/s2 --fastest-keys -o fast.csv
  orispline retime keys.csv --max-rate 90deg/s --max-acceleration 200deg/s2 --fastest-keys --insert-keys 5 -o fast.csv
  orispline retime keys.csv --constant-rate 10deg/s --ease 1s -o even.csv
  orispline retime poses --max-rate 90deg/s --output-folder slow
  orispline retime tuned.csv --method timed-c2 --ends rest --max-rate 90deg/s -o slow.csv
  orispline retime keys.csv --max-torque 0.5Nm --inertia=1,2,2.5 --method timed-c2 -o slow.csv --json
  orispline retime walk.bvh --max-rate 400deg/s -o slow.bvh

The limits hold everywhere on the curve of --method, with its settings, through the keys that are written. They are
certified by bounds, not by samples. A motion that is within them stays as it is. Equal keys are rests and keep their
duration; where no method is named, the body stands still in them. Into a file of skeletons whole clips are retimed,
each on one new clock for all its joints. docs/retime.md says more.)";

void add_retime_options(Command& app, TaskArguments& o) {
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
        add_word_flag(app, o.fields, field, word, group);
    else add_field(app, o.fields, field, group);
  o.output.scenes = scenes_written();
  add_output_options(app, o.output);
  add_gltf_options(app, o.output);
  add_report_option(app, o.report);
  add_summary_options(app, o.summary);
  app.usual = {"--max-rate", "--max-acceleration", "--max-jerk",     "--max-speed",
               "--duration", "--per-interval",     "--constant-rate"};
  app.footer = retime_footer;
}

constexpr auto bake_footer = R"(Examples:
  orispline bake keys.csv --tolerance 1e-4deg -o motion.json
  orispline bake keys.csv --method timed-c2:tension=0.6 --tolerance 1e-3deg -o motion.bin

The file has polynomials in single precision, for orientations and for positions where the keys have them: what plays it,
such as a web page, needs no library.
docs/bake.md says more.)";

void add_bake_options(Command& app, TaskArguments& o) {
  add_input_options(app, o.input);
  app.add_option("--method", o.method,
                 formatted("Method of the curve [the one named in INPUT, else {}]", default_method))
      ->type_name(method_type)
      ->group("Shape of the curve");
  add_method_options(app, o.shape);
  add_loop_options(app, o.shape);
  add_fields(app, o.fields, fields_of<jobs::BakeSettings>(), "Baking");
  app.add_option("-o,--output", o.output.path,
                 "File to write, .json or .bin; it appears complete or not at all [JSON on standard output]")
      ->type_name(file_type)
      ->group("Output");
  add_summary_options(app, o.summary);
  app.usual = {"--tolerance", "--position-tolerance", "--closed"};
  app.footer = bake_footer;
}

constexpr std::array commands{
    TaskCommand{"inspect", "Describe a file of keyframes, and where the rates of curves through it jump",
                add_inspect_options, run_inspect},
    TaskCommand{"difference", "Say how far the motions of a skeleton in two files are apart", add_difference_options,
                run_difference},
    TaskCommand{"clip", "Cut clips of a skeleton, join them, close them into loops, or take the way of a root out",
                add_clip_options, run_clip},
    TaskCommand{"compare", "Compare the methods on a recording: errors, smoothness, cost", add_compare_options,
                run_compare},
    TaskCommand{"align", "Bring a recording onto another one of the same motion: axes, clock, scale, place",
                add_align_options, run_align},
    TaskCommand{"smooth", "Turn noisy samples into a smooth motion with rates", add_smooth_options, run_smooth},
    TaskCommand{"mean", "Find the mean or the median of the orientations of a file", add_mean_options, run_mean},
    TaskCommand{"tune", "Find the tensions that make a curve smoothest, or nearest to a recording", add_tune_options,
                run_tune},
    TaskCommand{"reduce", "Keep the fewest keys that reproduce a recording within a tolerance", add_reduce_options,
                run_reduce},
    TaskCommand{"retime", "Slow a motion until it is within limits of rate, acceleration or torque", add_retime_options,
                run_retime},
    TaskCommand{"bake", "Turn a curve into a small file that web pages play", add_bake_options, run_bake},
};

}  // namespace

const TaskCommand& task_command(std::string_view name) {
  return *std::ranges::find(commands, name, &TaskCommand::name);
}

}  // namespace orispline::cli
