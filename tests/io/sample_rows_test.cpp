// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/sample_writer.hpp>

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <orispline/io/sample_writer.hpp>

#include "io/exact_number.hpp"
#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::content_of;
using test::decimal;
using test::ScratchDirectory;

TEST(SampleRows, AreTheRowsOfTheFile) {
  SampleRows rows(SampleColumns{});
  ASSERT_TRUE(rows.append(decimal("1.50"), {}) && rows.append(TimeOrigin(decimal("1700000000.1")), 1e-9, {}));
  EXPECT_EQ(rows.bytes(), "1.5,1,0,0,0\n1700000000.100000001,1,0,0,0\n");
  EXPECT_EQ(rows.size(), 2u);
}

TEST(SampleRows, AppendNothingThatIsNotFinite) {
  SampleRows rows({.positions = true});
  Sample sample;
  sample.linear_motion.position.z() = std::numeric_limits<double>::infinity();
  const auto appended = rows.append(TimeOrigin(decimal("2")), 0.5, sample);
  EXPECT_EQ(appended.error().message, "the sample at time 2.5 has a number that is not finite");
  EXPECT_EQ(rows.bytes(), "");
}

TEST(SampleRows, FollowThoseThatAreWrittenBefore) {
  const ScratchDirectory directory;
  const std::string path = directory.file("out.csv");
  auto writer = SampleWriter::open(path, {});
  SampleRows first(SampleColumns{}), second(SampleColumns{});
  ASSERT_TRUE(writer && writer->write(Decimal(), {}) && first.append(decimal("1"), {}) &&
              second.append(decimal("2"), {}));
  ASSERT_TRUE(writer->write(first) && writer->write(second) && writer->write(decimal("3"), {}) && writer->finish());
  EXPECT_EQ(content_of(path), "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n3,1,0,0,0\n");
}

TEST(SampleRows, MayNotRepeatTheLastNanosecondOfThoseBefore) {
  const SampleColumns euroc{.format = &euroc_format};
  const std::string refusal = "two samples fall on the nanosecond 7, wanted times that differ in EuRoC";
  const ScratchDirectory directory;
  auto writer = SampleWriter::open(directory.file("out.csv"), euroc);
  SampleRows first(euroc), second(euroc);
  ASSERT_TRUE(writer && first.append(decimal("7e-9"), {}) && second.append(decimal("7.1e-9"), {}));
  EXPECT_EQ(first.append(decimal("6.9e-9"), {}).error().message, refusal);
  ASSERT_TRUE(writer->write(first));
  EXPECT_EQ(writer->write(second).error().message, refusal);
  EXPECT_EQ(writer->write(decimal("7e-9"), {}).error().message, refusal);
  EXPECT_TRUE(writer->write(decimal("8e-9"), {}));
}

}}  // namespace orispline::io
