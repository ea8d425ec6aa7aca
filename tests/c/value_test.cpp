// SPDX-License-Identifier: Apache-2.0
// Tasks on values of any kind: gyros with clocks of their own, skeletons of files in memory, and what comes out of
// them.
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "align/rate_recordings.hpp"
#include "c/handles.hpp"
#include "scenes/gltf_file.hpp"
#include "support/places.hpp"

namespace orispline { namespace {

using namespace testing_support;
using Options = std::vector<const char*>;
using ValueHandle = Owned<orispline_value, orispline_value_free>;

ValueHandle value_of(const KeysHandle& keys) {
  orispline_value* value = nullptr;
  expect_ok(call(orispline_value_of_keys, static_cast<const orispline_keys*>(keys.get()), &value));
  return ValueHandle(value);
}

ValueHandle value_of(const GyroTrack& gyro, const char* epoch = nullptr) {
  const std::vector<double> rates = flat(gyro.rates.rates);
  orispline_value* value = nullptr;
  expect_ok(
      call(orispline_value_of_rates, gyro.rates.times.data(), rates.data(), gyro.rates.times.size(), epoch, &value));
  return ValueHandle(value);
}

struct ReadSkeleton {
  Result result;
  ValueHandle value;
};

ReadSkeleton read_skeleton(const std::string& bytes, const char* name, const Options& options = {}) {
  orispline_value* value = nullptr;
  Result result = call(orispline_value_of_skeleton, static_cast<const void*>(bytes.data()), bytes.size(), name,
                       options.data(), options.size(), &value);
  return {std::move(result), ValueHandle(value)};
}

ValueHandle skeleton_of(const std::string& bytes, const char* name, const Options& options = {}) {
  ReadSkeleton read = read_skeleton(bytes, name, options);
  expect_ok(read.result);
  return std::move(read.value);
}

struct TaskOnValues {
  Result result;
  OutcomeHandle outcome;

  [[nodiscard]] nlohmann::json document() const {
    return nlohmann::json::parse(orispline_outcome_document(outcome.get()));
  }
  [[nodiscard]] ValueHandle value(std::size_t index = 0) const {
    orispline_value* value = nullptr;
    expect_ok(call(orispline_outcome_value, static_cast<const orispline_outcome*>(outcome.get()), index, &value));
    return ValueHandle(value);
  }
};

TaskOnValues run_with(const char* task, const std::vector<orispline_named_value>& inputs, const Options& options = {}) {
  orispline_outcome* outcome = nullptr;
  Result result = call(orispline_task_run_with, task, inputs.data(), inputs.size(), options.data(), options.size(),
                       static_cast<orispline_progress>(nullptr), static_cast<void*>(nullptr), &outcome);
  return {std::move(result), OutcomeHandle(outcome)};
}

TaskOnValues done(const char* task, const std::vector<orispline_named_value>& inputs, const Options& options = {}) {
  TaskOnValues ran = run_with(task, inputs, options);
  EXPECT_EQ(ran.result.code, ORISPLINE_OK) << task << ": " << ran.result.text();
  return ran;
}

nlohmann::json json_of(const ValueHandle& value) {
  return nlohmann::json::parse(text_by(orispline_value_json, static_cast<const orispline_value*>(value.get())));
}

std::string written(const ValueHandle& value, const char* name, const Options& options = {}) {
  char* bytes = nullptr;
  std::size_t size = 0;
  expect_ok(call(orispline_value_write, static_cast<const orispline_value*>(value.get()), name, options.data(),
                 options.size(), &bytes, &size, static_cast<char**>(nullptr)));
  const Owned<char, orispline_text_free> owned(bytes);
  return bytes ? std::string(bytes, size) : "";
}

/// A gyro and the orientations of the body that carries it, 10 s long.
struct Recordings {
  rate_recordings::SimulatedBody body{3};
  GyroTrack gyro;
  KeyframeData poses;

  Recordings() {
    body.duration = 10.0;
    gyro = rate_recordings::gyro_of(body, {.rate = 200.0}, 1);
    poses = rate_recordings::poses_of(body, {.rate = 50.0}, 2).keys.data();
  }
};

/// Nine keys of an even turn about z.
std::string even_turn() {
  scenes::test::GltfFile file;
  std::vector<float> times, turns;
  for (int k = 0; k < 9; ++k) {
    const double half = 0.1 * k;
    times.push_back(static_cast<float>(k));
    for (const double x : {0.0, 0.0, std::sin(half), std::cos(half)}) turns.push_back(static_cast<float>(x));
  }
  const std::size_t input = file.floats("SCALAR", times);
  file.animate(input, file.floats("VEC4", turns));
  file.more = R"(,"extras":{"made":"by a test"})";
  return file.glb();
}

std::string walking() {
  std::ifstream file(in_project("examples/data/walking.bvh"), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ValuesOfC, SmoothARecordingBesideAGyroWithAClockOfItsOwn) {
  const Recordings recordings;
  const KeysHandle keys = keys_of(recordings.poses);
  const ValueHandle poses = value_of(keys), gyro = value_of(recordings.gyro);
  const TaskOnValues smoothed = done("smooth", {{"recording", poses.get()}, {"gyro", gyro.get()}});
  EXPECT_EQ(smoothed.document()["gyro_used"], true);
  ASSERT_EQ(orispline_outcome_value_count(smoothed.outcome.get()), 1u);
  EXPECT_EQ(orispline_value_kind(smoothed.value().get()), ORISPLINE_KEYS);
  EXPECT_EQ(orispline_outcome_track_count(smoothed.outcome.get()), 1u);
  const double truth = recordings.body.rate(5.0)[2];
  orispline_keys* made = nullptr;
  expect_ok(call(orispline_outcome_track, static_cast<const orispline_outcome*>(smoothed.outcome.get()), std::size_t{0},
                 &made));
  const CurveHandle curve = curve_through(KeysHandle(made), nullptr);
  orispline_motion motion;
  expect_ok(call(orispline_curve_motion, static_cast<const orispline_curve*>(curve.get()), 5.0, ORISPLINE_RIGHT,
                 ORISPLINE_WXYZ, &motion));
  EXPECT_NEAR(motion.angular_velocity[2], truth, 0.02);
}

TEST(ValuesOfC, CountTheTimesOfAGyroFromItsEpoch) {
  Recordings recordings;
  const KeysHandle keys = keys_of(recordings.poses);
  const ValueHandle poses = value_of(keys), same = value_of(recordings.gyro);
  for (double& time : recordings.gyro.rates.times) time -= 1000.0;
  const ValueHandle gyro = value_of(recordings.gyro, "1000");
  EXPECT_EQ(json_of(gyro)["epoch"], "1000");
  const auto noise = [&](const ValueHandle& one) -> double {
    return done("smooth", {{"recording", poses.get()}, {"gyro", one.get()}}).document()["gyro_noise_rad_s"];
  };
  EXPECT_NEAR(noise(gyro), noise(same), 1e-7);
  expect_ok(run_with("smooth", {{"recording", poses.get()}, {"gyro", gyro.get()}}).result);
  EXPECT_EQ(
      run_with("smooth", {{"recording", poses.get()}, {"gyro", value_of(recordings.gyro, "9e9").get()}}).result.code,
      ORISPLINE_BAD_DATA);
}

TEST(ValuesOfC, AlignAGyro) {
  const Recordings recordings;
  const rate_recordings::Sensor askew = rate_recordings::askew(4);
  const GyroTrack moved = rate_recordings::gyro_of(recordings.body, askew, 5);
  const KeysHandle keys = keys_of(recordings.poses);
  const ValueHandle gyro = value_of(moved), fixed = value_of(recordings.gyro), poses = value_of(keys);
  const TaskOnValues gyros = done("align", {{"moved", gyro.get()}, {"fixed", fixed.get()}});
  EXPECT_NEAR(gyros.document()["offset_s"], askew.late, 0.01) << gyros.document().dump(1);
  EXPECT_EQ(orispline_outcome_track_count(gyros.outcome.get()), 0u);
  const ValueHandle aligned = gyros.value();
  ASSERT_EQ(orispline_value_kind(aligned.get()), ORISPLINE_RATES);
  const std::size_t count = orispline_value_count(aligned.get());
  ASSERT_EQ(count, moved.rates.times.size());
  std::vector<double> times(count), rates(3 * count);
  expect_ok(call(orispline_value_rates, static_cast<const orispline_value*>(aligned.get()), times.data(), rates.data(),
                 count));
  double error = 0.0;
  for (std::size_t k = 0; k < count; ++k) error += rates[3 * k] - recordings.body.rate(times[k])[0];
  EXPECT_NEAR(error / static_cast<double>(count), 0.0, 0.01);
  const TaskOnValues onto = done("align", {{"moved", poses.get()}, {"fixed", gyro.get()}});
  EXPECT_EQ(orispline_value_kind(onto.value().get()), ORISPLINE_KEYS);
  expect_ok(done("smooth", {{"recording", poses.get()}, {"gyro", aligned.get()}}).result);
}

TEST(ValuesOfC, ReduceASkeletonAndWriteItAsItWas) {
  const ValueHandle skeleton = skeleton_of(even_turn(), "turn.glb");
  const auto json = json_of(skeleton);
  EXPECT_EQ(json["kind"], "skeleton");
  EXPECT_EQ(json["format"], "gltf");
  EXPECT_EQ(json["joints"], nlohmann::json({"arm"}));
  EXPECT_EQ(json["clips"], nlohmann::json({"walk"}));
  const TaskOnValues reduced = done("reduce", {{"recording", skeleton.get()}}, {"tolerance=0.1deg"});
  EXPECT_EQ(orispline_outcome_track_count(reduced.outcome.get()), 0u);
  ASSERT_EQ(orispline_outcome_value_count(reduced.outcome.get()), 1u);
  const std::string bytes = written(reduced.value(), "small.glb");
  EXPECT_LT(bytes.size(), even_turn().size());
  EXPECT_NE(bytes.find("by a test"), std::string::npos) << "what the file held besides";
  orispline_keys* keys = nullptr;
  expect_ok(call(orispline_keys_read, static_cast<const void*>(bytes.data()), bytes.size(), "small.glb",
                 static_cast<const char* const*>(nullptr), std::size_t{0}, &keys));
  EXPECT_EQ(orispline_keys_count(KeysHandle(keys).get()), 2u);
  const ValueHandle small = skeleton_of(bytes, "small.glb");
  const TaskOnValues apart = done("difference", {{"first", skeleton.get()}, {"second", small.get()}});
  EXPECT_EQ(orispline_outcome_value_count(apart.outcome.get()), 0u);
  EXPECT_GT(std::string(orispline_outcome_summary(apart.outcome.get())).size(), 20u);
}

TEST(ValuesOfC, TakeTheSkeletonThatATaskHasMade) {
  const ValueHandle skeleton = skeleton_of(walking(), "walking.bvh");
  const TaskOnValues smoothed = done("smooth", {{"recording", skeleton.get()}}, {"noise=0.2deg"});
  const ValueHandle made = smoothed.value();
  const TaskOnValues inspected = done("inspect", {{"keys", made.get()}});
  EXPECT_EQ(inspected.document()["joints"], done("inspect", {{"keys", skeleton.get()}}).document()["joints"]);
  const TaskOnValues apart = done("difference", {{"first", skeleton.get()}, {"second", made.get()}}, {"rate=24"});
  EXPECT_FALSE(apart.document().empty());
  EXPECT_NE(written(made, "smooth.bvh", {"output_euler=XYZ"}).find("Xrotation Yrotation Zrotation"), std::string::npos);
  EXPECT_EQ(written(made, "smooth.glb").substr(0, 4), "glTF");
}

TEST(ValuesOfC, SalvageARecordingThatWasCutOff) {
  const std::string whole = walking(), cut = whole.substr(0, whole.size() - 10);
  const ReadSkeleton refused = read_skeleton(cut, "walking.bvh");
  EXPECT_EQ(refused.result.code, ORISPLINE_BAD_DATA);
  EXPECT_STREQ(orispline_error_remedy(refused.result.error.get()), "salvage");
  const auto end = [](const ValueHandle& value) {
    return done("inspect", {{"keys", value.get()}}).document()["clips"][0]["end_s"].get<double>();
  };
  EXPECT_LT(end(skeleton_of(cut, "walking.bvh", {"salvage"})), end(skeleton_of(whole, "walking.bvh")));
}

TEST(ValuesOfC, AreWrittenInMetres) {
  const ValueHandle skeleton = skeleton_of(walking(), "walking.bvh");
  const auto distance = [&](const char* name, const Options& options) {
    const ValueHandle other = skeleton_of(written(skeleton, name, options), name);
    const TaskOnValues apart = done("difference", {{"first", skeleton.get()}, {"second", other.get()}});
    return apart.document()["translation_max"].get<double>();
  };
  EXPECT_LT(distance("walking.glb", {}), 1e-3);
  EXPECT_GT(distance("walking.glb", {"position_scale=0.01"}), 50.0);
}

TEST(ValuesOfC, CutTheClipsOfASkeleton) {
  const ValueHandle skeleton = skeleton_of(walking(), "walking.bvh");
  const TaskOnValues cut =
      done("clip", {{"scene", skeleton.get()}}, {"from=0.4", "to=1.6", "shift=0", "root=Hips", "loop=true"});
  EXPECT_EQ(cut.document()["clips"][0]["loop"]["closing"], "bent");
  const ValueHandle made = cut.value();
  EXPECT_NEAR(done("inspect", {{"keys", made.get()}}).document()["clips"][0]["end_s"].get<double>(), 1.2, 1e-9);
}

TEST(ValuesOfC, CompareTwoRecordings) {
  const Recordings recordings;
  const KeysHandle reference = keys_of(recordings.poses);
  KeyframeData few;
  for (std::size_t k = 0; k < recordings.poses.times.size(); k += 10) {
    few.times.push_back(recordings.poses.times[k]);
    few.orientations.push_back(recordings.poses.orientations[k]);
  }
  const KeysHandle keys = keys_of(few);
  const ValueHandle one = value_of(keys), other = value_of(reference);
  const TaskOnValues compared =
      done("compare", {{"keys", one.get()}, {"reference", other.get()}}, {"methods=slerp,auto"});
  EXPECT_EQ(compared.document().size(), 2u);
  EXPECT_EQ(orispline_outcome_value_count(compared.outcome.get()), 0u);
  EXPECT_NE(std::string(orispline_outcome_line(done("mean", {{"rows", one.get()}}).outcome.get())).find('\n'), 0u);
}

TEST(ValuesOfC, SayWhatIsStatedWrongly) {
  const Recordings recordings;
  const KeysHandle keys = keys_of(recordings.poses);
  const ValueHandle poses = value_of(keys), gyro = value_of(recordings.gyro),
                    skeleton = skeleton_of(even_turn(), "turn.glb");
  const auto fault = [](const char* task, const std::vector<orispline_named_value>& inputs,
                        const Options& options = {}) {
    const TaskOnValues ran = run_with(task, inputs, options);
    EXPECT_EQ(ran.result.code, ORISPLINE_BAD_ARGUMENT) << ran.result.text();
    EXPECT_EQ(ran.outcome, nullptr);
    return ran.result.text();
  };
  EXPECT_EQ(fault("smooth", {{"recording", gyro.get()}}),
            "recording: found the rates of a gyro, wanted orientations at times or the clips of a skeleton");
  EXPECT_EQ(fault("smooth", {{"recording", poses.get()}, {"gyro", poses.get()}}),
            "gyro: found orientations at times, wanted the rates of a gyro");
  EXPECT_EQ(fault("difference", {{"first", skeleton.get()}}), "second: found none, wanted the clips of a skeleton");
  EXPECT_EQ(fault("tune", {{"keys", skeleton.get()}}),
            "keys: found the clips of a skeleton, wanted orientations at times");
  EXPECT_EQ(fault("smooth", {{"recording", nullptr}}), "recording: found null, wanted a handle");
  EXPECT_NE(fault("reduce", {{"recording", skeleton.get()}, {"recording", poses.get()}}, {"tolerance=1deg"})
                .find("wanted it alone"),
            std::string::npos);
}

TEST(ValuesOfC, SayWhatFilesOfSkeletonsLack) {
  EXPECT_EQ(read_skeleton(walking(), "walking.csv").result.code, ORISPLINE_BAD_ARGUMENT);
  EXPECT_EQ(read_skeleton("HIERARCHY\n", "walking.bvh").result.code, ORISPLINE_BAD_DATA);
  EXPECT_EQ(read_skeleton("", "walking.bvh").result.code, ORISPLINE_BAD_DATA);
  const ReadSkeleton other = read_skeleton(even_turn(), "turn.glb", {"clip=run"});
  EXPECT_EQ(other.result.code, ORISPLINE_BAD_DATA);
  EXPECT_NE(other.result.text().find("walk"), std::string::npos) << other.result.text();
  EXPECT_EQ(other.value, nullptr);
  EXPECT_NE(read_skeleton(even_turn(), "turn.glb", {"clp=run"}).result.text().find("did you mean 'clip'?"),
            std::string::npos);
  EXPECT_EQ(orispline_value_count(skeleton_of(even_turn(), "turn.glb", {"clip=walk", "drop_duplicates"}).get()), 1u);
  const ValueHandle skeleton = skeleton_of(even_turn(), "turn.glb");
  char* bytes = nullptr;
  std::size_t size = 0;
  const auto fault = [&](const char* name, const Options& options) {
    const Result result = call(orispline_value_write, static_cast<const orispline_value*>(skeleton.get()), name,
                               options.data(), options.size(), &bytes, &size, static_cast<char**>(nullptr));
    EXPECT_EQ(result.code, ORISPLINE_BAD_ARGUMENT) << result.text();
    EXPECT_EQ(bytes, nullptr);
    return result.option();
  };
  EXPECT_EQ(fault("turn.csv", {}), "");
  EXPECT_EQ(fault("turn.bvh", {"output_euler=ZXZ"}), "output_euler");
  EXPECT_EQ(fault("turn.bvh", {"rate=-1"}), "rate");
  EXPECT_EQ(fault("turn.bvh", {"rates=1"}), "rates");
  EXPECT_EQ(fault("turn.glb", {"position_scale=0"}), "position_scale");
  EXPECT_EQ(fault("turn.glb", {"position_scale=0.01"}), "position_scale");  // which is in metres
}

TEST(ValuesOfC, AreOfOneKind) {
  const Recordings recordings;
  const KeysHandle keys = keys_of(recordings.poses);
  const ValueHandle poses = value_of(keys), gyro = value_of(recordings.gyro);
  const auto fault = [](const Result& result, const char* option) {
    EXPECT_EQ(result.code, ORISPLINE_BAD_ARGUMENT);
    EXPECT_EQ(result.option(), option) << result.text();
  };
  const orispline_value *const of_keys = poses.get(), *const of_rates = gyro.get(), *const none = nullptr;
  orispline_keys* made = nullptr;
  orispline_value* value = nullptr;
  char* text = nullptr;
  std::size_t size = 0;
  double number = 0.0;
  const char* const* const no_options = nullptr;
  char** const nobody = nullptr;
  fault(call(orispline_value_keys, of_rates, &made), "value");
  fault(call(orispline_value_keys, none, &made), "value");
  fault(call(orispline_value_rates, of_keys, &number, &number, std::size_t{1}), "value");
  fault(call(orispline_value_rates, of_rates, &number, &number, std::size_t{1}), "count");
  fault(call(orispline_value_rates, of_rates, static_cast<double*>(nullptr), &number, std::size_t{1}), "times");
  fault(call(orispline_value_write, of_keys, "a.glb", no_options, std::size_t{0}, &text, &size, nobody), "value");
  fault(call(orispline_value_write, none, "a.glb", no_options, std::size_t{0}, &text, &size, nobody), "value");
  fault(call(orispline_value_json, none, &text), "value");
  fault(call(orispline_value_of_keys, static_cast<const orispline_keys*>(nullptr), &value), "keys");
  const double* const no_numbers = nullptr;
  const char* const no_epoch = nullptr;
  fault(call(orispline_value_of_rates, no_numbers, no_numbers, std::size_t{1}, no_epoch, &value), "times");
  fault(call(orispline_value_of_rates, no_numbers, no_numbers, std::size_t{1} << 62, no_epoch, &value), "count");
  fault(call(orispline_value_of_rates, no_numbers, no_numbers, std::size_t{0}, "noon", &value), "epoch");
  const void* const no_bytes = nullptr;
  fault(call(orispline_value_of_skeleton, no_bytes, std::size_t{1}, "a.bvh", no_options, std::size_t{0}, &value),
        "bytes");
  fault(call(orispline_outcome_value, static_cast<const orispline_outcome*>(nullptr), std::size_t{0}, &value),
        "outcome");
  EXPECT_EQ(orispline_value_kind(nullptr), 0);
  EXPECT_EQ(orispline_value_count(nullptr), 0u);
  EXPECT_EQ(orispline_outcome_line(nullptr), nullptr);
  EXPECT_TRUE(!made && !value && !text);
}

}}  // namespace orispline
