// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <orispline/families/method_text.hpp>

// How a list of methods is read, and what tells methods from each other.

namespace orispline { namespace {

using Texts = std::vector<std::string>;

TEST(MethodList, IsOneMethodWhereItCanBe) {
  for (const char* text : {"auto", "quintic:tension=0.3,0.7,-0.2", "timed-c2:ends=natural,rest",
                           "timed-c2:start_rate=0,0,1.5:tension=1,2"})
    EXPECT_EQ(method_texts_in(text), Texts{text});
}

TEST(MethodList, ElseHasAMethodBetweenTwoCommas) {
  EXPECT_EQ(method_texts_in("auto,slerp"), (Texts{"auto", "slerp"}));
  EXPECT_EQ(method_texts_in("quintic:tension=0.6:ends=natural,sextic,tcb:tension=0.3"),
            (Texts{"quintic:tension=0.6:ends=natural", "sextic", "tcb:tension=0.3"}));
}

TEST(MethodList, LeavesItToItsReaderWhetherThereIsAMethod) {
  EXPECT_EQ(method_texts_in("all,bogus,"), (Texts{"all", "bogus", ""}));
  EXPECT_EQ(method_texts_in(""), Texts{""});
  EXPECT_EQ(method_texts_in("quintic:bias=1"), Texts{"quintic:bias=1"});
}

TEST(MethodList, DoesNotTakeValuesForMethods) {
  for (const auto& [list, value] : {std::pair("auto,quintic:tension=0.3,0.7", "0.7"),
                                    {"auto,timed-c2:ends=natural,rest,slerp", "rest"},
                                    {"quintic:tension=0.3,0.7,slerp", "0.7"},
                                    {"auto,quintic:tension=0.3,-0.2:ends=natural", "-0.2:ends=natural"}}) {
    const Error error = method_texts_in(list).error();
    EXPECT_EQ(error.option, "methods");
    EXPECT_EQ(error.message, "found '" + std::string(value) +
                                 "' between commas, wanted a method; one whose settings have commas is given by an "
                                 "option of its own");
  }
}

TEST(MethodList, SaysWhatIsWrongWithTheOneMethodThatWasMeant) {
  EXPECT_EQ(method_texts_in("quintic:tension=0.3,0.7:bias=1").error().message,
            method_from_text("quintic:tension=0.3,0.7:bias=1").error().message);
  EXPECT_EQ(method_texts_in("quintic:tension=0.3,0.7,x").error().message,
            "found '0.3,0.7,x', wanted numbers with commas between them");
}

TEST(MethodLabels, AreNamesUntilAnotherHasTheName) {
  const auto method = [](const char* text) { return method_from_text(text).value(); };
  EXPECT_EQ(labels_of(std::vector{method("quintic:tension=1,2"), method("auto")}), (Texts{"quintic", "auto"}));
  EXPECT_EQ(labels_of(std::vector{method("quintic:tension=1,2"), method("auto"), method("quintic:tension=1,3")}),
            (Texts{"quintic:tension=1,2", "auto", "quintic:tension=1,3"}));
  EXPECT_EQ(labels_of(std::vector{method("quintic"), method("quintic:tension=1")}),
            (Texts{"quintic", "quintic:tension=1"}));
}

}}  // namespace orispline
