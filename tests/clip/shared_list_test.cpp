// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/shared_list.hpp>

#include <span>

#include <gtest/gtest.h>

#include <orispline/base/parallel.hpp>
#include <orispline/clip/clip.hpp>

namespace orispline { namespace {

TEST(SharedList, IsAVector) {
  SharedList<int> list{1, 2, 3};
  list.push_back(4);
  list.emplace_back(5);
  list.insert(list.begin(), 0);
  EXPECT_EQ(list, (std::vector{0, 1, 2, 3, 4, 5}));
  list.pop_back();
  list.front() = 7;
  list.back() += 1;
  list[1] = 8;
  EXPECT_EQ(list, (SharedList<int>{7, 8, 2, 3, 5}));
  list.assign(std::size_t{2}, 6);
  list.resize(3);
  const std::vector<int> vector = list;
  EXPECT_EQ(vector, (std::vector{6, 6, 0}));
  EXPECT_EQ(std::span<const int>(std::as_const(list)).size(), 3u);
  EXPECT_TRUE(SharedList<int>().empty());
  EXPECT_EQ(SharedList<int>(), SharedList<int>(std::vector<int>()));
}

TEST(SharedList, SharesItsEntriesUntilACopyIsChanged) {
  const SharedList<int> list{1, 2, 3};
  SharedList<int> copy = list;
  EXPECT_TRUE(copy.shares_with(list));
  EXPECT_EQ(std::as_const(copy).data(), list.data());
  copy[0] = 5;
  EXPECT_FALSE(copy.shares_with(list));
  EXPECT_EQ(list.front(), 1);
  EXPECT_EQ(copy, (std::vector{5, 2, 3}));
  const int* const place = std::as_const(copy).data();
  copy[1] = 6;
  EXPECT_EQ(std::as_const(copy).data(), place) << "entries of its own are changed where they are";
  copy = list;
  EXPECT_TRUE(copy.shares_with(list));
  SharedList<int> moved = std::move(copy);
  EXPECT_TRUE(moved.shares_with(list));
  const SharedList<int>& itself = moved;
  moved = itself;
  EXPECT_EQ(moved, list);
}

TEST(SharedList, CopiesAreChangedOnThreadsAtOnce) {
  const SharedList<int> list(std::vector<int>(1000, 1));
  std::vector<SharedList<int>> copies(64, list);
  parallel_for(copies.size(), 8, [&](std::size_t i) {
    for (int& entry : copies[i]) entry += static_cast<int>(i);
  });
  for (std::size_t i = 0; i < copies.size(); ++i) EXPECT_EQ(copies[i], std::vector<int>(1000, 1 + static_cast<int>(i)));
  EXPECT_EQ(list, std::vector<int>(1000, 1));
}

TEST(Clip, LastsAsLongAsAllThatTheFileMoves) {
  Clip clip{.name = "face"};
  EXPECT_EQ(clip.whole_domain().end, 0.0);
  clip.passed_on = Domain{0.5, 2.0};
  EXPECT_EQ(clip.whole_domain().start, 0.5);
  EXPECT_EQ(clip.domain().end, 0.0);
  clip.translations.push_back({.times = {1.0, 3.0}, .values = {{0, 0, 0}, {1, 0, 0}}});
  EXPECT_EQ(clip.whole_domain().start, 0.5);
  EXPECT_EQ(clip.whole_domain().end, 3.0);
}

}}  // namespace orispline
