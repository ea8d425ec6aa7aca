// SPDX-License-Identifier: Apache-2.0
#include <orispline/math/highest.hpp>

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace orispline { namespace {

std::vector<double> places_up_to(double last, std::size_t steps) {
  std::vector<double> places;
  for (std::size_t i = 0; i <= steps; ++i) places.push_back(last * static_cast<double>(i) / static_cast<double>(steps));
  return places;
}

template <class F>
Height highest_of(const F& f, const std::vector<double>& places) {
  std::vector<double> values;
  for (const double place : places) values.push_back(f(place));
  return highest(places, values, f);
}

TEST(Highest, IsBetweenThePlacesWhereItIs) {
  const auto f = [](double x) { return 1.0 - (x - 0.37) * (x - 0.37); };
  const Height top = highest_of(f, places_up_to(1.0, 4));
  EXPECT_NEAR(top.place, 0.37, 1e-6);
  EXPECT_NEAR(top.value, 1.0, 1e-12);
}

TEST(Highest, IsTheHighestOfTwoWhoseSamplesSayTheOther) {
  // The samples see all of the first top, and 0.95 of the second.
  const auto f = [](double x) { return std::max(1.0 - std::abs(x - 1.0), 1.05 - std::pow((x - 3.3162), 2.0)); };
  EXPECT_NEAR(highest_of(f, places_up_to(4.0, 4)).value, 1.05, 1e-12);
}

TEST(Highest, IsAtAnEndWhereItRisesThere) {
  EXPECT_EQ(highest_of([](double x) { return x; }, places_up_to(2.0, 8)).place, 2.0);
  EXPECT_EQ(highest_of([](double x) { return 2.0 - x; }, places_up_to(2.0, 8)).place, 0.0);
}

TEST(Highest, OfAConstantIsNotLookedFor) {
  int looks = 0;
  const auto f = [&](double) { return ++looks, 0.0; };
  EXPECT_EQ(highest_of(f, places_up_to(1.0, 16)).value, 0.0);
  EXPECT_EQ(looks, 17);
}

}}  // namespace orispline
