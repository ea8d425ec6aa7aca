// SPDX-License-Identifier: Apache-2.0
// Options by their names, with values as people type them.
#include <gtest/gtest.h>

#include <orispline/fields.hpp>

namespace orispline { namespace {

constexpr double degree = 0.017453292519943295;

template <class Options>
Expected<FieldValue> typed(std::string_view name, std::string_view text) {
  return find_field(fields_of<Options>(), name).and_then([&](const FieldInfo* field) {
    return typed_value(*field, text);
  });
}

template <class Options>
std::string refusal(std::string_view name, std::string_view text) {
  const auto value = typed<Options>(name, text);
  return value ? "taken" : describe(value.error());
}

TEST(TypedField, IsFoundByItsNameOrTheNearest) {
  EXPECT_EQ((*find_field(fields_of<SmoothOptions>(), "penalty"))->name, "penalty");
  const auto unknown = find_field(fields_of<SmoothOptions>(), "penality");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().code, ErrorCode::bad_argument);
  EXPECT_NE(unknown.error().message.find("did you mean 'penalty'"), std::string::npos) << unknown.error().message;
}

TEST(TypedField, HasItsUnitBehindIt) {
  EXPECT_DOUBLE_EQ(std::get<double>(typed<SmoothOptions>("noise", "0.5deg").value()), 0.5 * degree);
  EXPECT_DOUBLE_EQ(std::get<double>(typed<SmoothOptions>("noise", "2mrad").value()), 0.002);
  EXPECT_DOUBLE_EQ(std::get<double>(typed<SmoothOptions>("smoothing_time", "0.25s").value()), 0.25);
  EXPECT_EQ(std::get<std::string>(typed<SmoothOptions>("penalty", "jerk").value()), "jerk");
  EXPECT_EQ(std::get<bool>(typed<SmoothOptions>("gyro", "true").value()), true);
}

TEST(TypedField, IsRefusedInWords) {
  for (const std::string_view text : {"", "fast", "-1deg", "nan", "1e999deg", "0.5furlong"})
    EXPECT_NE(refusal<SmoothOptions>("noise", text).find("wanted a"), std::string::npos)
        << text << ": " << refusal<SmoothOptions>("noise", text);
  EXPECT_NE(refusal<SmoothOptions>("penalty", "snap").find("wanted acceleration|jerk"), std::string::npos)
      << refusal<SmoothOptions>("penalty", "snap");
  EXPECT_EQ(typed<SmoothOptions>("penalty", "snap").error().option, "penalty");
}

}}  // namespace orispline
