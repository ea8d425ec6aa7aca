// SPDX-License-Identifier: Apache-2.0
// Trajectories of the TUM RGB-D benchmark: `t tx ty tz qx qy qz qw`.
#include <orispline/io/file_format.hpp>
#include <orispline/io/key_columns.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_columns.hpp>
#include <orispline/io/text_row.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace { namespace tum {

constexpr std::array<std::string_view, 1> extensions{".tum"};
constexpr std::array<std::string_view, 8> names{"t", "px", "py", "pz", "qx", "qy", "qz", "qw"};

Likeness likeness(const TextTable& table, const ReadOptions& options) {
  const bool has_its_shape = table.delimiter() != Delimiter::comma && table.delimiter() != Delimiter::semicolon &&
                             width_of(table.cells()) == names.size() && !is_header(table.cells());
  return has_its_shape && !options.order ? Likeness::likely : Likeness::none;
}

Expected<TableLayout> layout(const TextTable& table, const ReadOptions& options) {
  if (options.order)
    return misplaced(table, "order", "found a TUM file, whose columns are always t tx ty tz qx qy qz qw, wanted CSV");
  if (const auto option = header_option(options))
    return misplaced(table, *option, "found a TUM file, which has no header, wanted CSV with one");
  const KeyColumns columns{
      .width = names.size(), .orientation = {{7}, {4}, {5}, {6}}, .position = three_columns_from(1)};
  return TableLayout{columns, {names.begin(), names.end()}, TableLayout::FirstRow::key};
}

RowNumbers numbers(const Sample& sample, const SampleColumns& columns) {
  const Eigen::Quaterniond orientation = written_orientation(sample.motion.orientation, columns);
  RowNumbers numbers;
  numbers.add(sample.linear_motion.position);
  numbers.add(Eigen::Vector3d(orientation.vec()));
  numbers.add(orientation.w());
  return numbers;
}

void row(std::string& bytes, const Decimal& time, std::span<const double> numbers) {
  append_text_row(bytes, time, numbers, ' ');
}

}  // namespace tum

}  // namespace

constinit const FormatInfo tum_format{
    .id = "tum",
    .title = "TUM",
    .file = "a TUM file",
    .summary = "`t tx ty tz qx qy qz qw`, separated by blanks",
    .extensions = tum::extensions,
    .holds = {.always_positions = true, .comments = true},
    .reading = {.likeness = tum::likeness, .layout = tum::layout, .delimiter = Delimiter::blanks},
    .writing = {.numbers = tum::numbers, .row = tum::row}};

}}}  // namespace orispline::io
