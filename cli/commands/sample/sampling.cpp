// SPDX-License-Identifier: Apache-2.0
#include "commands/sample/sampling.hpp"

#include <algorithm>
#include <functional>
#include <vector>

#include <orispline/base/parallel.hpp>
#include <orispline/batch/sample.hpp>

namespace orispline::cli {

namespace {

constexpr std::size_t chunk_size = 16384;  // samples that a thread makes at a time: far dearer than the thread

/// Only where it was asked for is a sample written that is NaN.
io::MissingSamples missing_samples_of(Extrapolation extrapolation) {
  return extrapolation == Extrapolation::nan ? io::MissingSamples::written : io::MissingSamples::refused;
}

/// Successive samples that one thread makes.
class Chunk {
 public:
  explicit Chunk(const Sampling& sampling)
      : samples_(sampling.columns),
        rows_(sampling.columns, {missing_samples_of(sampling.extrapolation), sampling.outside, sampling.gaps}) {}

  /// Makes the samples from `begin` to before `end`.
  void make(const Sampling& sampling, std::size_t begin, std::size_t end) {
    samples_.resize(end - begin);
    for (std::size_t k = begin; k < end; ++k) {
      const Instant instant = sampling.times[k];
      samples_.times()[k - begin] = instant.t;
      samples_.offsets()[k - begin] = instant.offset;
    }
    made_ = sample_at<double>(sampling.curve, samples_.times(), samples_.room()).and_then([&] {
      return extrapolate<double>(sampling.curve, samples_.times(), sampling.extrapolation, samples_.room());
    });
    if (sampling.band) std::ranges::transform(samples_.times(), samples_.bands().begin(), std::cref(*sampling.band));
    if (made_) rows_.make(samples_, 0, end - begin, sampling.times.origin(), sampling.curve.orientation.domain());
  }

  /// Writes what was made.
  [[nodiscard]] Expected<RowCounts> write(io::SampleWriter& writer) const {
    return made_.and_then([&] { return rows_.write(writer); });
  }

 private:
  SampleBuffer samples_;
  BufferRows rows_;
  Expected<void> made_;
};

}  // namespace

Expected<RowCounts> write_samples(io::SampleWriter& writer, const Sampling& sampling, Progress::Show show) {
  const std::size_t size = sampling.times.size();
  const auto chunk_begin = [size](std::size_t index) { return std::min(index * chunk_size, size); };
  const std::size_t chunks = (size + chunk_size - 1) / chunk_size;
  // Angles that run on know those of the row before.
  const std::size_t threads = sampling.columns.form.runs_on() ? 1 : sampling.threads;
  std::vector<Chunk> made(std::clamp<std::size_t>(chunks, 1, threads), Chunk(sampling));
  Progress progress(size, show);
  RowCounts counts;
  for (std::size_t first = 0; first < chunks; first += made.size()) {
    const std::size_t count = std::min(made.size(), chunks - first);
    parallel_for(count, static_cast<unsigned>(count),
                 [&](std::size_t i) { made[i].make(sampling, chunk_begin(first + i), chunk_begin(first + i + 1)); });
    for (std::size_t i = 0; i < count; ++i) {
      const auto written = made[i].write(writer);
      if (!written) return tl::unexpected(written.error());
      counts += *written;
    }
    progress.advance_to(chunk_begin(first + count));
  }
  return counts;
}

}  // namespace orispline::cli
