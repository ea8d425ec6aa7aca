// SPDX-License-Identifier: Apache-2.0
// How far the search for few keys comes, and what its steps promise.
#include <orispline/reduce/key_search.hpp>
#include <orispline/reduce/span_reach.hpp>
#include <reduce/recorded_walk.hpp>

namespace orispline { namespace {

using namespace testing_support;

// Both steps are searches without a bound: these are the counts that they reach, and what they save.
TEST(Reduce, ExchangesAndRefitsKeysUntilFewSuffice) {
  std::size_t sampled = 0, refitted = 0;
  for (unsigned seed = 0; seed < 8; ++seed) {
    const Keyframes recording =
        recorded({.samples = 120, .step = 0.03, .noise = 0.001, .shift = 0.0, .start = 1000.0}, seed);
    const Tolerance allowed{.angle = degree};
    sampled += reduced("auto", recording, {.tolerance = allowed}).samples.size();
    refitted += reduced("auto", recording, {.tolerance = allowed, .values = KeyValues::refitted}).samples.size();
  }
  EXPECT_LE(sampled, 510U);   // 532 without exchanges
  EXPECT_LE(refitted, 440U);  // 496 where keys move by wrong shares
}

TEST(Reduce, NeedsNoPositionsForTheirTolerance) {
  const Keyframes recording = recorded({.samples = 60, .step = 0.03, .noise = 0.001, .shift = 0.0}, 5);
  for (const std::string_view method : reducing_methods)
    for (const KeyValues values : {KeyValues::sampled, KeyValues::refitted}) {
      const Reduction without = reduced(method, recording, {.tolerance = {.angle = degree}, .values = values});
      const Reduction with =
          reduced(method, recording, {.tolerance = {.angle = degree, .position = 0.05}, .values = values});
      EXPECT_EQ(with.samples, without.samples) << method;
      EXPECT_FALSE(with.deviation.position) << method;
    }
}

TEST(ToleranceCheck, LooksAtTheKeysThemselves) {
  const Keyframes recording = recorded({.samples = 9, .step = 0.0, .noise = 0.0, .shift = 0.0}, 3);
  OpenEndedWork work({}, 1.0);
  const ToleranceCheck check(recording, {.angle = 0.01}, work);
  for (const std::size_t moved : {0u, 1u, 2u}) {
    KeySet keys = check.keys_at({0, 4, 8});
    keys.orientations[moved] = keys.orientations[moved] * exp<double>(Eigen::Vector3d(0.02, 0.0, 0.0));
    const auto direct = check.worst_samples("slerp", keys).value();
    const auto by_misses = worst_of_segments(keys, check.misses("slerp", keys).value());
    for (const auto& worst : {direct, by_misses})
      for (std::size_t s = 0; s < 2; ++s) {
        const bool is_beside = s == moved || s + 1 == moved;
        EXPECT_NEAR(worst[s].excess, is_beside ? 4.0 : 0.0, 0.001) << moved << " " << s;  // squared, by the sines
        if (is_beside) {
          EXPECT_EQ(worst[s].sample, keys.samples[moved]);
        }
      }
  }
}

TEST(KeyRemoval, PassesOnWhyARepairFailed) {
  const Keyframes recording = recorded({.samples = 9, .step = 0.03, .noise = 0.0, .shift = 0.0}, 3);
  OpenEndedWork work({}, 1.0);
  const ToleranceCheck check(recording, {.angle = 1.0}, work);
  const Repair failing{.keys_moved = 1, .apply = [](const auto&, KeySet&) -> Expected<void> {
                         return failure(ErrorCode::not_converged, "as asked");
                       }};
  const auto keys = with_keys_removed({.method = "slerp", .reach = 1}, check, check.keys_at({0, 4, 8}), failing);
  ASSERT_FALSE(keys);
  EXPECT_EQ(keys.error().message, "as asked");
}

// One sharp turn, which no span can pass: spans are ruled out right behind it, from either side.
TEST(SpanReach, EndsAtWhatNoSpanPasses) {
  constexpr std::size_t samples = 65, turn = 40;
  KeyframeData data;
  for (std::size_t i = 0; i < samples; ++i) {
    data.times.push_back(static_cast<double>(i));
    data.orientations.push_back(exp<double>(Eigen::Vector3d(0.0, 0.0, i < turn ? 0.0 : 1.0)));
  }
  const Keyframes recording = Keyframes::make(std::move(data)).value();
  OpenEndedWork work({}, 1.0);
  const ToleranceCheck check(recording, {.angle = 0.01}, work);
  const WitnessSamples telling(SpanTest(check), samples);
  const auto to_end = farthest_of_spans(check, telling, SpanDirection::to_end);
  const auto to_start = farthest_of_spans(check, telling, SpanDirection::to_start);
  for (std::size_t i = 0; i < samples; ++i) {
    EXPECT_GE(to_end[i], i + 1 < turn ? turn - 1 : std::min(i + 1, samples - 1)) << i;
    EXPECT_LE(to_start[i], i > turn ? turn : i - std::min<std::size_t>(i, 1)) << i;
    if (i + 1 < turn) {
      EXPECT_LT(to_end[i], turn + 8) << i;
    }
    if (i > turn) {
      EXPECT_GT(to_start[i], turn - 9) << i;
    }
  }
}

}}  // namespace orispline
