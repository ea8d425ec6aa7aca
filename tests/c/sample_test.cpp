// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include <orispline/batch/pose_sampler.hpp>
#include <orispline/families/registry.hpp>

#include "c/handles.hpp"

namespace orispline { namespace {

using namespace testing_support;

template <class T>
constexpr orispline_type type_of = std::is_same_v<T, double> ? ORISPLINE_DOUBLE : ORISPLINE_FLOAT;

/// One quantity at these times.
template <class T>
std::vector<T> sampled(const CurveHandle& curve, const std::vector<double>& times, orispline_quantity quantity,
                       const char* beyond = nullptr, std::uint32_t threads = 1) {
  std::vector<T> numbers((quantity == ORISPLINE_ORIENTATION ? 4 : 3) * times.size());
  const orispline_output output{quantity, type_of<T>, numbers.data(), 0};
  expect_ok(call(orispline_sample_at, static_cast<const orispline_curve*>(curve.get()), times.data(), times.size(),
                 ORISPLINE_XYZW, beyond, threads, &output, std::size_t{1}));
  return numbers;
}

/// Room for each quantity, and the outputs that fill it.
template <class T>
struct Table {
  std::array<std::vector<T>, 10> numbers;

  explicit Table(std::size_t count) {
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i].resize((i == 0 ? 4 : 3) * count);
  }
  [[nodiscard]] std::vector<orispline_output> outputs(const std::vector<orispline_quantity>& quantities) {
    std::vector<orispline_output> all;
    for (const orispline_quantity quantity : quantities)
      all.push_back({quantity, type_of<T>, numbers[static_cast<std::size_t>(quantity)].data(), 0});
    return all;
  }
};

template <class T>
Table<T> sampled_by_cpp(const PoseCurve& curve, const std::vector<double>& times) {
  Table<T> table(times.size());
  auto& [q, w, a, j, w_world, a_world, j_world, p, v, l] = table.numbers;
  const PoseSampler sampler(curve);
  EXPECT_TRUE(sampler.sample_at<T>(times, Samples<T>{q, w, a, j, p, v, l}));
  std::vector<T> turned = q;
  EXPECT_TRUE(sampler.sample_at<T>(times, Samples<T>{turned, w_world, a_world, j_world}, Extrapolation::hold,
                                   RateFrame::world));
  return table;
}

template <class T>
void expect_bits_of_cpp() {
  const KeyframeData data = walk(13);
  std::vector<double> times = sample_times(data.times, 40);
  std::swap(times.front(), times.back());
  times.push_back(1e9);
  for (const FamilyInfo& family : families_info()) {
    const Table<T> wanted = sampled_by_cpp<T>(make_pose_curve(family.name, keyframes(data)).value(), times);
    const CurveHandle curve = curve_through(keys_of(data), std::string(family.name).c_str());
    Table<T> found(times.size());
    const auto outputs = found.outputs({0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
    expect_ok(call(orispline_sample_at, static_cast<const orispline_curve*>(curve.get()), times.data(), times.size(),
                   ORISPLINE_XYZW, static_cast<const char*>(nullptr), 1u, outputs.data(), outputs.size()));
    for (std::size_t i = 0; i < found.numbers.size(); ++i)
      EXPECT_EQ(found.numbers[i], wanted.numbers[i]) << family.name << ", quantity " << i;
  }
}

TEST(SamplesOfC, HaveTheBitsOfEveryMethod) { expect_bits_of_cpp<double>(); }
TEST(SamplesOfC, HaveTheBitsOfEveryMethodInFloat) { expect_bits_of_cpp<float>(); }

TEST(SamplesOfC, LieWhereTheyAreWanted) {
  const CurveHandle curve = curve_through(keys_of(walk()), "auto");
  const std::vector<double> times = sample_times(walk().times, 2000);  // more than one block
  const auto orientations = sampled<double>(curve, times, ORISPLINE_ORIENTATION);
  const auto body = sampled<double>(curve, times, ORISPLINE_ANGULAR_JERK),
             world = sampled<double>(curve, times, ORISPLINE_ANGULAR_JERK_WORLD);
  const auto single = sampled<float>(curve, times, ORISPLINE_POSITION);
  constexpr std::size_t stride = 12;
  std::vector<double> table(stride * times.size(), -7.0), dense(4 * times.size());
  std::vector<float> floats(5 * times.size(), -7.0f);
  const std::array<orispline_output, 6> outputs{
      {{ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, table.data(), stride},
       {ORISPLINE_ANGULAR_JERK, ORISPLINE_DOUBLE, table.data() + 4, stride},
       {ORISPLINE_ANGULAR_JERK_WORLD, ORISPLINE_DOUBLE, table.data() + 7, stride},
       {ORISPLINE_POSITION, ORISPLINE_FLOAT, floats.data(), 5},
       {ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, dense.data(), 0},
       {ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, dense.data(), 4}}};
  expect_ok(call(orispline_sample_at, static_cast<const orispline_curve*>(curve.get()), times.data(), times.size(),
                 ORISPLINE_WXYZ, static_cast<const char*>(nullptr), 0u, outputs.data(), std::size_t{5}));
  for (std::size_t k = 0; k < times.size(); ++k) {
    const double* const row = table.data() + stride * k;
    EXPECT_EQ(row[0], orientations[4 * k + 3]);
    EXPECT_EQ(row[1], orientations[4 * k]);
    EXPECT_EQ(dense[4 * k], orientations[4 * k + 3]);
    EXPECT_EQ(dense[4 * k + 3], orientations[4 * k + 2]);
    EXPECT_EQ(row[5], body[3 * k + 1]);
    EXPECT_EQ(row[8], world[3 * k + 1]);
    EXPECT_EQ(row[10], -7.0) << "which is nobody's";
    EXPECT_EQ(floats[5 * k + 2], single[3 * k + 2]);
    EXPECT_EQ(floats[5 * k + 3], -7.0f);
  }
}

TEST(SamplesOfC, AreAtEvenTimesAsWritten) {
  const CurveHandle curve = curve_through(keys_of(walk()), "timed-c2");
  constexpr std::size_t count = 20'000;
  std::vector<double> times(count), numbers(3 * count);
  for (std::size_t k = 0; k < count; ++k) times[k] = static_cast<double>(k) * 0.0003 + 0.1;
  const orispline_output output{ORISPLINE_ANGULAR_ACCELERATION, ORISPLINE_DOUBLE, numbers.data(), 0};
  for (const std::uint32_t threads : {0u, 1u, 3u}) {
    expect_ok(call(orispline_sample_even, static_cast<const orispline_curve*>(curve.get()), 0.1, 0.0003, count,
                   orispline_order{0}, "hold", threads, &output, std::size_t{1}));
    EXPECT_EQ(numbers, sampled<double>(curve, times, ORISPLINE_ANGULAR_ACCELERATION)) << threads;
  }
}

TEST(SamplesOfC, AreWhatIsWantedBeyondTheEnds) {
  const KeyframeData data = walk();
  const CurveHandle curve = curve_through(keys_of(data), "auto");
  const std::vector<double> times{data.times.front() - 1.0, data.times.back() + 1.0};
  EXPECT_EQ(sampled<double>(curve, times, ORISPLINE_ANGULAR_VELOCITY)[0], 0.0);
  EXPECT_TRUE(std::isnan(sampled<double>(curve, times, ORISPLINE_ANGULAR_VELOCITY, "nan")[0]));
  EXPECT_NEAR(sampled<double>(curve, times, ORISPLINE_ANGULAR_VELOCITY, "rate")[3],
              sampled<double>(curve, {data.times.back()}, ORISPLINE_ANGULAR_VELOCITY)[0], 1e-12);
  EXPECT_TRUE(std::isnan(sampled<double>(curve, {nan}, ORISPLINE_POSITION)[2]));
}

TEST(SamplesOfC, NameTheTimeThatIsAnError) {
  const KeyframeData data = walk();
  const CurveHandle owned = curve_through(keys_of(data), "auto");
  const orispline_curve* const curve = owned.get();
  std::vector<double> times(9000, data.times.back()), numbers(4 * times.size());
  times[8999] += 1.0;
  const orispline_output output{ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, numbers.data(), 0};
  const Result result = call(orispline_sample_at, curve, times.data(), times.size(), ORISPLINE_WXYZ, "error", 1u,
                             &output, std::size_t{1});
  EXPECT_EQ(result.code, ORISPLINE_BAD_ARGUMENT);
  EXPECT_EQ(orispline_error_time(result.error.get()), 8999);
}

TEST(SamplesOfC, AreNoneOfNothing) {
  const CurveHandle owned = curve_through(keys_of(walk()), "auto");
  const orispline_curve* const curve = owned.get();
  const orispline_output output{ORISPLINE_ORIENTATION, ORISPLINE_DOUBLE, nullptr, 0};
  const double* const no_times = nullptr;
  const char* const beyond = nullptr;
  expect_ok(
      call(orispline_sample_at, curve, no_times, std::size_t{0}, ORISPLINE_WXYZ, beyond, 1u, &output, std::size_t{1}));
  expect_ok(call(orispline_sample_even, curve, 0.0, 0.1, std::size_t{0}, ORISPLINE_WXYZ, beyond, 1u, &output,
                 std::size_t{1}));
  expect_ok(call(orispline_sample_even, curve, 0.0, 0.1, std::size_t{5}, ORISPLINE_WXYZ, beyond, 1u,
                 static_cast<const orispline_output*>(nullptr), std::size_t{0}));
}

}}  // namespace orispline
