// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <nlohmann/json.hpp>

#include "c/handles.hpp"

namespace orispline { namespace {

using namespace testing_support;

struct Ran {
  Result result;
  OutcomeHandle outcome;

  [[nodiscard]] nlohmann::json document() const {
    return nlohmann::json::parse(orispline_outcome_document(outcome.get()));
  }
  [[nodiscard]] KeysHandle track(std::size_t index = 0) const {
    orispline_keys* keys = nullptr;
    expect_ok(call(orispline_outcome_track, static_cast<const orispline_outcome*>(outcome.get()), index, &keys));
    return KeysHandle(keys);
  }
};

Ran run(const char* task, const std::vector<orispline_input>& inputs, const std::vector<const char*>& options = {},
        orispline_progress progress = nullptr, void* context = nullptr) {
  orispline_outcome* outcome = nullptr;
  Result result = call(orispline_task_run, task, inputs.data(), inputs.size(), options.data(), options.size(), progress,
                       context, &outcome);
  return {std::move(result), OutcomeHandle(outcome)};
}

/// A recording of 0.01 s steps.
KeyframeData recording(std::size_t count = 120) {
  KeyframeData data = random_walk(5, count, testing_support::Spacing::even, 0.03);
  for (std::size_t i = 0; i < count; ++i) data.times[i] = 0.01 * static_cast<double>(i);
  return data;
}

struct Case {
  const char* task;
  std::vector<const char*> inputs, options;
  const char* member;  ///< of the document
};

const std::vector<Case> cases{{"smooth", {"recording"}, {}, "noise_rad"},
                              {"tune", {"keys"}, {"method=quintic", "objective=linearised"}, "energy_after"},
                              {"reduce", {"recording"}, {"tolerance=2deg"}, "keys"},
                              {"retime", {"keys"}, {"max_rate=10deg/s"}, "duration_after_s"},
                              {"bake", {"keys"}, {"tolerance=1e-4deg"}, "pieces"},
                              {"mean", {"rows"}, {}, "qw"},
                              {"align", {"moved", "fixed"}, {}, "distance_rms_deg"},
                              {"compare", {"keys"}, {"methods=slerp,auto", "keep_every=8"}, "method"},
                              {"inspect", {"keys"}, {"methods=slerp,auto"}, "span_s"}};

const std::vector<std::string_view> trackless{"bake", "compare", "inspect"};

TEST(TasksOfC, AreAllOfTheList) {
  const auto list = nlohmann::json::parse(text_by(orispline_tasks_json));
  std::vector<std::string> wanted;
  for (const Case& one : cases) wanted.emplace_back(one.task);
  wanted.insert(wanted.end(), {"difference", "clip"});  // which take skeletons: value_test.cpp
  std::vector<std::string> found;
  for (const auto& task : list) found.push_back(task["task"]);
  EXPECT_EQ(found, wanted);
}

TEST(TasksOfC, GiveDocumentsSentencesAndTracks) {
  const KeysHandle keys = keys_of(recording());
  for (const Case& one : cases) {
    std::vector<orispline_input> inputs;
    for (const char* name : one.inputs) inputs.push_back({name, keys.get()});
    const Ran done = run(one.task, inputs, one.options);
    ASSERT_EQ(done.result.code, ORISPLINE_OK) << one.task << ": " << done.result.text();
    const auto document = done.document();
    EXPECT_TRUE((document.is_array() ? document[0] : document).contains(one.member)) << document.dump(1);
    EXPECT_GT(std::string(orispline_outcome_summary(done.outcome.get())).size(), 20u) << one.task;
    EXPECT_TRUE(nlohmann::json::parse(orispline_outcome_warnings(done.outcome.get())).is_array());
    const bool has_track = std::ranges::find(trackless, std::string_view(one.task)) == trackless.end();
    ASSERT_EQ(orispline_outcome_track_count(done.outcome.get()), has_track ? 1u : 0u) << one.task;
    if (has_track) {
      EXPECT_GT(orispline_keys_count(done.track().get()), 0u);
    }
  }
}

TEST(TasksOfC, MakeKeysThatNameTheirMethod) {
  const KeysHandle keys = keys_of(recording());
  const Ran reduced = run("reduce", {{"recording", keys.get()}}, {"tolerance=0.5deg", "methods=timed-c2"});
  expect_ok(reduced.result);
  const CurveHandle owned = curve_through(reduced.track(), nullptr);
  const orispline_curve* const curve = owned.get();
  EXPECT_EQ(text_by(orispline_curve_method, curve).substr(0, 8), "timed-c2");
}

TEST(TasksOfC, ReduceSeveralRecordings) {
  const KeysHandle one = keys_of(recording()), other = keys_of(recording(60));
  const Ran reduced =
      run("reduce", {{"recording", one.get()}, {"recording", other.get()}}, {"tolerance=0.02", "smooth"});
  EXPECT_EQ(reduced.result.code, ORISPLINE_BAD_ARGUMENT) << "a tolerance wants a unit";
  const Ran both =
      run("reduce", {{"recording", one.get()}, {"recording", other.get()}}, {"tolerance=0.02rad", "threads=1"});
  expect_ok(both.result);
  EXPECT_EQ(both.document().size(), 2u);
  EXPECT_EQ(orispline_outcome_track_count(both.outcome.get()), 2u);
}

TEST(TasksOfC, SayWhatIsStatedWrongly) {
  const KeysHandle keys = keys_of(recording());
  const orispline_input input{"keys", keys.get()};
  const auto fault = [&](const char* task, const std::vector<orispline_input>& inputs,
                         const std::vector<const char*>& options) {
    const Ran done = run(task, inputs, options);
    EXPECT_EQ(done.result.code, ORISPLINE_BAD_ARGUMENT) << done.result.text();
    EXPECT_EQ(done.outcome, nullptr);
    return done.result.text();
  };
  EXPECT_EQ(fault("tunee", {input}, {}), "unknown task 'tunee'; did you mean 'tune'?");
  EXPECT_EQ(fault("tune", {}, {}), "keys: found none, wanted orientations at times");
  EXPECT_EQ(fault("tune", {input, input}, {}), "keys: found it twice, wanted it once");
  EXPECT_NE(fault("tune", {{"key", keys.get()}}, {}).find("unknown input 'key'; did you mean 'keys'?"),
            std::string::npos);
  EXPECT_NE(fault("tune", {input}, {"objectiv=fit"}).find("did you mean 'objective'?"), std::string::npos);
  EXPECT_NE(fault("tune", {input}, {"objective=fat"}).find("objective: found 'fat', wanted linearised|"),
            std::string::npos);
  EXPECT_NE(fault("tune", {input}, {"objective=fit", "objective=fit"}).find("twice"), std::string::npos);
  EXPECT_NE(fault("tune", {input}, {"=fit"}).find("wanted name=value"), std::string::npos);
  EXPECT_NE(fault("tune", {input}, {""}).find("wanted name=value"), std::string::npos);
  EXPECT_NE(fault("tune", {input}, {nullptr}).find("found null"), std::string::npos);
  EXPECT_NE(fault("tune", {input}, {"method=squadd"}).find("did you mean 'squad'?"), std::string::npos);
  EXPECT_NE(fault("reduce", {{"recording", keys.get()}}, {}).find("tolerance: found none, wanted "), std::string::npos);
  EXPECT_NE(fault("compare", {input, {"reference", keys.get()}}, {"keep_every=4"}).find("`reference`"),
            std::string::npos);
  EXPECT_NE(fault("compare", {input}, {"tune=yes"}).find("tune: found 'yes', wanted true or false"), std::string::npos);
}

TEST(TasksOfC, ShowTheirProgressAndStop) {
  const KeysHandle keys = keys_of(recording(400));
  const orispline_input input{"recording", keys.get()};
  std::vector<double> shares;
  const auto shown = [](double share, void* context) -> std::int32_t {
    static_cast<std::vector<double>*>(context)->push_back(share);
    return 0;
  };
  expect_ok(run("smooth", {input}, {}, shown, &shares).result);
  ASSERT_FALSE(shares.empty());
  EXPECT_TRUE(std::ranges::is_sorted(shares));
  EXPECT_EQ(shares.back(), 1.0);
  const Ran stopped = run("smooth", {input}, {}, [](double, void*) -> std::int32_t { return 1; });
  EXPECT_EQ(stopped.result.code, ORISPLINE_CANCELLED);
  EXPECT_EQ(stopped.outcome, nullptr);
}

}}  // namespace orispline
