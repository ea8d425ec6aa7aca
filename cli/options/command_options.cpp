// SPDX-License-Identifier: Apache-2.0
#include "options/command_options.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <orispline/base/formatted.hpp>

namespace orispline::cli {

namespace {

constexpr std::array<std::string_view, 4> of_scenes{"signs", "drop_duplicates", "salvage", "rest_frame"};

void add_reading_option(Command& app, InputOptions& o, const io::FileOption<io::Reading>& option,
                        std::string_view standing) {
  TypedTexts& typed = o.reading[option.name];
  Option added{
      .names = flag_of(option.name),
      .sentence = standing.empty() ? std::string(option.sentence) : formatted("{} [{}]", option.sentence, standing),
      .typed = &typed.once,
      .stands_for = option.argument ? "" : "true",
      .argument = option.argument ? option.argument() : "",
      .section = "Reading",
      .is_repeated = option.is_repeated};
  if (option.is_repeated) added.typed = &typed.each;
  app.add(std::move(added));
}

}  // namespace

void add_input_options(Command& app, InputOptions& o, std::string_view default_signs) {
  app.add_option("INPUT", o.path,
                 formatted("{} file of keyframes; '-' is standard input", io::any_of(io::formats_read())))
      ->required()
      ->type_name(file_type);
  add_reading_options(app, o, default_signs);
}

void add_reading_options(Command& app, InputOptions& o, std::string_view default_signs) {
  for (const auto& option : io::reading_options())
    add_reading_option(app, o, option, option.name == "signs" ? default_signs : "");
}

void add_scene_reading_options(Command& app, InputOptions& o) {
  for (const auto& option : io::reading_options())
    if (std::ranges::find(of_scenes, option.name) != of_scenes.end()) add_reading_option(app, o, option, "");
}

void add_blending_option(Command& app, std::vector<std::string>& files) {
  app.add_option("--blending", files,
                 "JSON file with blending functions of your own, which are a method by the name that it says; "
                 "docs/own-blending.md")
      ->repeated()
      ->type_name("FILE")
      ->group("Shape of the curve");
}

void add_method_options(Command& app, MethodOptions& o) {
  const std::string group = "Shape of the curve";
  add_blending_option(app, o.blending);
  app.add_option("--tension", o.tension, "Short for --set tension=X[,X...]")->type_name("X[,X...]")->group(group);
  app.add_option("--set", o.settings,
                 "Setting of the method: a number, one number per key with commas, or a word; 'orispline methods "
                 "METHOD' lists them")
      ->repeated()
      ->type_name(setting_type)
      ->group(group);
  app.add_option("--ends", o.ends, "End rule for both ends, or one for each; 'orispline methods METHOD' lists them")
      ->type_name(ends_type)
      ->group(group);
  app.add_option("--start-rate", o.start_rate,
                 "Angular velocity at the first key, in the body frame and rad/s; the end rule there becomes clamped")
      ->type_name("WX,WY,WZ")
      ->group(group);
  app.add_option("--end-rate", o.end_rate,
                 "Angular velocity at the last key, in the body frame and rad/s; the end rule there becomes clamped")
      ->type_name("WX,WY,WZ")
      ->group(group);
}

void add_loop_options(Command& app, MethodOptions& o) {
  const std::string group = "Shape of the curve";
  app.add_flag("--closed", o.closed,
               "Make a loop of keys whose last one repeats the first: the curve passes it smoothly")
      ->group(group);
  app.add_option("--period", o.period, "Make a loop that comes back to the first key T seconds after it began there")
      ->type_name("T")
      ->group(group);
}

void add_output_file(Command& app, std::string& path) {
  app.add_option("-o,--output", path, "File to write; it appears complete or not at all [standard output]")
      ->type_name(file_type)
      ->group("Output");
}

void add_summary_options(Command& app, SummaryOptions& o) {
  app.add_flag("--json", o.json, "Print the summary as JSON on standard output; needs -o")->group("Output");
  app.add_flag("--quiet", o.quiet, "Print no summary")->group("Output");
}

void add_made_output(Command& app, OutputOptions& output, SummaryOptions& summary, std::string_view sentence) {
  add_output_options(app, output);
  app.option("-o,--output").sentence = sentence;
  add_summary_options(app, summary);
  app.option("--json").sentence = "Print what was found as JSON on standard output";
}

void add_report_option(Command& app, ReportOptions& o) {
  app.add_option("--report", o.path, "Write a page to look at in a browser: measures, plots and a view in space")
      ->type_name(file_type)
      ->group("Output");
}

void add_gltf_options(Command& app, OutputOptions& o) {
  app.add_option("--compress", o.compress,
                 "Compress the keys of a glTF file by EXT_meshopt_compression, without rounding them; 'reduce' rounds "
                 "them within its tolerances [none]")
      ->type_name(one_of(words<KeyCompression>))
      ->group("Output");
  app.add_option("--position-scale", o.position_scale,
                 "Metres in one unit of length of a BVH file, such as 0.01, for glTF, whose lengths are in metres "
                 "[lengths are kept as they are]")
      ->type_name("X")
      ->group("Output");
}

void add_output_options(Command& app, OutputOptions& o) {
  add_output_file(app, o.path);
  if (const std::string endings = endings_of(o.scenes); !endings.empty())
    app.options.back().sentence = formatted(
        "File to write, of a skeleton where its name ends in {}; it appears complete or not at all "
        "[standard output]",
        endings);
  for (const auto& option : io::writing_options())
    app.add({.names = flag_of(option.name),
             .sentence = std::string(option.sentence),
             .typed = &o.writing[option.name],
             .stands_for = option.argument ? "" : "true",
             .argument = option.argument ? option.argument() : "",
             .section = "Output"});
}

}  // namespace orispline::cli
