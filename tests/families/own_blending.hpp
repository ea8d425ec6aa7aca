// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <memory>

#include <gtest/gtest.h>

#include <orispline/families/blending/blending_family.hpp>

namespace orispline::testing_support {

inline std::shared_ptr<const BlendingFamily> family_of(const BlendingData& data) {
  auto made = BlendingFamily::make(data);
  EXPECT_TRUE(made) << (made ? "" : made.error().message);
  return made.value();
}

inline BlendingFinding finding(const BlendingData& data, BlendingFinding::Promise promise) {
  const auto family = family_of(data);
  const auto found = std::ranges::find(family->findings(), promise, &BlendingFinding::promise);
  EXPECT_NE(found, family->findings().end());
  return *found;
}

}  // namespace orispline::testing_support
