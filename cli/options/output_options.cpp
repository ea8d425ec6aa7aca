// SPDX-License-Identifier: Apache-2.0
#include "options/output_options.hpp"

#include <algorithm>

#include <orispline/base/formatted.hpp>

#include "options/file_places.hpp"

namespace orispline::cli {
namespace {

/// Euler angles are also asked for by their order or their unit alone.
Expected<io::OrientationForm> form_in(const OutputOptions& options) {
  FirstError checked;
  const auto representation =
      checked(if_given("--output-orientation", options.orientation, choice_of(orientation_choices)));
  const auto order = checked(if_given("--output-euler", options.euler, euler_order_in));
  const auto unit = checked(if_given("--output-angle-unit", options.angle_unit, choice_of(angle_unit_choices)));
  const bool asks_for_angles = order || unit;
  auto read = std::move(checked).or_else(io::OrientationForm{
      .representation =
          representation.value_or(asks_for_angles ? io::Representation::euler : io::Representation::quaternion),
      .order = order.value_or(EulerOrder{}),
      .unit = unit.value_or(io::AngleUnit::degrees)});
  if (read && asks_for_angles && read->representation != io::Representation::euler)
    return wanted({"--output-orientation", *options.orientation},
                  formatted("euler with {}", order ? "--output-euler" : "--output-angle-unit"));
  return read;
}

/// The format follows the name; one that ends as other files do is a mistake.
Expected<bool> check_name(std::string_view option, const std::string& path) {
  std::vector<std::string_view> extensions;
  for (const io::FormatInfo* const format : io::formats_written())
    if (std::ranges::find(extensions, format->extensions.front()) == extensions.end())
      extensions.push_back(format->extensions.front());
  extensions.push_back(any_text);
  return check_extension(option, path, std::move(extensions), "--output-format FORMAT writes any name").map([] {
    return true;
  });
}

}  // namespace

std::string_view place_of_output(const OutputOptions& options) {
  return options.option == "-o" ? "that of -o" : "the output";
}

Expected<std::string_view> folder_extension(const OutputOptions& options, std::string_view written) {
  if (options.path != io::standard_stream)
    return usage_failure(
        formatted("found -o and --output-folder, wanted one of them: a file for the {}, or their folder", written));
  return output_format(options).map([](std::optional<const io::FormatInfo*> format) {
    return format ? (*format)->extensions.front() : std::string_view();
  });
}

std::string formats_that(bool (*are)(const io::FormatInfo&)) {
  auto some = io::formats_written();
  std::erase_if(some, [are](const io::FormatInfo* format) { return !are(*format); });
  return io::any_of(some);
}

Expected<void> check_settings_fit(const Track& keys, const io::SampleColumns& columns, std::string_view output,
                                  std::string_view promise) {
  if (keys.settings.empty() || columns.format->holds.settings) return {};
  return usage_failure(formatted("{}: {} has no column for {}, with which {}, wanted {}", output, columns.format->file,
                                 keys.settings.begin()->first, promise,
                                 formats_that([](const auto& f) { return f.keeps_times() && f.holds.settings; })));
}

Expected<void> check_times_are_kept(const io::FormatInfo& format, std::string_view option, std::string_view promise) {
  if (format.keeps_times()) return {};
  return usage_failure(formatted("{}: {} rounds times, and {} may not hold with rounded times; wanted {}", option,
                                 format.file, promise, formats_that([](const auto& f) { return f.keeps_times(); })));
}

Expected<std::optional<const io::FormatInfo*>> output_format(const OutputOptions& options) {
  return if_given("--output-format", options.format, [](OptionText o) { return format_in(o, io::formats_written()); });
}

io::SampleColumns columns_like(const io::FormatInfo& input, io::SampleColumns columns, const OutputOptions& options) {
  const bool says_nothing = !options.format && has_extension(options.path, any_text);
  const bool holds_form = input.holds.forms || columns.form.representation == io::Representation::quaternion;
  const bool holds_rates = input.holds.rates || columns.derivatives == 0;
  if (says_nothing && input.keeps_times() && holds_form && holds_rates) columns.format = &input;
  return columns;
}

Expected<io::SampleColumns> output_columns(const OutputOptions& options) {
  if (options.path.empty()) return usage_failure("-o: found an empty name, wanted FILE or -");
  FirstError checked;
  const io::FormatInfo* const by_name = io::format_of_extension(options.path);
  if (!options.format) static_cast<void>(checked(check_name(options.option, options.path)));
  const auto format = checked(output_format(options)).value_or(by_name ? by_name : &io::csv_format);
  const auto form = checked(form_in(options));
  const auto turning = options.conjugate ? io::Turning::world_to_body : io::Turning::body_to_world;
  auto columns = std::move(checked).or_else(io::SampleColumns{.format = format, .form = form, .turning = turning});
  if (columns && !format->holds.forms && form.representation != io::Representation::quaternion)
    return usage_failure(formatted("{}: {} holds orientations as quaternions only, wanted {}",
                                   options.orientation ? "--output-orientation"
                                   : options.euler     ? "--output-euler"
                                                       : "--output-angle-unit",
                                   format->file, formats_that([](const auto& f) { return f.holds.forms; })));
  return columns;
}

}  // namespace orispline::cli
