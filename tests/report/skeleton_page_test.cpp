// SPDX-License-Identifier: Apache-2.0
#include <orispline/report/page.hpp>

#include <gtest/gtest.h>

#include <orispline/report/page_json.hpp>
#include <orispline/report/page_template.hpp>
#include <support/counted.hpp>

namespace orispline::report { namespace {

using testing_support::count_of;

/// Two joints at two times, 8 units wide in all: the second one moves by 1 along x, and is off by 0.5 along y.
SkeletonPage small_page() {
  PageClip clip{.name = "swing", .start = 0.0, .end = 0.5, .rotation_keys = {9, 4}, .translation_keys = {2, 1}};
  clip.times = clip.error_times = {0.0, 0.5};
  clip.before = {{0.0, 0.0, 0.0}, {7.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, {8.0, 0.0, 0.0}};
  clip.after = clip.before;
  clip.after[3].y() = 0.5;
  clip.joints = {{.angles = {0.0, 0.0}, .distances = {0.0, 0.0}},
                 {.angles = {0.0, 2.0},
                  .distances = {0.0, 0.5},
                  .angle = {2.5, 0.25},
                  .distance = {0.5, 0.5},
                  .keys = {9, 4},
                  .key_times = {0.0, 0.125, 0.25, 0.5}}};
  return {.title = "A title",
          .notes = {"A note."},
          .before = "a.glb",
          .after = "b<.glb",
          .length_unit = "mm",
          .shell = 30.0,
          .angle_limit = 0.2,
          .joints = {{.name = "root"}, {.name = "tip", .parent = 0, .is_compared = false}},
          .clips = {clip}};
}

TEST(SkeletonPage, IsTheSameTemplateWithItsDataInTheMarkersPlace) {
  std::string parts;
  for (const std::string_view piece : page_template()) parts += piece;
  const SkeletonPage page = small_page();
  const std::size_t at = parts.find(data_marker);
  EXPECT_EQ(skeleton_document(page), parts.substr(0, at) + json_of(page) + parts.substr(at + data_marker.size()));
}

TEST(SkeletonPage, SaysWhatTheMotionsAreAndHowTheJointsHang) {
  const std::string json = json_of(small_page());
  EXPECT_EQ(count_of(R"("notes":["A note."],"skeleton":{"before":"a.glb","after":"b\u003c.glb","unit":"mm","shell":30,)"
                     R"("up":"y","angle_limit":0.2,"distance_limit":null)",
                     json),
            1U);
  EXPECT_EQ(count_of("[{\"name\":\"root\",\"parent\":null,\"is_compared\":true},\n"
                     "{\"name\":\"tip\",\"parent\":0,\"is_compared\":false}]",
                     json),
            1U);
  SkeletonPage other = small_page();
  other.up = PageUp::z;
  other.distance_limit = 2.0;
  EXPECT_EQ(count_of(R"("up":"z","angle_limit":0.2,"distance_limit":2)", json_of(other)), 1U);
}

TEST(SkeletonPage, HasPositionsAsWholeStepsFromTheTimeBefore) {
  const std::string json = json_of(small_page());
  EXPECT_EQ(count_of(R"("poses":{"t":[0,0.5],"step":0.001,"before":[0,0,0,7000,0,0,0,0,0,1000,0,0],)"
                     R"("offset_step":0.001,"after":[0,0,0,0,0,0,0,0,0,0,500,0]})",
                     json),
            1U);
}

TEST(SkeletonPage, HasErrorsAsWholeStepsAndNoneOfWhatIsNotOff) {
  const std::string json = json_of(small_page());
  EXPECT_EQ(count_of("\"errors\":{\"t\":[0,0.5],\"angle_step\":0.001,\"angle_deg\":[[],\n[0,2000]],"
                     "\"distance_step\":0.001,\"distance\":[[],\n[0,500]]}",
                     json),
            1U);
  EXPECT_EQ(count_of(R"({"angle_deg":[2.5,0.25],"distance":[0.5,0.5],"keys":[9,4],"key_t":[0,0.125,0.25,0.5]})", json),
            1U);
  EXPECT_EQ(count_of(R"("start":0,"end":0.5,"rotation_keys":[9,4],"translation_keys":[2,1])", json), 1U);
}

TEST(SkeletonPage, RoundsWhatStandsInTablesAsItsLines) {
  SkeletonPage page = small_page();
  page.clips[0].joints[1].distances = {0.0, 1.00105};
  page.clips[0].joints[1].distance = {1.00105, 0.5};
  page.clips[0].joints[0].distance = {0.0004, 0.0};
  const std::string json = json_of(page);
  EXPECT_EQ(count_of("\"distance_step\":0.001,\"distance\":[[],\n[0,1001]]}", json), 1U);
  EXPECT_EQ(count_of(R"("distance":[1.001,0.5])", json), 1U);
  EXPECT_EQ(count_of(R"("distance":[0,0])", json), 1U);
}

TEST(SkeletonPage, OfAClipThatStandsStillAtOnePlaceHasStepsOfOne) {
  SkeletonPage page = small_page();
  page.clips[0] = {.name = "still"};
  page.clips[0].times = page.clips[0].error_times = {0.0};
  page.clips[0].before = page.clips[0].after = {{3.0, 3.0, 3.0}};
  page.clips[0].joints = {{.angles = {0.0}, .distances = {0.0}}};
  EXPECT_EQ(count_of(R"("poses":{"t":[0],"step":1,"before":[3,3,3],"offset_step":1,"after":[0,0,0]})", json_of(page)),
            1U);
}

}}  // namespace orispline::report
