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

template <class F>
Height highest_in_passing(const F& f, const std::vector<double>& places) {
  SummitsInPassing summits;
  for (const double place : places) summits.pass({place, f(place)});
  return summits.highest(f);
}

TEST(SummitsInPassing, FindsTheTopBetweenPlaces) {
  const auto f = [](double x) { return 1.0 - (x - 0.37) * (x - 0.37); };
  EXPECT_NEAR(highest_in_passing(f, places_up_to(1.0, 4)).place, 0.37, 1e-6);
  EXPECT_NEAR(highest_in_passing(f, {0.0, 0.35, 1.0}).value, 1.0, 1e-12);
  EXPECT_EQ(highest_in_passing([](double x) { return x; }, places_up_to(2.0, 8)).place, 2.0);
  EXPECT_EQ(highest_in_passing([](double x) { return 2.0 - x; }, places_up_to(2.0, 8)).place, 0.0);
}

TEST(SummitsInPassing, FindsACornerHoweverSteepItsOtherSide) {
  const auto f = [](double x) { return x < 0.74 ? x : std::max(0.74 - 60.0 * (x - 0.74), 0.0); };
  EXPECT_NEAR(highest_in_passing(f, places_up_to(4.0, 16)).value, 0.74, 1e-5);
}

TEST(SummitsInPassing, FindsTheHighestOfManyThatSamplesCannotTellApart) {
  // The top is 35 s from the start; beside it the samples see more of others.
  const auto f = [](double x) { return std::abs(std::sin(3.0 * x)) * (1.0 - 1e-4 * std::abs(x - 35.0)); };
  std::vector<double> places = places_up_to(70.0, 2000);
  double densely = 0.0;
  for (const double place : places_up_to(70.0, 700'000)) densely = std::max(densely, f(place));
  std::size_t looks = 0;
  const auto counted = [&](double x) { return ++looks, f(x); };
  EXPECT_NEAR(highest_in_passing(counted, places).value, densely, 1e-9);
  EXPECT_LT(looks, 2 * places.size());
}

TEST(SummitsInPassing, LooksAtNothingElseWhereNothingRises) {
  int looks = 0;
  const auto f = [&](double) { return ++looks, 0.0; };
  EXPECT_EQ(highest_in_passing(f, places_up_to(1.0, 16)).place, 0.0);
  EXPECT_EQ(looks, 17);
}

TEST(SummitsInPassing, PassesByWhatIsNoNumber) {
  const auto f = [](double x) { return x == 0.0 || x == 0.5 ? std::nan("") : 1.0 - (x - 0.8) * (x - 0.8); };
  EXPECT_NEAR(highest_in_passing(f, places_up_to(1.0, 8)).value, 1.0, 1e-12);
}

}}  // namespace orispline
