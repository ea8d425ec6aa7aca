// SPDX-License-Identifier: Apache-2.0
// Baked curves that were stored.

#include <batch/agreement.hpp>
#include <batch/specimen_curves.hpp>
#include <support/not_finite.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

template <class T>
void expect_the_same_when_restored(const AnyCurve& curve) {
  const BakedCurve<T> baked = bake<T>(curve, 1e-6).value();
  const auto ends = baked.knots().times();
  const auto pieces = baked.pieces();
  const auto restored =
      BakedCurve<T>::restored({ends.begin(), ends.end()}, {pieces.begin(), pieces.end()}, baked.largest_difference());
  ASSERT_TRUE(restored) << describe(restored.error());
  EXPECT_EQ(restored->largest_difference(), baked.largest_difference());
  for (double t = curve.domain().start - 0.5; t < curve.domain().end + 0.5; t += 0.01)
    EXPECT_EQ((*restored)(t).coeffs(), baked(t).coeffs()) << t;
}

TEST(BakedCurve, IsTheSameWhenItIsRestored) {
  for (const char* kind : kinds_of_curves) {
    expect_the_same_when_restored<double>(specimen_curve(kind));
    expect_the_same_when_restored<float>(specimen_curve(kind));
  }
  expect_the_same_when_restored<double>(make_curve("auto", keyframes(random_walk(119, 1, Spacing::even))).value());
}

TEST(BakedCurve, IsNotRestoredFromWhatIsNone) {
  using Pieces = std::vector<batch::BakedRecord<double>>;
  const Pieces two(2, batch::BakedRecord<double>{});
  EXPECT_TRUE(BakedCurve<>::restored({0.0, 1.0, 2.0}, two, 0.0));
  Pieces broken = two;
  broken[1].coefficients[3][9] = infinity;
  for (const auto& restored :
       {BakedCurve<>::restored({}, {}, 0.0), BakedCurve<>::restored({0.0, 1.0, 1.0}, two, 0.0),
        BakedCurve<>::restored({0.0, nan, 2.0}, two, 0.0), BakedCurve<>::restored({0.0, 1.0}, two, 0.0),
        BakedCurve<>::restored({0.0, 1.0, 2.0}, broken, 0.0), BakedCurve<>::restored({0.0, 1.0, 2.0}, two, infinity)}) {
    ASSERT_FALSE(restored);
    EXPECT_EQ(restored.error().code, ErrorCode::bad_data);
  }
}

}}  // namespace orispline
