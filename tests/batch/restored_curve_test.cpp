// SPDX-License-Identifier: Apache-2.0
// Baked curves that were stored.

#include <batch/agreement.hpp>
#include <batch/specimen_curves.hpp>
#include <support/not_finite.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

template <class T>
void expect_the_same_when_restored(const AnyCurve& curve, double tolerance = 1e-6) {
  const BakedCurve<T> baked = bake<T>(curve, tolerance).value();
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
    expect_the_same_when_restored<double>(specimen_curve(kind), 0.5);  // few pieces, which turn far
  }
  expect_the_same_when_restored<double>(make_curve("auto", keyframes(random_walk(119, 1, Spacing::even))).value());
}

using Pieces = std::vector<batch::BakedRecord<double>>;

/// Two pieces of 1 s at rest.
Pieces two_pieces() {
  Pieces pieces;
  for (const double middle : {0.5, 1.5}) {
    pieces.push_back({.coefficients = {}, .middle = middle, .per_step = 2.0});
    pieces.back().coefficients[3][0] = 1.0;
  }
  return pieces;
}

TEST(BakedCurve, IsNotRestoredFromWhatIsNone) {
  const Pieces two = two_pieces();
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

/// Finite numbers of which no orientations, or no rates, can be made.
TEST(BakedCurve, IsNotRestoredFromFiniteNumbersThatGiveOthers) {
  using Change = void (*)(batch::BakedRecord<double>&);
  for (const Change change : std::initializer_list<Change>{
           [](auto& piece) { piece.coefficients[3][9] = 1.7e308; },
           [](auto& piece) {
             piece.coefficients[3][1] = 10.0;
           },  // no orientation at one place, a tenth before the middle
           [](auto& piece) { piece.coefficients[0][1] = 1e200; }, [](auto& piece) { piece.coefficients[3][0] = 0.0; },
           [](auto& piece) { piece.per_step = 1.7e308; }, [](auto& piece) { piece.middle = -1.7e308; },
           [](auto& piece) { piece = {.coefficients = {}, .middle = 1.5, .per_step = 1e200}; }}) {
    Pieces pieces = two_pieces();
    change(pieces[1]);
    const auto restored = BakedCurve<>::restored({0.0, 1.0, 2.0}, pieces, 0.0);
    ASSERT_FALSE(restored);
    EXPECT_EQ(restored.error().code, ErrorCode::bad_data);
    EXPECT_EQ(restored.error().message,
              "the piece from 1 to 2 s: found no orientations on all of it, wanted those of a baked curve");
  }
  EXPECT_FALSE(BakedCurve<>::restored({-1.7e308, 1.7e308}, {two_pieces()[0]}, 0.0));
}

}}  // namespace orispline
