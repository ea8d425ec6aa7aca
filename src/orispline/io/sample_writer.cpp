// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/sample_writer.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <orispline/base/formatted.hpp>
#include <orispline/math/continuous_euler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

tl::unexpected<Error> not_finite(const Decimal& time) {
  return failure(ErrorCode::bad_data,
                 formatted("the sample at time {} has a number that is not finite", time.to_string()));
}

tl::unexpected<Error> same_time(const Decimal& time, const FormatInfo& format) {
  return failure(ErrorCode::bad_data, formatted("two samples fall on the {} {}, wanted times that differ in {}",
                                                format.writing.whole_times->unit, time.to_string(), format.title));
}

}  // namespace

Expected<void> SampleRows::append(const Decimal& time, const Sample& sample) {
  const FormatWriting& writing = columns_.format->writing;
  const RowNumbers numbers = numbers_of(sample);
  if (!may_write(numbers, sample)) return not_finite(time);
  if (writing.rounded_row) {
    writing.rounded_row(bytes_, time.to_double(), numbers.values());
  } else {
    const auto written_time = writing.whole_times ? next_whole(time) : Expected<Decimal>(time);
    if (!written_time) return tl::unexpected(written_time.error());
    writing.row(bytes_, *written_time, numbers.values());
  }
  ++size_;
  return {};
}

Expected<void> SampleRows::append(const TimeOrigin& origin, double offset, const Sample& sample) {
  const FormatWriting& writing = columns_.format->writing;
  if (!writing.rounded_row) return append(origin.plus(offset), sample);
  const RowNumbers numbers = numbers_of(sample);
  if (!may_write(numbers, sample)) return not_finite(origin.plus(offset));
  writing.rounded_row(bytes_, origin.nearest_plus(offset), numbers.values());
  ++size_;
  return {};
}

RowNumbers SampleRows::numbers_of(const Sample& sample) {
  const FormatWriting& writing = columns_.format->writing;
  if (!columns_.form.runs_on() || sample.motion.orientation.coeffs().hasNaN()) return writing.numbers(sample, columns_);
  const EulerOrder& order = columns_.form.order;
  const Eigen::Quaterniond orientation = written_orientation(sample.motion.orientation, columns_);
  angles_ = ContinuousEuler(order).after(angles_.value_or(euler_angles(order, orientation)), orientation);
  Sample running = sample;
  running.angles = angles_;
  return writing.numbers(running, columns_);
}

void SampleRows::append_empty(const TimeOrigin& origin, double offset) {
  const FormatWriting& writing = columns_.format->writing;
  const std::size_t cells = column_names(columns_).size() - 1;
  if (writing.rounded_row) {
    const std::vector<double> none(cells, std::numeric_limits<double>::quiet_NaN());
    writing.rounded_row(bytes_, origin.nearest_plus(offset), none);
  } else {
    writing.row(bytes_, origin.plus(offset), {});
    bytes_.insert(bytes_.size() - 1, cells, ',');
  }
  ++size_;
}

bool SampleRows::may_write(const RowNumbers& numbers, const Sample& sample) const noexcept {
  if (numbers.are_finite()) return true;
  const bool has_orientation = !sample.motion.orientation.coeffs().hasNaN();
  if (missing_ == MissingSamples::written) return !has_orientation;
  const auto is_infinite = [](double number) { return std::isinf(number); };
  return missing_ == MissingSamples::free_rates && has_orientation &&
         std::ranges::none_of(numbers.values(), is_infinite);
}

/// The time in whole units of the format, which no two neighbours may share.
Expected<Decimal> SampleRows::next_whole(const Decimal& time) {
  const Decimal whole = (time * Decimal::power_of_ten(columns_.format->writing.whole_times->per_second)).rounded();
  if (whole == last_whole_) return same_time(whole, *columns_.format);
  if (!first_whole_) first_whole_ = whole;
  last_whole_ = whole;
  return whole;
}

Expected<void> SampleRows::may_follow(const SampleRows& others) const {
  if (first_whole_ && first_whole_ == others.last_whole_) return same_time(*first_whole_, *columns_.format);
  return {};
}

void SampleRows::clear() noexcept {
  bytes_.clear();
  size_ = 0;
  first_whole_.reset();
}

void SampleRows::continue_after(const SampleRows& others) noexcept {
  clear();
  if (others.last_whole_) last_whole_ = others.last_whole_;
}

Expected<SampleWriter> SampleWriter::open(const std::string& path, const SampleColumns& columns, std::size_t rows) {
  if (auto checked = check_columns(columns); !checked) return tl::unexpected(std::move(checked.error()));
  return OutputFile::open(path).and_then([&](OutputFile&& file) { return open(std::move(file), columns, rows); });
}

Expected<SampleWriter> SampleWriter::open(OutputFile file, const SampleColumns& columns, std::size_t rows) {
  if (auto checked = check_columns(columns); !checked) return tl::unexpected(std::move(checked.error()));
  if (auto written = file.write(header_of(columns, rows)); !written) return tl::unexpected(std::move(written.error()));
  return SampleWriter(std::move(file), columns, rows);
}

Expected<void> SampleWriter::write(const Decimal& time, const Sample& sample) {
  if (auto appended = pending_.append(time, sample); !appended) return appended;
  return pending_.bytes().size() < written_block ? Expected<void>() : write_pending();
}

Expected<void> SampleWriter::write(const SampleRows& rows) {
  if (auto written = write_pending(); !written) return written;
  if (auto checked = rows.may_follow(pending_); !checked) return checked;
  pending_.continue_after(rows);
  rows_ += rows.size();
  return file_.write(rows.bytes());
}

Expected<void> SampleWriter::write_pending() {
  rows_ += pending_.size();
  auto written = file_.write(pending_.bytes());
  pending_.clear();
  return written;
}

Expected<void> SampleWriter::close() {
  if (auto written = write_pending(); !written) return written;
  if (columns_.format->writing.counts_rows && rows_ != stated_rows_)
    if (auto counted = file_.write_again(header_of(columns_, rows_)); !counted) return counted;
  auto closed = file_.close();
  closed_ = closed.has_value();
  return closed;
}

Expected<void> SampleWriter::finish() {
  if (!closed_)
    if (auto closed = close(); !closed) return closed;
  return file_.finish();
}

}}}  // namespace orispline::io
