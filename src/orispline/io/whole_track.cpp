// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/whole_track.hpp>

#include <algorithm>
#include <set>
#include <utility>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr int highest_order = 3;  // of rates that keys may have

/// With the columns that the families take.
ReadOptions read_for(std::span<const FamilyInfo* const> families, ReadOptions options) {
  std::set<std::string> parameters;
  options.rate_orders = 0;
  for (const FamilyInfo* const family : families) {
    options.rate_orders = std::max(options.rate_orders, family->rate_orders);
    options.inner_quaternions |= family->takes_inner_quaternions();
    for (const Parameter& parameter : family->parameters) parameters.emplace(parameter.name);
  }
  options.parameters = {parameters.begin(), parameters.end()};
  options.parameters.insert(options.parameters.end(), band_columns.begin(), band_columns.end());
  options.world_rates = true;
  return options;
}

/// With the columns that any family takes, those too that are `named`: which one the keys are for is not known yet.
ReadOptions read_for_all(std::vector<const FamilyInfo*> named, std::span<const FamilyInfo> all, ReadOptions options) {
  for (const FamilyInfo& family : all) named.push_back(&family);
  options = read_for(named, std::move(options));
  options.rate_orders = highest_order;
  return options;
}

bool has_more_than_motion(const TrackFile& file) {
  const Keyframes& keys = file.track.keys;
  return !file.track.settings.empty() || !keys.angular_velocities().empty() || !keys.inner_leaving().empty() ||
         !keys.inner_arriving().empty();
}

Warning left_out(const std::string& path, const std::string& reason) {
  return {
      .code = "columns_left_out",
      .message =
          "columns of rates, inner quaternions or settings are left out, since they are not those of keys: " + reason,
      .where = {.file = path}};
}

Warning lost(const FormatInfo& format, const std::string& what, const std::string& path) {
  return {.code = "not_written",
          .message = std::string(format.file) + " has no columns for " + what + ", which are left out",
          .where = {.file = path}};
}

}  // namespace

Expected<TrackFile> read_whole_track(const Input& from, Reading reading, const CurvesOfKeys& curves) {
  reading.options.keep_exact_times = reading.options.keep_as_read = true;
  auto input = KeyInput::open(from, reading.options);
  if (!input) return tl::unexpected(std::move(input.error()));
  const auto family = curves.named(input->recipe(), from.name());
  if (!family) return tl::unexpected(family.error());
  const std::vector<const FamilyInfo*> named(*family ? 1 : 0, family->get());
  auto file = read_track(std::move(*input), read_for_all(named, curves.families, reading.options), reading.signs);
  const bool is_whole = file && (!has_more_than_motion(*file) || file->repairs.invalid_dropped == 0);
  if (is_whole || from.is_standard_input()) return file;
  auto plain = read_track(from, read_for(named, std::move(reading.options)), reading.signs);
  if (!plain || (file && file->track.keys.size() == plain->track.keys.size())) return file ? file : plain;
  plain->warnings.push_back(left_out(from.name(), file ? "some have no numbers" : curves.words(file.error())));
  return plain;
}

Expected<std::vector<Warning>> write_whole_track(OutputFile& file, Track track, SampleColumns columns) {
  const FormatInfo& format = *columns.format;
  columns.positions = !track.keys.positions().empty();
  columns.derivatives = format.holds.rates ? highest_order : 0;
  // Digits are those of quaternions: other forms are those of a unit quaternion.
  if (columns.form.representation != Representation::quaternion) track.as_read.clear();
  std::vector<Warning> warnings;
  const std::string& path = file.path();
  if (const auto warning = recipe_not_stated(track, columns, path)) warnings.push_back(*warning);
  if (!format.holds.rates && !track.keys.angular_velocities().empty()) warnings.push_back(lost(format, "rates", path));
  if (!format.holds.rates && track.keys.have_inner_quaternions())
    warnings.push_back(lost(format, "inner quaternions", path));
  if (!format.holds.settings && !track.settings.empty()) {  // without them the keys are for another curve
    warnings.push_back(lost(format, "settings", path));
    track.settings.clear();
    track.recipe = {};
  }
  return write_tracks(file, {&track, 1}, columns).map([&] { return std::move(warnings); });
}

}}}  // namespace orispline::io
