// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/sample_columns.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr int highest_derivative = 3, highest_position_derivative = 2;
constexpr std::array<std::string_view, highest_derivative> rate_letters{"w", "a", "j"};
constexpr std::array<std::string_view, highest_position_derivative> position_rate_letters{"v", "ap"};

/// An angular rate in the frame of the file; order 1 ω, 2 α, 3 jerk.
Eigen::Vector3d rate_of(const Motion& motion, int order, Frame frame) {
  const bool in_body = frame == Frame::body;
  if (order == 1) return in_body ? motion.angular_velocity : angular_velocity_world(motion);
  if (order == 2) return in_body ? motion.angular_acceleration : angular_acceleration_world(motion);
  return in_body ? motion.angular_jerk : angular_jerk_world(motion);
}

/// Beside orientations that turn world to body, a rate without a frame in its name is read as one of nobody knows
/// which.
std::string_view rate_suffix(const SampleColumns& columns) {
  if (columns.frame == Frame::world) return "_world";
  return columns.turning == Turning::world_to_body ? "_body" : "";
}

}  // namespace

Expected<void> check_columns(const SampleColumns& columns) {
  const FormatInfo& format = *columns.format;
  if (!format.is_written())
    return failure(ErrorCode::bad_argument,
                   formatted("{} files are not written, wanted {}", format.title, any_of(formats_written())));
  const auto check = [&](std::string_view what, int asked, int highest) -> Expected<void> {
    if (0 <= asked && asked <= (format.holds.rates ? highest : 0)) return {};
    return failure(ErrorCode::bad_argument,
                   formatted("{} derivatives{} were asked for, and {} holds 0{}", asked, what, format.title,
                             format.holds.rates ? formatted(" to {}", highest) : ""));
  };
  if (!format.holds.forms && columns.form.representation != Representation::quaternion)
    return failure(ErrorCode::bad_argument, formatted("{} holds orientations as quaternions only", format.title));
  const std::size_t settings = format.holds.settings ? most_settings : 0;
  if (columns.settings.size() > settings)
    return failure(ErrorCode::bad_argument, formatted("{} columns of settings were asked for, and {} holds {}",
                                                      columns.settings.size(), format.title, settings));
  if (std::ranges::count(columns.inner, true) > 0 && !format.holds.rates)
    return failure(ErrorCode::bad_argument, formatted("{} has no columns for inner quaternions", format.title));
  if (columns.band && !format.holds.rates)
    return failure(ErrorCode::bad_argument, formatted("{} has no column for a band", format.title));
  return check("", columns.derivatives, highest_derivative).and_then([&] {
    return check(" of the position", columns.position_derivatives, highest_position_derivative);
  });
}

std::string header_of(const SampleColumns& columns, std::size_t rows) {
  const FormatWriting& writing = columns.format->writing;
  return writing.header ? writing.header(columns, rows) : "";
}

// THE order of the columns: `column_names` and `named_numbers` agree.

std::vector<std::string> column_names(const SampleColumns& columns) {
  std::vector<std::string> names{"t"};
  std::ranges::copy(written_names(columns.form), std::back_inserter(names));
  const auto append = [&names](std::string_view letters, std::string_view suffix) {
    for (const char axis : {'x', 'y', 'z'}) names.push_back(formatted("{}{}{}", letters, axis, suffix));
  };
  if (columns.positions) append("p", "");
  for (std::size_t order = 0; order < static_cast<std::size_t>(columns.derivatives); ++order)
    append(rate_letters[order], rate_suffix(columns));
  for (std::size_t order = 0; order < static_cast<std::size_t>(columns.position_derivatives); ++order)
    append(position_rate_letters[order], "");
  for (std::size_t side = 0; side < inner_names.size(); ++side)
    if (columns.inner[side]) names.insert(names.end(), inner_names[side].begin(), inner_names[side].end());
  if (columns.band) names.emplace_back("band");
  std::ranges::copy(columns.settings, std::back_inserter(names));
  return names;
}

RowNumbers named_numbers(const Sample& sample, const SampleColumns& columns) {
  const auto& [motion, linear_motion, inner, settings, band, angles] = sample;
  RowNumbers row;
  for (const double number : angles ? numbers_of_angles(*angles, columns.form)
                                    : numbers_of(written_orientation(motion.orientation, columns), columns.form))
    row.add(number);
  if (columns.positions) row.add(linear_motion.position);
  for (int order = 1; order <= columns.derivatives; ++order) row.add(rate_of(motion, order, columns.frame));
  if (columns.position_derivatives > 0) row.add(linear_motion.velocity);
  if (columns.position_derivatives > 1) row.add(linear_motion.acceleration);
  for (std::size_t side = 0; side < inner.size(); ++side)
    if (columns.inner[side])
      for (const double number : numbers_of(written_orientation(inner[side], columns), {})) row.add(number);
  if (columns.band) row.add_band(band);
  for (const double setting : settings) row.add(setting);
  return row;
}

void RowNumbers::add(const Eigen::Vector3d& v) noexcept {
  for (const double number : v) add(number);
}

void RowNumbers::add_band(double value) noexcept {
  band_ = count_;
  add(value);
}

bool RowNumbers::are_finite() const noexcept {
  for (std::size_t i = 0; i < count_; ++i)
    if (!std::isfinite(values_[i]) && !(i == band_ && std::isinf(values_[i]))) return false;
  return true;
}

}}}  // namespace orispline::io
