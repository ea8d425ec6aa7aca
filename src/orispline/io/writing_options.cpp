// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/file_option.hpp>

#include <algorithm>
#include <array>

#include <orispline/base/file_name.hpp>
#include <orispline/io/file_option_words.hpp>
#include <orispline/io/output_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

using WritingOption = FileOption<SampleColumns>;

const std::array writing_list{
    WritingOption{.name = "output_format",
                  .sentence = "Format of the output [that of the extension of the file, else csv]",
                  .argument = [] { return list_of(formats_written()); },
                  .take =
                      [](SampleColumns& columns, std::string_view text) {
                        return format_in("output_format", text, formats_written()).map(into(columns.format));
                      }},
    WritingOption{
        .name = "output_orientation",
        .sentence = "Form of the written orientations [quaternion]",
        .argument = list_of<representation_words>,
        .take =
            [](SampleColumns& columns, std::string_view text) {
              return word_in<representation_words>("output_orientation", text).map(into(columns.form.representation));
            }},
    WritingOption{
        .name = "output_euler",
        .sentence = "Order of the written Euler angles [ZYX: roll, pitch, yaw]",
        .argument = [] { return std::string("ORDER"); },
        .take = [](SampleColumns& columns,
                   std::string_view text) { return euler_in("output_euler", text).map(into(columns.form.order)); }},
    WritingOption{.name = "output_angle_unit",
                  .sentence = "Unit of the written Euler angles [deg]",
                  .argument = list_of<angle_unit_words>,
                  .take =
                      [](SampleColumns& columns, std::string_view text) {
                        return word_in<angle_unit_words>("output_angle_unit", text).map(into(columns.form.unit));
                      }},
    WritingOption{.name = "continuous",
                  .sentence =
                      "Euler angles run on from row to row, as they do anyway: full turns are counted, and nothing "
                      "jumps at 180° or flips at the pole",
                  .take =
                      [](SampleColumns& columns, std::string_view) {
                        columns.form.continuous = true;
                        return Expected<void>();
                      }},
    WritingOption{.name = "no_continuous",
                  .sentence = "Euler angles of each row by itself, within ±180° [they run on from row to row]",
                  .take =
                      [](SampleColumns& columns, std::string_view) {
                        columns.form.continuous = false;
                        return Expected<void>();
                      }},
    WritingOption{.name = "output_conjugate",
                  .sentence =
                      "Write orientations that turn world into body, as C-kernels of SPICE hold them [body into "
                      "world]",
                  .take =
                      [](SampleColumns& columns, std::string_view) {
                        columns.turning = Turning::world_to_body;
                        return Expected<void>();
                      }},
};

constexpr std::string_view any_text = ".txt";  // a text of any format

bool is_stated(const StatedOptions& stated, std::string_view name) {
  return std::ranges::find(stated, name, &StatedOptions::value_type::first) != stated.end();
}

std::string small_extension_of(const std::string& path) {
  std::string extension(extension_of(path));
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

/// The format follows the name; one that ends as other files do is a mistake.
Expected<void> check_name(const std::string& path) {
  if (path.empty()) return bad_option("path", "found an empty name, wanted that of a file");
  std::vector<std::string_view> extensions;
  for (const FormatInfo* const format : formats_written())
    if (std::ranges::find(extensions, format->extensions.front()) == extensions.end())
      extensions.push_back(format->extensions.front());
  const std::string extension = small_extension_of(path);
  if (is_stream(path) || extension.empty() || extension == any_text ||
      std::ranges::find(extensions, extension) != extensions.end())
    return {};
  return not_wanted(
      "path", path,
      formatted("a name that ends in {} or {}; `output_format` writes any name", joined(extensions, ", "), any_text));
}

/// The option that asks for the form of orientations.
std::string_view asking(const StatedOptions& stated) {
  for (const std::string_view name : {"output_orientation", "output_euler", "continuous", "no_continuous"})
    if (is_stated(stated, name)) return name;
  return "output_angle_unit";
}

Expected<void> check_form(const SampleColumns& columns, const StatedOptions& stated) {
  const Representation form = columns.form.representation;
  for (const std::string_view name : {"output_euler", "output_angle_unit", "continuous", "no_continuous"})
    if (is_stated(stated, name) && form != Representation::euler)
      return not_wanted("output_orientation",
                        std::ranges::find(stated, "output_orientation", &StatedOptions::value_type::first)->second,
                        formatted("euler with `{}`", name));
  if (columns.format->holds.forms || form == Representation::quaternion) return {};
  auto holding = formats_written();
  std::erase_if(holding, [](const FormatInfo* format) { return !format->holds.forms; });
  return bad_option(asking(stated), formatted("{} holds orientations as quaternions only, wanted {}",
                                              columns.format->file, any_of(holding)));
}

}  // namespace

std::span<const FileOption<SampleColumns>> writing_options() noexcept { return writing_list; }

Expected<SampleColumns> columns_of_output(const std::string& path, const StatedOptions& stated) {
  SampleColumns columns;
  if (const FormatInfo* const by_name = format_of_extension(path)) columns.format = by_name;
  constexpr std::array of_angles{"output_euler", "output_angle_unit", "continuous", "no_continuous"};
  if (std::ranges::any_of(of_angles, [&](std::string_view name) { return is_stated(stated, name); }))
    columns.form.representation = Representation::euler;
  const auto named = is_stated(stated, "output_format") && !path.empty() ? Expected<void>() : check_name(path);
  return named.and_then([&] { return take_all<SampleColumns>(columns, writing_list, stated); })
      .and_then([&] { return check_form(columns, stated); })
      .map([&] { return columns; });
}

SampleColumns columns_like(const FormatInfo& input, SampleColumns columns, const std::string& path,
                           const StatedOptions& stated) {
  const bool says_nothing = !is_stated(stated, "output_format") && extension_of(path) == any_text;
  const bool holds_form = input.holds.forms || columns.form.representation == Representation::quaternion;
  const bool holds_rates = input.holds.rates || columns.derivatives == 0;
  if (says_nothing && input.keeps_times() && holds_form && holds_rates) columns.format = &input;
  return columns;
}

}}}  // namespace orispline::io
