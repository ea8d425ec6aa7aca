// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_rows.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/key_parts.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/io/clock.hpp>
#include <orispline/io/row_reader.hpp>
#include <orispline/io/time_column.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

Expected<void> check_width(const TextTable& table, std::size_t width) {
  const auto cells = table.cells();
  const auto is_empty = [](std::string_view cell) { return cell.empty(); };
  if (cells.size() >= width && std::all_of(cells.begin() + static_cast<std::ptrdiff_t>(width), cells.end(), is_empty))
    return {};
  return failure(ErrorCode::bad_data,
                 formatted("found {} cell{}, wanted {}", cells.size(), cells.size() == 1 ? "" : "s", width),
                 table.here());
}

/// Where the rates of each order go.
constexpr std::array rates_of_keys{&KeyframeData::angular_velocities, &KeyframeData::angular_accelerations,
                                   &KeyframeData::angular_jerks};

/// Where the inner quaternions of either side go.
constexpr std::array inner_of_keys{&KeyframeData::inner_leaving, &KeyframeData::inner_arriving};

/// The rates in the body frame of a key at this orientation, of any norm.
std::array<Eigen::Vector3d, 3> body_rates(const KeyRow& key, const RateColumns& columns,
                                          const Eigen::Quaterniond& orientation) {
  const Eigen::Quaterniond q = orientation.normalized();
  std::array<Eigen::Vector3d, 3> rates = key.rates;
  const auto is_in_world = [&columns](std::size_t k) { return columns[k] && columns[k]->frame == Frame::world; };
  for (std::size_t k = 0; k < rates.size(); ++k)
    if (is_in_world(k)) rates[k] = to_body<double>(q, rates[k]);
  if (is_in_world(2)) rates[2] -= transport_of_jerk(rates[0], rates[1]);
  return rates;
}

/// A vector turned, unless keys refuse it as too long: its sums could be NaN, which stands for a free rate.
template <class Turn>
Eigen::Vector3d turned_for_keys(const Eigen::Vector3d& v, Turn turn) {
  return v.cwiseAbs().maxCoeff() > largest_component ? v : Eigen::Vector3d(turn(v));
}

/// Where the body is that has the world's origin there, in its own frame. `orientation`: of the body, of any norm.
Eigen::Vector3d place_of_body(const Eigen::Quaterniond& orientation, const Eigen::Vector3d& origin) {
  return Eigen::Vector3d::Zero() - to_world<double>(orientation.normalized(), origin);
}

/// A jerk in the frame of the world is turned into the body's by the rates of lower orders, which must not be free.
Expected<void> check_turned_jerk(const KeyRow& key, const RateColumns& columns, const TextTable& table) {
  if (!columns[2] || columns[2]->frame != Frame::world || is_free(key.rates[2])) return {};
  if (!is_free(key.rates[0]) && !is_free(key.rates[1])) return {};
  return failure(ErrorCode::bad_data,
                 "found an angular jerk in the frame of the world without the angular velocity and acceleration of its "
                 "key, wanted them as well, or the jerk left free",
                 table.here(columns[2]->columns[0].index));
}

/// Rows that stand after a row of later time.
std::size_t late_rows(const std::vector<Decimal>& times) {
  std::size_t late = 0;
  const Decimal* latest = &times.front();
  for (const Decimal& time : times) {
    if (time < *latest) ++late;
    else latest = &time;
  }
  return late;
}

}  // namespace

Error norm_refused(double norm, Where where) {
  const auto message = formatted("the quaternion has norm {:.6g}, wanted 1 within {:g}", norm, loose_norm_limit);
  return mended_by("norms", message, std::move(where)).value();
}

KeyRows::KeyRows(std::string path, const FormatInfo& format, KeyColumns columns, const ReadOptions& options)
    : columns_(std::move(columns)), options_(options), frames_(options.frames) {
  file_.path = std::move(path);
  file_.format = &format;
  file_.ignored_columns = columns_.ignored;
  if (!options_.count_rows) return;
  columns_.counts_rows = columns_.states_time_unit = true;
  columns_.time_unit = Fraction();
}

Expected<void> KeyRows::add(const TextTable& table) {
  const auto refused = [this](Error error) {
    if (!options_.sort) error.where.key = taken_ + size();  // before sorting a row has no index yet
    return tl::unexpected(std::move(error));
  };
  if (auto checked = check_width(table, columns_.width); !checked) return refused(std::move(checked.error()));
  RowReader row(table, options_);
  KeyRow key = row.key(columns_);
  if (columns_.counts_rows) key.time = Decimal::from_double(static_cast<double>(taken_ + size()));
  if (row.refused()) return refused(*row.refused());
  if (auto error = row.not_finite()) {
    if (!options_.drop_invalid) return refused(std::move(*error));
    ++file_.repairs.invalid_dropped;
    return {};
  }
  if (auto settled = settle_clock(table); !settled) return refused(std::move(settled.error()));
  if (!key.is_posed) {
    if (auto added = add_unposed(key, table); !added) return refused(std::move(added.error()));
    return {};
  }
  const auto unit = orientation_of(key.orientation, table.here());
  if (!unit) return refused(unit.error());
  std::array<Eigen::Quaterniond, inner_of_keys.size()> inner = key.inner;
  for (std::size_t side = 0; side < inner.size(); ++side) {
    if (!columns_.inner[side] || is_free_inner(inner[side])) continue;
    auto found = orientation_of(inner[side], table.here((*columns_.inner[side])[0].index));
    if (!found) return refused(std::move(found.error()));
    inner[side] = *found;
  }
  if (auto turned = check_turned_jerk(key, columns_.rates, table); !turned) return refused(std::move(turned.error()));
  if (options_.sort) {
    times_.push_back(key.time);
  } else {
    const auto appended = append_time(key.time, table.cells()[columns_.time], table.line());
    if (!appended) return tl::unexpected(appended.error());
    if (!*appended) return {};
  }
  file_.lines.push_back(static_cast<std::uint32_t>(table.line()));
  if (options_.keep_table) {
    const auto cells = table.cells().first(columns_.width);
    file_.table.rows.emplace_back(cells.begin(), cells.end());
  }
  append_motion(key, *unit);
  for (std::size_t side = 0; side < inner.size(); ++side)
    if (columns_.inner[side]) (file_.data.*inner_of_keys[side]).push_back(frames_.orientation(inner[side]));
  for (std::size_t i = 0; i < key.parameters.size(); ++i)
    file_.parameters[columns_.parameters[i].name].push_back(key.parameters[i]);
  return {};
}

/// The orientation, body to world, that a quaternion of the file states.
Expected<Eigen::Quaterniond> KeyRows::orientation_of(const Eigen::Quaterniond& stated, Where where) {
  return normalised(stated, std::move(where)).map([this](const Eigen::Quaterniond& unit) {
    return options_.conjugate || options_.inverse_poses ? unit.conjugate() : unit;
  });
}

/// Appends the orientation of the row, body to world, with its position and rates.
void KeyRows::append_motion(const KeyRow& key, const Eigen::Quaterniond& orientation) {
  if (key.angles) turns_.add(*key.angles, orientation);
  file_.data.orientations.push_back(frames_.orientation(orientation));
  if (columns_.position)
    file_.data.positions.push_back(turned_for_keys(key.position, [&](const Eigen::Vector3d& p) {
      return frames_.in_world<double>(options_.inverse_poses ? place_of_body(orientation, p) : p);
    }));
  const auto rates = body_rates(key, columns_.rates, orientation);
  for (std::size_t k = 0; k < rates.size(); ++k)
    if (columns_.rates[k])
      (file_.data.*rates_of_keys[k]).push_back(turned_for_keys(rates[k], [&](const Eigen::Vector3d& rate) {
        return frames_.body_rate(rate);
      }));
  if (std::ranges::any_of(rates, is_free)) ++file_.repairs.rates_left_free;
}

/// Of the rows that are set aside the order is theirs alone.
Expected<void> KeyRows::add_unposed(const KeyRow& key, const TextTable& table) {
  if (columns_.rates[0]->frame == Frame::world)
    return failure(
        ErrorCode::bad_data,
        "found a rate in the frame of the world without the orientation that turns it into the body's, wanted "
        "both, or rates of the body",
        table.here(columns_.rates[0]->columns[0].index));
  settle_time_unit(key.time);
  RateRows& rows = file_.unposed;
  const Decimal time = columns_.time_unit.time_of(key.time);
  if (!rows.exact_times.empty() && time <= rows.exact_times.back() && !options_.sort)
    return mended_by("sort",
                     formatted("time {} does not come after {}, wanted increasing times", time.to_string(),
                               rows.exact_times.back().to_string()),
                     table.here(columns_.time));
  rows.exact_times.push_back(time);
  rows.rates.push_back(
      turned_for_keys(key.rates[0], [this](const Eigen::Vector3d& rate) { return frames_.body_rate(rate); }));
  rows.lines.push_back(static_cast<std::uint32_t>(table.line()));
  return {};
}

/// A quaternion that is near enough to norm 1 for keys.
Expected<Eigen::Quaterniond> KeyRows::normalised(Eigen::Quaterniond q, Where where) {
  const double norm = q.coeffs().stableNorm(), off = std::abs(norm - 1.0);
  if (off <= norm_error_limit || options_.norms == Norms::as_they_are) return q;
  if (norm == 0.0) return failure(ErrorCode::bad_data, "the quaternion is zero, wanted a rotation", std::move(where));
  if (!std::isfinite(norm)) return tl::unexpected(norm_refused(norm, std::move(where)));
  if (options_.norms == Norms::near_one && off > loose_norm_limit + 1e-12)
    return tl::unexpected(norm_refused(norm, std::move(where)));
  ++file_.repairs.normalised;
  file_.repairs.largest_norm_error = std::max(file_.repairs.largest_norm_error, off);
  q.coeffs() /= norm;
  return q;
}

/// Times of ISO 8601 are seconds, and a file has them in all rows or in none.
Expected<void> KeyRows::settle_clock(const TextTable& table) {
  if (columns_.counts_rows) return {};
  const std::string_view cell = table.cells()[columns_.time];
  const bool is_iso = looks_like_iso_time(cell);
  if (has_iso_times_ && *has_iso_times_ != is_iso)
    return failure(ErrorCode::bad_data,
                   formatted("found {}, wanted {} as in the rows before", in_quotes(cell),
                             is_iso ? "a number" : "a time of ISO 8601"),
                   table.here(columns_.time));
  if (is_iso && options_.time_scale)
    return bad_option("time_scale", formatted("found {}, which needs no scale, wanted numbers", in_quotes(cell)));
  if (is_iso && !has_iso_times_) {
    columns_.time_unit = Fraction();
    columns_.states_time_unit = true;
  }
  has_iso_times_ = is_iso;
  return {};
}

void KeyRows::settle_time_unit(const Decimal& first) {
  if (columns_.states_time_unit) return;
  columns_.states_time_unit = true;
  if (auto guess = time_unit_by_size(first)) {
    columns_.time_unit = guess->seconds;
    guess->warning.where.file = file_.path;
    file_.warnings.push_back(std::move(guess->warning));
  }
}

/// Appends the time of the next key; false for a duplicate that is dropped. `text`: the time in the file, if at hand.
Expected<bool> KeyRows::append_time(const Decimal& time, std::string_view text, std::size_t line) {
  std::vector<double>& times = file_.data.times;
  const bool is_first = taken_ + times.size() == 0;
  const auto refused = [&](std::string message, std::string_view remedy = {}) {
    return mended_by(remedy, std::move(message), {file_.path, line, std::nullopt, taken_ + times.size()});
  };
  const auto shown = [&] { return text.empty() ? time.to_string() : std::string(text); };
  if (is_first) {
    settle_time_unit(time);
    first_ = time;
    file_.epoch = columns_.time_unit.time_of(first_);
  } else if (time < latest_)
    return refused(formatted("time {} comes after {}, wanted increasing times", shown(), latest_.to_string()), "sort");
  else if (time == latest_) {
    if (!options_.drop_duplicates)
      return refused(formatted("duplicate time {}, as in line {}, wanted increasing times", shown(), latest_line_),
                     "drop_duplicates");
    ++file_.repairs.duplicates_dropped;
    return false;
  }

  const double seconds = columns_.time_unit.of(time - first_).to_double();
  if (!is_first && seconds <= latest_seconds_)
    return refused(
        formatted("time {} is too near to {} to be told apart in double precision, wanted keys farther apart", shown(),
                  latest_.to_string()));
  times.push_back(seconds);
  if (options_.keep_exact_times) file_.exact_times.push_back(columns_.time_unit.time_of(time));
  latest_ = time;
  latest_seconds_ = seconds;
  latest_line_ = line;
  return true;
}

/// Brings the gathered rows into the order of their times.
Expected<void> KeyRows::sort() {
  std::vector<std::uint32_t> places(times_.size());
  std::iota(places.begin(), places.end(), std::uint32_t{0});
  file_.repairs.rows_moved = late_rows(times_);
  if (file_.repairs.rows_moved > 0)
    std::stable_sort(places.begin(), places.end(), [this](auto a, auto b) { return times_[a] < times_[b]; });

  std::vector<std::uint32_t> kept;
  kept.reserve(places.size());
  for (const std::uint32_t place : places) {
    const auto appended = append_time(times_[place], {}, file_.lines[place]);
    if (!appended) return tl::unexpected(appended.error());
    if (*appended) kept.push_back(place);
  }
  file_.lines = entries_at(file_.lines, kept);
  file_.table.rows = entries_at(file_.table.rows, kept);
  file_.data.orientations = entries_at(file_.data.orientations, kept);
  for_each_part([&](const auto& part) { file_.data.*part.list = entries_at(file_.data.*part.list, kept); });
  for (auto& [name, values] : file_.parameters) values = entries_at(values, kept);
  return {};
}

/// Likewise of those that are set aside.
Expected<void> KeyRows::sort_unposed() {
  RateRows& rows = file_.unposed;
  std::vector<std::uint32_t> places(rows.lines.size());
  std::iota(places.begin(), places.end(), std::uint32_t{0});
  std::stable_sort(places.begin(), places.end(),
                   [&rows](auto a, auto b) { return rows.exact_times[a] < rows.exact_times[b]; });
  rows.exact_times = entries_at(rows.exact_times, places);
  rows.rates = entries_at(rows.rates, places);
  rows.lines = entries_at(rows.lines, places);
  const auto same = std::ranges::adjacent_find(rows.exact_times);
  if (same == rows.exact_times.end()) return {};
  return failure(
      ErrorCode::bad_data, formatted("duplicate time {}, wanted increasing times", same->to_string()),
      {.file = file_.path, .line = rows.lines[static_cast<std::size_t>(same - rows.exact_times.begin()) + 1]});
}

Expected<void> KeyRows::complete() {
  if (taken_ + size() == 0) {
    const std::size_t dropped = file_.repairs.invalid_dropped;
    const std::string reason = dropped > 0 ? formatted(" (all {} rows were dropped as invalid)", dropped) : "";
    return failure(ErrorCode::bad_data, "empty: no keys" + reason, {.file = file_.path});
  }
  turns_.finish();
  if (!options_.sort) return {};
  if (auto sorted = sort_unposed(); !sorted) return sorted;
  return sort();
}

KeyFile KeyRows::take() {
  taken_ += size();
  if (columns_.form.representation == Representation::euler && file_.repairs.rows_moved == 0) {
    file_.turns = turns_;
    file_.euler = columns_.form.order;
  }
  KeyFile rest;
  rest.path = file_.path;
  rest.format = file_.format;
  rest.epoch = file_.epoch;
  rest.repairs = file_.repairs;
  rest.ignored_columns = file_.ignored_columns;
  return std::exchange(file_, std::move(rest));
}

}}}  // namespace orispline::io
