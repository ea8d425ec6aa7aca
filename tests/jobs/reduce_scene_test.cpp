// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/reduce.hpp>

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <orispline/math/degrees.hpp>

#include "jobs/turns.hpp"

namespace orispline::jobs { namespace {

constexpr double clip_tolerance = 0.01;  // [rad]

/// A shoulder with an elbow 0.3 above it.
Skeleton arm() {
  JointPose elbow;
  elbow.translation = {0.0, 0.3, 0.0};
  return Skeleton::make({{.name = "shoulder"}, {.name = "elbow", .parent = 0, .rest = elbow}}).value();
}

/// Both joints turn at 30 Hz, as far as this at most [rad].
Clip swing(std::string name, double widest) {
  Clip clip{.name = std::move(name)};
  for (const std::size_t joint : {0u, 1u}) {
    RotationChannel channel{.joint = joint};
    for (int i = 0; i < 90; ++i) {
      channel.times.push_back(i / 30.0);
      channel.values.emplace_back(
          Eigen::AngleAxisd(widest * std::sin(0.07 * i + static_cast<double>(joint)), Eigen::Vector3d::UnitZ()));
    }
    clip.rotations.push_back(std::move(channel));
  }
  return clip;
}

ReduceSceneRequest request_of(ClipFile file) {
  return {.file = std::move(file),
          .skeleton = arm(),
          .clips = {swing("nod", 0.3), swing("wave", 1.0)},
          .options = {.tolerance = clip_tolerance}};
}

const ClipFile glb{.name = "arm.glb", .format = {.file = "a glTF file", .holds_floats = true}};
const ClipFile bvh{.name = "arm.bvh", .format = {.file = "a BVH file", .has_no_unit = true}};

ReduceSceneOutcome reduced(ReduceSceneRequest request) { return reduce_scene(std::move(request)).value(); }

TEST(ReduceSceneJob, AddsUpTheClipsOnce) {
  const ReduceSceneOutcome outcome = reduced(request_of(glb));
  ASSERT_EQ(outcome.reductions.size(), 2u);
  const ClipTotals totals = outcome.totals();
  EXPECT_EQ(totals.rotation_tracks, 4u);
  EXPECT_EQ(totals.rotation_keys_before, 360u);
  EXPECT_EQ(totals.rotation_keys, outcome.reductions[0].rotation_keys + outcome.reductions[1].rotation_keys);
  for (const ClipReduction& reduction : outcome.reductions)
    EXPECT_GE(totals.angle->angle.largest.value, reduction.angle.largest.value);
  EXPECT_EQ(outcome.clips().back().name, "wave");
  EXPECT_TRUE(outcome.warnings.empty());
}

TEST(ReduceSceneJob, AddsUpNoClips) {
  ReduceSceneRequest request = request_of(glb);
  request.clips.clear();
  const ReduceSceneOutcome outcome = reduced(std::move(request));
  EXPECT_EQ(outcome.totals().angle, nullptr);
  EXPECT_TRUE(summary_of(outcome).starts_with("0 clips from arm.glb, tolerance 0.572958°")) << summary_of(outcome);
}

TEST(ReduceSceneJob, SaysNothingOfErrorsWhereNoJointMoves) {
  for (Skeleton skeleton : {Skeleton(), arm()}) {
    ReduceSceneRequest request = request_of(glb);
    request.skeleton = std::move(skeleton);
    request.clips = {{.name = "weights alone"}};
    request.options.world_tolerance = 0.01;
    const ReduceSceneOutcome outcome = reduced(std::move(request));
    EXPECT_EQ(outcome.totals().distance, nullptr);
    const Json document = document_of(outcome);
    for (const char* name : {"angle_deg", "translation_m", "shell_distance_m", "from_smooth_deg", "from_stored_deg"})
      EXPECT_TRUE(std::holds_alternative<std::nullptr_t>(member(document, name).value())) << name;
    EXPECT_EQ(summary_of(outcome),
              "1 clip from arm.glb, tolerance 0.572958°, 0.01 m in the world, method cubicspline\n");
    EXPECT_EQ(line_of(outcome), "0 of 0 keys, 0° and 0 m in the world off at most");
    EXPECT_TRUE(outcome.warnings.empty());
  }
}

TEST(ReduceSceneJob, SaysHowFarTranslationsAreOffWhereTheyAreBounded) {
  ReduceSceneRequest request = request_of(bvh);
  VectorChannel shift{.joint = 0};
  for (int i = 0; i < 90; ++i) {
    shift.times.push_back(i / 30.0);
    shift.values.emplace_back(std::sin(0.1 * i), 0.0, 0.0);
  }
  request.clips[0].translations.push_back(shift);
  request.position_scale = 0.01;
  EXPECT_EQ(summary_of(reduced(request)).find("largest shift"), std::string::npos);
  request.options.position_tolerance = 1e-4;
  const ReduceSceneOutcome outcome = reduced(request);
  const double largest = number(member(document_of(outcome), "translation_m"), "largest");
  EXPECT_GT(largest, 0.0);
  EXPECT_LE(largest, 1e-4);
  EXPECT_NE(summary_of(outcome).find("largest shift   "), std::string::npos) << summary_of(outcome);
  request.options.position_tolerance = 1e-12;
  const auto warnings = reduced(request).warnings;
  EXPECT_EQ(std::ranges::count(warnings, std::string_view("position_tolerance"), &Warning::option), 1);
}

TEST(ReduceSceneJob, WarnsOfSinglePrecision) {
  ReduceSceneRequest request = request_of({.name = "arm.csv"});
  request.options.tolerance = 1e-9;
  request.options.world_tolerance = 1e-9;
  const auto warnings = reduced(std::move(request)).warnings;
  ASSERT_EQ(warnings.size(), 2u);
  EXPECT_EQ(warnings[0].code, "single_precision");
  EXPECT_EQ(warnings[0].option, "tolerance");
  EXPECT_EQ(warnings[1].option, "world_tolerance");
}

TEST(ReduceSceneJob, WantsAScaleForLengthsWithoutAUnit) {
  ReduceSceneRequest request = request_of(bvh);
  EXPECT_TRUE(check(request)) << "angles want none";
  request.options.world_tolerance = 0.02;
  const auto refused = reduce_scene(request);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(describe(refused.error()),
            "world_tolerance: found a BVH file, which has no unit of length, wanted `position_scale` as well, such as "
            "0.01 for centimetres");
  request.options.world_tolerance = std::numeric_limits<double>::infinity();
  request.options.position_tolerance = 0.02;
  EXPECT_EQ(reduce_scene(request).error().option, "position_tolerance");
  request.position_scale = 0.01;
  EXPECT_TRUE(reduce_scene(request));
  EXPECT_TRUE(check(request));
}

TEST(ReduceSceneJob, TakesAndShowsLengthsInMetres) {
  ReduceSceneRequest request = request_of(bvh);
  request.options = {.world_tolerance = 0.001, .shell = 0.02};
  request.position_scale = 0.1;
  const ReduceSceneOutcome outcome = reduced(std::move(request));
  EXPECT_DOUBLE_EQ(outcome.options.world_tolerance, 0.001);
  EXPECT_LE(outcome.totals().distance->distance.largest.value, 0.001);
  const Json document = document_of(outcome);
  EXPECT_DOUBLE_EQ(number(document, "world_tolerance_m"), 0.001);
  EXPECT_DOUBLE_EQ(number(document, "shell_m"), 0.02);
  EXPECT_LE(number(member(document, "shell_distance_m"), "largest"), 0.001);
  EXPECT_NE(summary_of(outcome).find("; shell 0.02 m\n"), std::string::npos) << summary_of(outcome);
}

TEST(ReduceSceneJob, TakesAFileWithoutAUnitToMetres) {
  ReduceSceneRequest request = request_of(bvh);
  request.clips[0].translations.push_back(
      {.joint = 0, .times = {0.0, 1.0}, .values = {Eigen::Vector3d::Zero(), Eigen::Vector3d(10.0, 0.0, 0.0)}});
  request.position_scale = 0.1;
  const ReduceSceneOutcome outcome = reduced(std::move(request));
  EXPECT_FALSE(outcome.request.file.format.has_no_unit);
  EXPECT_EQ(outcome.clips()[0].translations[0].values.back().x(), 1.0);
  EXPECT_DOUBLE_EQ(outcome.request.skeleton[1].rest.translation.norm(), 0.1 * arm()[1].rest.translation.norm());
  ReduceSceneRequest in_metres = request_of(glb);
  in_metres.position_scale = 0.1;
  EXPECT_EQ(
      describe(check(in_metres).error()),
      "position_scale: found a glTF file, whose lengths are in metres, wanted a file without a unit, such as BVH");
}

TEST(ReduceSceneJob, ShowsNoUnitThatIsNotKnown) {
  const ReduceSceneOutcome outcome = reduced(request_of(bvh));
  EXPECT_NE(summary_of(outcome).find("; shell 0.03\n"), std::string::npos) << summary_of(outcome);
  EXPECT_TRUE(line_of(outcome).ends_with(" in the world off at most")) << line_of(outcome);
  EXPECT_EQ(line_of(outcome).find(" m "), std::string::npos) << line_of(outcome);
}

TEST(ReduceSceneJob, NamesTheFileOfWhatItCannotReduce) {
  ReduceSceneRequest request = request_of(glb);
  request.options.method = Method("bspline");
  EXPECT_EQ(reduce_scene(request).error().where.file, "arm.glb");
}

}}  // namespace orispline::jobs
