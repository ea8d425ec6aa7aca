// SPDX-License-Identifier: Apache-2.0
// The order of the rows of a table: what they say where their times do not rise, and what is made of that.
#include <orispline/io/key_rows.hpp>

#include <algorithm>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_parts.hpp>
#include <orispline/io/order_errors.hpp>
#include <orispline/io/rates_order.hpp>
#include <orispline/io/time_order.hpp>
#include <orispline/math/degrees.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::size_t most_ahead = 8;  // rows that are looked at before one is refused

/// Rows of one time that differ by no more are the same [rad], [m].
constexpr double same_turn = 1e-6, same_place = 1e-6;
/// Rows of one time that turn by more are a jump, and no row that was written twice [rad].
constexpr double jump = 5.0 / degrees;

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

/// The times that belong to rows, from one of them on, as many as are looked at.
std::vector<Decimal> times_from(const std::vector<Decimal>& times, std::span<const std::uint32_t> rows) {
  std::vector<Decimal> some;
  for (const std::uint32_t row : rows.first(std::min(rows.size(), most_ahead))) some.push_back(times[row]);
  return some;
}

}  // namespace

/// Reads no more than the time of a row behind one whose time does not rise, to say what that one is.
Expected<void> KeyRows::look_ahead(const TextTable& table) {
  RowReader row(table, options_);
  const KeyRow key = table.cells().size() < columns_.width ? KeyRow() : row.key(columns_);
  if (table.cells().size() < columns_.width || row.refused()) return tl::unexpected(out_of_order());
  if (row.not_finite()) return options_.drop_invalid ? Expected<void>() : tl::unexpected(out_of_order());
  if (options_.drop_invalid && is_zero_stamp() && key.time >= latest_) {
    file_.repairs.invalid_dropped += 1 + unrising_->after.size();
    unrising_.reset();
    return add(table);
  }
  unrising_->after.push_back(key.time);
  if (unrising_->after.size() < most_ahead) return {};
  return tl::unexpected(out_of_order());
}

/// Appends the time of the next key; false for one that does not rise, which is `unrising_` or a duplicate that is
/// dropped. `text`: the time in the file, if at hand.
Expected<bool> KeyRows::append_time(const Decimal& time, std::string_view text, std::size_t line, const Pose& pose) {
  std::vector<double>& times = file_.data.times;
  const bool is_first = taken_ + times.size() == 0;
  std::string shown = text.empty() ? time.to_string() : std::string();
  if (is_first) {
    settle_time_unit(time);
    first_ = time;
    file_.epoch = columns_.time_unit.time_of(first_);
  } else if (time < latest_ || (time == latest_ && !jumps_to(pose))) {
    if (time < latest_ || !options_.drop_duplicates)
      unrising_ = Unrising{time, text.empty() ? std::move(shown) : std::string(text), line, {}, turn_to(pose)};
    else note_duplicate(pose);
    return false;
  }
  latest_jumps_ = !is_first && time == latest_;
  const double seconds = columns_.time_unit.of(time - first_).to_double();
  if (!is_first && !latest_jumps_ && seconds <= latest_seconds_)
    return failure(
        ErrorCode::bad_data,
        formatted("time {} is too near to {} to be told apart in double precision, wanted keys farther apart",
                  text.empty() ? std::string_view(shown) : text, latest_.to_string()),
        {file_.path, line, std::nullopt, taken_ + times.size()});
  times.push_back(seconds);
  if (options_.keep_exact_times) file_.exact_times.push_back(columns_.time_unit.time_of(time));
  latest_ = time;
  latest_seconds_ = seconds;
  latest_line_ = line;
  latest_pose_ = pose;
  return true;
}

/// A time of 0 that is an invalid stamp, as far as the rows behind it are known.
bool KeyRows::is_zero_stamp() const {
  const auto is_zero = [](const Decimal& time) { return time == Decimal(); };
  return is_zero(unrising_->time) && is_far_from_zero(first_, latest_, taken_ + file_.data.times.size()) &&
         std::ranges::all_of(unrising_->after, is_zero);
}

/// What is wrong with the row whose time does not rise.
Error KeyRows::out_of_order() const {
  const auto& [time, text, line, after, turn] = *unrising_;
  const Where where{file_.path, line, std::nullopt, taken_ + file_.data.times.size()};
  const auto error = [&where](std::string_view remedy, std::string message) {
    return mended_by(remedy, std::move(message), where).value();
  };
  if (saw_leap_second_) return {ErrorCode::bad_data, beside_leap_second(*unrising_), where};
  if (time == latest_) {
    const std::string same = duplicate_time(text, latest_line_);
    if (repeat_in_runs(time, after))
      return error("columns", same +
                                  ": the stamps repeat in runs, since they are coarser than the rows; if another "
                                  "column has the rest of the time, name both, such as t=sec+nanosec");
    if (latest_jumps_) return {ErrorCode::bad_data, same + ": a third row has this time, and a jump has two", where};
    if (turn > jump && !options_.jumps)
      return error("jumps", formatted("{}: the orientation jumps there by {:.3g}°", same, turn * degrees));
    return error(
        "drop_duplicates",
        turn > same_turn ? formatted("{}; the row is turned by {:.3g}° from that one", same, turn * degrees) : same);
  }
  std::vector<Decimal> times{latest_, time};
  times.insert(times.end(), after.begin(), after.end());
  const bool begins = session_starts(times).size() > 1;
  const bool is_zero = time == Decimal() && is_far_from_zero(first_, latest_, taken_ + file_.data.times.size()) &&
                       (after.empty() || after.front() >= latest_ || (after.front() == time && first_ != time));
  if (is_zero)
    return error("drop_invalid",
                 formatted("time {} comes after {}, wanted increasing times: 0 is an invalid time stamp there", text,
                           latest_.to_string()));
  return falling_time(text, latest_, begins, where).value();
}

/// No option mends it: the rows of the leap second and those behind it have the same times.
std::string KeyRows::beside_leap_second(const Unrising& row) const {
  const std::string unrising =
      row.time == latest_ ? duplicate_time(row.text, latest_line_)
                          : formatted("time {} comes after {}, wanted increasing times", row.text, latest_.to_string());
  return unrising +
         ": the leap second 23:59:60 is not counted, so that its times come twice; leave out its rows, or give times "
         "that have no leap seconds, such as those of TAI or GPS";
}

/// From the latest key [rad]; 0 where one of both is no rotation.
double KeyRows::turn_to(const Pose& pose) const {
  if (!latest_pose_ || pose.orientation.coeffs().isZero(0.0) || latest_pose_->orientation.coeffs().isZero(0.0))
    return 0.0;
  return angular_distance(pose.orientation.normalized(), latest_pose_->orientation.normalized());
}

/// Whether a row of the same time is no repetition of the latest key, where such rows are jumps.
bool KeyRows::jumps_to(const Pose& pose) const {
  if (!options_.jumps || latest_jumps_) return false;
  const bool is_elsewhere = columns_.position && (pose.position - latest_pose_->position).norm() > same_place;
  return turn_to(pose) > same_turn || is_elsewhere || (pose.rate - latest_pose_->rate).norm() > 0.0;
}

void KeyRows::note_duplicate(const Pose& dropped) {
  ++file_.repairs.duplicates_dropped;
  if (!latest_pose_ || dropped.orientation.coeffs().isZero(0.0)) return;
  const double turn = turn_to(dropped);
  const double distance = columns_.position ? (dropped.position - latest_pose_->position).norm() : 0.0;
  if (turn > same_turn || distance > same_place) ++differing_duplicates_;
  RepairReport& repairs = file_.repairs;
  repairs.largest_duplicate_turn = std::max(repairs.largest_duplicate_turn, turn);
  repairs.largest_duplicate_distance = std::max(repairs.largest_duplicate_distance, distance);
}

void KeyRows::warn_of_duplicates() {
  if (differing_duplicates_ == 0) return;
  const RepairReport& repairs = file_.repairs;
  const std::string distance = repairs.largest_duplicate_distance > same_place
                                   ? formatted(" and {:.4g} m", repairs.largest_duplicate_distance)
                                   : "";
  file_.warnings.push_back(
      {.code = "duplicates_differ",
       .message = formatted("{} of duplicate time {} from the row that is kept, by up to {:.4g}°{}",
                            counted(differing_duplicates_, "row"), differing_duplicates_ == 1 ? "differs" : "differ",
                            repairs.largest_duplicate_turn * degrees, distance),
       .where = {.file = file_.path},
       .numbers = {{"rows", static_cast<double>(differing_duplicates_)},
                   {"largest_deg", repairs.largest_duplicate_turn * degrees},
                   {"largest_m", repairs.largest_duplicate_distance}}});
}

/// The first rows of the recordings among which one may be chosen: those that go back, and those that jump.
std::vector<std::size_t> KeyRows::recordings() const {
  std::vector<std::size_t> starts = session_starts(times_);
  const auto& q = file_.data.orientations;
  for (std::size_t i = 1; i < times_.size(); ++i)
    if (!options_.jumps && times_[i] == times_[i - 1] && !q[i].coeffs().isZero(0.0) && !q[i - 1].coeffs().isZero(0.0) &&
        angular_distance(q[i].normalized(), q[i - 1].normalized()) > jump)
      starts.push_back(i);
  std::ranges::sort(starts);
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  return starts;
}

/// The rows that are read, in the order of the file. Errors: a recording that there is not; recordings that sorting
/// would mix, a time of 0 that it would bring to the front.
Expected<std::vector<std::uint32_t>> KeyRows::chosen_rows() {
  std::vector<std::size_t> starts = options_.session ? recordings() : session_starts(times_);
  const std::size_t session = options_.session.value_or(1);
  if (session > starts.size() || session == all_sessions) return no_such_session(session, starts.size());
  if (!options_.session && !may_be_sorted(times_.size(), starts.size()))
    return mixed_sessions(starts.size(), {.file = file_.path, .line = file_.lines[starts[1]]});
  starts.push_back(times_.size());
  const std::size_t first = options_.session ? starts[session - 1] : 0;
  const std::size_t end = options_.session ? starts[session] : times_.size();
  choose_unposed(first, end);
  const std::vector<bool> zeros = zero_stamps(std::span(times_).subspan(first, end - first));
  std::vector<std::uint32_t> rows;
  for (std::size_t i = first; i < end; ++i) {
    if (!zeros[i - first]) {
      rows.push_back(static_cast<std::uint32_t>(i));
    } else if (!options_.drop_invalid) {
      return mended_by("drop_invalid",
                       formatted("time 0 comes after {}, wanted increasing times: 0 is an invalid time stamp there",
                                 times_[i - 1].to_string()),
                       {.file = file_.path, .line = file_.lines[i]});
    } else {
      ++file_.repairs.invalid_dropped;
    }
  }
  return rows;
}

/// Brings the gathered rows into their order, and leaves out those that are not read.
Expected<void> KeyRows::arrange() {
  auto rows = chosen_rows();
  if (!rows) return tl::unexpected(std::move(rows.error()));
  if (options_.sort) {
    file_.repairs.rows_moved = late_rows(entries_at(times_, *rows));
    if (file_.repairs.rows_moved > 0)
      std::stable_sort(rows->begin(), rows->end(), [this](auto a, auto b) { return times_[a] < times_[b]; });
  }
  std::vector<std::uint32_t> kept;
  kept.reserve(rows->size());
  const auto pose_at = [this](std::uint32_t row) {
    const KeyframeData& data = file_.data;
    return Pose{data.orientations[row], columns_.position ? data.positions[row] : free_rate(),
                columns_.rates[0] ? data.angular_velocities[row] : free_rate()};
  };
  for (std::size_t i = 0; i < rows->size(); ++i) {
    const std::uint32_t row = (*rows)[i];
    const auto appended = append_time(times_[row], {}, file_.lines[row], pose_at(row));
    if (!appended) return tl::unexpected(appended.error());
    if (unrising_) {
      unrising_->after = times_from(times_, std::span(*rows).subspan(i + 1));
      return tl::unexpected(out_of_order());
    }
    if (*appended) kept.push_back(row);
  }
  file_.lines = entries_at(file_.lines, kept);
  file_.table.rows = entries_at(file_.table.rows, kept);
  file_.data.orientations = entries_at(file_.data.orientations, kept);
  for_each_part([&](const auto& part) { file_.data.*part.list = entries_at(file_.data.*part.list, kept); });
  for (auto& [name, values] : file_.parameters) values = entries_at(values, kept);
  return {};
}

/// Of the rows that are set aside leaves those that stand among the rows from `first` to `end`.
void KeyRows::choose_unposed(std::size_t first, std::size_t end) {
  RateRows& rows = file_.unposed;
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t place = 0; place < rows.lines.size(); ++place)
    if ((first == 0 || rows.lines[place] > file_.lines[first]) &&
        (end == file_.lines.size() || rows.lines[place] < file_.lines[end]))
      chosen.push_back(place);
  rows = rows_at(rows, chosen);
}

}}}  // namespace orispline::io
