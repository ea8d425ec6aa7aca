// SPDX-License-Identifier: Apache-2.0
#include "sampling.hpp"

#include <algorithm>
#include <vector>

#include "threads.hpp"

namespace orispline::cli {
namespace {

constexpr std::size_t stretch_size = 16384;  // samples that a thread makes at a time: far dearer than the thread

/// Successive samples that one thread makes.
class Stretch {
 public:
  explicit Stretch(const Sampling& sampling) : rows_(sampling.columns) {}

  /// Makes the samples from `begin` to before `end`.
  void make(const Sampling& sampling, std::size_t begin, std::size_t end) {
    rows_.clear();
    held_ = 0;
    made_ = {};
    const Domain domain = sampling.curve.orientation.domain();
    for (std::size_t k = begin; k < end && made_; ++k) {
      const auto [t, offset] = sampling.times[k];
      if (!domain.contains(t)) ++held_;
      io::Sample sample{.motion = sampling.curve.orientation.motion(t)};
      if (sampling.curve.position) sample.travel = sampling.curve.position->travel(t);
      made_ = rows_.append(sampling.times.origin(), offset, sample);
    }
  }

  /// Writes what was made; the number of samples that hold an end orientation.
  [[nodiscard]] Expected<std::size_t> write(io::SampleWriter& writer) const {
    auto written = writer.write(rows_).and_then([this] { return made_; });
    return written.map([this] { return held_; });
  }

 private:
  io::SampleRows rows_;
  std::size_t held_ = 0;
  Expected<void> made_;
};

}  // namespace

Expected<std::size_t> write_samples(io::SampleWriter& writer, const Sampling& sampling, Progress::Show show) {
  const std::size_t size = sampling.times.size();
  const auto stretch_begin = [size](std::size_t index) { return std::min(index * stretch_size, size); };
  const std::size_t stretches = (size + stretch_size - 1) / stretch_size;
  std::vector<Stretch> made(std::clamp<std::size_t>(stretches, 1, sampling.threads), Stretch(sampling));
  Progress progress(size, show);
  std::size_t held = 0;
  for (std::size_t first = 0; first < stretches; first += made.size()) {
    const std::size_t count = std::min(made.size(), stretches - first);
    on_threads(count,
               [&](std::size_t i) { made[i].make(sampling, stretch_begin(first + i), stretch_begin(first + i + 1)); });
    for (std::size_t i = 0; i < count; ++i) {
      const auto written = made[i].write(writer);
      if (!written) return tl::unexpected(written.error());
      held += *written;
    }
    progress.advance_to(stretch_begin(first + count));
  }
  return writer.finish().map([held] { return held; });
}

}  // namespace orispline::cli
