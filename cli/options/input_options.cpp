// SPDX-License-Identifier: Apache-2.0
#include "options/input_options.hpp"

#include <orispline/base/formatted.hpp>
#include <orispline/io/iso_time.hpp>

namespace orispline::cli {
namespace {

using ColumnNames = std::map<std::string, std::string, std::less<>>;

Expected<ColumnNames> column_names(const std::vector<std::string>& lists) {
  ColumnNames names;
  for (const std::string& list : lists)
    for (const std::string_view piece : pieces_of(list, ',')) {
      const auto assignment = assignment_in({"--columns", piece});
      if (!assignment) return tl::unexpected(assignment.error());
      const auto& [name, in_file] = *assignment;
      if (!names.emplace(name, in_file).second)
        return usage_failure(formatted("--columns: '{}' is given twice, wanted it once", name));
    }
  return names;
}

Expected<io::OrientationReading> orientation_reading(const InputOptions& options) {
  FirstError checked;
  io::OrientationReading reading{
      .representation = checked(if_given("--input-orientation", options.orientation, choice_of(orientation_choices))),
      .euler = checked(if_given("--euler", options.euler, euler_order_in)),
      .angle_unit = checked(if_given("--angle-unit", options.angle_unit, choice_of(angle_unit_choices)))};
  return std::move(checked).or_else(std::move(reading));
}

Expected<std::optional<const io::FormatInfo*>> input_format(const InputOptions& options) {
  return if_given("--input-format", options.format, [](OptionText o) { return format_in(o, io::formats_read()); });
}

Expected<Fraction> time_scale_in(OptionText option) { return fraction_in(option); }

Expected<Decimal> instant_in(OptionText option) {
  const auto instant = io::parse_iso_time(option.text);
  if (!instant) return wanted(option, "a time of ISO 8601 such as 2024-02-29T12:30:00Z");
  return *instant;
}

}  // namespace

Expected<EulerOrder> euler_order_in(OptionText option) {
  if (const auto order = euler_order_of(option.text)) return *order;
  return wanted(option, "three axes such as ZYX (those of the body) or zyx (of the world), none twice in a row");
}

Expected<const io::FormatInfo*> format_in(OptionText option, std::span<const io::FormatInfo* const> formats) {
  const auto found = std::ranges::find(formats, option.text, &io::FormatInfo::id);
  if (found == formats.end()) return wanted(option, one_of(formats));
  return *found;
}

std::string one_of(std::span<const io::FormatInfo* const> formats) {
  std::vector<std::string_view> ids;
  for (const io::FormatInfo* const format : formats) ids.push_back(format->id);
  return joined(ids, "|");
}

Expected<io::Clock> clock_in(const InputOptions& options) {
  FirstError checked;
  io::Clock clock{
      .zero = checked(if_given("--epoch", options.epoch, instant_in)).value_or(Decimal()),
      .frames_per_second = checked(if_given("--fps", options.fps, [](OptionText o) { return fraction_in(o); }))};
  return std::move(checked).or_else(std::move(clock));
}

Expected<InputRequest> input_request(const InputOptions& options) {
  if (options.path.empty()) return usage_failure("INPUT: found an empty name, wanted FILE or -");
  FirstError checked;
  io::ReadOptions read{.format = checked(input_format(options)).value_or(nullptr),
                       .columns = checked(column_names(options.columns)),
                       .order = checked(if_given("--order", options.order, choice_of(order_choices))),
                       .orientation = checked(orientation_reading(options)),
                       .time_scale = checked(if_given("--time-scale", options.time_scale, time_scale_in)),
                       .clock = checked(clock_in(options)),
                       .conjugate = options.conjugate,
                       .drop_duplicates = options.drop_duplicates,
                       .drop_invalid = options.drop_invalid,
                       .sort = options.sort,
                       .recipe = options.ignore_recipe ? io::RecipeUse::ignored : io::RecipeUse::honoured,
                       .norms = options.normalise ? io::Norms::any : io::Norms::near_one};
  const auto given_signs = checked(if_given("--signs", options.signs, choice_of(sign_choices)));
  return std::move(checked).or_else(InputRequest{.path = options.path, .read = std::move(read), .signs = given_signs});
}

}  // namespace orispline::cli
