// SPDX-License-Identifier: Apache-2.0
#include "options/output_options.hpp"

#include <orispline/base/formatted.hpp>

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

}  // namespace

std::string a_file_of(io::FileFormat format) {
  return formatted("{} {} file", format == io::FileFormat::euroc ? "an" : "a", io::title_of(format));
}

Expected<void> check_times_are_kept(io::FileFormat format, std::string_view option, std::string_view promise) {
  if (format != io::FileFormat::euroc && format != io::FileFormat::npy) return {};
  return usage_failure(formatted("{}: {} rounds times, with which {} need not hold, wanted CSV or TUM", option,
                                 a_file_of(format), promise));
}

Expected<io::SampleColumns> output_columns(const OutputOptions& options) {
  if (options.path.empty()) return usage_failure("-o: found an empty name, wanted FILE or -");
  FirstError checked;
  const auto format = checked(if_given("--output-format", options.format, choice_of(output_format_choices)));
  const auto form = checked(form_in(options));
  auto columns = std::move(checked).or_else(io::SampleColumns{
      .format = format.value_or(io::format_of_extension(options.path).value_or(io::FileFormat::csv)), .form = form});
  if (columns && !io::holds_all_columns(columns->format) && form.representation != io::Representation::quaternion)
    return usage_failure(formatted("{}: {} holds orientations as quaternions only, wanted CSV",
                                   options.orientation ? "--output-orientation"
                                   : options.euler     ? "--output-euler"
                                                       : "--output-angle-unit",
                                   a_file_of(columns->format)));
  return columns;
}

}  // namespace orispline::cli
