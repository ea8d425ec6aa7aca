// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/best_of_offsets.hpp>

#include <cmath>
#include <utility>

#include <gtest/gtest.h>

namespace orispline { namespace {

struct Fit {
  TriedOffset of;
  [[nodiscard]] double cost() const { return of.noise; }
  [[nodiscard]] const TriedOffset& tried() const { return of; }
};

constexpr TriedOffset best{.offset = 1.0, .sigma = 0.01, .noise = 1.0, .samples = 1000};

std::optional<double> rival_of_best(const TriedOffset& other) {
  BestOfOffsets<Fit> fits;
  fits.add(Fit{best});
  fits.add(std::nullopt);
  fits.add(Fit{other});
  return fits.rival(0.1);
}

/// Three standard deviations of a σ of n numbers: 3/√(2n) of it.
TEST(BestOfOffsets, HasARivalThatLeavesNoMoreThanChanceDoes) {
  for (const auto& [samples, chance] : {std::pair{std::size_t{1000}, 3.0 / std::sqrt(6000.0)},
                                        {std::size_t{500}, 3.0 / std::sqrt(3000.0)},
                                        {std::size_t{4000}, 3.0 / std::sqrt(6000.0)}}) {
    EXPECT_EQ(rival_of_best({3.0, 0.01, 1.0 + 0.99 * chance, samples}), 3.0) << samples;
    EXPECT_FALSE(rival_of_best({3.0, 0.01, 1.0 + 1.01 * chance, samples})) << samples;
  }
}

TEST(BestOfOffsets, HasNoRivalNearerThanAnIntervalOrThanBothAreSure) {
  EXPECT_EQ(rival_of_best({1.11, 0.01, 1.0, 1000}), 1.11);
  EXPECT_EQ(rival_of_best({0.89, 0.01, 1.0, 1000}), 0.89);
  EXPECT_FALSE(rival_of_best({1.09, 0.01, 1.0, 1000}));
  EXPECT_EQ(rival_of_best({1.31, 0.05, 1.0, 1000}), 1.31);
  EXPECT_FALSE(rival_of_best({1.29, 0.05, 1.0, 1000}));
}

TEST(BestOfOffsets, HasNoRivalOfLessThanHalfAsManySamples) {
  EXPECT_EQ(rival_of_best({3.0, 0.01, 1.0, 500}), 3.0);
  EXPECT_FALSE(rival_of_best({3.0, 0.01, 1.0, 499}));
}

TEST(BestOfOffsets, NamesTheRivalThatLeavesLeast) {
  BestOfOffsets<Fit> fits;
  for (const auto& [offset, noise] : {std::pair{3.0, 1.02}, {4.0, 1.01}, {5.0, 1.03}})
    fits.add(Fit{{offset, 0.01, noise, 1000}});
  fits.add(Fit{best});
  EXPECT_EQ(fits.rival(0.1), 4.0);
  EXPECT_EQ(fits.best()->of.offset, 1.0);
}

}}  // namespace orispline
