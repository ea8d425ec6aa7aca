// SPDX-License-Identifier: Apache-2.0
// The times of a grid are those of its formula to the last bit, and an open grid keeps what it has given.
#include <orispline/batch/sample_grid.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

namespace orispline { namespace {

using Rate = SampleGrid::Rate;
using Count = SampleGrid::Count;

Decimal decimal(const char* text) { return Decimal::parse(text).value(); }

TEST(SampleGrid, HasTheNearestDoublesOfExactTimesAtARate) {
  const Decimal start = decimal("1700000000.000000001");
  const SampleGrid grid =
      SampleGrid::make({.spacing = Rate{30.0}, .start = start, .end = start + decimal("10")}, 0.0, {}).value();
  ASSERT_EQ(grid.size(), 301u);
  for (std::uint64_t k = 0; k < 300; ++k) {
    const double offset = static_cast<double>(k) / 30.0;
    EXPECT_EQ(grid[k].offset, offset);
    EXPECT_EQ(grid[k].t, (start + Decimal::from_double(offset)).to_double());
  }
  EXPECT_EQ(grid[300].offset, 10.0);
  EXPECT_EQ(grid[300].t, (start + decimal("10")).to_double());
  EXPECT_EQ(grid.time(301), std::numeric_limits<double>::infinity());
}

TEST(SampleGrid, FillsWithTheTimesThatItHasOneByOne) {
  for (const char* start : {"0", "0.1", "-3", "1700000000.000000001", "0.91345678901234567"})
    for (const char* length : {"0", "7", "12.3456789", "0.09", "1e9"})
      for (const SampleGrid::LastSample last : {SampleGrid::LastSample::before_end, SampleGrid::LastSample::at_end})
        for (const std::variant<Rate, Count>& spacing :
             {std::variant<Rate, Count>(Rate{3.0}), std::variant<Rate, Count>(Rate{30000.0, 1001.0}),
              std::variant<Rate, Count>(Count{1}), std::variant<Rate, Count>(Count{1000})}) {
          const Decimal begin = decimal(start);
          const auto grid = SampleGrid::make(
              {.spacing = spacing, .start = begin, .end = begin + decimal(length), .last = last}, 0.0, {});
          if (!grid) continue;
          const std::uint64_t size = std::min<std::uint64_t>(*grid->size(), 2000), rest = *grid->size() - size;
          for (const std::uint64_t first : {std::uint64_t{0}, std::min<std::uint64_t>(1, rest), rest}) {
            std::vector<double> times(size);
            grid->fill(first, times);
            for (std::uint64_t k = 0; k < size; ++k)
              ASSERT_EQ(times[k], (*grid)[first + k].t) << start << ' ' << first + k;
          }
        }
  const SampleGrid steps(0.5, {0.1});
  std::vector<double> times(10);
  steps.fill(5, times);
  for (std::uint64_t k = 0; k < 10; ++k) EXPECT_EQ(times[k], steps[5 + k].t);
}

TEST(SampleGrid, FillsDecimalsOfFewAndOfManyDigitsWithTheTimesThatItHasOneByOne) {
  std::mt19937_64 random(43);
  const auto any = [&](std::uint64_t most) { return std::uniform_int_distribution<std::uint64_t>(0, most)(random); };
  const std::vector<Rate> rates{{1.0},
                                {2.5},
                                {8.0},
                                {10.0},
                                {12.5},
                                {30.0},
                                {50.0},
                                {64.0},
                                {100.0},
                                {1000.0},
                                {1024.0},
                                {29.97},
                                {30000.0, 1001.0},
                                {0.5},
                                {0.1},
                                {1.0, 3600.0},
                                {3.0, 7.0},
                                {1e6},
                                {1e9},
                                {4e5, 3.0},
                                {44100.0},
                                {200.0, 0.25},
                                {7e15},
                                {1.0, 1e15}};
  for (int i = 0; i < 20000; ++i) {
    const Rate rate = rates[any(rates.size() - 1)];
    const auto places = static_cast<int>(any(12));
    const auto digits = static_cast<int>(any(17));
    std::uint64_t most = 1;
    for (int k = 0; k < digits; ++k) most *= 10;
    Decimal start = Decimal::parse(std::to_string(any(most - 1))).value() * Decimal::power_of_ten(-places);
    if (i % 3 == 0) start = -start;
    const SampleGrid open = SampleGrid::make({.spacing = rate, .start = start}, 0.0, {}).value();
    // Indices of any size, at and beside those where the digits become too many.
    std::uint64_t first = any(std::uint64_t{1} << any(52));
    if (i % 5 == 0) first = static_cast<std::uint64_t>(std::min(1e15 * rate.per_second() / 1e3, 8e15)) - 10;
    if (i % 7 == 0) first = 0;
    std::vector<double> times(20);
    open.fill(first, times);
    for (std::uint64_t k = 0; k < times.size(); ++k)
      ASSERT_EQ(times[k], open[first + k].t)
          << start.to_string() << ' ' << rate.hertz << '/' << rate.seconds << ' ' << first + k;
  }
}

TEST(SampleGrid, FillsTheEndOfDecimalsWithTheEnd) {
  for (const char* start : {"0", "0.1", "-7.25", "1311868163.8697"})
    for (const char* length : {"10", "10.0000000001", "9.9999999999", "10.004", "9.9999999999999999"}) {
      const Decimal begin = decimal(start), end = begin + decimal(length);
      const SampleGrid grid = SampleGrid::make({.spacing = Rate{100.0}, .start = begin, .end = end}, 0.0, {}).value();
      std::vector<double> times(*grid.size());
      grid.fill(0, times);
      for (std::uint64_t k = 0; k < times.size(); ++k) ASSERT_EQ(times[k], grid[k].t) << start << ' ' << length;
    }
}

TEST(SampleGrid, MeetsAnEndThatRoundingHides) {
  const auto sizes = [](double hertz, const char* end) {
    return *SampleGrid::make({.spacing = Rate{hertz}, .end = decimal(end)}, 0.1, {}).value().size();
  };
  EXPECT_EQ(sizes(10.0, "0.4"), 4u);
  EXPECT_EQ(sizes(10.0, "0.39999"), 3u);
  EXPECT_EQ(sizes(10.0, "0.1"), 1u);
  EXPECT_EQ(sizes(10.0, "0.09"), 0u);
  const SampleGrid grid = SampleGrid::make({.spacing = Rate{3.0}}, 0.0, 7.0 - 1e-10).value();
  EXPECT_EQ(*grid.size(), 22u);
  EXPECT_EQ(grid[21].t, 7.0 - 1e-10);
}

TEST(SampleGrid, HasTheTimesOfAFractionWithoutRoundingIt) {
  const SampleGrid grid = SampleGrid::make({.spacing = Rate{30000.0, 1001.0}}, 0.0, 2002.0).value();
  ASSERT_EQ(*grid.size(), 60001u);
  EXPECT_EQ(grid[30000].t, 1001.0);
  EXPECT_EQ(grid[60000].t, 2002.0);
  for (std::uint64_t k = 0; k < 60000; k += 7) EXPECT_EQ(grid[k].t, static_cast<double>(k) * 1001.0 / 30000.0);
  for (std::uint64_t k = 0; k < 60000; k += 97) EXPECT_EQ(grid.first_from(grid.time(k)), k);
}

TEST(SampleGrid, EndsAtTheEndOnRequest) {
  const auto grid = [](double end, SampleGrid::LastSample last) {
    return SampleGrid::make({.spacing = Rate{4.0}, .last = last}, 0.0, end).value();
  };
  const SampleGrid with = grid(1.1, SampleGrid::LastSample::at_end),
                   without = grid(1.1, SampleGrid::LastSample::before_end);
  ASSERT_EQ(*with.size(), 6u);
  ASSERT_EQ(*without.size(), 5u);
  for (std::uint64_t k = 0; k < 5; ++k) EXPECT_EQ(with[k].t, without[k].t);
  EXPECT_EQ(with[5].t, 1.1);
  EXPECT_EQ(with.first_from(1.05), 5u);
  EXPECT_EQ(with.first_after(1.1), 6u);
  EXPECT_EQ(*grid(1.0, SampleGrid::LastSample::at_end).size(), 5u);  // which is one of its times
  EXPECT_EQ(*grid(0.0, SampleGrid::LastSample::at_end).size(), 1u);
}

TEST(SampleGrid, HasBothEndsOfACount) {
  const SampleGrid grid = SampleGrid::make({.spacing = Count{8}, .start = decimal("0.1")}, 0.0, 3.3).value();
  ASSERT_EQ(grid.size(), 8u);
  EXPECT_EQ(grid[0].t, 0.1);
  EXPECT_EQ(grid[7].t, 3.3);
  const double span = (decimal("3.3") - decimal("0.1")).to_double();
  for (std::uint64_t k = 1; k < 7; ++k) EXPECT_EQ(grid[k].offset, span * static_cast<double>(k) / 7.0);
}

TEST(SampleGrid, RefusesMoreSamplesThanDoublesCanTellApart) {
  const auto refusal = [](const SampleGrid::Request& request) {
    const auto grid = SampleGrid::make(request, 0.0, 3.0);
    return grid ? "made" : grid.error().option + ": " + grid.error().message;
  };
  EXPECT_EQ(refusal({.spacing = Rate{1e20}}), "rate: 1e+20 makes 3e+20 samples over 3 s, wanted fewer than 9e+15");
  EXPECT_EQ(refusal({.spacing = Count{2}, .start = decimal("3")}),
            "count: found 2 and a range that is the single time 3, wanted 1");
}

TEST(SampleGrid, FindsTheFirstSampleFromATimeOn) {
  std::mt19937_64 random(41);
  std::uniform_real_distribution<double> anywhere(-1.0, 9.0);
  const std::vector<SampleGrid> grids{SampleGrid(0.3, {0.07}),
                                      SampleGrid(1e9, {1e-8}),
                                      SampleGrid(-7.0, {1001.0, 30000.0}),
                                      SampleGrid::make({.spacing = Rate{11.0}}, 0.3, 7.9).value(),
                                      SampleGrid::make({.spacing = Rate{11.0}}, 0.3, {}).value(),
                                      SampleGrid::make({.spacing = Count{40}}, 0.3, 7.9).value()};
  for (const SampleGrid& grid : grids)
    for (int i = 0; i < 300; ++i) {
      const double t = i % 2 == 0 ? grid[static_cast<std::uint64_t>(i / 8)].t : grid[0].t + anywhere(random);
      const auto from = grid.first_from(t), after = grid.first_after(t);
      const std::uint64_t size = grid.size().value_or(from + 2);
      EXPECT_TRUE(from >= size || grid.time(from) >= t);
      EXPECT_TRUE(from == 0 || grid.time(from - 1) < t);
      EXPECT_GE(after, from);
      EXPECT_GT(grid.time(after), t);
      EXPECT_TRUE(after == 0 || grid.time(after - 1) <= t);
    }
}

TEST(SampleGrid, KeepsTheSamplesThatAreSettledWhereverItEnds) {
  std::mt19937_64 random(42);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int i = 0; i < 3000; ++i) {
    const double start = i % 3 == 0 ? 0.0 : 1e3 * share(random);
    const Rate rate{std::pow(10.0, 8.0 * share(random) - 4.0)};
    const double t = start + (1.0 + 50.0 * share(random)) / rate.hertz;
    const SampleGrid open = SampleGrid::make({.spacing = rate}, start, {}).value();
    const std::uint64_t settled = open.settled_until(t);
    // Ends behind t, and those that lie a hair's breadth beside a sample.
    const double beside = open[settled].t * (1.0 + 2e-16 * std::round(6.0 * share(random) - 3.0));
    for (const double end : {t, t + share(random) / rate.hertz, std::max(t, beside)}) {
      const SampleGrid closed = SampleGrid::make({.spacing = rate}, start, end).value();
      ASSERT_LE(settled, *closed.size());
      for (std::uint64_t k = settled > 3 ? settled - 3 : 0; k < settled; ++k) {
        EXPECT_EQ(open[k].t, closed[k].t);
        EXPECT_EQ(open[k].offset, closed[k].offset);
      }
      EXPECT_LE(*closed.size(), settled + 3);
    }
  }
}

TEST(SampleGrid, LivesWithRatesOfAnySize) {
  for (const double hertz : {1e-300, 1e-9, 1e300}) {
    const SampleGrid grid = SampleGrid::make({.spacing = Rate{hertz}}, 5.0, {}).value();
    EXPECT_EQ(grid.first_from(4.0), 0u);
    EXPECT_GT(grid.first_after(6.0), 0u);
  }
}

}}  // namespace orispline
