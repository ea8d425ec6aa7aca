// SPDX-License-Identifier: Apache-2.0
#include <orispline/families/method_text.hpp>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>

// The text form of methods: what it says, that it reads back bit for bit, and what is refused.

namespace orispline { namespace {

void expect_equal(const Method& a, const Method& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.options.parameters, b.options.parameters);
  EXPECT_EQ(a.options.choices, b.options.choices);
  for (const auto& [one, other] : {std::pair(a.options.start, b.options.start), {a.options.end, b.options.end}}) {
    EXPECT_EQ(one.rule, other.rule);
    EXPECT_EQ(one.angular_velocity, other.angular_velocity);
  }
  ASSERT_EQ(a.options.loop.has_value(), b.options.loop.has_value());
  if (a.options.loop) {
    EXPECT_EQ(a.options.loop->period, b.options.loop->period);
  }
}

TEST(MethodText, SaysWhatAMethodIs) {
  const Method method = method_from_text("timed-c2:tension=0.5,1,2:ends=natural,rest").value();
  EXPECT_EQ(method.name, "timed-c2");
  EXPECT_EQ(method.options.parameters.at("tension"), (std::vector{0.5, 1.0, 2.0}));
  EXPECT_EQ(method.options.start.rule, EndRule::natural);
  EXPECT_EQ(method.options.end.rule, EndRule::rest);
  EXPECT_EQ(method_from_text("squad-timed:variant=boyle").value().options.choices.at("variant"), "boyle");
  EXPECT_EQ(method_from_text("timed-c2:start_rate=0,0,1.5").value().options.start.angular_velocity.z(), 1.5);
  EXPECT_EQ(method_from_text("timed-c2:period=4").value().options.loop->period, 4.0);
}

TEST(MethodText, ReadsBackBitForBit) {
  for (const char* text :
       {"auto", "auto:hold=1", "quintic:tension=0.1:ends=natural", "timed-c2:tension=0.30000000000000004,1e-300,-0",
        "timed-c2:ends=natural,rest", "timed-c2:ends=clamped:start_rate=1,0.1,-3e-17:end_rate=0,0,0",
        "timed-c2:ends=natural,clamped:end_rate=0,0,2", "timed-c2:ends=clamped,none:start_rate=0,1,0",
        "squad-timed:variant=boyle", "timed-c3:closed", "timed-c3:period=12.5"}) {
    const auto method = method_from_text(text);
    ASSERT_TRUE(method) << text << ": " << describe(method.error());
    EXPECT_EQ(text_of(*method), text);
    expect_equal(method_from_text(text_of(*method)).value(), *method);
  }
}

TEST(MethodText, ReadsTheNamesOfAllMethods) {
  for (const FamilyInfo& family : families_info())
    EXPECT_EQ(text_of(method_from_text(family.name).value()), family.name);
}

TEST(MethodText, RefusesWhatIsNoMethod) {
  const auto error = [](const char* text) { return method_from_text(text).error(); };
  EXPECT_EQ(error("bezel").code, ErrorCode::bad_argument);
  EXPECT_EQ(error("").code, ErrorCode::bad_argument);
  EXPECT_EQ(error("auto:").message, "found '', wanted NAME=VALUE");
  EXPECT_EQ(error("quintic:tension=").message, "found 'tension=', wanted NAME=VALUE");
  EXPECT_EQ(error("quintic:tension=high").message, "found 'high', wanted numbers with commas between them");
  EXPECT_EQ(error("quintic:tension=high").option, "tension");
  EXPECT_EQ(error("quintic:tension=1e999").option, "tension");
  EXPECT_EQ(error("quintic:tension=nan").option, "tension");
  EXPECT_EQ(error("quintic:tension=1 ").option, "tension");
  EXPECT_EQ(error("quintic:tension=1:tension=2").message, "'tension' is given twice, wanted it once");
  EXPECT_EQ(error("quintic:bias=1").message, "quintic: unknown parameter 'bias', wanted one of tension");
  EXPECT_EQ(error("timed-c2:ends=loose").option, "ends");
  EXPECT_EQ(error("timed-c2:ends=rest,rest,rest").message, "found 'rest,rest,rest', wanted RULE or START,END");
  EXPECT_EQ(error("timed-c2:ends=natural:start_rate=0,0,1").message,
            "a rate needs the end rule clamped, found natural");
  EXPECT_EQ(error("timed-c2:start_rate=0,1").option, "start_rate");
  EXPECT_EQ(error("slerp:closed").code, ErrorCode::bad_argument);
  EXPECT_EQ(error("timed-c2:period=0").option, "period");
}

TEST(MethodText, IsSilentAboutWhatOthersSay) {
  const auto left = [](const char* text, const std::vector<std::string>& names) {
    return text_of(without(method_from_text(text).value(), names));
  };
  EXPECT_EQ(left("tcb:bias=0.5:tension=0.25", {"tension"}), "tcb:bias=0.5");
  EXPECT_EQ(left("squad-timed:variant=boyle", {"variant"}), "squad-timed");
  EXPECT_EQ(left("timed-c2:ends=rest", {"ends", "bias"}), "timed-c2");
  EXPECT_EQ(left("timed-c2:start_rate=0,0,1:end_rate=0,1,0", {"start_rate"}),
            "timed-c2:ends=none,clamped:end_rate=0,1,0");
  EXPECT_EQ(left("timed-c2:start_rate=0,0,1:end_rate=0,1,0", {"end_rate"}),
            "timed-c2:ends=clamped,none:start_rate=0,0,1");
  const Method open = without(method_from_text("timed-c2:start_rate=0,0,1").value(), std::vector<std::string>{"ends"});
  EXPECT_EQ(text_of(with_ends(open, "clamped,rest").value()), "timed-c2:ends=clamped,rest:start_rate=0,0,1");
  EXPECT_EQ(left("timed-c2:period=7", {"closed"}), "timed-c2");
  EXPECT_EQ(left("timed-c2:closed", {}), "timed-c2:closed");
}

}}  // namespace orispline
