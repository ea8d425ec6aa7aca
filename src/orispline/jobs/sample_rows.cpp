// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/sample_rows.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include <orispline/base/parallel.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

constexpr std::size_t samples_of_a_thread = 16384;  // at a time: far dearer than the thread
constexpr std::size_t fewest_of_a_thread = 1024;

Eigen::Vector3d vector_of(const std::vector<double>& numbers, std::size_t k) {
  if (numbers.empty()) return Eigen::Vector3d::Zero();
  return Eigen::Vector3d(numbers.data() + 3 * k);
}

std::size_t parts_of(std::size_t samples, std::size_t threads) {
  return std::clamp<std::size_t>(threads, 1, (samples + fewest_of_a_thread - 1) / fewest_of_a_thread);
}

/// Makes the rows of a block in parts, and writes them in their order.
class BlockRows {
 public:
  BlockRows(const SampleSource& source, const RowPolicy& policy, RowSink& sink)
      : source_(source), policy_(policy), sink_(sink) {}

  [[nodiscard]] Expected<void> write(const SampleBlock& block, RowCounts& counts) {
    const std::size_t parts = policy_.in_turn ? 1 : parts_of(block.size(), policy_.threads);
    sink_.clear(parts);
    made_.assign(parts, {});
    parallel_for(parts, static_cast<unsigned>(parts), [&](std::size_t i) {
      made_[i] = make(block, i, block.size() * i / parts, block.size() * (i + 1) / parts);
    });
    for (std::size_t i = 0; i < parts; ++i) {
      if (auto written = sink_.write(i, source_); !written) return written;
      if (!made_[i].done) return made_[i].done;
      counts.outside += made_[i].counts.outside;
      counts.in_gaps += made_[i].counts.in_gaps;
      counts.without_band += made_[i].counts.without_band;
    }
    counts.samples += block.size();
    sink_.written(counts.samples);
    return {};
  }

 private:
  struct Made {
    RowCounts counts{};
    Expected<void> done{};
  };

  /// The samples without an orientation within the domain lie in gaps.
  [[nodiscard]] Made make(const SampleBlock& block, std::size_t buffer, std::size_t begin, std::size_t end) {
    const Domain domain = source_.domain();
    const TimeOrigin& origin = source_.origin();
    Made made;
    for (std::size_t k = begin; k < end && made.done; ++k) {
      const bool is_outside = !domain.contains(block.time(k));
      const bool is_in_gap = policy_.gaps != GapRows::none && !is_outside && !block.has_sample(k);
      made.counts.outside += is_outside ? 1 : 0;
      made.counts.in_gaps += is_in_gap ? 1 : 0;
      if (is_in_gap && policy_.gaps == GapRows::empty) sink_.add_empty(buffer, origin, block.offset(k));
      if (is_in_gap || (is_outside && policy_.outside == OutsideRows::left_out)) continue;
      made.counts.without_band += std::isinf(block.band(k)) ? 1 : 0;
      made.done = sink_.add(buffer, origin, block, k);
    }
    return made;
  }

  const SampleSource& source_;
  RowPolicy policy_;
  RowSink& sink_;
  std::vector<Made> made_;
};

}  // namespace

void SampleBlock::resize(std::size_t size) {
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

Samples<double> SampleBlock::room() noexcept {
  return {.orientations = orientations_,
          .angular_velocities = angular_velocities_,
          .angular_accelerations = angular_accelerations_,
          .angular_jerks = angular_jerks_,
          .positions = positions_,
          .velocities = velocities_,
          .accelerations = accelerations_};
}

Motion SampleBlock::motion(std::size_t k) const {
  return {.orientation = Eigen::Quaterniond(orientations_.data() + 4 * k),
          .angular_velocity = vector_of(angular_velocities_, k),
          .angular_acceleration = vector_of(angular_accelerations_, k),
          .angular_jerk = vector_of(angular_jerks_, k)};
}

LinearMotion SampleBlock::linear_motion(std::size_t k) const {
  return {.position = vector_of(positions_, k),
          .velocity = vector_of(velocities_, k),
          .acceleration = vector_of(accelerations_, k)};
}

Expected<void> CurveSamples::next(SampleBlock& block, std::size_t most, Work work) {
  block.resize(std::min(most, times_.size() - next_));
  times_.fill(next_, block.times(), block.offsets());
  next_ += block.size();
  if (sampling_.band && block.size() > 0) {
    const std::size_t parts = parts_of(block.size(), work.threads);
    parallel_for(parts, work.threads, [&](std::size_t i) {
      const std::size_t begin = block.size() * i / parts, end = block.size() * (i + 1) / parts;
      for (std::size_t k = begin; k < end; ++k) block.bands()[k] = band_at(*sampling_.band, block.time(k));
    });
  }
  return sample_at<double>(curve_, block.times(), block.room(), work).and_then([&] {
    return extrapolate<double>(curve_, block.times(), sampling_.extrapolation, block.room(), work);
  });
}

Expected<RowCounts> sample_rows(SampleSource& source, const RowColumns& columns, const RowPolicy& policy,
                                RowSink& sink) {
  SampleBlock block(columns);
  BlockRows rows(source, policy, sink);
  RowCounts counts;
  while (true) {
    auto made = source.next(block, policy.threads * samples_of_a_thread, {static_cast<unsigned>(policy.threads)});
    if (!made) return tl::unexpected(std::move(made.error()));
    if (block.size() == 0) return counts;
    if (auto written = rows.write(block, counts); !written) return tl::unexpected(std::move(written.error()));
  }
}

}}}  // namespace orispline::jobs
