// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include <orispline/clip/filtered_keys.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { namespace {

class Random {
 public:
  double part() { return normal_(engine_); }
  Eigen::Quaterniond rotation() { return Eigen::Quaterniond(part(), part(), part(), part()).normalized(); }

 private:
  std::mt19937 engine_{3};
  std::normal_distribution<double> normal_{};
};

RotationChannel rotations(bool is_spline) {
  Random random;
  RotationChannel channel;
  for (int i = 0; i < 50; ++i) {
    channel.times.push_back(0.1 * i);
    channel.values.push_back(random.rotation());
    if (!is_spline) continue;
    channel.in_tangents.push_back(Eigen::Quaterniond(random.part(), random.part(), random.part(), random.part()));
    channel.out_tangents.push_back(Eigen::Quaterniond(random.part(), random.part(), random.part(), random.part()));
  }
  if (is_spline) channel.interpolation = ChannelInterpolation::cubicspline;
  return channel;
}

TEST(FilteredKeys, RotationsAreWithinWhatIsAllowedByTheFewestBits) {
  const RotationChannel channel = rotations(false);
  int before = 0;
  for (const double allowed : {0.2, 0.02, 2e-3, 5e-4}) {
    const RotationChannel rounded = with_fewest_bits(channel, allowed);
    double most = 0.0;
    for (std::size_t i = 0; i < channel.size(); ++i)
      most = std::max(most, angular_distance(channel.values[i], rounded.values[i]));
    EXPECT_LE(most, allowed);
    EXPECT_GT(most, 0.05 * allowed);
    const auto bits = filter_bits(rounded);
    ASSERT_TRUE(bits) << allowed;
    EXPECT_GT(*bits, before);
    before = *bits;
  }
  EXPECT_FALSE(filter_bits(channel));
  EXPECT_EQ(with_fewest_bits(channel, 1e-9).values[3].coeffs(), channel.values[3].coeffs());
}

TEST(FilteredKeys, SplinesOfRotationsAreHeldByWholeNumbers) {
  const RotationChannel channel = rotations(true), rounded = with_fewest_bits(channel, 1e-2);
  std::vector<float> numbers;
  double most = 0.0;
  for (std::size_t i = 0; i < channel.size(); ++i) {
    most = std::max(most, angular_distance(channel.values[i], rounded.values[i]));
    for (const auto* const list : {&rounded.in_tangents, &rounded.values, &rounded.out_tangents}) {
      const Eigen::Quaterniond& number = (*list)[i];
      for (const double part : {number.x(), number.y(), number.z(), number.w()})
        numbers.push_back(static_cast<float>(part));
    }
  }
  EXPECT_GT(most, 0.0);
  EXPECT_LE(most, 1e-2);
  const auto whole = whole_numbers(numbers, true, true);
  ASSERT_TRUE(whole);
  EXPECT_LT(whole->exponent, -6);
  EXPECT_GT(whole->exponent, -14);
}

TEST(FilteredKeys, VectorsAreHeldByWholeNumbers) {
  Random random;
  VectorChannel channel;
  for (int i = 0; i < 30; ++i) {
    channel.times.push_back(i);
    channel.values.push_back({random.part(), 1e3 * random.part(), 0.0});
  }
  const VectorChannel rounded = with_fewest_bits(channel, 0.01);
  std::vector<float> numbers;
  for (std::size_t i = 0; i < channel.size(); ++i) {
    EXPECT_LE((channel.values[i] - rounded.values[i]).norm(), 0.01);
    for (const double part : rounded.values[i]) numbers.push_back(static_cast<float>(part));
  }
  const auto whole = whole_numbers(numbers, false, false);
  ASSERT_TRUE(whole);
  EXPECT_EQ(whole->exponent, -7);  // 2^-7 √3 / 2 is 0.0068, twice that is too much
  for (std::size_t i = 0; i < numbers.size(); ++i)
    EXPECT_EQ(std::ldexp(static_cast<double>(whole->numbers[i]), whole->exponent), static_cast<double>(numbers[i]));
  EXPECT_FALSE(whole_numbers(std::vector<float>{1e9F, 1e-9F}, false, false));
}

TEST(FilteredKeys, ANumberIsAWholeOneAndAnExponent) {
  EXPECT_EQ(exponential(1, 0), 0x00000001U);
  EXPECT_EQ(exponential(-1, -8), 0xF8FFFFFFU);
}

}}  // namespace orispline
