// SPDX-License-Identifier: Apache-2.0
// The fits of a few keys: their rates, and how far a key lies from what the others foretell.
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/curve/chart_curve.hpp>
#include <orispline/curve/natural_spline.hpp>
#include <orispline/curve/window_polynomial.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

using namespace testing_support;

Window some_window(Dice& dice, std::size_t size, std::size_t centre) {
  Window window{.size = size, .centre = centre};
  for (std::size_t i = 1; i < size; ++i) window.times[i] = window.times[i - 1] + dice.between(0.5, 2.0);
  const double origin = window.times[centre];
  for (std::size_t i = 0; i < size; ++i) {
    window.times[i] -= origin;
    window.displacements[i] = dice.vector();
  }
  return window;
}

Window moved(Window window, std::size_t key, const Eigen::Vector3d& by) {
  window.displacements[key] += by;
  return window;
}

/// The miss of a key whose others foretell 0 grows as the key moves, and is the way that it moved.
template <class Fit>
void expect_misses_of_keys_that_move() {
  Dice dice(381);
  for (std::size_t size = 4; size <= Window::capacity; ++size)
    for (std::size_t key = 0; key < size; ++key) {
      SCOPED_TRACE(testing::Message() << "key " << key << " of " << size);
      Window line = some_window(dice, size, size / 2);
      const Eigen::Vector3d slope = dice.vector(), by = dice.vector();
      for (std::size_t i = 0; i < size; ++i) line.displacements[i] = line.times[i] * slope;
      EXPECT_NEAR(Fit(line).left_out_error(0, size), 0.0, tolerance::algebra);
      const Window off = moved(line, key, by);
      EXPECT_NEAR(Fit(off).left_out_error(key, key + 1), by.squaredNorm(), tolerance::algebra);

      const Window any = some_window(dice, size, size / 2);
      const auto miss = [&](double share) {
        return Fit(moved(any, key, share * by)).left_out_error(key, key + 1);
      };  // |m + share by|², of which the second difference is 2 |by|²
      EXPECT_NEAR(miss(1.0) - 2.0 * miss(0.0) + miss(-1.0), 2.0 * by.squaredNorm(), 1e2 * tolerance::algebra);
    }
}

TEST(WindowPolynomial, MissesAKeyByAsMuchAsItMoves) { expect_misses_of_keys_that_move<WindowPolynomial>(); }
TEST(NaturalSpline, MissesAKeyByAsMuchAsItMoves) { expect_misses_of_keys_that_move<NaturalSpline>(); }

TEST(NaturalSpline, HasRatesThatMeetAtAKeyAndNoneBeyondItsEnds) {
  Dice dice(382);
  for (std::size_t size = 2; size <= Window::capacity; ++size) {
    const Window window = some_window(dice, size, 0);
    std::vector<WindowRates> rates;
    for (std::size_t centre = 0; centre < size; ++centre) {
      Window seen = window;
      seen.centre = centre;
      rates.push_back(NaturalSpline(seen).rates());
    }
    EXPECT_TRUE(near(rates.front().second, Eigen::Vector3d::Zero(), 0.0));
    EXPECT_TRUE(near(rates.back().second, Eigen::Vector3d::Zero(), 0.0));
    for (std::size_t i = 0; i + 1 < size; ++i) {  // a cubic between two keys
      const double h = window.step(i);
      EXPECT_TRUE(near(rates[i + 1].first - rates[i].first, 0.5 * h * (rates[i].second + rates[i + 1].second),
                       tolerance::algebra));
      EXPECT_TRUE(near(window.secant(i), rates[i].first + h / 6.0 * (2.0 * rates[i].second + rates[i + 1].second),
                       tolerance::algebra));
    }
  }
}

TEST(ChartPiece, AboutTheMiddleHasTheRatesThatWereAskedForWhateverItTurns) {
  Dice dice(383);
  for (const double turn : {0.0, 1e-9, 0.3, 1.5, 3.1, 4.5, 6.0}) {
    const Eigen::Vector3d step = turn * dice.vector().normalized();
    const Eigen::Quaterniond start = exp<double>(dice.vector());
    const double h = dice.between(0.5, 2.0);
    const std::array leaving{dice.vector(), dice.vector(), Eigen::Vector3d(Eigen::Vector3d::Zero())};
    const std::array arriving{dice.vector(), dice.vector(), Eigen::Vector3d(Eigen::Vector3d::Zero())};
    const ChartCurve<5> curve(Knots({0.0, h}), {hermite_piece_about_middle(start, step, leaving, arriving, h)});
    const Motion first = curve.motion(0.0, 0), last = curve.motion(h, 0);
    EXPECT_TRUE(near(first.orientation.coeffs(), start.coeffs(), tolerance::algebra)) << turn;
    EXPECT_TRUE(near(last.orientation.coeffs(), (start * exp<double>(step)).coeffs(), tolerance::algebra)) << turn;
    EXPECT_TRUE(near(first.angular_velocity, leaving[0], tolerance::algebra)) << turn;
    EXPECT_TRUE(near(last.angular_velocity, arriving[0], tolerance::algebra)) << turn;
    EXPECT_TRUE(near(first.angular_acceleration, leaving[1], 1e2 * tolerance::algebra)) << turn;
    EXPECT_TRUE(near(last.angular_acceleration, arriving[1], 1e2 * tolerance::algebra)) << turn;
  }
}

}}  // namespace orispline
