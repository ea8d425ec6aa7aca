// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/time_order.hpp>

#include <algorithm>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

/// Shuffled rows begin anew again and again.
constexpr std::size_t many_sessions = 8, rows_of_shuffled = 16;

}  // namespace

TimeOrder::Row TimeOrder::add(const Decimal& time) {
  const bool is_late = latest_ && time < *latest_;
  if (!is_late || !late_ || time < *late_) rising_ = rows_ = 0;
  if (!is_late) {
    latest_ = time;
    late_.reset();
    return Row::on_time;
  }
  if (rows_++ == 0 || time != *late_) ++rising_;
  late_ = time;
  if (rising_ < fewest_of_session) return Row::late;
  latest_ = time;
  late_.reset();
  return Row::begins;
}

std::vector<std::size_t> session_starts(std::span<const Decimal> times) {
  std::vector<std::size_t> starts{0};
  TimeOrder order;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (order.add(times[i]) == TimeOrder::Row::begins) starts.push_back(i + 1 - order.late_rows());
  return starts;
}

bool may_be_sorted(std::size_t rows, std::size_t sessions) noexcept {
  return sessions == 1 || (sessions > many_sessions && rows < rows_of_shuffled * sessions);
}

bool is_far_from_zero(const Decimal& first, const Decimal& last, std::size_t count) {
  constexpr double many_steps = 10.0;
  if (count < fewest_of_session || first < Decimal()) return false;
  return first == Decimal() || first * Decimal::from_double(static_cast<double>(count - 1)) >
                                   (last - first) * Decimal::from_double(many_steps);
}

std::vector<bool> zero_stamps(std::span<const Decimal> times) {
  std::vector<bool> are_zero(times.size(), false);
  std::vector<Decimal> others(times.begin(), times.end());
  std::erase(others, Decimal());
  if (others.empty()) return are_zero;
  const auto [least, most] = std::ranges::minmax_element(others);
  const Decimal& first = times.front() == Decimal() ? times.front() : *least;
  if (!is_far_from_zero(first, *most, others.size())) return are_zero;
  TimeOrder order;
  Decimal latest;
  for (std::size_t i = 0; i < times.size(); ++i) {
    const bool is_late = order.add(times[i]) != TimeOrder::Row::on_time;
    if (!is_late) latest = times[i];
    if (!is_late || times[i] != Decimal()) continue;
    const bool goes_on = i + 1 < times.size() && times[i + 1] > Decimal() && times[i + 1] < latest;
    are_zero[i] = !goes_on;
  }
  return are_zero;
}

bool repeat_in_runs(const Decimal& twice, std::span<const Decimal> after) {
  std::size_t repeated = 1;
  const Decimal* before = &twice;
  for (const Decimal& time : after) {
    if (time == *before) ++repeated;
    before = &time;
  }
  return repeated > 1 && 3 * repeated >= after.size() + 1;
}

}}}  // namespace orispline::io
