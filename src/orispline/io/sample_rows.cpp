// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/sample_rows.hpp>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include <orispline/base/formatted.hpp>
#include <orispline/base/number_text.hpp>

namespace orispline::io {
namespace {

tl::unexpected<Error> not_finite(const Decimal& time) {
  return failure(ErrorCode::bad_data,
                 formatted("the sample at time {} has a number that is not finite", time.to_string()));
}

tl::unexpected<Error> same_nanosecond(const Decimal& nanosecond) {
  return failure(
      ErrorCode::bad_data,
      formatted("two samples fall on the nanosecond {}, wanted times that differ in EuRoC", nanosecond.to_string()));
}

using DoubleBytes = std::array<char, sizeof(double)>;

DoubleBytes little_endian(double value) {
  auto bytes = std::bit_cast<DoubleBytes>(value);
  if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(bytes);
  return bytes;
}

}  // namespace

Expected<void> SampleRows::append(const Decimal& time, const Sample& sample) {
  const RowNumbers numbers(sample, columns_);
  if (!numbers.are_finite()) return not_finite(time);
  if (columns_.format != FileFormat::npy) return append_text(time, numbers);
  append_binary(time.to_double(), numbers);
  return {};
}

Expected<void> SampleRows::append(const TimeOrigin& origin, double offset, const Sample& sample) {
  if (columns_.format != FileFormat::npy) return append(origin.plus(offset), sample);
  const RowNumbers numbers(sample, columns_);
  if (!numbers.are_finite()) return not_finite(origin.plus(offset));
  append_binary(origin.nearest_plus(offset), numbers);
  return {};
}

Expected<void> SampleRows::append_text(const Decimal& time, const RowNumbers& numbers) {
  const auto written_time = columns_.format == FileFormat::euroc ? next_nanosecond(time) : Expected<Decimal>(time);
  if (!written_time) return tl::unexpected(written_time.error());
  written_time->append_to(bytes_);
  std::array<char, RowNumbers::most*(1 + longest_shortest_text) + shortest_text_room> row;
  const char separator = columns_.format == FileFormat::tum ? ' ' : ',';
  char* end = row.data();
  for (const double value : numbers.values()) {
    *end++ = separator;
    end = write_shortest_text(end, value);
  }
  *end++ = '\n';
  bytes_.append(row.data(), end);
  ++size_;
  return {};
}

void SampleRows::append_binary(double time, const RowNumbers& numbers) {
  std::array<DoubleBytes, 1 + RowNumbers::most> row;
  const auto values = numbers.values();
  row[0] = little_endian(time);
  std::ranges::transform(values, row.begin() + 1, little_endian);
  bytes_.append(row.front().data(), (1 + values.size()) * sizeof(double));
  ++size_;
}

/// The time in whole nanoseconds, which no two neighbours may share.
Expected<Decimal> SampleRows::next_nanosecond(const Decimal& time) {
  const Decimal nanosecond = (time * Decimal::power_of_ten(9)).rounded();
  if (nanosecond == last_nanosecond_) return same_nanosecond(nanosecond);
  if (!first_nanosecond_) first_nanosecond_ = nanosecond;
  last_nanosecond_ = nanosecond;
  return nanosecond;
}

Expected<void> SampleRows::may_follow(const SampleRows& others) const {
  if (first_nanosecond_ && first_nanosecond_ == others.last_nanosecond_) return same_nanosecond(*first_nanosecond_);
  return {};
}

void SampleRows::clear() noexcept {
  bytes_.clear();
  size_ = 0;
  first_nanosecond_.reset();
}

void SampleRows::continue_after(const SampleRows& others) noexcept {
  clear();
  if (others.last_nanosecond_) last_nanosecond_ = others.last_nanosecond_;
}

}  // namespace orispline::io
