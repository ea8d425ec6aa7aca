// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sampling.hpp"

#include <algorithm>
#include <vector>

#include <orispline/base/parallel.hpp>
#include <orispline/batch/sample.hpp>

namespace orispline::cli {
namespace {

constexpr std::size_t chunk_size = 16384;  // samples that a thread makes at a time: far dearer than the thread

/// Successive samples that one thread makes.
class Chunk {
 public:
  explicit Chunk(const Sampling& sampling) : rows_(sampling.columns) {}

  /// Makes the samples from `begin` to before `end`.
  void make(const Sampling& sampling, std::size_t begin, std::size_t end) {
    rows_.clear();
    held_ = 0;
    made_ = {};
    instants_.clear();
    times_.clear();
    for (std::size_t k = begin; k < end; ++k) {
      instants_.push_back(sampling.times[k]);
      times_.push_back(instants_.back().t);
    }
    evaluate(sampling);
    const Domain domain = sampling.curve.orientation.domain();
    for (std::size_t k = 0; k < times_.size() && made_; ++k) {
      if (!domain.contains(times_[k])) ++held_;
      io::Sample sample{.motion = motion(k)};
      if (sampling.curve.position) sample.linear_motion = linear_motion(k);
      made_ = rows_.append(sampling.times.origin(), instants_[k].offset, sample);
    }
  }

  /// Writes what was made; the number of samples that hold an end orientation.
  [[nodiscard]] Expected<std::size_t> write(io::SampleWriter& writer) const {
    auto written = writer.write(rows_).and_then([this] { return made_; });
    return written.map([this] { return held_; });
  }

 private:
  void evaluate(const Sampling& sampling) {
    const int derivatives = sampling.columns.derivatives;
    const int of_position = sampling.curve.position ? sampling.columns.position_derivatives : -1;
    const auto room = [this](std::vector<double>& numbers, bool wanted) {
      numbers.resize(wanted ? 3 * times_.size() : 0);
    };
    orientations_.resize(4 * times_.size());
    room(angular_velocities_, derivatives >= 1);
    room(angular_accelerations_, derivatives >= 2);
    room(angular_jerks_, derivatives >= 3);
    room(positions_, of_position >= 0);
    room(velocities_, of_position >= 1);
    room(accelerations_, of_position >= 2);
    made_ = sample_at<double>(sampling.curve, times_,
                              Samples<double>{.orientations = orientations_,
                                              .angular_velocities = angular_velocities_,
                                              .angular_accelerations = angular_accelerations_,
                                              .angular_jerks = angular_jerks_,
                                              .positions = positions_,
                                              .velocities = velocities_,
                                              .accelerations = accelerations_});
  }

  [[nodiscard]] Motion motion(std::size_t k) const {
    return {.orientation = Eigen::Quaterniond(orientations_.data() + 4 * k),
            .angular_velocity = vector_of(angular_velocities_, k),
            .angular_acceleration = vector_of(angular_accelerations_, k),
            .angular_jerk = vector_of(angular_jerks_, k)};
  }
  [[nodiscard]] LinearMotion linear_motion(std::size_t k) const {
    return {.position = vector_of(positions_, k),
            .velocity = vector_of(velocities_, k),
            .acceleration = vector_of(accelerations_, k)};
  }
  [[nodiscard]] Eigen::Vector3d vector_of(const std::vector<double>& numbers, std::size_t k) const {
    if (numbers.empty()) return Eigen::Vector3d::Zero();
    return Eigen::Vector3d(numbers.data() + 3 * k);
  }

  std::vector<Instant> instants_;
  std::vector<double> times_, orientations_, angular_velocities_, angular_accelerations_, angular_jerks_, positions_,
      velocities_, accelerations_;
  io::SampleRows rows_;
  std::size_t held_ = 0;
  Expected<void> made_;
};

}  // namespace

Expected<std::size_t> write_samples(io::SampleWriter& writer, const Sampling& sampling, Progress::Show show) {
  const std::size_t size = sampling.times.size();
  const auto chunk_begin = [size](std::size_t index) { return std::min(index * chunk_size, size); };
  const std::size_t chunks = (size + chunk_size - 1) / chunk_size;
  std::vector<Chunk> made(std::clamp<std::size_t>(chunks, 1, sampling.threads), Chunk(sampling));
  Progress progress(size, show);
  std::size_t held = 0;
  for (std::size_t first = 0; first < chunks; first += made.size()) {
    const std::size_t count = std::min(made.size(), chunks - first);
    parallel_for(count, static_cast<unsigned>(count),
                 [&](std::size_t i) { made[i].make(sampling, chunk_begin(first + i), chunk_begin(first + i + 1)); });
    for (std::size_t i = 0; i < count; ++i) {
      const auto written = made[i].write(writer);
      if (!written) return tl::unexpected(written.error());
      held += *written;
    }
    progress.advance_to(chunk_begin(first + count));
  }
  return writer.finish().map([held] { return held; });
}

}  // namespace orispline::cli
