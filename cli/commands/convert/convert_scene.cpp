// SPDX-License-Identifier: Apache-2.0
#include "commands/convert/convert_scene.hpp"

#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/jobs/inspect_scene.hpp>

#include "options/file_places.hpp"
#include "options/scene_input.hpp"
#include "output/scene_output.hpp"
#include "output/summary.hpp"

namespace orispline::cli {

namespace {

/// What was converted.
struct ConvertedScene {
  std::string input{}, output{};
  std::string_view input_format{}, output_format{};  ///< titles
  std::string_view input_id{}, output_id{};          ///< words
  std::size_t joints = 0, clips = 0;
  jobs::SceneCounts counts{};
  scenes::WrittenKeys written{};
};

std::string text_of(const ConvertedScene& report) {
  return formatted("{} and {} from {} ({}) written to {} ({}): {} of rotations, {} of translations\n",
                   counted(report.joints, "joint"), counted(report.clips, "clip"), printable(report.input),
                   report.input_format, destination(report.output), report.output_format,
                   counted(report.written.rotations, "key"), counted(report.written.translations, "key"));
}

Json json_of(const ConvertedScene& report) {
  Json json{{"input", report.input},   {"input_format", report.input_id},
            {"output", report.output}, {"output_format", report.output_id},
            {"joints", report.joints}, {"clips", report.clips}};
  json.update(json_of(report.counts));
  json["rotation_keys_written"] = report.written.rotations;
  json["translation_keys_written"] = report.written.translations;
  return json;
}

/// By its name, as far as that tells.
std::string_view id_of_table(const InputRequest& input) {
  if (input.read.format) return input.read.format->id;
  const io::FormatInfo* const format = io::format_of_extension(input.path);
  return format ? format->id : io::csv_format.id;
}

}  // namespace

Expected<void> convert_scene(const ConvertArguments& options, const InputRequest& input) {
  FirstError checked;
  scenes::SceneWriting writing = checked(scene_writing(options.output));
  writing.rate = checked(if_given("--rate", options.rate, [](OptionText text) { return positive_in(text); }));
  writing.bones = !options.no_bones;
  auto understood = std::move(checked).or_else(writing);
  if (!understood) return tl::unexpected(std::move(understood.error()));
  if (understood->rate && scenes::scene_format_of(options.output.path) != &scenes::bvh_format)
    return usage_failure("--rate: found an output that keeps the times of the keys, wanted BVH");
  if (auto fits = check_summary(options.summary, options.output.path, "keys"); !fits) return fits;
  if (auto apart = check_output_apart("-o", options.output.path, {{"INPUT", input.path}}); !apart) return apart;
  const auto scene = open_scene(input);
  if (!scene) return tl::unexpected(scene.error());
  warn(scene->warnings);
  ConvertedScene report{.input = input.path,
                        .output = options.output.path,
                        .input_format = scene->format ? scene->format->title : "keys",
                        .output_format = scenes::scene_format_of(options.output.path)->title,
                        .input_id = scene->format ? scene->format->id : id_of_table(input),
                        .output_id = scenes::scene_format_of(options.output.path)->id,
                        .joints = scene->skeleton.size(),
                        .clips = scene->clips.size(),
                        .counts = jobs::counts_of(scene->skeleton, scene->clips)};
  return write_counted_scene(options.output.path, *scene, *understood)
      .map_error([&](Error error) {
        if (error.where.file.empty()) error.where.file = input.path;
        return error;
      })
      .and_then([&](const scenes::WrittenKeys& written) {
        report.written = written;
        return summarise(options.summary, report);
      });
}

}  // namespace orispline::cli
