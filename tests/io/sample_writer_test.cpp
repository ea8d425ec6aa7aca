// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/sample_writer.hpp>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <utility>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include "io/exact_number.hpp"
#include "io/text_file.hpp"

namespace orispline::io { namespace {

using test::content_of;
using test::decimal;
using test::ScratchDirectory;
using test::text_of;

const Motion moving{.orientation = quaternion_wxyz(0.5, -0.5, 0.5, -0.5),
                    .angular_velocity = {1, 2, 3},
                    .angular_acceleration = {4, 5, 6},
                    .angular_jerk = {7, 8, 9}};

std::string written(const SampleColumns& columns, const Sample& sample, std::string_view time = "0") {
  const ScratchDirectory directory;
  const std::string path = directory.file("out");
  auto writer = SampleWriter::open(path, columns);
  EXPECT_TRUE(writer && writer->write(decimal(time), sample) && writer->finish());
  return content_of(path);
}

TEST(SampleWriter, WritesTheColumnsThatAreAskedFor) {
  const Sample sample{
      .motion = moving,
      .linear_motion = {.position = {10, 20, 30}, .velocity = {11, 12, 13}, .acceleration = {14, 15, 16}}};
  EXPECT_EQ(written({}, sample, "0.25"), "t,qw,qx,qy,qz\n0.25,0.5,-0.5,0.5,-0.5\n");
  EXPECT_EQ(written({.derivatives = 1}, sample, "0.25"), "t,qw,qx,qy,qz,wx,wy,wz\n0.25,0.5,-0.5,0.5,-0.5,1,2,3\n");
  EXPECT_EQ(written({.positions = true, .derivatives = 3}, sample, "0.25"),
            "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz,ax,ay,az,jx,jy,jz\n"
            "0.25,0.5,-0.5,0.5,-0.5,10,20,30,1,2,3,4,5,6,7,8,9\n");
}

TEST(SampleWriter, WritesTheRatesOfPositionsLast) {
  const Sample sample{
      .motion = moving,
      .linear_motion = {.position = {10, 20, 30}, .velocity = {11, 12, 13}, .acceleration = {14, 15, 16}}};
  EXPECT_EQ(written({.positions = true, .derivatives = 1, .position_derivatives = 1}, sample),
            "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz,vx,vy,vz\n0,0.5,-0.5,0.5,-0.5,10,20,30,1,2,3,11,12,13\n");
  EXPECT_EQ(written({.positions = true, .derivatives = 2, .position_derivatives = 2}, sample),
            "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz,ax,ay,az,vx,vy,vz,apx,apy,apz\n"
            "0,0.5,-0.5,0.5,-0.5,10,20,30,1,2,3,4,5,6,11,12,13,14,15,16\n");
}

TEST(SampleWriter, WritesRatesInTheWorldFrame) {
  Sample sample{.motion = moving, .linear_motion = {.velocity = {1, 2, 3}}};
  sample.motion.orientation = quaternion_wxyz(0.0, 1.0, 0.0, 0.0);  // half turn about x: y and z change sign
  // jerk_world = R (jerk + ω × α), ω × α = (-3, 6, -3); the velocity is in the world frame as it is
  EXPECT_EQ(written({.derivatives = 3, .position_derivatives = 1, .frame = Frame::world}, sample),
            "t,qw,qx,qy,qz,wx_world,wy_world,wz_world,ax_world,ay_world,az_world,jx_world,jy_world,jz_world,vx,vy,vz\n"
            "0,0,1,0,0,1,-2,-3,4,-5,-6,4,-14,-6,1,2,3\n");
}

TEST(SampleWriter, WritesTum) {
  const Sample sample{.motion = moving, .linear_motion = {.position = {1, 2, 3}}};
  EXPECT_EQ(written({.format = &tum_format, .positions = true}, sample, "1311868163.8731"),
            "1311868163.8731 1 2 3 -0.5 0.5 -0.5 0.5\n");
}

TEST(SampleWriter, WritesEveryDigitOfATime) {
  EXPECT_EQ(written({}, {}, "1700000000.100000001").substr(14), "1700000000.100000001,1,0,0,0\n");
  EXPECT_EQ(written({}, {}, "-4.69999999999999996").substr(14), "-4.69999999999999996,1,0,0,0\n");
}

TEST(SampleWriter, RefusesWhatTheFormatCannotHold) {
  const ScratchDirectory directory;
  const auto refusal = [&](const SampleColumns& columns) {
    const auto writer = SampleWriter::open(directory.file("out"), columns);
    EXPECT_EQ(writer.error().code, ErrorCode::bad_argument);
    return writer.error().message;
  };
  EXPECT_EQ(refusal({.format = &tum_format, .derivatives = 1}), "1 derivatives were asked for, and TUM holds 0");
  EXPECT_EQ(refusal({.format = &euroc_format, .derivatives = 2}), "2 derivatives were asked for, and EuRoC holds 0");
  EXPECT_EQ(refusal({.derivatives = 4}), "4 derivatives were asked for, and CSV holds 0 to 3");
  EXPECT_EQ(refusal({.derivatives = -1}), "-1 derivatives were asked for, and CSV holds 0 to 3");
  EXPECT_EQ(refusal({.position_derivatives = 3}), "3 derivatives of the position were asked for, and CSV holds 0 to 2");
  EXPECT_EQ(refusal({.format = &tum_format, .form = {.representation = Representation::matrix}}),
            "TUM holds orientations as quaternions only");
  EXPECT_EQ(directory.entries(), 0u);
}

TEST(SampleWriter, RefusesNumbersThatAreNotFinite) {
  const ScratchDirectory directory;
  auto writer = SampleWriter::open(directory.file("out.csv"), {.derivatives = 2});
  ASSERT_TRUE(writer);
  Sample sample{.motion = moving};
  sample.motion.angular_acceleration.y() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(writer->write(decimal("11.5"), sample).error().message,
            "the sample at time 11.5 has a number that is not finite");
}

TEST(OutputFile, AppearsOnlyWhenItIsFinished) {
  const ScratchDirectory directory;
  const std::string path = directory.file("out.csv");
  auto file = OutputFile::open(path);
  ASSERT_TRUE(file && file->write("new"));
  EXPECT_FALSE(std::filesystem::exists(path));

  ASSERT_TRUE(file->finish());

  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(directory.entries(), 1u);
}

TEST(OutputFile, LeavesTheTargetAloneWhenItIsAbandoned) {
  const ScratchDirectory directory;
  const std::string path = directory.file("out.csv");
  std::ofstream(path) << "old";
  {
    auto file = OutputFile::open(path);
    ASSERT_TRUE(file && file->write("new"));
    OutputFile moved = std::move(*file);
    EXPECT_TRUE(moved.write("er"));
  }
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(directory.entries(), 1u);
}

TEST(OutputFile, StaysBesideItsTargetWhileItIsOnlyClosed) {
  const ScratchDirectory directory;
  const std::string path = directory.file("out.csv");
  std::ofstream(path) << "old";
  {
    auto abandoned = SampleWriter::open(path, {});
    ASSERT_TRUE(abandoned && abandoned->write(decimal("0"), {}) && abandoned->close());
    EXPECT_EQ(content_of(path), "old");
    EXPECT_EQ(content_of(abandoned->part()), "t,qw,qx,qy,qz\n0,1,0,0,0\n");
  }
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
  auto writer = SampleWriter::open(path, {});
  ASSERT_TRUE(writer && writer->write(decimal("0"), {}) && writer->close() && writer->finish());
  EXPECT_EQ(content_of(path), "t,qw,qx,qy,qz\n0,1,0,0,0\n");
  EXPECT_FALSE(std::filesystem::exists(path + ".part"));
}

TEST(OutputFile, IsCheckedWithoutATrace) {
  const ScratchDirectory directory;
  const std::string path = directory.file("out.csv");
  EXPECT_TRUE(check_output(path));
  EXPECT_TRUE(check_output("-"));
  EXPECT_TRUE(check_output("/dev/null"));
  EXPECT_FALSE(std::filesystem::exists(path) || std::filesystem::exists(path + ".part"));
  std::ofstream(path) << "old";
  EXPECT_TRUE(check_output(path));
  EXPECT_EQ(content_of(path), "old");
  EXPECT_EQ(check_output(directory.file("nowhere/out.csv")).error().message, "cannot write: No such file or directory");
  EXPECT_EQ(check_output(directory.file("")).error().message, "cannot write: Is a directory");
}

TEST(OutputFile, IsAbandonedWhenAnotherTakesItsPlace) {
  const ScratchDirectory directory;
  auto file = OutputFile::open(directory.file("one.csv"));
  auto other = OutputFile::open(directory.file("two.csv"));
  ASSERT_TRUE(file && other && file->write("1") && other->write("2"));

  *file = std::move(*other);

  EXPECT_EQ(directory.entries(), 1u);
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(content_of(directory.file("two.csv")), "2");
  EXPECT_FALSE(std::filesystem::exists(directory.file("one.csv")));
}

TEST(OutputFile, IsStandardOutputForADash) {
  ::testing::internal::CaptureStdout();
  auto file = OutputFile::open("-");
  const bool complete = file && file->write("t,qw\n") && file->finish();
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "t,qw\n");
  EXPECT_TRUE(complete);
}

TEST(OutputFile, ReplacesTheTargetAndKeepsItsPermissions) {
  const ScratchDirectory directory;
  const std::string path = directory.file("out.csv");
  std::ofstream(path) << "old and longer";
  const auto only_owner = std::filesystem::perms::owner_read | std::filesystem::perms::owner_write;
  std::filesystem::permissions(path, only_owner);

  auto file = OutputFile::open(path);
  ASSERT_TRUE(file && file->write("new") && file->finish());

  EXPECT_EQ(content_of(path), "new");
  EXPECT_EQ(std::filesystem::status(path).permissions(), only_owner);
}

TEST(OutputFile, WritesTheFileBehindALink) {
  const ScratchDirectory directory;
  const std::string path = directory.file("out.csv"), link = directory.file("link.csv");
  std::ofstream(path) << "old";
  std::filesystem::create_symlink(path, link);

  auto file = OutputFile::open(link);
  ASSERT_TRUE(file && file->write("new") && file->finish());

  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_EQ(content_of(path), "new");
}

TEST(OutputFile, WritesTheFileThatALinkLeadsToThoughItIsNotThere) {
  const ScratchDirectory directory;
  const std::string path = directory.file("out.csv"), link = directory.file("link.csv"),
                    far = directory.file("far.csv");
  std::filesystem::create_symlink("out.csv", link);
  std::filesystem::create_symlink(link, far);

  auto file = OutputFile::open(far);
  ASSERT_TRUE(file && file->write("new") && file->finish());

  EXPECT_TRUE(std::filesystem::is_symlink(link) && std::filesystem::is_symlink(far));
  EXPECT_FALSE(std::filesystem::is_symlink(path));
  EXPECT_EQ(content_of(path), "new");
}

TEST(OutputFile, IsNoLinkInACircle) {
  const ScratchDirectory directory;
  const std::string link = directory.file("link.csv");
  std::filesystem::create_symlink(link, link);
  EXPECT_EQ(text_of(OutputFile::open(link).error()), "link.csv: cannot write: Too many levels of symbolic links");
  EXPECT_TRUE(std::filesystem::is_symlink(link));
}

TEST(OutputFile, PassesByThePartsOfOthers) {
  const ScratchDirectory directory;
  const std::string path = directory.file("out.csv");
  std::ofstream(path + ".part") << "another's";
  const int other = ::open((path + ".part").c_str(), O_RDWR);  // a run that writes it
  ASSERT_EQ(flock(other, LOCK_EX | LOCK_NB), 0);
  auto first = OutputFile::open(path), second = OutputFile::open(path);
  ASSERT_TRUE(first && second && first->write("1") && second->write("2") && second->finish() && first->finish());
  EXPECT_EQ(content_of(path), "1");
  EXPECT_EQ(content_of(path + ".part"), "another's");
  EXPECT_EQ(directory.entries(), 2u);
  ::close(other);
}

TEST(OutputFile, SaysWhyItCannotBeWritten) {
  const ScratchDirectory directory;
  const auto refusal = [](const std::string& path) {
    const auto file = OutputFile::open(path);
    EXPECT_EQ(file.error().code, ErrorCode::bad_access);
    return text_of(file.error());
  };
  EXPECT_EQ(refusal(directory.file("absent/out.csv")), "out.csv: cannot write: No such file or directory");
  std::filesystem::create_directory(directory.file("folder"));
  EXPECT_EQ(refusal(directory.file("folder")), "folder: cannot write: Is a directory");
}

TEST(OutputFile, DoesNotReplaceAProtectedFile) {
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is protected from root";
  const ScratchDirectory directory;
  const std::string path = directory.file("fixed.csv");
  std::ofstream(path) << "old";
  std::filesystem::permissions(path, std::filesystem::perms::owner_read);
  EXPECT_EQ(text_of(OutputFile::open(path).error()), "fixed.csv: cannot write: Permission denied");
}

TEST(OutputFile, ReportsAFullDisk) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  auto small = OutputFile::open("/dev/full");
  ASSERT_TRUE(small && small->write("little"));
  const auto finished = small->finish();
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().code, ErrorCode::bad_access);
  EXPECT_EQ(describe(finished.error()), "/dev/full: cannot write: No space left on device");

  auto large = OutputFile::open("/dev/full");
  ASSERT_TRUE(large);
  EXPECT_EQ(describe(large->write(std::string(1 << 20, 'x')).error()),
            "/dev/full: cannot write: No space left on device");
}

TEST(SampleWriter, SaysThatTheDiskIsFullWhenRowsOfAnotherThreadCome) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
  auto writer = SampleWriter::open("/dev/full", {});
  ASSERT_TRUE(writer);
  const Sample sample{.motion = moving};
  for (int i = 0; i < 6000; ++i) ASSERT_TRUE(writer->write(decimal(std::to_string(1'000'000 + i)), sample));
  SampleRows rows{SampleColumns{}};
  ASSERT_TRUE(rows.append(decimal("2000000"), sample));
  const auto done = writer->write(rows);
  ASSERT_FALSE(done);
  EXPECT_EQ(describe(done.error()), "/dev/full: cannot write: No space left on device");
}

TEST(OutputFile, WritesDevicesDirectly) {
  auto file = OutputFile::open("/dev/null");
  EXPECT_TRUE(file && file->write("gone") && file->finish());
  EXPECT_FALSE(std::filesystem::is_regular_file("/dev/null"));
  EXPECT_FALSE(std::filesystem::exists("/dev/null.part"));
}

}}  // namespace orispline::io
