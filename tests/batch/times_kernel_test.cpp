// SPDX-License-Identifier: Apache-2.0
// Loops over times: by every instruction set, and through blocks of which some are in order and some are not.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/base/decimal.hpp>
#include <orispline/base/shortest_rest.hpp>

#include <batch/every_kernel.hpp>
#include <batch/sampled.hpp>
#include <batch/specimen_curves.hpp>
#include <support/not_finite.hpp>

namespace orispline { namespace {

using namespace testing_support;

TEST(TimesKernel, TellsWhetherTimesAreInOrder) {
  for (const batch::Kernels* kernels : all_kernels()) {
    SCOPED_TRACE(kernels->name);
    const auto are_in_order = [&](const std::vector<double>& times) {
      return kernels->are_in_order(times.data(), times.size());
    };
    EXPECT_TRUE(are_in_order({}));
    EXPECT_TRUE(are_in_order({3.0}));
    EXPECT_FALSE(are_in_order({nan}));
    EXPECT_TRUE(are_in_order({-infinity, -0.0, 0.0, -0.0, 1.0, 1.0, infinity, infinity}));
    for (const std::size_t size : {2U, 7U, 8U, 9U, 40U}) {
      std::vector<double> rising(size);
      for (std::size_t k = 0; k < size; ++k) rising[k] = std::floor(static_cast<double>(k) / 2.0);
      EXPECT_TRUE(are_in_order(rising));
      for (std::size_t k = 0; k < size; ++k)
        for (const double wrong : {nan, k == 0 ? 1e9 : -1.0}) {
          std::vector<double> times = rising;
          times[k] = wrong;
          EXPECT_FALSE(are_in_order(times)) << wrong << " at " << k << " of " << size;
        }
    }
  }
}

TEST(TimesKernel, WritesEvenTimesAsTheirFormulaSays) {
  for (const batch::Kernels* kernels : all_kernels())
    for (const batch::EvenTimes& even : {batch::EvenTimes{1001.0, 0.0, 30000.0}, batch::EvenTimes{7.3, 0.0, 999.0},
                                         batch::EvenTimes{25.0, -1311868163869.0, 1e4}})
      for (const double first : {0.0, 5.0, 123456789012.0})
        for (const std::size_t count : {1U, 7U, 8U, 1000U}) {
          std::vector<double> times(count);
          kernels->write_even_times(even, first, count, times.data());
          for (std::size_t k = 0; k < count; ++k) {
            const double product = (first + static_cast<double>(k)) * even.factor, sum = product + even.offset;
            ASSERT_EQ(times[k], sum / even.divisor) << kernels->name << ' ' << first << ' ' << k;
          }
        }
}

TEST(TimesKernel, WritesTheNearestDoublesOfDecimalTimesOrSaysThatItCannotTell) {
  for (const char* const start : {"0.83716123456789115", "-3.7", "1700000000.1234567", "1e-9"})
    for (const batch::EvenTimes& steps :
         {batch::EvenTimes{1.0, 0.0, 1000.0}, batch::EvenTimes{9.1234567890123, 0.0, 999.0},
          batch::EvenTimes{1001.0, 0.0, 30000.0}, batch::EvenTimes{1e6, 0.0, 3.0}, batch::EvenTimes{1e-5, 0.0, 7.0},
          batch::EvenTimes{1.0, 0.0, 1024.0}}) {
      const TimeOrigin origin(Decimal::parse(start).value());
      const batch::DecimalTimes wanted{steps.factor, steps.divisor, origin.halves()->high, origin.halves()->low};
      const auto offset = [&](std::size_t k) { return static_cast<double>(k) * steps.factor / steps.divisor; };
      for (int exponent = lowest_decade; exponent <= highest_decade; ++exponent) {
        std::size_t first = 1;
        while (first < 20000 && offset(first) < least_of_decade(exponent)) ++first;
        std::size_t count = 0;
        while (count < 1003 && offset(first + count) < least_of_decade(exponent + 1)) ++count;
        if (first == 20000 || count == 0) continue;
        std::vector<double> times(count);
        for (const batch::Kernels* kernels : all_kernels()) {
          const std::size_t unsure =
              kernels->write_decimal_times(wanted, exponent, static_cast<double>(first), count, times.data());
          EXPECT_EQ(unsure, static_cast<std::size_t>(std::ranges::count_if(times, [](double t) { return t != t; })));
          EXPECT_LE(unsure, 4 + count / 50) << kernels->name << ' ' << start << ' ' << offset(first);
          for (std::size_t k = 0; k < count; ++k) {
            const double exact = origin.plus(offset(first + k)).to_double();
            ASSERT_TRUE(std::isnan(times[k]) || times[k] == exact)
                << kernels->name << ' ' << start << " + " << offset(first + k) << ": " << times[k] - exact;
          }
        }
      }
    }
}

/// Each as if it were the only time.
void expect_the_samples_of_single_times(const AnyCurve& curve, const std::vector<double>& times) {
  Sampled<double> together(times.size(), Wanted::jerk);
  ASSERT_TRUE(sample_at<double>(curve, times, together.spans()));
  Sampled<double> alone(times.size(), Wanted::jerk);
  const Samples<double> all = alone.spans();
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto at = [i](std::span<double> numbers, std::size_t columns) {
      return numbers.subspan(columns * i, columns);
    };
    ASSERT_TRUE(sample_at<double>(curve, {&times[i], 1},
                                  {.orientations = at(all.orientations, 4),
                                   .angular_velocities = at(all.angular_velocities, 3),
                                   .angular_accelerations = at(all.angular_accelerations, 3),
                                   .angular_jerks = at(all.angular_jerks, 3)}));
  }
  EXPECT_TRUE(together.same_bits(alone));
}

TEST(TimesKernel, BlocksInOrderAndOthersGiveTheSamplesOfSingleTimes) {
  std::mt19937_64 random(83);
  for (const char* kind : kinds_of_curves) {
    SCOPED_TRACE(kind);
    const AnyCurve curve = specimen_curve(kind);
    const Domain domain = curve.domain();
    std::uniform_real_distribution<double> anywhere(domain.start - 0.3, domain.end + 0.3);
    std::vector<double> times(7000);  // three blocks and a part of one
    for (double& t : times) t = anywhere(random);
    const auto knots = curve.knots().times();
    std::copy(knots.begin(), knots.end(), times.begin());
    std::copy(knots.begin(), knots.end(), times.begin() + 1000);
    std::ranges::sort(times);
    expect_the_samples_of_single_times(curve, times);
    std::swap(times[2500], times[2700]);
    times[6999] = nan;
    expect_the_samples_of_single_times(curve, times);
    std::ranges::reverse(times);
    expect_the_samples_of_single_times(curve, times);
  }
}

}}  // namespace orispline
