// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/smoothing_stretches.hpp>

#include <algorithm>

#include <orispline/base/formatted.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t shortest_run = 3;  // of far samples that are rather motion than faults

/// As many as tell noise from motion.
std::size_t fewest_samples(Penalty penalty) { return static_cast<std::size_t>(order_of(penalty)) + 1; }

template <class T>
std::vector<T> in_stretch(std::span<const T> all, const Stretch& stretch) {
  const auto part = all.subspan(stretch.first, stretch.count);
  return {part.begin(), part.end()};
}

}  // namespace

RecordingScale scale_of(const Keyframes& recording) {
  return {.interval = median_interval(recording.times()),
          .noise = std::max(least_noise, local_noise(recording.times(), recording.orientations()))};
}

Expected<std::vector<Stretch>> stretches_of(const Keyframes& recording, Penalty penalty, std::optional<double> gap) {
  const auto t = recording.times();
  auto stretches = stretches_between_gaps(t, gap);
  if (!stretches) return stretches;
  std::erase_if(*stretches, [&](const Stretch& stretch) { return stretch.count < fewest_samples(penalty); });
  if (!stretches->empty()) return stretches;
  return failure(ErrorCode::bad_data, formatted("found {} {}, wanted at least {} {}to smooth", t.size(),
                                                t.size() == 1 ? "sample" : "samples", fewest_samples(penalty),
                                                are_in_stretches(recording, gap) ? "without a gap " : ""));
}

StretchProblems problems_of(const Keyframes& recording, const std::vector<Stretch>& stretches, double noise,
                            const std::vector<double>& shares) {
  StretchProblems problems;
  for (const Stretch& stretch : stretches) {
    problems.push_back({.times = in_stretch(recording.times(), stretch),
                        .orientations = in_stretch(recording.orientations(), stretch)});
    if (!shares.empty()) problems.back().shares = in_stretch(std::span(shares), stretch);
  }
  readmit(problems, noise);
  return problems;
}

StretchProblems position_problems_of(const Keyframes& recording, const std::vector<Stretch>& stretches,
                                     const Eigen::Vector3d& origin, double unit) {
  StretchProblems problems;
  for (const Stretch& stretch : stretches) {
    auto& problem = problems.emplace_back();
    problem.times = in_stretch(recording.times(), stretch);
    for (const Eigen::Vector3d& p : in_stretch(recording.positions(), stretch))
      problem.positions.emplace_back((p - origin) / unit);
    problem.weights.assign(stretch.count, 1.0);
  }
  return problems;
}

FarSamples far_samples(const std::vector<std::vector<double>>& lengths, const std::vector<Stretch>& stretches,
                       double limit) {
  FarSamples far;
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const auto& those = lengths[k];
    for (std::size_t begin = 0, end; begin < those.size(); begin = end + 1) {
      end = begin;
      while (end < those.size() && those[end] > limit) ++end;
      auto& samples = end - begin >= shortest_run ? far.in_runs : far.single;
      for (std::size_t i = begin; i < end; ++i) samples.push_back(stretches[k].first + i);
    }
  }
  return far;
}

void readmit(StretchProblems& problems, double noise) {
  for (SmoothingProblem& problem : problems) {
    problem.weights.assign(problem.size(), 1.0 / (noise * noise));
    for (std::size_t i = 0; i < problem.shares.size(); ++i) problem.weights[i] *= problem.shares[i];
  }
}

Expected<FarSamples> reject(StretchProblems& problems, const std::vector<Stretch>& stretches, FarSamples far,
                            Penalty penalty) {
  FarSamples done{.single = {}, .in_runs = std::move(far.in_runs)};
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    const auto& [first, count] = stretches[k];
    const auto begin = std::ranges::lower_bound(far.single, first);
    const auto end = std::ranges::lower_bound(far.single, first + count);
    const auto left = count - static_cast<std::size_t>(end - begin);
    const bool enough = left >= fewest_samples(penalty);
    if (!enough && stretches.size() == 1)
      return failure(ErrorCode::bad_data, formatted("of {} samples {} are outliers, wanted at least {} others", count,
                                                    count - left, fewest_samples(penalty)));
    auto& samples = enough ? done.single : done.in_runs;
    samples.insert(samples.end(), begin, end);
    for (auto sample = begin; enough && sample != end; ++sample) problems[k].weights[*sample - first] = 0.0;
  }
  std::ranges::sort(done.in_runs);
  return done;
}

}}  // namespace orispline
