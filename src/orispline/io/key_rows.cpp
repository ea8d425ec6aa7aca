// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/key_rows.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/key_parts.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/io/clock.hpp>
#include <orispline/io/rates_order.hpp>
#include <orispline/io/time_column.hpp>
#include <orispline/math/euler.hpp>
#include <orispline/math/median.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr double full_turn = 2.0 * std::numbers::pi;
constexpr double long_step = 1000.0;  // [s]
constexpr std::size_t most_times_to_tell = 1000;

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

/// A jerk in the frame of the world is turned into the body's by the rates of lower orders, which must not be free.
Expected<void> check_turned_jerk(const KeyRow& key, const RateColumns& columns, const TextTable& table) {
  if (!columns[2] || columns[2]->frame != Frame::world || is_free(key.rates[2])) return {};
  if (!is_free(key.rates[0]) && !is_free(key.rates[1])) return {};
  return failure(ErrorCode::bad_data,
                 "found an angular jerk in the frame of the world without the angular velocity and acceleration of its "
                 "key, wanted them as well, or the jerk left free",
                 table.here(columns[2]->columns[0].index));
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
  if (!columns_.commented_header.empty())
    file_.warnings.push_back(commented_header(columns_.commented_header, file_.path));
  // A set of rows has no clock; and of a pose turned back the position needs the orientation.
  may_be_parts_ = !options_.count_rows && !options_.inverse_poses;
  if (!options_.count_rows) return;
  columns_.counts_rows = columns_.states_time_unit = true;
  columns_.time_unit = Fraction();
}

KeyRows::Place KeyRows::place_of(const TextTable& table) const {
  return {table.line(), table.cells()[columns_.time], table.cells().first(columns_.width)};
}

Where KeyRows::where(std::size_t line, std::optional<std::size_t> column) const {
  return {.file = file_.path, .line = line, .column = column};
}

/// Before sorting a row has no index yet.
Expected<void> KeyRows::refused(Error error) const {
  if (!needs_all()) error.where.key = taken_ + size();
  return tl::unexpected(std::move(error));
}

Expected<void> KeyRows::add(const TextTable& table) {
  if (unrising_) return look_ahead(table);
  if (auto checked = check_width(table, columns_.width); !checked) return refused(std::move(checked.error()));
  RowReader row(table, options_);
  KeyRow key = row.key(columns_);
  if (columns_.counts_rows) key.time = Decimal::from_double(static_cast<double>(taken_ + size()));
  if (row.refused()) return refused(*row.refused());
  if (auto error = row.not_finite()) {
    if (key.lacks != KeyRow::Lacks::nothing && may_be_parts_) return add_part(std::move(key), std::move(*error), table);
    if (!options_.drop_invalid) return refused(parts_.empty() ? std::move(*error) : parts_.front().missing);
    ++file_.repairs.invalid_dropped;
    return {};
  }
  if (auto settled = settle_clock(key, table); !settled) return refused(std::move(settled.error()));
  if (!key.is_posed) {
    if (auto added = add_unposed(key, table); !added) return refused(std::move(added.error()));
    return {};
  }
  if (auto settled = settle_parts(); !settled) return settled;
  if (options_.drop_invalid && key.orientation.coeffs().isZero(0.0)) {
    ++file_.repairs.invalid_dropped;
    return {};
  }
  if (auto turned = check_turned_jerk(key, columns_.rates, table); !turned) return refused(std::move(turned.error()));
  if (options_.inverse_poses && columns_.position)
    key.position = turned_for_keys(key.position, [&key](const Eigen::Vector3d& origin) {
      return place_of_body(key.orientation.conjugate(), origin);
    });
  return options_.count_turns ? append_between(key, place_of(table)) : append(key, place_of(table));
}

/// Appends a row with the position of the body.
Expected<void> KeyRows::append(const KeyRow& key, const Place& place) {
  const auto orientation = orientation_of(key.orientation, place.line);
  if (!orientation) return refused(orientation.error());
  const auto inner = inner_of(key, place.line);
  if (!inner) return refused(inner.error());
  const Pose pose{*orientation, key.position, columns_.rates[0] ? key.rates[0] : free_rate()};
  if (needs_all()) {
    times_.push_back(key.time);
  } else {
    const auto appended = append_time(key.time, place.time, place.line, pose);
    if (!appended) return tl::unexpected(appended.error());
    if (!*appended) return {};
  }
  if (key.matrix_distance > 0.0) {
    ++file_.repairs.normalised;
    file_.repairs.largest_matrix_distance = std::max(file_.repairs.largest_matrix_distance, key.matrix_distance);
  }
  file_.lines.push_back(static_cast<std::uint32_t>(place.line));
  if (options_.keep_table) file_.table.rows.emplace_back(place.cells.begin(), place.cells.end());
  append_motion(key, *orientation);
  for (std::size_t side = 0; side < inner->size(); ++side)
    if (columns_.inner[side]) (file_.data.*inner_of_keys[side]).push_back(frames_.orientation((*inner)[side]));
  for (std::size_t i = 0; i < key.parameters.size(); ++i)
    file_.parameters[columns_.parameters[i].name].push_back(key.parameters[i]);
  return {};
}

/// The orientation, body to world, that a quaternion of the file states.
Expected<Eigen::Quaterniond> KeyRows::orientation_of(const Eigen::Quaterniond& stated, std::size_t line,
                                                     std::optional<std::size_t> column) {
  return normalised(stated, line, column).map([this](const Eigen::Quaterniond& unit) {
    return options_.conjugate || options_.inverse_poses ? unit.conjugate() : unit;
  });
}

/// The inner quaternions of the row, made unit and conjugated in the same way.
Expected<KeyRows::InnerQuaternions> KeyRows::inner_of(const KeyRow& key, std::size_t line) {
  InnerQuaternions inner = key.inner;
  for (std::size_t side = 0; side < inner.size(); ++side) {
    if (!columns_.inner[side] || is_free_inner(inner[side])) continue;
    auto found = orientation_of(inner[side], line, (*columns_.inner[side])[0].index + 1);
    if (!found) return tl::unexpected(std::move(found.error()));
    inner[side] = *found;
  }
  return inner;
}

/// Appends the orientation of the row, body to world, with its position and rates.
void KeyRows::append_motion(const KeyRow& key, const Eigen::Quaterniond& orientation) {
  if (key.angles) turns_.add(*key.angles, orientation);
  file_.data.orientations.push_back(frames_.orientation(orientation));
  if (columns_.position && key.lacks != KeyRow::Lacks::position)
    file_.data.positions.push_back(position_in_world(key.position));
  const auto rates = body_rates(key, columns_.rates, orientation);
  for (std::size_t k = 0; k < rates.size(); ++k)
    if (columns_.rates[k])
      (file_.data.*rates_of_keys[k]).push_back(turned_for_keys(rates[k], [&](const Eigen::Vector3d& rate) {
        return frames_.body_rate(rate);
      }));
  const auto is_left_free = [this, &rates](std::size_t k) { return columns_.rates[k] && is_free(rates[k]); };
  if (is_left_free(0) || is_left_free(1) || is_left_free(2)) ++file_.repairs.rates_left_free;
}

Eigen::Vector3d KeyRows::position_in_world(const Eigen::Vector3d& stated) const {
  return turned_for_keys(stated, [this](const Eigen::Vector3d& p) { return frames_.in_world<double>(p); });
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
  rows.exact_times.push_back(columns_.time_unit.time_of(key.time));
  rows.rates.push_back(
      turned_for_keys(key.rates[0], [this](const Eigen::Vector3d& rate) { return frames_.body_rate(rate); }));
  rows.lines.push_back(static_cast<std::uint32_t>(table.line()));
  return {};
}

/// The row, and before it those that a quaternion needs to hold the turns from the last row to it: each step is then a
/// third of a turn at most, which is told from its way back.
Expected<void> KeyRows::append_between(const KeyRow& key, const Place& place) {
  if (before_ && key.time > before_->time) {
    const Eigen::Vector3d turn = *key.angles - *before_->angles;
    const double parts = std::ceil(3.0 * turn.lpNorm<1>() / full_turn - 1e-9);
    if (turn.lpNorm<1>() > full_turn - 1e-9)
      for (double part = 1.0; part < parts; ++part) {
        KeyRow between = *before_;
        const double share = part / parts;
        const Fraction of_interval(Decimal::from_double(part), Decimal::from_double(parts));
        between.time = before_->time + of_interval.time_of(key.time - before_->time);
        between.angles = *before_->angles + share * turn;
        between.orientation = quaternion_from_euler(columns_.form.order, *between.angles);
        between.position = before_->position + share * (key.position - before_->position);
        between.rates.fill(free_rate());
        between.inner.fill(free_inner());
        ++file_.repairs.rows_between;
        if (auto appended = append(between, {place.line, {}, place.cells}); !appended) return appended;
      }
  }
  before_ = key;
  return append(key, place);
}

/// Keeps a row with an orientation or a position only, until it is known whether that is so of all rows.
Expected<void> KeyRows::add_part(KeyRow key, Error missing, const TextTable& table) {
  if (auto settled = settle_clock(key, table); !settled) return refused(std::move(settled.error()));
  const Place place = place_of(table);
  parts_.push_back({std::move(key),
                    std::move(missing),
                    place.line,
                    std::string(place.time),
                    {place.cells.begin(), place.cells.end()}});
  return {};
}

/// A row has both: those before it are rows without what is needed.
Expected<void> KeyRows::settle_parts() {
  may_be_parts_ = false;
  if (parts_.empty()) return {};
  if (!options_.drop_invalid) return refused(parts_.front().missing);
  file_.repairs.invalid_dropped += parts_.size();
  parts_.clear();
  return {};
}

/// No row has both an orientation and a position: the keys are those with orientations, the others a track beside them.
Expected<void> KeyRows::take_two_tracks() {
  const auto lacks = [](KeyRow::Lacks what) { return [what](const Part& part) { return part.key.lacks == what; }; };
  const auto with_orientation = std::ranges::count_if(parts_, lacks(KeyRow::Lacks::position));
  if (with_orientation == 0 || with_orientation == std::ssize(parts_) || needs_all()) return settle_parts();
  const std::vector<Part> parts = std::exchange(parts_, {});
  for (const Part& part : parts) {
    if (part.key.lacks == KeyRow::Lacks::orientation) continue;
    const std::vector<std::string_view> cells(part.cells.begin(), part.cells.end());
    if (auto appended = append(part.key, {part.line, part.time, cells}); !appended) return appended;
    if (unrising_) return tl::unexpected(out_of_order());
  }
  PositionTrack& apart = file_.positions_apart;
  for (const Part& part : parts) {
    if (part.key.lacks == KeyRow::Lacks::position) continue;
    const double time = columns_.time_unit.of(part.key.time - first_).to_double();
    if (!apart.times.empty() && time <= apart.times.back())
      return failure(
          ErrorCode::bad_data,
          formatted("time {} does not come after that of the position before it, wanted increasing times", part.time),
          where(part.line));
    apart.times.push_back(time);
    apart.positions.push_back(position_in_world(part.key.position));
  }
  file_.warnings.push_back(
      {.code = "two_tracks",
       .message = formatted("orientations and positions stand in different rows: they are taken for two tracks on one "
                            "clock, {} and {}; the keys are those with an orientation",
                            counted(static_cast<std::size_t>(with_orientation), "orientation"),
                            counted(apart.times.size(), "position")),
       .where = {.file = file_.path}});
  return {};
}

/// A quaternion that is near enough to norm 1 for keys.
Expected<Eigen::Quaterniond> KeyRows::normalised(Eigen::Quaterniond q, std::size_t line,
                                                 std::optional<std::size_t> column) {
  const double norm = q.coeffs().stableNorm(), off = std::abs(norm - 1.0);
  if (off <= norm_error_limit || options_.norms == Norms::as_they_are) return q;
  if (norm == 0.0) return mended_by("drop_invalid", "the quaternion is zero, wanted a rotation", where(line, column));
  if (!std::isfinite(norm)) return tl::unexpected(norm_refused(norm, where(line, column)));
  if (options_.norms == Norms::near_one && off > loose_norm_limit + 1e-12)
    return tl::unexpected(norm_refused(norm, where(line, column)));
  ++file_.repairs.normalised;
  file_.repairs.largest_norm_error = std::max(file_.repairs.largest_norm_error, off);
  q.coeffs() /= norm;
  return q;
}

/// Times of ISO 8601 are seconds, and a file has them in all rows or in none. A clock that comes round is counted on.
Expected<void> KeyRows::settle_clock(KeyRow& key, const TextTable& table) {
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
  saw_leap_second_ = saw_leap_second_ || (is_iso && cell.find(":60") != std::string_view::npos);
  const auto& round = options_.clock.round;
  if (!round) return {};
  if (is_iso) return bad_option("unwrap", formatted("found {}, wanted a counter that comes round", in_quotes(cell)));
  settle_time_unit(key.time);
  if (!round_clock_)
    round_clock_.emplace(round->is_in_seconds ? columns_.time_unit.inverse().of(round->length) : round->length);
  auto counted = round_clock_->counted_on(key.time);
  if (!counted) return failure(ErrorCode::bad_data, std::move(counted.error().message), table.here(columns_.time));
  key.time = *counted;
  return {};
}

void KeyRows::settle_time_unit(const Decimal& first) {
  if (columns_.states_time_unit) return;
  columns_.states_time_unit = true;
  if (auto guess = time_unit_by_size(first)) {
    columns_.time_unit = guess->seconds;
    guess->warning.where.file = file_.path;
    file_.warnings.push_back(std::move(guess->warning));
  } else {
    unit_is_assumed_ = true;
  }
}

/// Clocks of microseconds that count from the start of a machine look like seconds of long ago.
void KeyRows::warn_of_long_steps() {
  const auto& times = file_.data.times;
  if (std::exchange(looked_at_steps_, true) || !unit_is_assumed_ || times.size() < 2) return;
  const double step = median_interval(std::span(times).first(std::min(times.size(), most_times_to_tell)));
  if (step <= long_step) return;
  file_.warnings.push_back(
      {.code = "long_steps",
       .message = formatted("the times are taken as seconds, by which the keys are {:.6g} s apart; if they are "
                            "microseconds, set `time_scale` to 1e-6",
                            step),
       .where = {.file = file_.path},
       .numbers = {{"step_s", step}}});
}

Expected<void> KeyRows::complete() {
  if (!parts_.empty())
    if (auto taken = take_two_tracks(); !taken) return taken;
  if (unrising_ && !(options_.drop_invalid && is_zero_stamp())) return tl::unexpected(out_of_order());
  if (unrising_) ++file_.repairs.invalid_dropped;
  if (taken_ + size() == 0) {
    const std::size_t dropped = file_.repairs.invalid_dropped;
    const std::string reason = dropped > 0 ? formatted(" (all {} rows were dropped as invalid)", dropped) : "";
    return failure(ErrorCode::bad_data, "empty: no keys" + reason, {.file = file_.path});
  }
  turns_.finish();
  if (round_clock_)
    if (auto checked = round_clock_->check_came_round(); !checked) return checked;
  if (needs_all())
    if (auto arranged = arrange(); !arranged) return arranged;
  if (auto ordered = put_in_order(file_.unposed, options_, file_.path); !ordered) return ordered;
  warn_of_duplicates();
  return {};
}

KeyFile KeyRows::take() {
  if (taken_ == 0) warn_of_long_steps();
  taken_ += size();
  file_.data.jumps = options_.jumps;
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
