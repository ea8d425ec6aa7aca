// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/output_file.hpp>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "io/text_file.hpp"

namespace {

std::vector<long> synced_sizes;  // of the files that fsync() was asked for
int sync_error = 0;              // what it then says

}  // namespace

/// In the place of the C library's, which no test can ask whether it was called.
extern "C" int fsync(int descriptor) {
  struct stat status {};
  if (fstat(descriptor, &status) == 0) synced_sizes.push_back(status.st_size);
  errno = sync_error;
  return sync_error == 0 ? 0 : -1;
}

namespace orispline::io { namespace {

class Synced : public ::testing::Test {
 protected:
  void SetUp() override {
    synced_sizes.clear();
    sync_error = 0;
  }
  void TearDown() override { sync_error = 0; }

  const test::TextFile old_{"old", "out.csv"};
};

TEST_F(Synced, ReachesTheDiskWholeBeforeItHasItsName) {
  auto file = OutputFile::open(old_.path());
  ASSERT_TRUE(file && file->write("all of it"));
  EXPECT_TRUE(synced_sizes.empty());
  ASSERT_TRUE(file->close());
  EXPECT_EQ(synced_sizes, std::vector<long>{9});
  EXPECT_EQ(test::content_of(old_.path()), "old");
  ASSERT_TRUE(file->finish());
  EXPECT_EQ(test::content_of(old_.path()), "all of it");
  EXPECT_EQ(synced_sizes.size(), 1u);
}

TEST_F(Synced, LeavesTheOldFileWhereTheDiskFails) {
  sync_error = EIO;
  {
    auto file = OutputFile::open(old_.path());
    ASSERT_TRUE(file && file->write("all of it"));
    const auto finished = file->finish();
    ASSERT_FALSE(finished);
    EXPECT_EQ(test::text_of(finished.error()), "out.csv: cannot write: Input/output error");
    EXPECT_EQ(finished.error().code, ErrorCode::bad_access);
  }
  EXPECT_EQ(test::content_of(old_.path()), "old");
  EXPECT_FALSE(std::filesystem::exists(old_.path() + ".part"));
}

TEST_F(Synced, IsWrittenWhereTheFileSystemCannotBeAsked) {
  sync_error = EINVAL;
  auto file = OutputFile::open(old_.path());
  ASSERT_TRUE(file && file->write("new") && file->finish());
  EXPECT_EQ(test::content_of(old_.path()), "new");
}

TEST(Parts, RemovesThePartsOfRunsThatWereKilled) {
  const test::ScratchDirectory directory;
  const std::string path = directory.file("out.csv");
  for (const char* name : {".part", ".part1", ".part3"}) std::ofstream(path + name) << "torn";
  std::filesystem::create_directory(path + ".part2");  // no part at all
  auto file = OutputFile::open(path);
  ASSERT_TRUE(file && file->write("whole") && file->finish());
  EXPECT_EQ(test::content_of(path), "whole");
  EXPECT_TRUE(std::filesystem::is_directory(path + ".part2"));
  EXPECT_EQ(directory.entries(), 2u);
}

TEST(Parts, HaveAShortNameWhereThatOfTheTargetLeavesNoRoom) {
  for (const std::size_t length : {250U, 251U, 255U}) {
    const test::ScratchDirectory directory;
    const std::string path = directory.file(std::string(length, 'x'));
    auto killed = OutputFile::open(path);
    ASSERT_TRUE(killed && killed->close());
    const std::string left = killed->part();
    EXPECT_EQ(left == path + ".part", length == 250U);
    ASSERT_TRUE(killed->finish());
    std::ofstream(left) << "torn";
    auto file = OutputFile::open(path);
    ASSERT_TRUE(file && file->write("whole"));
    EXPECT_EQ(file->part(), left);
    ASSERT_TRUE(file->finish());
    EXPECT_EQ(test::content_of(path), "whole");
    EXPECT_EQ(directory.entries(), 1U);
  }
  const test::ScratchDirectory directory;
  const auto file = OutputFile::open(directory.file(std::string(256, 'x')));
  ASSERT_FALSE(file);
  EXPECT_TRUE(file.error().message.ends_with("cannot write: File name too long"));
}

TEST(Parts, HoldsItsPartUntilItIsInItsPlace) {
  const test::ScratchDirectory directory;
  const std::string path = directory.file("out.csv");
  auto closed = OutputFile::open(path);
  ASSERT_TRUE(closed && closed->write("1") && closed->close());  // waits for others
  auto moved = std::move(*closed);
  {
    const auto other = OutputFile::open(path);
    ASSERT_TRUE(other);
    EXPECT_NE(other->part(), moved.part());
    EXPECT_EQ(directory.entries(), 2u);
  }
  EXPECT_EQ(directory.entries(), 1u);
  ASSERT_TRUE(moved.finish());
  EXPECT_EQ(test::content_of(path), "1");
  EXPECT_EQ(directory.entries(), 1u);
}

}}  // namespace orispline::io
