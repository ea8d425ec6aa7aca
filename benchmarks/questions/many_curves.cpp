// SPDX-License-Identifier: Apache-2.0
// What do many curves at one time cost? All have the same key times and tension, each its own keys.
#include <benchmark/benchmark.h>

#include <memory>
#include <orispline/batch/curve_bundle.hpp>
#include <peers/peers.hpp>
#include <questions/questions.hpp>
#include <workload/buffer.hpp>
#include <workload/keys.hpp>
#include <workload/verify.hpp>

namespace orispline::bench {

namespace {

constexpr double time = 1.4, tension = 0.5;  // in the second of three segments, from 1 to 2 s

Track four_keys(std::uint64_t seed) {
  Track track = random_track(4, seed);
  track.times = {0.0, 1.0, 2.0, 3.0};
  track.tensions.assign(4, tension);
  return track;
}

/// What the formula needs of the second segment, curve after curve: see many_by_formula.
template <class T>
std::vector<T> segments_of(std::size_t curves) {
  std::vector<T> segments;
  segments.reserve(13 * curves);
  for (std::size_t i = 0; i < curves; ++i) {
    const Track track = four_keys(i + 1);
    const auto key = [&](std::size_t k) { return Eigen::Quaterniond(&track.orientations[4 * k]); };
    for (const double x : Eigen::Vector4d(key(1).coeffs())) segments.push_back(static_cast<T>(x));
    for (std::size_t k = 0; k < 3; ++k)
      for (const double x : Eigen::Vector3d(0.5 * log(key(k).conjugate() * key(k + 1))))
        segments.push_back(static_cast<T>(x));
  }
  return segments;
}

template <class T>
struct Scene {
  std::vector<CompiledCurve<T>> curves;
  std::vector<T> segments;
  std::vector<LongQuaternion> truth;
  Buffer<T> out;

  explicit Scene(std::size_t count) : segments(segments_of<T>(count)), out(4 * count) {
    for (std::size_t i = 0; i < count; ++i) {
      const Track track = four_keys(i + 1);
      curves.emplace_back(curve_through(track));
      truth.push_back(Definition(track).quintic(time));
    }
  }
};

template <class T>
void enter_contenders(std::size_t count, Errors& errors) {
  constexpr bool in_double = std::is_same_v<T, double>;
  const auto scene = std::make_shared<Scene<T>>(count);
  const auto enter = [&](const std::string& contender, double limit, auto run) {
    const std::string name = "many/" + contender + (in_double ? "/double/" : "/float/") + std::to_string(count);
    run();
    const double error =
        largest_error<T>(scene->out.all(), Layout::interleaved, [&](std::size_t k) { return scene->truth[k]; });
    measure(name, count, run);
    return accept(name, error, limit);
  };
  const auto enter_ours = [&](const std::string& contender, auto run) {
    if constexpr (in_double) errors.add_double(enter(contender, 1.2 * our_limit, run));
    else errors.add_float(enter(contender, our_float_limit, run));
  };
  enter_ours("ours", [scene] {
    check(sample_many<T>(std::span<const CompiledCurve<T>>(scene->curves), time, {.orientations = scene->out.all()}));
  });
  std::vector<AnyCurve> curves;
  for (const CompiledCurve<T>& compiled : scene->curves) curves.push_back(compiled.curve());
  const auto bundle = std::make_shared<CurveBundle<T>>(CurveBundle<T>::make(std::move(curves)).value());
  enter_ours("ours bundled", [scene, bundle] { check(bundle->sample(time, {.orientations = scene->out.all()})); });
  enter("formula", in_double ? peer_limit : peer_float_limit, [scene] {
    many_by_formula<T>(scene->segments, static_cast<T>(time - 1.0), static_cast<T>(tension), scene->out.all());
  });
}

}  // namespace

void ask_many_curves(const Sizes& sizes, Errors& errors) {
  for (const std::size_t count : sizes.many_curves) {
    enter_contenders<double>(count, errors);
    enter_contenders<float>(count, errors);
  }
}

}  // namespace orispline::bench
