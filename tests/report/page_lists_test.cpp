// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page_lists.hpp>

#include <cstring>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include <orispline/base/base64.hpp>
#include <orispline/report/page_numbers.hpp>
#include <support/not_finite.hpp>

namespace orispline::report { namespace {

constexpr double none = testing_support::nan, endless = testing_support::infinity;

/// The numbers of a typed array in the JSON.
template <class Number>
std::vector<Number> unpacked(const std::string& json) {
  const std::size_t begin = json.find(":\"") + 2, end = json.find('"', begin);
  const std::string bytes = bytes_from_base64(std::string_view(json).substr(begin, end - begin)).value();
  std::vector<Number> numbers(bytes.size() / sizeof(Number));
  std::memcpy(numbers.data(), bytes.data(), bytes.size());  // all machines of the tests have the lowest byte first
  return numbers;
}

std::vector<double> counted_from(double first, std::size_t count) {
  std::vector<double> numbers(count);
  std::iota(numbers.begin(), numbers.end(), first);
  return numbers;
}

TEST(Base64, IsThatOfItsStandard) {  // RFC 4648, section 10
  const std::vector<std::pair<std::string, std::string>> pairs{{"", ""},
                                                               {"f", "Zg=="},
                                                               {"fo", "Zm8="},
                                                               {"foo", "Zm9v"},
                                                               {"foob", "Zm9vYg=="},
                                                               {"fooba", "Zm9vYmE="},
                                                               {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : pairs) {
    EXPECT_EQ(base64_of(bytes), text);
    EXPECT_EQ(bytes_from_base64(text), bytes);
  }
  EXPECT_EQ(base64_of("\xff\xfe\xfb"), "//77");
  EXPECT_FALSE(bytes_from_base64("A*A="));
}

TEST(PageLists, ShortOnesAreArraysWithNullForNoNumber) {
  EXPECT_EQ(doubles_json(std::vector{0.0, 1.0 / 3.0, none}), "[0,0.3333333333333333,null]");
  EXPECT_EQ(floats_json(std::vector{1.0 / 3.0, -endless}), "[0.3333333,null]");
  EXPECT_EQ(halves_json(std::vector{Eigen::Vector3d(1.0 / 3.0, 1e300, none)}), "[0.3333333,1e+300,null]");
  EXPECT_EQ(steps_json(std::vector{1234567.891, 1234568.0}), "[1234567.891,1234568]");
  EXPECT_EQ(floats_json(std::vector{Eigen::Quaterniond(0.5, 0.25, -0.5, 1.0)}), "[0.5,0.25,-0.5,1]");
  EXPECT_EQ(doubles_json(counted_from(0.0, 16)).front(), '[');
  EXPECT_EQ(doubles_json(counted_from(0.0, 17)).front(), '{');
}

TEST(PageLists, LongOnesAreTypedArrays) {
  std::vector<double> numbers = counted_from(0.1, 17);
  numbers[3] = none;
  const auto doubles = unpacked<double>(doubles_json(numbers));
  const auto floats = unpacked<float>(floats_json(numbers));
  ASSERT_EQ(doubles.size(), 17U);
  ASSERT_EQ(floats.size(), 17U);
  for (std::size_t i = 0; i < 17; ++i) {
    EXPECT_EQ(std::isnan(doubles[i]), i == 3);
    EXPECT_EQ(std::isnan(floats[i]), i == 3);
    if (i == 3) continue;
    EXPECT_EQ(doubles[i], numbers[i]);
    EXPECT_EQ(floats[i], static_cast<float>(numbers[i]));
  }
}

TEST(PageLists, HalfFloatsHaveAUnitInWhichNothingOverflows) {
  std::vector<double> numbers = counted_from(1.0, 18);
  numbers[5] = none;
  numbers[6] = -endless;
  for (const double size : {1e-300, 3.7, 1e10, 1e300}) {
    std::vector<Eigen::Vector3d> vectors;
    for (std::size_t i = 0; i < 18; i += 3) vectors.push_back(size * Eigen::Vector3d(numbers.data() + i));
    const std::string json = halves_json(vectors);
    const double unit = std::stod(json.substr(json.find("\"unit\":") + 7));
    const auto halves = unpacked<Eigen::half>(json);
    ASSERT_EQ(halves.size(), 18U);
    for (std::size_t i = 0; i < 18; ++i) {
      EXPECT_EQ((Eigen::numext::isnan)(halves[i]), i == 5 || i == 6) << i;
      if (i == 5 || i == 6) continue;
      const double read = unit * static_cast<double>(static_cast<float>(halves[i]));
      EXPECT_NEAR(read / (size * numbers[i]), 1.0, 0x1p-11 + 1e-7) << i;
      EXPECT_EQ(read, HalfFloats{unit}.rounded((size * numbers[i])));
      EXPECT_EQ(read, HalfFloats{16.0 * unit}.rounded((size * numbers[i])));
    }
  }
}

TEST(PageLists, TimesAreWholeStepsFromTheFirstOneToTheLast) {
  std::vector<double> times = counted_from(1e9, 20);
  times[4] = times[5];
  const std::string json = steps_json(times);
  EXPECT_NE(json.find(R"("start":1000000000)"), std::string::npos);
  const TimeSteps steps = TimeSteps::of(times.front(), times.back());
  const auto counts = unpacked<std::uint32_t>(json);
  ASSERT_EQ(counts.size(), 20U);
  EXPECT_EQ(counts.front(), 0U);
  EXPECT_EQ(counts.back(), 0xFFFFFFFFU);
  EXPECT_EQ(counts[4], counts[5]);
  for (std::size_t i = 0; i < 20; ++i) EXPECT_NEAR(steps.at(counts[i]), times[i], 19.0 / 0x1p32);
  EXPECT_EQ(unpacked<std::uint32_t>(steps_json(std::vector(17, 5.0))), std::vector<std::uint32_t>(17));
}

TEST(PageLists, TimesThatAreNotNumbersAreKept) {
  std::vector<double> times = counted_from(0.0, 17);
  times[8] = none;
  EXPECT_EQ(steps_json(times).substr(0, 7), R"({"f8":")");
}

}}  // namespace orispline::report
