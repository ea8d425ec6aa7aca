// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sample_buffer.hpp"

namespace orispline::cli {

namespace {

Eigen::Vector3d vector_of(const std::vector<double>& numbers, std::size_t k) {
  if (numbers.empty()) return Eigen::Vector3d::Zero();
  return Eigen::Vector3d(numbers.data() + 3 * k);
}

}  // namespace

void SampleBuffer::resize(std::size_t size) {
  const int derivatives = columns_.derivatives;
  const int of_position = columns_.positions ? columns_.position_derivatives : -1;
  const auto room = [size](std::vector<double>& numbers, bool wanted) { numbers.resize(wanted ? 3 * size : 0); };
  times_.resize(size);
  offsets_.resize(size);
  orientations_.resize(4 * size);
  bands_.resize(columns_.band ? size : 0);
  room(angular_velocities_, derivatives >= 1);
  room(angular_accelerations_, derivatives >= 2);
  room(angular_jerks_, derivatives >= 3);
  room(positions_, of_position >= 0);
  room(velocities_, of_position >= 1);
  room(accelerations_, of_position >= 2);
}

Samples<double> SampleBuffer::room() noexcept {
  return {.orientations = orientations_,
          .angular_velocities = angular_velocities_,
          .angular_accelerations = angular_accelerations_,
          .angular_jerks = angular_jerks_,
          .positions = positions_,
          .velocities = velocities_,
          .accelerations = accelerations_};
}

io::Sample SampleBuffer::sample(std::size_t k) const {
  io::Sample sample{.motion = {.orientation = Eigen::Quaterniond(orientations_.data() + 4 * k),
                               .angular_velocity = vector_of(angular_velocities_, k),
                               .angular_acceleration = vector_of(angular_accelerations_, k),
                               .angular_jerk = vector_of(angular_jerks_, k)}};
  if (columns_.band) sample.band = bands_[k];
  if (columns_.positions)
    sample.linear_motion = LinearMotion{.position = vector_of(positions_, k),
                                        .velocity = vector_of(velocities_, k),
                                        .acceleration = vector_of(accelerations_, k)};
  return sample;
}

void BufferRows::make(const SampleBuffer& samples, std::size_t begin, std::size_t end, const TimeOrigin& origin,
                      const Domain& domain) {
  rows_.clear();
  counts_ = {};
  made_ = {};
  for (std::size_t k = begin; k < end && made_; ++k) {
    const bool is_outside = !domain.contains(samples.time(k));
    const bool is_in_gap = policy_.gaps != GapRows::none && !is_outside && !samples.has_sample(k);
    counts_ += {is_outside ? 1U : 0U, is_in_gap ? 1U : 0U};
    if (is_in_gap && policy_.gaps == GapRows::empty) rows_.append_empty(origin, samples.offset(k));
    if (is_in_gap || (is_outside && policy_.outside == LeftOut::yes)) continue;
    made_ = rows_.append(origin, samples.offset(k), samples.sample(k));
  }
}

Expected<RowCounts> BufferRows::write(io::SampleWriter& writer) const {
  auto written = writer.write(rows_).and_then([this] { return made_; });
  return written.map([this] { return counts_; });
}

}  // namespace orispline::cli
