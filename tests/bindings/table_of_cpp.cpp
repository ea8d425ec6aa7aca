// SPDX-License-Identifier: Apache-2.0
// table_of_cpp TABLE FOLDER: what jobs::run_task() finds for every request of the table, a line of JSON each.
#include <memory>

#include <orispline/base/base64.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/fields/warning_json.hpp>
#include <orispline/files.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/jobs/task_list.hpp>
#include <orispline/scenes/scene_file.hpp>

#include "bindings/table.hpp"
#include "json_text.hpp"

namespace orispline::bindings_table { namespace {

Json told(const Error& error) {
  return {{"error",
           {{"code", static_cast<int>(error.code) + 1},
            {"message", error.message},
            {"option", error.option},
            {"remedy", error.remedy},
            {"key", error.where.key ? static_cast<std::int64_t>(*error.where.key) : -1}}}};
}

std::string words_of(const Error& error) { return describe(error); }

Expected<jobs::TaskValue> keys_of(const Input& input) {
  return io::read_whole_track(io::Input::in_memory(input.file, input.bytes), {},
                              {families_info(), jobs::family_named, words_of})
      .map([](io::TrackFile file) { return jobs::TaskValue(std::make_shared<const Track>(std::move(file.track))); });
}

jobs::TaskValue gyro_of(const Input& input) {
  const Rates read = rates_in(input.bytes);
  GyroTrack gyro;
  gyro.rates.clock = GyroRates::Clock::own;
  gyro.rates.times = read.times;
  for (std::size_t k = 0; k < read.times.size(); ++k) gyro.rates.rates.emplace_back(read.rates.data() + 3 * k);
  return std::make_shared<const GyroTrack>(std::move(gyro));
}

/// What is read, of the first skeleton with what its file held besides.
struct Made {
  jobs::TaskRequest request{};
  std::optional<scenes::Scene> scene{};
};

Expected<jobs::TaskValue> skeleton_of(const Input& input, std::optional<scenes::Scene>& first) {
  return scenes::read_scene(io::Input::in_memory(input.file, input.bytes)).map([&](const scenes::Scene& scene) {
    if (!first) first = scene;
    return jobs::TaskValue(std::make_shared<const MotionFile>(scenes::motion_file_of(scene)));
  });
}

Expected<Made> made_of(const Request& request) {
  Made made;
  for (const Input& input : request.inputs) {
    auto value = input.kind == "rates"      ? Expected<jobs::TaskValue>(gyro_of(input))
                 : input.kind == "skeleton" ? skeleton_of(input, made.scene)
                                            : keys_of(input);
    if (!value) return tl::unexpected(std::move(value.error()));
    made.request.inputs.emplace_back(input.name, std::move(*value));
  }
  for (const auto& [name, text] : request.options) made.request.options.emplace_back(name, text);
  return made;
}

Json json_of(const Track& track) {
  Json orientations = Json::array();
  for (const Eigen::Quaterniond& q : track.keys.data().orientations)
    for (const double x : {q.w(), q.x(), q.y(), q.z()}) orientations.push_back(x);
  return {{"times", track.keys.data().times}, {"orientations", orientations}};
}

Json json_of(const GyroTrack& gyro) {
  Json rates = Json::array();
  for (const Eigen::Vector3d& rate : gyro.rates.rates)
    for (const double x : rate) rates.push_back(x);
  return {{"times", gyro.rates.times}, {"rates", rates}};
}

Json json_of(const MotionFile& motion, const scenes::Scene& file) {
  const auto written = scenes::written_scene(scenes::with_motion(file, motion), "made.glb");
  return {{"skeleton", base64_of(written ? written->bytes : "")}};
}

Json json_of(const jobs::TaskOutcome& outcome, const std::optional<scenes::Scene>& file) {
  Json made = Json::array();
  for (const Track& track : outcome.tracks) made.push_back(json_of(track));
  for (const GyroTrack& gyro : outcome.gyros) made.push_back(json_of(gyro));
  for (const MotionFile& motion : outcome.scenes) made.push_back(json_of(motion, *file));
  return {{"document", Json::parse(c::json_text(outcome.document))},
          {"summary", outcome.summary},
          {"line", outcome.line},
          {"warnings", Json::parse(c::json_text(warnings_json(outcome.warnings)))},
          {"made", made}};
}

Json found_for(const Request& request) {
  const auto made = made_of(request);
  if (!made) return told(made.error());
  const auto outcome = jobs::run_task(request.task, made->request);
  return outcome ? json_of(*outcome, made->scene) : told(outcome.error());
}

}}  // namespace orispline::bindings_table

int main(int count, char** arguments) {
  return orispline::bindings_table::run_table(count, arguments, orispline::bindings_table::found_for);
}
