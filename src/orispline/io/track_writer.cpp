// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/track_file.hpp>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/io/key_table.hpp>
#include <orispline/io/recipe_line.hpp>
#include <orispline/io/sample_writer.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

/// The highest order that there is.
int rate_orders_of(const Keyframes& keys) {
  if (!keys.angular_jerks().empty()) return 3;
  if (!keys.angular_accelerations().empty()) return 2;
  return keys.angular_velocities().empty() ? 0 : 1;
}

/// A rate that the keys of this track may not have.
Eigen::Vector3d rate_at(std::span<const Eigen::Vector3d> rates, std::size_t key) {
  return rates.empty() ? free_rate() : rates[key];
}

/// Those that the keys of a track fill.
SampleColumns columns_for(const Track& track, SampleColumns columns) {
  columns.positions = !track.keys.positions().empty();
  columns.derivatives = std::min(columns.derivatives, rate_orders_of(track.keys));
  columns.position_derivatives = 0;
  const bool has_room = columns.format->holds.rates;
  columns.inner = {has_room && !track.keys.inner_leaving().empty(), has_room && !track.keys.inner_arriving().empty()};
  columns.settings.clear();
  for (const auto& [name, values] : track.settings) columns.settings.push_back(name);
  return columns;
}

Sample sample_at(const Track& track, const SampleColumns& columns, std::size_t key) {
  const Keyframes& keys = track.keys;
  Sample sample{.motion = {.orientation = track.written(key)}};
  if (columns.positions) sample.linear_motion.position = keys.positions()[key];
  if (columns.derivatives > 0) sample.motion.angular_velocity = rate_at(keys.angular_velocities(), key);
  if (columns.derivatives > 1) sample.motion.angular_acceleration = rate_at(keys.angular_accelerations(), key);
  if (columns.derivatives > 2) sample.motion.angular_jerk = rate_at(keys.angular_jerks(), key);
  if (columns.inner[0]) sample.inner[0] = keys.inner_leaving()[key];
  if (columns.inner[1]) sample.inner[1] = keys.inner_arriving()[key];
  return sample;
}

/// Angles that run on do so by the shorter way of each step.
bool goes_short_ways(const Keyframes& keys) {
  const auto q = keys.orientations();
  for (std::size_t i = 0; i + 1 < q.size(); ++i)
    if (q[i].dot(q[i + 1]) < 0.0) return false;
  return true;
}

/// What a file would need so that its keys give the curve of their recipe; nothing if there is all.
std::optional<std::string_view> lacking_for_recipe(const Track& track, const SampleColumns& columns) {
  const FormatInfo& format = *columns.format;
  const bool keeps_signs = columns.form.representation == Representation::quaternion ||
                           columns.form.representation == Representation::rotation_vector ||
                           (columns.form.runs_on() && goes_short_ways(track.keys));
  if (!format.holds.comments) return "comments";
  if (track.recipe.signs == Signs::as_given && !keeps_signs) return "signs in this form of orientations";
  if (!format.holds.rates && rate_orders_of(track.keys) > 0) return "columns for rates";
  if (!format.holds.rates && track.keys.have_inner_quaternions()) return "columns for inner quaternions";
  if (!format.holds.settings && !track.settings.empty()) return "columns for settings";
  return std::nullopt;
}

Expected<void> write_rows(OutputFile& file, const Track& track, const SampleColumns& columns) {
  SampleRows rows(columns, MissingSamples::free_rates);
  std::vector<double> settings(track.settings.size());
  for (std::size_t key = 0; key < track.keys.size(); ++key) {
    std::ranges::transform(track.settings, settings.begin(), [key](const auto& column) { return column.second[key]; });
    Sample sample = sample_at(track, columns, key);
    sample.settings = settings;
    if (auto appended = rows.append(track.time_of(key), sample); !appended) {
      appended.error().where.key = key;
      return tl::unexpected(track.located(std::move(appended.error())));
    }
    if (rows.bytes().size() < written_block) continue;
    if (auto written = file.write(rows.bytes()); !written) return written;
    rows.clear();
  }
  return file.write(rows.bytes());
}

}  // namespace

bool states_recipe(const Track& track, const SampleColumns& columns) { return !lacking_for_recipe(track, columns); }

std::optional<Warning> recipe_not_stated(const Track& track, const SampleColumns& columns, std::string_view file) {
  const auto lacking = lacking_for_recipe(track, columns);
  if (track.recipe.method.empty() || !lacking) return std::nullopt;
  return Warning{
      .code = "recipe_not_stated",
      .message = formatted(
          "{} has no {}, so it does not say that its keys are for {}; name the method where the keys are read",
          columns.format->file, *lacking, track.recipe.method),
      .where = {.file = std::string(file)}};
}

Expected<void> write_tracks(OutputFile& file, std::span<const Track> tracks, const SampleColumns& columns) {
  const FormatInfo& format = *columns.format;
  if (format.writing.tracks) return format.writing.tracks(file, tracks, columns);
  if (tracks.size() != 1)
    return failure(ErrorCode::bad_argument, formatted("found {} tracks, and {} holds one", tracks.size(), format.file),
                   {.file = file.path()});
  const Track& track = tracks.front();
  const std::string comment = states_recipe(track, columns) ? recipe_line(track.recipe) : "";
  if (format.writing.table && !track.table.rows.empty())
    return file.write(comment + format.writing.table(track.table, track.settings));
  const SampleColumns filled = columns_for(track, columns);
  return check_columns(filled)
      .and_then([&] { return file.write(comment + header_of(filled, track.keys.size())); })
      .and_then([&] { return write_rows(file, track, filled); });
}

}}}  // namespace orispline::io
