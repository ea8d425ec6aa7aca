// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <orispline/families/registry.hpp>
#include <reduce/recorded_walk.hpp>
#include <support/follower.hpp>

namespace orispline { namespace {

using namespace testing_support;

double angle_between(const Eigen::Quaterniond& p, const Eigen::Quaterniond& q) {
  const double chord = std::min((p.coeffs() - q.coeffs()).norm(), (p.coeffs() + q.coeffs()).norm());
  return 4.0 * std::asin(std::min(1.0, 0.5 * chord));
}

/// Whether the geodesic between two samples passes all between them, by the sines of the textbook.
bool span_holds(const Keyframes& k, std::size_t i, std::size_t j, const Tolerance& tolerance) {
  const Eigen::Quaterniond& from = k.orientations()[i];
  Eigen::Quaterniond to = k.orientations()[j];
  if (from.dot(to) < 0.0) to.coeffs() = -to.coeffs();
  const double half = 2.0 * std::asin(std::min(1.0, 0.5 * (from.coeffs() - to.coeffs()).norm()));
  for (std::size_t m = i + 1; m < j; ++m) {
    const double share = (k.times()[m] - k.times()[i]) / (k.times()[j] - k.times()[i]);
    Eigen::Quaterniond at = from;
    if (half > 0.0)
      at.coeffs() =
          (std::sin((1.0 - share) * half) * from.coeffs() + std::sin(share * half) * to.coeffs()) / std::sin(half);
    if (angle_between(at, k.orientations()[m]) > tolerance.angle) return false;
    if (k.positions().empty()) continue;
    const Eigen::Vector3d position = (1.0 - share) * k.positions()[i] + share * k.positions()[j];
    if ((position - k.positions()[m]).norm() > tolerance.position) return false;
  }
  return true;
}

/// The number of keys of the shortest chain, by trying every span.
std::size_t fewest_keys(const Keyframes& k, const Tolerance& tolerance) {
  std::vector<std::size_t> keys(k.size(), k.size() + 1);
  keys[0] = 1;
  for (std::size_t j = 1; j < k.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (keys[i] + 1 < keys[j] && span_holds(k, i, j, tolerance)) keys[j] = keys[i] + 1;
  return keys.back();
}

void expect_within(const Reduction& reduction, const Keyframes& recording, const Tolerance& tolerance) {
  const PoseCurve curve = make_pose_curve(reduction.method, reduction.track.keys).value();
  double angle = 0.0, distance = 0.0;
  for (std::size_t i = 0; i < recording.size(); ++i) {
    const double t = recording.times()[i];
    angle = std::max(angle, angle_between(curve.orientation(t), recording.orientations()[i]));
    if (!recording.positions().empty())
      distance = std::max(distance, (curve.position->linear_motion(t).position - recording.positions()[i]).norm());
  }
  EXPECT_LE(angle, tolerance.angle * (1.0 + 1e-12)) << reduction.method.name;
  EXPECT_LE(distance, tolerance.position) << reduction.method.name;
  EXPECT_NEAR(reduction.deviation.angle, angle, 1e-12) << reduction.method.name;
  EXPECT_NEAR(reduction.deviation.position.value_or(0.0), distance, 1e-12) << reduction.method.name;
}

TEST(Reduce, OfNoSamplesSaysSo) {
  EXPECT_EQ(Reduction{}.track.keys.size(), 0u);
  const auto reduction = reduce(Reduction{}.track, "auto", {.tolerance = {.angle = 0.01}});
  ASSERT_FALSE(reduction);
  EXPECT_EQ(reduction.error().message, "auto needs 2 keys, found 0");
}

TEST(Reduce, NeedsNoMoreGeodesicsThanTheShortestChainOfAll) {
  for (unsigned seed = 0; seed < 120; ++seed)
    for (const double tolerance : {0.3, 1.0, 3.0, 10.0, 40.0}) {
      const Walk walk{
          .samples = 3 + seed % 58, .step = 0.02 * (1 + seed % 7), .noise = 0.004 * (seed % 4), .shift = 0.0};
      const Keyframes recording = recorded(walk, seed);
      const Tolerance allowed{.angle = tolerance * degree};
      const Reduction found = reduced("slerp", recording, {.tolerance = allowed});
      EXPECT_EQ(found.samples.size(), fewest_keys(recording, allowed)) << seed << " " << tolerance;
      expect_within(found, recording, allowed);
    }
}

TEST(Reduce, NeedsNoMoreGeodesicsForLongSpansAndLargeTurns) {
  for (unsigned seed = 0; seed < 12; ++seed)
    for (const double noise : {0.001, 0.01}) {
      const Keyframes long_spans = recorded({.samples = 260, .step = 0.004, .noise = noise, .shift = 0.0}, seed);
      for (const double factor : {0.5, 1.2, 1.7, 2.5}) {
        const Tolerance allowed{.angle = factor * noise};
        EXPECT_EQ(reduced("slerp", long_spans, {.tolerance = allowed}).samples.size(), fewest_keys(long_spans, allowed))
            << seed << " " << noise << " " << factor;
      }
      const Keyframes large_turns = recorded({.samples = 40, .step = 1.7, .noise = noise, .shift = 0.0}, seed);
      for (const double tolerance : {0.1, 1.0, 2.5}) {
        const Tolerance allowed{.angle = tolerance};
        EXPECT_EQ(reduced("slerp", large_turns, {.tolerance = allowed}).samples.size(),
                  fewest_keys(large_turns, allowed))
            << seed << " " << tolerance;
      }
    }
}

/// At rest but for one turn in the middle, with noise of that largest component [rad].
Keyframes at_rest_but_for_a_jump(std::size_t samples, double jump, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(-noise, noise);
  KeyframeData data;
  for (std::size_t i = 0; i < samples; ++i) {
    const Eigen::Quaterniond rest = exp<double>(Eigen::Vector3d(0.0, 0.0, i < samples / 2 ? 0.0 : jump));
    data.times.push_back(0.01 * static_cast<double>(i));
    data.orientations.push_back(rest * exp<double>(Eigen::Vector3d(any(random), any(random), any(random))));
  }
  return Keyframes::make(std::move(data)).value();
}

TEST(Reduce, NeedsNoMoreGeodesicsAtRestInNoise) {
  constexpr double noise = 0.04 * degree;
  for (unsigned seed = 0; seed < 10; ++seed)
    for (const double jump : {0.0, 1.0, 90.0, 179.9, 180.0}) {
      const Keyframes recording = at_rest_but_for_a_jump(180, jump * degree, noise, seed);
      for (const double factor : {1.3, 1.7, 2.0, 2.3, 2.6}) {
        const Tolerance allowed{.angle = factor * noise};
        const Reduction found = reduced("slerp", recording, {.tolerance = allowed});
        EXPECT_EQ(found.samples.size(), fewest_keys(recording, allowed)) << seed << " " << jump << " " << factor;
        expect_within(found, recording, allowed);
      }
    }
}

TEST(Reduce, NeedsNoMoreGeodesicsWithPositionsBounded) {
  for (unsigned seed = 0; seed < 60; ++seed)
    for (const double distance : {0.01, 0.05, 0.2}) {
      const Keyframes recording =
          recorded({.samples = 50, .step = 0.03, .noise = 0.002, .shift = 0.03, .start = 1.7e9}, seed);
      const Tolerance allowed{.angle = 2.0 * degree, .position = distance};
      const Reduction found = reduced("slerp", recording, {.tolerance = allowed});
      EXPECT_EQ(found.samples.size(), fewest_keys(recording, allowed)) << seed << " " << distance;
      expect_within(found, recording, allowed);
    }
}

TEST(Reduce, IsWithinTheToleranceByEveryMethodAndRefittedKeysAreNotMore) {
  for (unsigned seed = 0; seed < 3; ++seed) {
    const Keyframes recording = recorded({.samples = 200, .step = 0.03, .noise = 0.001, .shift = 0.01}, seed);
    const Tolerance allowed{.angle = 1.0 * degree, .position = 0.05};
    for (const std::string_view method : {"auto", "timed-c2", "slerp", "squad-timed", "timed-c1"}) {
      const Reduction sampled = reduced(method, recording, {.tolerance = allowed});
      const Reduction refitted = reduced(method, recording, {.tolerance = allowed, .values = KeyValues::refitted});
      expect_within(sampled, recording, allowed);
      expect_within(refitted, recording, allowed);
      EXPECT_LE(refitted.samples.size(), sampled.samples.size()) << method;
      EXPECT_LT(sampled.samples.size(), recording.size()) << method;
    }
  }
}

/// Turns [rad] about one axis at whole seconds after `start`.
Keyframes about_an_axis(const std::vector<double>& turns, double start = 0.0) {
  KeyframeData data;
  for (const double turn : turns) {
    data.times.push_back(start + static_cast<double>(data.times.size()));
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.6 * turn, 0.0, 0.8 * turn)));
  }
  return Keyframes::make(std::move(data)).value();
}

std::vector<double> evenly(std::size_t count, double step) {
  std::vector<double> turns(count);
  for (std::size_t i = 0; i < count; ++i) turns[i] = step * static_cast<double>(i);
  return turns;
}

TEST(Reduce, KeepsTheTwoEndsOfAnEvenTurnOfRestAndOfTwoSamples) {
  for (const std::string_view method : reducing_methods)
    for (const Keyframes& recording : {about_an_axis(evenly(200, 0.01)), about_an_axis(evenly(200, 0.0)),
                                       about_an_axis(evenly(2, 2.0)), about_an_axis(evenly(200, 0.01), 1.7e9)})
      EXPECT_EQ(reduced(method, recording, {.tolerance = {.angle = 1e-9}}).samples,
                (std::vector<std::size_t>{0, recording.size() - 1}))
          << method;
}

TEST(Reduce, KeepsHalfTurnsBetweenSamples) {
  const Keyframes recording = about_an_axis(evenly(9, std::numbers::pi));
  for (const std::string_view method : reducing_methods)
    EXPECT_EQ(reduced(method, recording, {.tolerance = {.angle = 0.01}}).samples.size(), 9u) << method;
}

TEST(Reduce, AnEnormousToleranceLeavesTheTwoEnds) {
  const Keyframes recording = recorded({.samples = 100, .step = 2.0, .noise = 1.0, .shift = 1.0}, 7);
  for (const std::string_view method : reducing_methods)
    for (const double angle : {3.15, 1e6, std::numeric_limits<double>::infinity()})
      EXPECT_EQ(reduced(method, recording, {.tolerance = {.angle = angle}}).samples.size(), 2u) << method << angle;
}

TEST(Reduce, SaysWhatItCannotDo) {
  const Keyframes recording = about_an_axis(evenly(5, 0.1));
  const auto error = [&](std::string_view method, const Keyframes& samples, const Tolerance& tolerance) {
    const auto reduction = reduce(samples, method, {.tolerance = tolerance});
    return reduction ? std::string("none") : describe(reduction.error());
  };
  for (const auto& [angle, shown] : {std::pair(0.0, "0"), {-1.0, "-1"}, {1e-13, "1e-13"}, {std::nan(""), "nan"}})
    EXPECT_EQ(error("slerp", recording, {.angle = angle}),
              std::string("tolerance: found ") + shown +
                  " rad, wanted 1e-12 rad at least: the rounding of orientations is not much smaller");
  for (const auto& [position, shown] : {std::pair(0.0, "0"), {-1.0, "-1"}, {std::nan(""), "nan"}})
    EXPECT_EQ(error("auto", recording, {.angle = 0.1, .position = position}),
              std::string("position_tolerance: found ") + shown + " m, wanted more than 0");
  EXPECT_EQ(error("slerp", about_an_axis({0.0}), {.angle = 0.1}), "found 1 sample, wanted 2 or more");
  EXPECT_EQ(
      error("rotation-spline", recording, {.angle = 0.1}),
      "rotation-spline: found a method that depends on all keys, wanted a local one through its keys, such as auto");
  EXPECT_EQ(error("bspline", recording, {.angle = 0.1}),
            "bspline: found a method that passes near its keys, wanted a local one through its keys, such as auto");
  EXPECT_NE(error("no-such", recording, {.angle = 0.1}), "none");
}

TEST(Reduce, GivesTheSameOnAnyNumberOfThreads) {
  const std::vector<Method> methods(reducing_methods.begin(), reducing_methods.end());
  std::vector<Track> tracks;
  for (unsigned seed = 0; seed < 5; ++seed)
    tracks.push_back(recorded({.samples = 60 + 20 * seed, .step = 0.03, .noise = 0.001, .shift = 0.0}, seed));
  tracks.push_back(about_an_axis({0.0}));
  const ReduceOptions options{.tolerance = {.angle = 0.5 * degree}, .values = KeyValues::refitted};
  const auto alone = reduce_tracks(tracks, methods, options, 1);
  ASSERT_EQ(alone.size(), tracks.size());
  EXPECT_FALSE(alone.back());
  for (const unsigned threads : {2u, 3u, 16u, 0u}) {
    const auto found = reduce_tracks(tracks, methods, options, threads);
    for (std::size_t i = 0; i + 1 < tracks.size(); ++i)
      for (std::size_t m = 0; m < reducing_methods.size(); ++m) {
        const Reduction &a = alone[i]->at(m), &b = found[i]->at(m);
        EXPECT_EQ(a.method.name, reducing_methods[m]);
        EXPECT_EQ(a.samples, b.samples);
        EXPECT_EQ(a.deviation.angle, b.deviation.angle);
        for (std::size_t k = 0; k < a.track.keys.size(); ++k)
          EXPECT_EQ(a.track.keys.orientations()[k].coeffs(), b.track.keys.orientations()[k].coeffs());
      }
  }
}

TEST(Reduce, MeasuresTheDistanceToSamplesButThoseLeftOut) {
  const Keyframes recording = about_an_axis(evenly(9, 0.1));
  const Reduction reduction = reduced("slerp", recording, {.tolerance = {.angle = 0.01}});
  std::vector<double> turns = evenly(9, 0.1);
  turns[2] += 1.0, turns[4] += 0.02, turns[6] -= 0.03;
  const DistanceStatistics distance =
      distance_of(reduction, about_an_axis(turns), std::array<std::size_t, 1>{2}).value();
  EXPECT_EQ(distance.count, 8u);
  EXPECT_EQ(distance.largest_at, 6u);
  EXPECT_NEAR(distance.largest, 0.03, 1e-12);
  EXPECT_NEAR(distance.rms, std::sqrt((0.02 * 0.02 + 0.03 * 0.03) / 8.0), 1e-12);
  const DistanceStatistics of_none =
      distance_of(reduction, about_an_axis(turns), std::array<std::size_t, 9>{0, 1, 2, 3, 4, 5, 6, 7, 8}).value();
  EXPECT_EQ(of_none.count, 0u);
  EXPECT_EQ(of_none.largest_at, 0u);
}

TEST(Reduce, IsFollowedAndStopped) {
  const Keyframes recording = recorded({300, 0.05, 0.0, 0.0}, 61);
  testing_support::expect_to_be_followed_and_stopped(
      [&](const Progress& progress) { return reduce(recording, "auto", {.tolerance = {.angle = degree}}, progress); });
  std::stop_source stopped;
  stopped.request_stop();
  for (const std::string_view method : reducing_methods)
    for (const KeyValues values : {KeyValues::sampled, KeyValues::refitted}) {
      const auto none =
          reduce(recording, method, {.tolerance = {.angle = degree}, .values = values}, {.stop = stopped.get_token()});
      ASSERT_FALSE(none) << method;
      EXPECT_EQ(none.error().code, ErrorCode::cancelled) << method;
    }
}

}}  // namespace orispline
