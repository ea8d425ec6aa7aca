// SPDX-License-Identifier: Apache-2.0
#include "commands/convert/convert.hpp"

#include <algorithm>
#include <utility>

#include <orispline/families/method_text.hpp>
#include <orispline/io/track_file.hpp>

#include "commands/convert/convert_report.hpp"
#include "commands/convert/convert_scene.hpp"
#include "options/file_places.hpp"
#include "options/method_options.hpp"
#include "options/scene_input.hpp"
#include "output/keys_file.hpp"
#include "output/standard_output.hpp"

namespace orispline::cli {

namespace {

constexpr int highest_order = 3;  // of rates that keys may have

/// Digits are those of quaternions: other forms are those of a unit quaternion.
Expected<io::TrackFile> open_source(InputRequest request, const io::OrientationForm& form) {
  request.read.keep_exact_times = true;
  request.read.keep_as_read = form.representation == io::Representation::quaternion;
  auto input = io::KeyInput::open(request.path, request.read);
  if (!input) return tl::unexpected(std::move(input.error()));
  const Recipe stated = input->recipe();
  const auto method = method_of(stated, request.path);
  if (!method) return tl::unexpected(method.error());
  if (*method) {
    request.read.parameters = open_parameters(**method);
    if ((*method)->name == smoothed_method) read_band(request.read);
    request.read = with_columns_of(**method, std::move(request.read));
    request.read.world_rates = jobs::family_of(**method).rate_orders > 0;
  }
  return io::read_track(std::move(*input), request.read, request.signs.value_or(Signs::as_given))
      .map([&](io::TrackFile file) {
        file.track.recipe.signs = request.signs.value_or(stated.signs);
        return file;
      });
}

/// Without their settings the keys are no longer for the curve of their method.
void leave_settings(Track& track, const io::SampleColumns& columns, const std::string& path) {
  if (track.settings.empty()) return;
  if (const auto warning = io::recipe_not_stated(track, columns, path)) warn({*warning});
  track.recipe = {};
  track.settings.clear();
}

ConvertReport report_on(const io::TrackFile& source, const ConvertArguments& options,
                        const io::SampleColumns& columns) {
  ConvertReport report{.input = options.input.path,
                       .output = options.output.path,
                       .input_format = source.format,
                       .output_format = columns.format,
                       .repairs = source.repairs,
                       .keyframes = source.track.keys.report(),
                       .keys = source.track.keys.size(),
                       .start = source.track.exact_times.front(),
                       .end = source.track.exact_times.back(),
                       .dropped_columns = source.ignored_columns};
  if (columns.derivatives == 0 && !source.track.keys.angular_velocities().empty())
    report.dropped_columns.emplace_back("angular velocities");
  if (!columns.format->holds.rates && source.track.keys.have_inner_quaternions())
    report.dropped_columns.emplace_back("inner quaternions");
  if (!columns.format->holds.settings)
    for (const auto& [name, values] : source.track.settings) report.dropped_columns.push_back(name);
  if (!columns.positions)
    report.positions =
        columns.format->holds.always_positions ? ConvertReport::Positions::zero : ConvertReport::Positions::absent;
  return report;
}

}  // namespace

Expected<void> convert(const ConvertArguments& options) {
  FirstError checked;
  auto input = checked(input_request(options.input));
  if (is_scene(options.output.path))
    return std::move(checked).or_else(std::move(input)).and_then([&](const InputRequest& request) {
      return convert_scene(options, request);
    });
  if (options.rate || options.no_bones)
    return usage_failure(formatted("{}: found an output without a skeleton, wanted a file such as walk.bvh or walk.glb",
                                   options.rate ? "--rate" : "--no-bones"));
  auto columns = checked(output_columns(options.output));
  auto request = std::move(checked).or_else(std::move(input));
  if (!request) return tl::unexpected(std::move(request.error()));
  if (auto fits = check_summary(options.summary, options.output.path, "keys"); !fits) return fits;
  if (auto apart = check_output_apart("-o", options.output.path, {{"INPUT", options.input.path}}); !apart) return apart;
  auto source = open_source(std::move(*request), columns.form);
  if (!source) return tl::unexpected(with_output_for_all(source.error(), "an output such as all.glb"));
  warn(source->warnings);
  columns = columns_like(*source->format, columns, options.output);
  columns.positions = !source->track.keys.positions().empty();
  columns.derivatives = columns.format->holds.rates ? highest_order : 0;
  const ConvertReport report = report_on(*source, options, columns);
  if (!columns.format->holds.settings) leave_settings(source->track, columns, options.output.path);
  return write_keys(options.output.path, source->track, columns).and_then([&] {
    return summarise(options.summary, report);
  });
}

}  // namespace orispline::cli
