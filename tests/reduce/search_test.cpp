// SPDX-License-Identifier: Apache-2.0
// How far the search for few keys comes.
#include <reduce/recorded_walk.hpp>

namespace orispline {
namespace {

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

}  // namespace
}  // namespace orispline
