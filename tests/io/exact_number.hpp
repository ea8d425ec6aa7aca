// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include <gtest/gtest.h>

#include <orispline/base/decimal.hpp>

namespace orispline::test {

inline Decimal decimal(std::string_view text) {
  auto number = Decimal::parse(text);
  EXPECT_TRUE(number) << text << ": " << number.error().message;
  return number.value_or(Decimal());
}

}  // namespace orispline::test
