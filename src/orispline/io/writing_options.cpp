// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/file_option.hpp>

#include <algorithm>
#include <array>
#include <filesystem>

#include <orispline/io/file_option_words.hpp>
#include <orispline/io/output_file.hpp>

namespace orispline::inline ORISPLINE_ABI::io {
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

std::string extension_of(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(),
                         [](char c) { return 'A' <= c && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return extension;
}

/// The format follows the name; one that ends as other files do is a mistake.
Expected<void> check_name(const std::string& path) {
  std::vector<std::string_view> extensions;
  for (const FormatInfo* const format : formats_written())
    if (std::ranges::find(extensions, format->extensions.front()) == extensions.end())
      extensions.push_back(format->extensions.front());
  const std::string extension = extension_of(path);
  if (is_stream(path) || extension.empty() || extension == any_text ||
      std::ranges::find(extensions, extension) != extensions.end())
    return {};
  return not_wanted(
      "path", path,
      formatted("a name that ends in {} or {}, or `output_format` with any name", joined(extensions, ", "), any_text));
}

}  // namespace

std::span<const FileOption<SampleColumns>> writing_options() noexcept { return writing_list; }

Expected<SampleColumns> columns_of_output(const std::string& path, const StatedOptions& stated,
                                          const FormatInfo* like) {
  SampleColumns columns;
  const bool has_format = is_stated(stated, "output_format");
  if (const FormatInfo* const by_name = format_of_extension(path)) columns.format = by_name;
  else if (like && extension_of(path) == any_text) columns.format = like;
  const bool asks_for_angles = is_stated(stated, "output_euler") || is_stated(stated, "output_angle_unit");
  if (asks_for_angles) columns.form.representation = Representation::euler;
  if (path.empty()) return bad_option("path", "found an empty name, wanted that of a file");
  if (auto taken = take_all<SampleColumns>(columns, writing_list, stated); !taken)
    return tl::unexpected(std::move(taken.error()));
  if (auto checked = has_format ? Expected<void>() : check_name(path); !checked)
    return tl::unexpected(std::move(checked.error()));
  if (asks_for_angles && columns.form.representation != Representation::euler)
    return bad_option("output_orientation",
                      formatted("found another form than euler, wanted euler with `{}`",
                                is_stated(stated, "output_euler") ? "output_euler" : "output_angle_unit"));
  return columns;
}

}  // namespace orispline::inline ORISPLINE_ABI::io
