// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <gtest/gtest.h>

#include <orispline/base/expected.hpp>

namespace orispline::testing_support {

inline void expect_bad_argument(const Expected<void>& sampled, const std::string& message) {
  ASSERT_FALSE(sampled);
  EXPECT_EQ(sampled.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(sampled.error().message, message);
}

}  // namespace orispline::testing_support
