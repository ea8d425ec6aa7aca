// SPDX-License-Identifier: Apache-2.0
// A family of one's own is taken by every task: a copy of one that is built in gives the same numbers.
#include <gtest/gtest.h>

#include <orispline/analysis.hpp>
#include <orispline/families/quintic.hpp>
#include <orispline/orispline.hpp>
#include <orispline/own_curves.hpp>
#include <orispline/reduce.hpp>
#include <orispline/retime.hpp>
#include <orispline/streams.hpp>
#include <orispline/tune.hpp>
#include <support/specimens.hpp>

namespace orispline { namespace {

struct Mine : families::Quintic {
  static constexpr FamilyInfo info = [] {
    FamilyInfo copied = families::Quintic::info;
    copied.name = "mine";
    return copied;
  }();
};

class OwnMethod : public testing::Test {
 protected:
  const Keyframes keys_ =
      testing_support::keyframes(testing_support::random_walk(91, 12, testing_support::Spacing::uneven, 1.0));
  const Method mine_ = own_method<Mine>(), built_in_ = "quintic";
};

TEST_F(OwnMethod, MakesTheSameCurve) {
  const auto mine = make_curve(mine_, keys_), built_in = make_curve(built_in_, keys_);
  for (const double t : testing_support::sample_times(keys_.times(), 5))
    EXPECT_EQ((*mine)(t).coeffs(), (*built_in)(t).coeffs());
}

TEST_F(OwnMethod, IsComparedAndMeasured) {
  const std::vector<Candidate> candidates{{mine_, keys_}, {built_in_, keys_}};
  const Comparison comparison = compare(candidates, {keys_.times(), keys_.orientations()});
  EXPECT_EQ(comparison.measures[0]->energies.acceleration, comparison.measures[1]->energies.acceleration);
  EXPECT_EQ(comparison.measures[0]->shape.order(), 2);
}

TEST_F(OwnMethod, IsTunedAndStaysOnesOwn) {
  const auto mine = tune(keys_, mine_), built_in = tune(keys_, built_in_);
  ASSERT_TRUE(mine) << mine.error().message;
  EXPECT_EQ(mine->energy_after, built_in->energy_after);
  EXPECT_EQ(mine->method.own, mine_.own);
  EXPECT_EQ(mine->method.options.parameters, built_in->method.options.parameters);
}

TEST_F(OwnMethod, IsReducedTo) {
  const auto mine = reduce(keys_, mine_, {.tolerance = {.angle = 0.2}}),
             built_in = reduce(keys_, built_in_, {.tolerance = {.angle = 0.2}});
  ASSERT_TRUE(mine) << mine.error().message;
  EXPECT_EQ(mine->samples, built_in->samples);
}

TEST_F(OwnMethod, IsRetimed) {
  const auto mine = retime(keys_, mine_, {.limits = {.rate = 0.1}}),
             built_in = retime(keys_, built_in_, {.limits = {.rate = 0.1}});
  ASSERT_TRUE(mine) << mine.error().message;
  EXPECT_EQ(mine->time_scale, built_in->time_scale);
}

TEST_F(OwnMethod, IsStreamed) {
  auto mine = OnlineCurve::make(mine_, 16);
  ASSERT_TRUE(mine) << mine.error().message;
  for (std::size_t i = 0; i < keys_.size(); ++i)
    ASSERT_TRUE(mine->append({.time = keys_.times()[i], .orientation = keys_.orientations()[i]}));
  ASSERT_TRUE(mine->finish());
  const auto whole = make_curve(built_in_, keys_);
  for (const double t : testing_support::sample_times(keys_.times(), 5))
    EXPECT_LE(angular_distance((*mine)(t), (*whole)(t)), 1e-14);
}

TEST_F(OwnMethod, IsInTheTextOfAMethodByItsFamily) {
  const Method shaped = method_from_text("mine:tension=0.25:ends=natural", {&mine_.own, 1}).value();
  EXPECT_EQ(shaped.own, mine_.own);
  EXPECT_EQ(text_of(shaped), "mine:tension=0.25:ends=natural");
  EXPECT_FALSE(method_from_text("mine"));
}

}}  // namespace orispline
