// SPDX-License-Identifier: Apache-2.0
// Handles that come and go by the hundred thousand leave memory as it was after the first hundred.
#include "c/handles.hpp"
#include "c/live_allocations.hpp"

namespace orispline { namespace {

using namespace testing_support;

template <class Work>
void expect_steady_memory(Work work) {
  constexpr int first = 100, all = 100'000;
  for (int i = 0; i < first; ++i) work();
  const long before = live_allocations();
  for (int i = first; i < all; ++i) work();
  EXPECT_EQ(live_allocations(), before);
}

TEST(MemoryOfC, IsThatOfTheHandlesWhichLive) {
  const KeysHandle keys = keys_of(walk(4));
  expect_steady_memory([&] {
    orispline_curve* curve = nullptr;
    ASSERT_EQ(orispline_curve_make(keys.get(), "squad", &curve, nullptr), ORISPLINE_OK);
    orispline_curve_free(curve);
  });
}

TEST(MemoryOfC, IsNotKeptByWhatIsRefused) {
  const KeysHandle keys = keys_of(walk(4));
  expect_steady_memory([&] {
    orispline_curve* curve = nullptr;
    orispline_error* error = nullptr;
    ASSERT_EQ(orispline_curve_make(keys.get(), "squad:tension=1", &curve, &error), ORISPLINE_BAD_ARGUMENT);
    orispline_error_free(error);
    ASSERT_EQ(orispline_curve_make(keys.get(), "nothing", &curve, nullptr), ORISPLINE_BAD_ARGUMENT);
  });
}

TEST(MemoryOfC, IsThatOfTheKeysWhichLive) {
  const KeyframeData data = walk(4);
  const std::vector<double> orientations = flat(data.orientations, ORISPLINE_WXYZ);
  expect_steady_memory([&] {
    orispline_keys* keys = nullptr;
    ASSERT_EQ(orispline_keys_make(data.times.data(), orientations.data(), 4, ORISPLINE_WXYZ, ORISPLINE_SHORTEST,
                                  nullptr, 0, &keys, nullptr),
              ORISPLINE_OK);
    orispline_keys_free(keys);
  });
}

}}  // namespace orispline
