// SPDX-License-Identifier: Apache-2.0
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <curve/counting_new.hpp>
#include <orispline/io/key_file.hpp>
#include <orispline/io/sample_writer.hpp>
#include <orispline/io/times_file.hpp>

#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::ScratchDirectory;
using testing_support::bytes_of_this_thread;

struct TimedSample {
  double t;  // since the epoch
  Sample sample;
};

std::vector<TimedSample> random_samples(std::size_t count) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<TimedSample> samples;
  for (double t = 0.0; samples.size() < count; t += std::abs(normal(random)) * 1e-3 + 1e-9) {
    Sample sample{.linear_motion = {.position = {normal(random), 1e9 * normal(random), 1e-9 * normal(random)}}};
    sample.motion.orientation.coeffs() =
        Eigen::Vector4d(normal(random), normal(random), normal(random), normal(random)).normalized();
    sample.motion.angular_velocity = {normal(random), 0.0, -0.0};
    samples.push_back({t, sample});
  }
  return samples;
}

void write(const std::string& path, const SampleColumns& columns, std::string_view epoch,
           const std::vector<TimedSample>& samples) {
  auto writer = SampleWriter::open(path, columns);
  ASSERT_TRUE(writer);
  for (const auto& [t, sample] : samples)
    ASSERT_TRUE(writer->write(Decimal::parse(epoch).value() + Decimal::from_double(t), sample));
  ASSERT_TRUE(writer->finish());
}

TEST(RoundTrip, GivesBackEveryBit) {
  const auto samples = random_samples(3000);
  for (const FormatInfo* const format : {&csv_format, &tum_format})
    for (const char* epoch : {"0", "1700000000.123456789", "-3.25", "98174919753"}) {
      const ScratchDirectory directory;
      const std::string path = directory.file("samples.txt");
      const bool is_csv = format == &csv_format;
      write(path, {.format = format, .positions = true, .derivatives = is_csv ? 1 : 0}, epoch, samples);

      const auto file = read_keys(path);

      ASSERT_TRUE(file) << describe(file.error());
      EXPECT_EQ(file->format, format);
      EXPECT_EQ(file->epoch.to_string(), epoch);
      ASSERT_EQ(file->data.times.size(), samples.size());
      for (std::size_t i = 0; i < samples.size(); ++i) {
        ASSERT_EQ(file->data.times[i], samples[i].t);
        ASSERT_EQ(file->data.orientations[i].coeffs(), samples[i].sample.motion.orientation.coeffs());
        ASSERT_EQ(file->data.positions[i], samples[i].sample.linear_motion.position);
        if (is_csv) {
          ASSERT_EQ(file->data.angular_velocities[i], samples[i].sample.motion.angular_velocity);
        }
      }
    }
}

TEST(RoundTrip, GivesBackEveryBitFromEuRoCWithinANanosecond) {
  const auto samples = random_samples(3000);
  const ScratchDirectory directory;
  const std::string path = directory.file("data.csv");
  const Decimal epoch = Decimal::parse("1700000000.123456789").value();
  write(path, {.format = &euroc_format}, epoch.to_string(), samples);

  const auto file = read_keys(path);

  ASSERT_TRUE(file) << describe(file.error());
  EXPECT_EQ(file->format, &euroc_format);
  ASSERT_EQ(file->data.times.size(), samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    ASSERT_NEAR(file->data.times[i], samples[i].t, 0.5000001e-9);
    ASSERT_EQ(file->data.orientations[i].coeffs(), samples[i].sample.motion.orientation.coeffs());
    ASSERT_EQ(file->data.positions[i], samples[i].sample.linear_motion.position);
  }
}

TEST(RoundTrip, GivesBackTheTimesAsSampleTimes) {
  const auto samples = random_samples(1000);
  const ScratchDirectory directory;
  const Decimal epoch = Decimal::parse("1700000000.123456789").value();
  std::ofstream file(directory.file("times.txt"));
  for (const auto& [t, sample] : samples) file << (epoch + Decimal::from_double(t)).to_string() << "\n";
  file.close();

  const auto times = read_times(directory.file("times.txt"), epoch);

  ASSERT_TRUE(times);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(times->times[i], samples[i].t);
}

TEST(RoundTrip, AsksForLittleMoreMemoryThanTheKeysTake) {
  constexpr std::size_t count = 200'000;
  const ScratchDirectory directory;
  const std::string path = directory.file(std::string(200, 'x') + ".csv");  // which no row copies
  auto writer = SampleWriter::open(path, {.positions = true, .derivatives = 1});
  ASSERT_TRUE(writer);
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_TRUE(writer->write(Decimal::from_double(static_cast<double>(i) / 1000.0), {}));
  ASSERT_TRUE(writer->finish());
  const std::size_t before = bytes_of_this_thread();

  const auto file = read_keys(path);

  const std::size_t asked = bytes_of_this_thread() - before;
  ASSERT_TRUE(file) << describe(file.error());
  ASSERT_EQ(file->data.times.size(), count);
  EXPECT_EQ(file->data.times.back(), 199.999);
  const std::size_t taken = count * (sizeof(double) + sizeof(Eigen::Quaterniond) + sizeof(Eigen::Vector3d));
  EXPECT_LE(asked, 5 * taken);  // a list that grows asks for twice its size in all, at least
}

}}  // namespace orispline::io
