// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/sample_writer.hpp>

#include <array>
#include <cmath>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace orispline::io {
namespace {

constexpr int highest_derivative = 3;
constexpr std::array<std::string_view, highest_derivative> rate_letters{"w", "a", "j"};

std::string header_of(const SampleColumns& columns) {
  std::string header = "t,qw,qx,qy,qz";
  if (columns.positions) header += ",px,py,pz";
  const std::string_view frame = columns.frame == Frame::world ? "_world" : "";
  for (std::size_t order = 0; order < static_cast<std::size_t>(columns.derivatives); ++order)
    for (const char axis : {'x', 'y', 'z'}) header += fmt::format(",{}{}{}", rate_letters[order], axis, frame);
  return header + "\n";
}

/// ω, α, jerk in the frame of the file.
std::array<Eigen::Vector3d, highest_derivative> rates_of(const Motion& motion, Frame frame) {
  if (frame == Frame::body) return {motion.angular_velocity, motion.angular_acceleration, motion.angular_jerk};
  return {angular_velocity_world(motion), angular_acceleration_world(motion), angular_jerk_world(motion)};
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

}  // namespace

Expected<SampleWriter> SampleWriter::open(const std::string& path, const SampleColumns& columns, const Decimal& epoch) {
  const int highest = columns.format == FileFormat::tum ? 0 : highest_derivative;
  if (columns.derivatives < 0 || columns.derivatives > highest)
    return failure(ErrorCode::bad_argument,
                   fmt::format("{} derivatives were asked for, and {} holds 0{}", columns.derivatives,
                               highest == 0 ? "TUM" : "CSV", highest == 0 ? "" : " to 3"));
  return OutputFile::open(path).and_then([&](OutputFile&& file) -> Expected<SampleWriter> {
    if (columns.format == FileFormat::csv)
      if (auto written = file.write(header_of(columns)); !written) return tl::unexpected(std::move(written.error()));
    return SampleWriter(std::move(file), columns, epoch);
  });
}

Expected<void> SampleWriter::write(const Sample& sample) {
  if (!std::isfinite(sample.t))
    return failure(ErrorCode::bad_data, fmt::format("a sample time is {}, wanted a finite number", sample.t));
  const Decimal time = epoch_ + Decimal::from_double(sample.t);
  const Eigen::Quaterniond& q = sample.motion.orientation;
  Row row(row_, columns_.format == FileFormat::tum ? " " : ",");
  row.time(time);
  if (columns_.format == FileFormat::tum) {
    row.vector(sample.position).numbers(q.x(), q.y(), q.z(), q.w());
  } else {
    row.numbers(q.w(), q.x(), q.y(), q.z());
    if (columns_.positions) row.vector(sample.position);
    const auto rates = rates_of(sample.motion, columns_.frame);
    for (std::size_t order = 0; order < static_cast<std::size_t>(columns_.derivatives); ++order)
      row.vector(rates[order]);
  }
  row.end();
  if (!row.is_finite())
    return failure(ErrorCode::bad_data,
                   fmt::format("the sample at time {} has a number that is not finite", time.to_string()));
  return file_.write(row_);
}

}  // namespace orispline::io
