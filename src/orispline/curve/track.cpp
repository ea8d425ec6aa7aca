// SPDX-License-Identifier: Apache-2.0
#include <orispline/curve/track.hpp>

#include <cmath>
#include <utility>

#include <orispline/base/date_text.hpp>
#include <orispline/curve/key_parts.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double rounding = 1e-15;  // of the components of a unit quaternion

/// The place with the name of the track and, where it is a key, its line.
Where in_file(Where where, const Track& track) {
  where.file = track.name;
  if (where.key && *where.key < track.lines.size()) where.line = track.lines[*where.key];
  return where;
}

}  // namespace

Decimal Track::time_of(std::size_t key) const {
  return exact_times.empty() ? epoch + Decimal::from_double(keys.times()[key]) : exact_times[key];
}

std::string Track::time_text(const Decimal& time) const { return is_dated ? date_text(time) : time.to_string() + " s"; }

std::string Track::span_text(const Decimal& from, const Decimal& to) const {
  return (is_dated ? date_text(from) : from.to_string()) + " to " + time_text(to);
}

Eigen::Quaterniond Track::written(std::size_t key) const {
  const Eigen::Quaterniond& q = keys.orientations()[key];
  if (as_read.empty()) return q;
  const double sign = as_read[key].dot(q) < 0.0 ? -1.0 : 1.0;
  const Eigen::Quaterniond turned(sign * as_read[key].coeffs());
  const bool is_the_same = std::abs(turned.norm() - 1.0) <= unit_norm_tolerance &&
                           (turned.coeffs().normalized() - q.coeffs()).norm() <= rounding;
  return is_the_same ? turned : q;
}

Track Track::at(std::span<const std::size_t> indices) const {
  Track some(keys.at(indices));
  some.name = name;
  some.epoch = epoch;
  some.is_dated = is_dated;
  some.lines = entries_at(lines, indices);
  some.exact_times = entries_at(exact_times, indices);
  for (const auto& [parameter, values] : settings) some.settings.emplace(parameter, entries_at(values, indices));
  some.as_read = entries_at(as_read, indices);
  some.table = {table.names, entries_at(table.rows, indices)};
  some.forget_band();
  return some;
}

Track Track::with_keys(const Keyframes& others) const {
  Track track = *this;
  track.keys = others;
  track.table = {};
  return track;
}

Expected<Track> Track::with_times(std::vector<double> times) const {
  return keys.with_times(std::move(times)).map([this](const Keyframes& moved) {
    Track track = with_keys(moved);
    track.exact_times.clear();
    track.forget_band();
    return track;
  });
}

void Track::forget_band() {
  for (const std::string_view column_name : band_columns)
    if (const auto column = settings.find(column_name); column != settings.end()) settings.erase(column);
}

Error Track::located(Error error) const {
  error.where = in_file(std::move(error.where), *this);
  return error;
}

Warning Track::located(Warning warning) const {
  if (warning.where.key) warning.where = in_file(std::move(warning.where), *this);
  return warning;
}

std::map<std::string, std::vector<double>, std::less<>> settings_per_key(const Method& method, std::size_t keys) {
  std::map<std::string, std::vector<double>, std::less<>> found;
  for (const auto& [name, values] : method.options.parameters)
    if (keys > 1 && values.size() == keys) found.emplace(name, values);
  return found;
}

Method completed(Method method, const FamilyInfo& family, const Track& track) {
  for (const Parameter& parameter : family.parameters)
    if (const auto column = track.settings.find(parameter.name); column != track.settings.end())
      method.options.parameters.insert(*column);  // which keeps what is there
  return method;
}

}}  // namespace orispline
