// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/sample_writer.hpp>

#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <orispline/io/euroc.hpp>

namespace orispline::io {
namespace {

constexpr int highest_derivative = 3, highest_position_derivative = 2;
constexpr std::array<std::string_view, highest_derivative> rate_letters{"w", "a", "j"};
constexpr std::array<std::string_view, highest_position_derivative> position_rate_letters{"v", "ap"};

// THE order of the columns of a CSV: `csv_header` and `append_csv` agree.

std::string csv_header(const SampleColumns& columns) {
  std::string header = fmt::format("t,{}", fmt::join(written_names(columns.form), ","));
  const auto append = [&header](std::string_view letters, std::string_view suffix) {
    for (const char axis : {'x', 'y', 'z'}) header += fmt::format(",{}{}{}", letters, axis, suffix);
  };
  if (columns.positions) append("p", "");
  for (std::size_t order = 0; order < static_cast<std::size_t>(columns.derivatives); ++order)
    append(rate_letters[order], columns.frame == Frame::world ? "_world" : "");
  for (std::size_t order = 0; order < static_cast<std::size_t>(columns.position_derivatives); ++order)
    append(position_rate_letters[order], "");
  return header;
}

/// Puts numbers into one line of text.
class Row {
 public:
  Row(std::string& text, std::string_view separator) : text_(text), separator_(separator) { text_.clear(); }

  Row& time(const Decimal& t) {
    text_ += t.to_string();
    return *this;
  }
  template <class... Numbers>
  Row& numbers(Numbers... values) {
    (append(values), ...);
    return *this;
  }
  Row& all(const OrientationNumbers& values) {
    for (const double value : values) append(value);
    return *this;
  }
  Row& vector(const Eigen::Vector3d& v) { return numbers(v.x(), v.y(), v.z()); }
  void end() { text_ += '\n'; }
  [[nodiscard]] bool is_finite() const { return finite_; }

 private:
  void append(double value) {
    finite_ = finite_ && std::isfinite(value);
    fmt::format_to(std::back_inserter(text_), "{}{}", separator_, value);
  }

  std::string& text_;
  std::string_view separator_;
  bool finite_ = true;
};

/// ω, α, jerk in the frame of the file.
std::array<Eigen::Vector3d, highest_derivative> rates_of(const Motion& motion, Frame frame) {
  if (frame == Frame::body) return {motion.angular_velocity, motion.angular_acceleration, motion.angular_jerk};
  return {angular_velocity_world(motion), angular_acceleration_world(motion), angular_jerk_world(motion)};
}

void append_csv(Row& row, const Sample& sample, const SampleColumns& columns) {
  const auto& [motion, travel] = sample;
  row.all(numbers_of(motion.orientation, columns.form));
  if (columns.positions) row.vector(travel.position);
  const auto rates = rates_of(motion, columns.frame);
  for (std::size_t order = 0; order < static_cast<std::size_t>(columns.derivatives); ++order) row.vector(rates[order]);
  if (columns.position_derivatives > 0) row.vector(travel.velocity);
  if (columns.position_derivatives > 1) row.vector(travel.acceleration);
}

void append_sample(Row& row, const Sample& sample, const SampleColumns& columns) {
  const Eigen::Quaterniond& q = sample.motion.orientation;
  switch (columns.format) {
    case FileFormat::csv:
      return append_csv(row, sample, columns);
    case FileFormat::tum:
      row.vector(sample.travel.position).numbers(q.x(), q.y(), q.z(), q.w());
      return;
    case FileFormat::euroc:
      row.vector(sample.travel.position).numbers(q.w(), q.x(), q.y(), q.z());
      return;
  }
}

/// What the format cannot hold.
Expected<void> check_columns(const SampleColumns& columns) {
  const bool is_csv = columns.format == FileFormat::csv;
  const auto check = [&](std::string_view what, int asked, int highest) -> Expected<void> {
    if (0 <= asked && asked <= (is_csv ? highest : 0)) return {};
    return failure(ErrorCode::bad_argument,
                   fmt::format("{} derivatives{} were asked for, and {} holds 0{}", asked, what,
                               title_of(columns.format), is_csv ? fmt::format(" to {}", highest) : ""));
  };
  if (!is_csv && columns.form.representation != Representation::quaternion)
    return failure(ErrorCode::bad_argument,
                   fmt::format("{} holds orientations as quaternions only", title_of(columns.format)));
  return check("", columns.derivatives, highest_derivative).and_then([&] {
    return check(" of the position", columns.position_derivatives, highest_position_derivative);
  });
}

}  // namespace

Expected<SampleWriter> SampleWriter::open(const std::string& path, const SampleColumns& columns) {
  if (auto checked = check_columns(columns); !checked) return tl::unexpected(std::move(checked.error()));
  return OutputFile::open(path).and_then([&](OutputFile&& file) -> Expected<SampleWriter> {
    const std::string header = columns.format == FileFormat::csv     ? csv_header(columns) + "\n"
                               : columns.format == FileFormat::euroc ? std::string(euroc_header) + "\n"
                                                                     : "";
    if (auto written = file.write(header); !written) return tl::unexpected(std::move(written.error()));
    return SampleWriter(std::move(file), columns);
  });
}

/// The time in whole nanoseconds, which no two neighbours may share.
Expected<Decimal> SampleWriter::next_nanosecond(const Decimal& time) {
  const Decimal nanosecond = (time * Decimal::power_of_ten(9)).rounded();
  if (nanosecond == last_nanosecond_)
    return failure(ErrorCode::bad_data,
                   fmt::format("two samples fall on the nanosecond {}, wanted times that differ in EuRoC",
                               nanosecond.to_string()));
  last_nanosecond_ = nanosecond;
  return nanosecond;
}

Expected<void> SampleWriter::write(const Decimal& time, const Sample& sample) {
  const auto written_time = columns_.format == FileFormat::euroc ? next_nanosecond(time) : Expected<Decimal>(time);
  if (!written_time) return tl::unexpected(written_time.error());
  Row row(row_, columns_.format == FileFormat::tum ? " " : ",");
  row.time(*written_time);
  append_sample(row, sample, columns_);
  row.end();
  if (!row.is_finite())
    return failure(ErrorCode::bad_data,
                   fmt::format("the sample at time {} has a number that is not finite", time.to_string()));
  return file_.write(row_);
}

}  // namespace orispline::io
