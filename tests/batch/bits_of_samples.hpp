// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <vector>

#include <batch/bits_hash.hpp>
#include <batch/sampled.hpp>
#include <batch/specimen_curves.hpp>
#include <orispline/batch/baked_curve.hpp>
#include <orispline/batch/path_sampler.hpp>
#include <support/tracks.hpp>

// The bits of all samples of all curves, from keys to samples. Every processor, compiler, level of optimisation and
// instruction set, WebAssembly too, must come to the numbers that are written here; a change of the formulas may change
// them, on purpose.

namespace orispline::testing_support {

struct BitsOfSamples {
  std::uint64_t local_samples, local_jerks;
  std::uint64_t solved_samples, solved_jerks;  ///< of solutions of equations over all keys
  std::uint64_t path_samples, path_rates;      ///< of baked curves and of positions
};

inline constexpr BitsOfSamples written_bits{.local_samples = 0x3f811b94674bd3d7U,
                                            .local_jerks = 0xb527e48936d3428aU,
                                            .solved_samples = 0x4a189207f105c82fU,
                                            .solved_jerks = 0xcac4c3033bee3601U,
                                            .path_samples = 0x2e65c57236076fb7U,
                                            .path_rates = 0x3168807cffbfa260U};

/// Angles that need folding.
[[nodiscard]] inline AnyCurve tense_curve(double tension) {
  CurveOptions options;
  options.parameters.emplace("tension", std::vector{tension});
  return make_curve({"quintic", options}, keyframes(random_walk(103, 9, Spacing::uneven))).value();
}

/// Whether the curve is the solution of equations over all keys, whose bits depend on how they are eliminated.
[[nodiscard]] inline bool is_solved(const std::string& name) {
  const auto family = find_family(name);
  return family && (*family)->support_keys == all_keys;
}

/// Curves with positions of every kind.
[[nodiscard]] inline std::vector<PoseCurve> specimen_pose_curves() {
  std::vector<PoseCurve> all;
  for (const char* name : kinds_of_curves)
    all.push_back(make_pose_curve(name, keyframes(posed_walk(141, 9, Spacing::uneven, 0.7))).value());
  return all;
}

/// Without a framework of tests, which WebAssembly has none of.
inline void expect_done(const Expected<void>& done) {
  if (done) return;
  std::fputs(describe(done.error()).c_str(), stderr);
  std::abort();
}

struct RatesHashes {
  BitsHash samples, rates;  ///< `rates`: what has one derivative more
};

template <class T>
void add_samples(const AnyCurve& curve, RatesHashes& hashes) {
  Sampled<T> samples(500, Wanted::jerk);
  const double start = curve.domain().start, end = curve.domain().end;
  expect_done(sample_uniform<T>(curve, start, (end - start) / 480.0, samples.spans()));
  const Samples<T> spans = samples.spans();
  hashes.samples.add(spans.orientations);
  hashes.samples.add(spans.angular_velocities);
  hashes.samples.add(spans.angular_accelerations);
  hashes.rates.add(spans.angular_jerks);
}

/// Of the baked curve all, and positions.
template <class T>
void add_samples(const PoseCurve& curve, RatesHashes& hashes) {
  const auto [start, end] = curve.orientation.domain();
  const double dt = (end - start) / 480.0;
  std::vector<T> orientations(4 * 500), ignored(orientations), first(3 * 500), second(first), third(first);
  const BakedCurve<T> baked = bake<T>(curve.orientation, 1e-6).value();
  expect_done(sample_uniform<T>(baked, start, dt, Samples<T>{.orientations = orientations}));
  hashes.samples.add(std::span<const T>(orientations));
  const Samples<T> path{.orientations = ignored, .positions = first, .velocities = second, .accelerations = third};
  expect_done(sample_uniform<T>(curve, start, dt, path));
  for (const auto& numbers : {first, second, third}) hashes.samples.add(std::span<const T>(numbers));
  const Samples<T> rates{
      .orientations = ignored, .angular_velocities = first, .angular_accelerations = second, .angular_jerks = third};
  expect_done(sample_uniform<T>(baked, start, dt, rates));
  for (const auto& numbers : {first, second, third}) hashes.rates.add(std::span<const T>(numbers));
  expect_done(sample_uniform<T>(curve, start, dt, Samples<T>{.orientations = ignored, .linear_jerks = first}));
  hashes.rates.add(std::span<const T>(first));
}

/// `note(name, hash)` is called after each method with what its kind has come to, to find the one that differs.
template <class Note>
[[nodiscard]] BitsOfSamples bits_of_samples(Note note) {
  RatesHashes local, solved, paths;
  std::vector<NamedCurve> curves = curve_of_every_family(107);
  for (const double tension : {0.5, 20.0}) curves.push_back({std::to_string(tension), tense_curve(tension)});
  for (const auto& [name, curve] : curves) {
    RatesHashes& hashes = is_solved(name) ? solved : local;
    add_samples<double>(curve, hashes);
    add_samples<float>(curve, hashes);
    note(name, hashes.samples.value());
  }
  for (const PoseCurve& curve : specimen_pose_curves()) {
    add_samples<double>(curve, paths);
    add_samples<float>(curve, paths);
  }
  return {local.samples.value(), local.rates.value(),   solved.samples.value(),
          solved.rates.value(),  paths.samples.value(), paths.rates.value()};
}

}  // namespace orispline::testing_support
