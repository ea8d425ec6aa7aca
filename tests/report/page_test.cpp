// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page.hpp>

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include <orispline/report/page_json.hpp>
#include <orispline/report/page_template.hpp>
#include <support/counted.hpp>
#include <support/not_finite.hpp>

namespace orispline::report { namespace {

using testing_support::count_of;
using testing_support::nan;

TEST(Page, IsTheTemplateWithTheDataInTheMarkersPlace) {
  std::string parts;
  for (const std::string_view piece : page_template()) parts += piece;
  ASSERT_EQ(count_of(data_marker, parts), 1U);
  const Page page{.title = "A title"};
  const std::size_t at = parts.find(data_marker);
  EXPECT_EQ(document(page), parts.substr(0, at) + data_of(page) + parts.substr(at + data_marker.size()));
}

TEST(Page, KeepsTheLicencesOfWhatItContains) {
  const std::string html = document({.title = "A title"});
  EXPECT_EQ(count_of("Copyright © 2010-", html), 1U);  // three.js
  EXPECT_EQ(count_of("Leon Sorokin", html), 1U);       // uPlot
  EXPECT_GE(count_of("Permission is hereby granted, free of charge", html), 2U);
}

TEST(Page, RunsTheModuleThatANotebookLoads) {
  const PageModule module = page_module();
  const std::string html = document({.title = "A title"});
  EXPECT_EQ(count_of("<script type=\"module\">" + module.script + "</script>", html), 1U);
  EXPECT_EQ(count_of("<style id=\"viewer\">" + module.style + "</style>", html), 1U);
  EXPECT_EQ(count_of(" as default};", module.script), 1U);
  EXPECT_EQ(count_of("Permission is hereby granted, free of charge", module.script), 2U);
  EXPECT_EQ(count_of("@page", module.style), 0U);  // what is for the whole page only
}

TEST(Page, NoTextEndsTheScriptOrTheString) {
  const std::string json = json_of(Page{.title = "</script> \"a\\b\"\n\x01 ω"});
  EXPECT_EQ(count_of("<", json), 0U);
  EXPECT_EQ(count_of(R"("title":"\u003c/script> \u0022a\u005cb\u0022\u000a\u0001 ω")", json), 1U);
}

TEST(Page, WritesQuaternionsScalarFirstAndVectorsFlat) {
  const Eigen::Quaterniond first(1.0, 0.0, 0.0, 0.0), second(0.5, -0.5, 0.5, 0.25);
  const std::string json = json_of(Page{.keys = {{{0.0, 1.5}, {first, second}}, {{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}}}});
  EXPECT_EQ(count_of(R"("keys":{"t":[0,1.5],"q":[1,0,0,0,0.5,-0.5,0.5,0.25],"p":[1,2,3,4,5,6]})", json), 1U);
  EXPECT_EQ(count_of(R"("reference":null)", json), 1U);
}

TEST(Page, RoundsToSevenDigitsAndHasNullForNoNumber) {
  PageMethod method{.name = "m", .continuity = "C2"};
  method.measures = {{"big", 123456789.0}, {"none", nan}, {"third", 1.0 / 3.0}};
  method.samples = {.path = {{0.0}, {Eigen::Quaterniond::Identity()}},
                    .angular_velocities = {{1e-9, -2.0 / 3.0, 1e300}},
                    .errors = {nan},
                    .exactness = 0.0031};
  const std::string json = json_of(Page{.methods = {method}});
  EXPECT_EQ(count_of(R"("measures":{"big":1.234568e+08,"none":null,"third":0.3333333})", json), 1U);
  EXPECT_EQ(count_of(R"("w":[1e-09,-0.6666667,1e+300])", json), 1U);
  EXPECT_EQ(count_of(R"("error_deg":[null],"straight":false,"exactness_deg":0.0031})", json), 1U);
}

TEST(Page, StatesTheVersionOfItsData) {
  EXPECT_EQ(json_of(Page{}).substr(0, 20), R"({"data":2,"title":"")");
  EXPECT_EQ(json_of(SkeletonPage{}).substr(0, 20), R"({"data":2,"title":"")");
}

TEST(Page, WritesTimesThatSeveralMethodsHaveOnce) {
  const Eigen::Quaterniond one(1.0, 0.0, 0.0, 0.0);
  std::vector<PageMethod> methods(4);
  methods[0].samples.path = methods[2].samples.path = {{0.0, 1.0}, {one, one}};
  methods[1].samples.path = {{0.0, 2.0}, {one, one}};
  const std::string json = json_of(Page{.methods = methods});
  EXPECT_EQ(count_of(R"("samples":{"t":[0,1],)", json), 1U);
  EXPECT_EQ(count_of(R"("samples":{"t":[0,2],)", json), 1U);
  EXPECT_EQ(count_of(R"("samples":{"t":{"like":0},)", json), 1U);
  EXPECT_EQ(count_of(R"("samples":{"t":[],)", json), 1U);
}

TEST(Page, HasNotesLimitsMarksAndKeysOfAMethod) {
  const Eigen::Quaterniond one(1.0, 0.0, 0.0, 0.0);
  const std::string empty = json_of(Page{.methods = {{.name = "m"}}});
  EXPECT_EQ(count_of(R"("notes":[],)", empty), 1U);
  EXPECT_EQ(count_of(R"("marks":null,"limits":{},"units":{},)", empty), 1U);
  EXPECT_EQ(count_of(R"("torque":[],"p":[],"error_t":[],"error_deg":[],"straight":false,"exactness_deg":null},)"
                     R"("keys":null,"clock":null,"bands":{}})",
                     empty),
            1U);
  PageMethod method{.name = "m", .keys = PageKeys{.path = {{2.0}, {one}}}};
  method.samples.torques = {{1.0, 2.0, 3.0}};
  method.samples.error_times = {0.5};
  method.samples.errors = {4.0};
  method.clock = PageClock{{0.0, 3.0}, {0.0, 1.5}};
  method.bands["w"] = {"σ", {0.5, 1.0}, {0.0, std::nan("")}, {0.25, std::nan("")}};
  const std::string json = json_of(Page{.notes = {"a", "b"},
                                        .marks = PageMarks{"odd ones", {{1.0}, {one}}, {30.0}},
                                        .limits = {{"w", 1.5}, {"error", 0.1}},
                                        .units = {{"w", {"°/s", 0.0174532925}}},
                                        .methods = {method}});
  EXPECT_EQ(count_of("\"notes\":[\"a\",\n\"b\"]", json), 1U);
  EXPECT_EQ(count_of(R"("marks":{"label":"odd ones","t":[1],"q":[1,0,0,0],"error_deg":[30]})", json), 1U);
  EXPECT_EQ(count_of(R"("limits":{"error":0.1,"w":1.5},"units":{"w":{"unit":"°/s","size":0.01745329}})", json), 1U);
  EXPECT_EQ(
      count_of(R"("torque":[1,2,3],"p":[],"error_t":[0.5],"error_deg":[4],"straight":false,"exactness_deg":null})",
               json),
      1U);
  EXPECT_EQ(count_of(R"("keys":{"t":[2],"q":[1,0,0,0],"p":[]},"clock":{"t":[0,3],"own":[0,1.5]},)"
                     R"("bands":{"w":{"label":"σ","t":[0.5,1],"low":[0,null],"high":[0.25,null]}}})",
                     json),
            1U);
}

TEST(Page, NamesColumnsBodiesAndFailures) {
  Page page{.body = PageBody::axes, .sorted_by = "rms", .first = "b", .second = "c"};
  page.columns = {{"rms", "RMS", "deg", "why", Better::less, false, 1e-12}, {"n", "N", "", "", Better::neither, true}};
  page.methods = {{.name = "a", .failure = "no"}, {.name = "b"}};
  const std::string json = json_of(page);
  EXPECT_EQ(count_of(R"("body":"axes")", json), 1U);
  EXPECT_EQ(count_of(R"({"id":"rms","label":"RMS","unit":"deg","explanation":"why","better":"less",)"
                     R"("is_time":false,"rounding":1e-12})",
                     json),
            1U);
  EXPECT_EQ(count_of(R"("better":"neither","is_time":true,"rounding":0}],"sorted_by":"rms","first":"b","second":"c",)"
                     R"("methods":[{"name":"a","continuity":"","failure":"no")",
                     json),
            1U);
}

}}  // namespace orispline::report
