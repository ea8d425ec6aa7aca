// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/variant.h>
#include <nanobind/stl/vector.h>

#include <orispline/jobs.hpp>
#include <orispline/pages.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "fields.hpp"
#include "interruption.hpp"
#include "keys.hpp"
#include "method_text.hpp"
#include "scenes.hpp"
#include "text.hpp"

// Every task: what Python states for one becomes a request of the library, and what was found becomes Python's.

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

using jobs::TaskOutcome;

/// The recording of a gyro.
struct Gyro {
  std::shared_ptr<const GyroTrack> track;
};

using Input = std::variant<Keys, Gyro, SharedScene>;
using Decimations = std::vector<nb::typed<nb::dict, nb::str, nb::any>>;

// What is stated.

/// Seconds since the epoch, which is exact.
Gyro gyro_of(const Numbers& times, const Rows3& rates, const std::string& epoch, bool is_dated) {
  const std::span<const double> seconds = span_of(times);
  GyroTrack track{.epoch = value_of(Decimal::parse(epoch)), .is_dated = is_dated};
  track.rates.times = {seconds.begin(), seconds.end()};
  track.rates.rates = rows_of<Eigen::Vector3d>(rates);
  track.rates.clock = GyroRates::Clock::own;
  return {std::make_shared<const GyroTrack>(std::move(track))};
}

/// Orientations of which each has a weight.
Keys weighted(const Keys& keys, const Numbers& weights) {
  Track track = *keys.track;
  const std::span<const double> numbers = span_of(weights);
  track.settings[std::string(jobs::weight_name)] = {numbers.begin(), numbers.end()};
  return {std::make_shared<const Track>(std::move(track))};
}

/// The chordal mean alone; no weights are the same for all.
FloatArray chordal_mean_of(const Rows4& rotations, const std::optional<Numbers>& weights) {
  const std::vector<Eigen::Quaterniond> orientations = rows_of<Eigen::Quaterniond>(rotations);
  const Eigen::Quaterniond mean = value_of(
      chordal_mean({.orientations = orientations, .weights = weights ? span_of(*weights) : std::span<const double>()}));
  return array_of(mean.coeffs().data(), 4, 0);
}

struct ValueOfInput {
  jobs::TaskValue operator()(const Keys& keys) const { return keys.track; }
  jobs::TaskValue operator()(const Gyro& gyro) const { return gyro.track; }
  jobs::TaskValue operator()(const SharedScene& scene) const {
    return std::make_shared<const MotionFile>(scenes::motion_file_of(*scene.scene));
  }
};

std::vector<Decimation> decimations_in(const Decimations& stated) {
  std::vector<Decimation> decimations;
  for (const nb::dict& one : stated) {
    Decimation decimation;
    for (const auto& [name, value] : options_in(one, fields_of<Decimation>())) {
      const FieldInfo& field = field_named(fields_of<Decimation>(), name);
      if (!field.set(&decimation, value)) raise(of_another_type(field, one[name.c_str()]));
    }
    value_of(check_ranges(decimation));
    decimations.push_back(decimation);
  }
  return decimations;
}

using jobs::found;
using jobs::told;

/// `options` are the task's, `settings` what it takes beside them: those of smoothing, where it smooths first.
std::vector<TaskOutcome> run(const std::string& task, const std::vector<std::pair<std::string, Input>>& inputs,
                             const nb::dict& options, const nb::dict& settings, const std::optional<MethodText>& method,
                             const std::vector<MethodText>& methods, const Decimations& decimations) {
  jobs::TaskRequest request{.decimations = decimations_in(decimations)};
  for (const auto& [name, input] : inputs) request.inputs.emplace_back(name, std::visit(ValueOfInput(), input));
  const std::vector<FieldInfo>& fields = jobs::options_for(*value_of(jobs::task_named(task)), request);
  request.options = options_in(options, fields);
  std::ranges::move(options_in(settings), std::back_inserter(request.options));
  if (method) request.method = value_of(jobs::chosen_method(method->method(), *request.input("keys"), {}));
  for (const MethodText& one : methods) {
    request.methods.push_back({one.words, one.method()});
    request.named.push_back(one.words);
  }
  auto outcome = interruptible([&](const Progress& progress) { return jobs::run_task(task, request, progress); });
  if (!outcome)
    raise(as_shown(as_shown(std::move(outcome.error()), options, fields), settings, fields_of<SmoothOptions>()));
  if (outcome->parts.empty()) outcome->parts.push_back(*outcome);
  return std::move(outcome->parts);
}

/// Null where it made none.
struct KeysOf {
  const Track* operator()(const jobs::SmoothOutcome& outcome) const { return &outcome.smoothing.track; }
  const Track* operator()(const jobs::TuneOutcome& outcome) const { return &outcome.tuning.track; }
  const Track* operator()(const jobs::ReduceOutcome& outcome) const { return &outcome.chosen().track; }
  const Track* operator()(const jobs::RetimeOutcome& outcome) const { return &outcome.retiming.track; }
  const Track* operator()(const jobs::AlignOutcome& outcome) const { return &outcome.aligned; }
  const Track* operator()(const jobs::RateAlignOutcome& outcome) const { return std::get_if<Track>(&outcome.aligned); }
  const Track* operator()(const auto&) const { return nullptr; }
};

std::optional<Keys> keys_of(const TaskOutcome& outcome) {
  const Track* const track = std::visit([](const auto& found) { return KeysOf()(*found); }, outcome.finding);
  return track ? std::optional(Keys{std::make_shared<const Track>(*track)}) : std::nullopt;
}

/// As Python's lists have them; quaternions scalar last.
std::vector<double> numbers_of(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
std::vector<double> numbers_of(const Eigen::Quaterniond& q) { return {q.x(), q.y(), q.z(), q.w()}; }

FloatArray array(const std::vector<double>& numbers) { return array_of(numbers.data(), numbers.size(), 0); }
FloatArray array(const std::vector<Eigen::Vector3d>& rows) { return array_of(rows.front().data(), rows.size(), 3); }

nb::object method_text(const Method& method) { return nb::cast(MethodText::of(method)); }

/// None where there is none.
template <class T>
nb::object or_none(const T* value) {
  return value ? nb::cast(*value) : nb::object(nb::none());
}

nb::dict attributes(const jobs::SmoothOutcome& outcome) {
  nb::dict all = attributes_of(outcome.smoothing);
  all["method"] = method_text(outcome.smoothing.method);
  return all;
}

nb::dict attributes(const jobs::TuneOutcome& outcome) {
  nb::dict all = attributes_of(outcome.tuning), values;
  for (const std::string& name : outcome.tuning.parameters) values[text(name)] = array(outcome.values(name));
  all["parameters"] = values;
  all["objective"] = text(word_of(outcome.request.options.objective));
  all["unit"] = text(unit_of(outcome.request.options.objective));
  all["method"] = method_text(outcome.tuning.method);
  return all;
}

nb::dict attributes(const jobs::ReduceOutcome& outcome) {
  nb::dict all = attributes_of(outcome.chosen());
  all["samples"] = outcome.chosen().samples;
  const jobs::SmoothedFirst* const smoothed = outcome.smoothed ? &*outcome.smoothed : nullptr;
  const auto* const path = smoothed && smoothed->raw_positions ? &*smoothed->raw_positions : nullptr;
  all["raw_error_rms"] = or_none(smoothed ? &smoothed->raw.rms : nullptr);
  all["raw_error_max"] = or_none(smoothed ? &smoothed->raw.largest : nullptr);
  all["raw_position_error_rms"] = or_none(path ? &path->rms : nullptr);
  all["raw_position_error_max"] = or_none(path ? &path->largest : nullptr);
  all["smoothing"] = smoothed ? nb::cast(told(jobs::SmoothOutcome(*smoothed))) : nb::object(nb::none());
  all["method"] = method_text(outcome.chosen().method);
  return all;
}

nb::dict attributes(const jobs::RetimeOutcome& outcome) {
  nb::dict all = attributes_of(outcome.retiming), certificates;
  all["duration_before"] = outcome.duration_before();
  for (const Certificate& c : outcome.certificates())
    certificates[text(c.id)] = nb::make_tuple(c.limit, c.bound, c.found, c.time, c.segment);
  all["certificates"] = certificates;
  all["method"] = method_text(outcome.retiming.method);
  return all;
}

nb::dict attributes(const MeanWindow& window) {
  const Mean& mean = window.mean;
  nb::dict all = attributes_of(mean);
  all["time"] = window.time;
  all["orientation"] = array_of(mean.orientation.coeffs().data(), 4, 0);
  all["position"] = mean.position ? nb::object(array_of(mean.position->data(), 3, 0)) : nb::none();
  all["farthest"] = mean.farthest;
  all["farthest_position"] = or_none(mean.farthest_position ? &*mean.farthest_position : nullptr);
  return all;
}

nb::dict attributes(const jobs::MeanOutcome& outcome) {
  nb::list windows;
  for (const MeanWindow& window : outcome.windows) windows.append(attributes(window));
  nb::dict all;
  all["windows"] = windows;
  return all;
}

nb::dict attributes(const jobs::AlignOutcome& outcome) {
  nb::dict all = attributes_of(outcome.alignment);
  nb::list open;
  for (const OpenDirection& one : outcome.alignment.open)
    open.append(nb::make_tuple(numbers_of(one.world), numbers_of(one.body), one.offset, one.scale,
                               numbers_of(one.translation)));
  all["world"] = numbers_of(outcome.alignment.world);
  all["body"] = numbers_of(outcome.alignment.body);
  all["open"] = open;
  return all;
}

/// `rates`: times since the epoch of the fixed recording, and rates.
nb::dict attributes(const jobs::RateAlignOutcome& outcome) {
  nb::dict all = attributes_of(outcome.alignment);
  nb::list open;
  for (const OpenRateDirection& one : outcome.alignment.open)
    open.append(nb::make_tuple(numbers_of(one.body), one.offset, numbers_of(one.bias)));
  const auto* const gyro = std::get_if<GyroTrack>(&outcome.aligned);
  all["body"] = numbers_of(outcome.alignment.body);
  all["open"] = open;
  all["rates"] = gyro ? nb::object(nb::make_tuple(array(gyro->rates.times), array(gyro->rates.rates))) : nb::none();
  return all;
}

/// `texts`: the method of each row, with the values that were tuned.
nb::dict attributes(const jobs::CompareOutcome& outcome) {
  nb::list measures, texts;
  for (const MeasureInfo& measure : outcome.measures()) {
    nb::dict info;
    info["id"] = text(measure.id);
    info["word"] = text(measure.word);
    info["label"] = text(measure.label);
    info["unit"] = text(measure.unit);
    info["explanation"] = text(measure.explanation);
    measures.append(info);
  }
  for (const ComparedMethod& method : outcome.methods) texts.append(method_text(method.candidate.method));
  nb::dict all;
  all["measures"] = measures;
  all["texts"] = texts;
  all["alignment"] = outcome.alignment ? nb::cast(told(*outcome.alignment)) : nb::object(nb::none());
  return all;
}

/// Value, clip, joint and time of what is largest; without names where all is 0.
nb::tuple worst_of(const jobs::ReduceSceneOutcome& outcome, const ClipReduction* reduction,
                   ClipReduction::Worst ClipReduction::*which, double unit = 1.0) {
  if (!reduction || (reduction->*which).largest.value == 0.0) return nb::make_tuple(0.0, "", "", 0.0);
  const ClipReduction::Worst& worst = reduction->*which;
  return nb::make_tuple(worst.largest.value * unit, text(reduction->clip.name),
                        text(outcome.request.skeleton[worst.joint].name), worst.largest.time);
}

nb::dict attributes(const jobs::ReduceSceneOutcome& outcome) {
  const ClipTotals totals = outcome.totals();
  nb::dict all;
  all["rotation_keys"] = totals.rotation_keys;
  all["rotation_keys_before"] = totals.rotation_keys_before;
  all["rotation_tracks"] = totals.rotation_tracks;
  all["open_tracks"] = totals.open_tracks;
  all["translation_keys"] = totals.translation_keys;
  all["translation_keys_before"] = totals.translation_keys_before;
  all["angle"] = worst_of(outcome, totals.angle, &ClipReduction::angle);
  all["translation"] = worst_of(outcome, totals.translation, &ClipReduction::translation);
  all["distance"] = worst_of(outcome, totals.distance, &ClipReduction::distance);
  all["from_smooth"] = worst_of(outcome, totals.from_smooth, &ClipReduction::from_smooth);
  all["from_stored"] = worst_of(outcome, totals.from_stored, &ClipReduction::from_stored);
  all["cuts"] = totals.cuts;
  all["tracks_before"] = totals.tracks_before;
  all["tracks_left_out"] = totals.tracks_left_out;
  return all;
}

/// `joints`: clip, joint and what was found of every rotation that was smoothed.
nb::dict attributes(const jobs::SmoothClipsOutcome& outcome) {
  nb::list joints, runs;
  std::size_t left = 0, refused = 0;
  for (const ClipSmoothing& clip : outcome.clips) {
    left += clip.left + clip.refused.size();
    refused += clip.refused.size();
    for (const auto& [joint, smoothed, change, at] : clip.joints)
      joints.append(nb::make_tuple(text(clip.clip.name), text(outcome.request.skeleton[joint].name),
                                   smoothed.smoothing_time, smoothed.noise, smoothed.rejected.size(), change, at));
    for (const WrongRun& run : clip.runs) {
      nb::list names;
      for (const std::size_t joint : run.joints) names.append(text(outcome.request.skeleton[joint].name));
      runs.append(
          nb::make_tuple(text(clip.clip.name), nb::tuple(names), run.first, run.count, run.start, run.end, run.jump));
    }
  }
  nb::dict all;
  all["joints"] = joints;
  all["left"] = left;
  all["refused"] = refused;
  all["runs"] = runs;
  return all;
}

/// `clips`: the name of each, and of each joint in it the name and the largest shell distance.
nb::dict attributes(const jobs::DifferenceOutcome& outcome) {
  nb::list clips, only_in_first;
  for (const jobs::ClipDifference& clip : outcome.clips) {
    nb::list joints;
    for (std::size_t i = 0; i < clip.joints.size(); ++i)
      joints.append(
          nb::make_tuple(text(outcome.request.first.skeleton[clip.joints[i]].name), clip.worst[i].distance.value));
    clips.append(nb::make_tuple(text(outcome.name_of(clip)), joints));
  }
  for (const std::string& name : outcome.only_in_first) only_in_first.append(text(name));
  nb::dict all;
  all["clips"] = clips;
  all["only_in_first"] = only_in_first;
  return all;
}

/// Value, clip, joint and time of the largest change of a loop.
nb::tuple change_of(const jobs::ClipOutcome& outcome, const ClipEdit& edit, const LoopChange& change) {
  if (change.joint == no_parent) return nb::make_tuple(0.0, "", "", 0.0);
  return nb::make_tuple(change.largest.value, text(edit.clip.name),
                        text(outcome.request.file.skeleton[change.joint].name), change.largest.time);
}

/// `clips`: of each its name, what was kept, and of a loop how it was closed.
nb::dict attributes(const jobs::ClipOutcome& outcome) {
  nb::list clips;
  for (std::size_t i = 0; i < outcome.clips.size(); ++i) {
    const ClipEdit& edit = outcome.clips[i];
    const ClipLoop loop = edit.loop.value_or(ClipLoop{});
    clips.append(nb::make_tuple(text(edit.clip.name), edit.part.start, edit.part.end,
                                edit.loop ? nb::cast(text(word_of(loop.closing))) : nb::object(nb::none()),
                                change_of(outcome, edit, loop.rotation), change_of(outcome, edit, loop.translation),
                                loop.travel, loop.turn, outcome.seams[i].pose.value, outcome.seams[i].rate.value));
  }
  nb::dict all;
  all["clips"] = clips;
  return all;
}

/// `clips`: of each its name, how it was slowed, and how long it takes.
nb::dict attributes(const jobs::RetimeClipsOutcome& outcome) {
  nb::list clips;
  for (std::size_t i = 0; i < outcome.clips.size(); ++i) {
    const ClipRetiming& retiming = outcome.clips[i];
    const Domain before = outcome.request.file.clips[i].domain(), after = retiming.clip.domain();
    clips.append(nb::make_tuple(text(retiming.clip.name), text(word_of(retiming.slowing)), before.end - before.start,
                                after.end - after.start, retiming.time_scale, retiming.rests, retiming.slack));
  }
  nb::dict all;
  all["clips"] = clips;
  return all;
}

/// Of what has none that Python shows.
nb::dict attributes(const auto&) { return {}; }

/// Of the orientations and of the angular velocities; None where they were not asked for.
nb::object sigmas_of(const TaskOutcome& outcome) {
  const auto& sigmas = found<jobs::SmoothOutcome>(outcome).smoothing.sigmas;
  if (!sigmas) return nb::none();
  return nb::make_tuple(array(sigmas->orientations), array(sigmas->angular_velocities));
}

bool covers(const TaskOutcome& outcome, double t) { return found<jobs::SmoothOutcome>(outcome).smoothing.covers(t); }

Keys aligned_keys(const TaskOutcome& outcome, const Keys& keys) {
  const auto& align = found<jobs::AlignOutcome>(outcome);
  return {std::make_shared<const Track>(value_of(aligned(*keys.track, *align.request.fixed, align.alignment)))};
}

/// Those of a row.
Keys compared_keys(const TaskOutcome& outcome, std::size_t row) {
  const auto& compared = found<jobs::CompareOutcome>(outcome);
  return {std::make_shared<const Track>(compared.data.key_sets[compared.methods.at(row).key_set].track)};
}

/// The scene with the clips that the task made of its own.
SharedScene scene_of(const TaskOutcome& outcome, const SharedScene& before) {
  return SharedScene(scenes::with_motion(*before.scene, outcome.scenes.front()));
}

/// Bytes, since names in it need not be UTF-8.
nb::bytes page(const TaskOutcome& outcome, const std::string& date, const std::string& after) {
  auto made = [&] {
    const nb::gil_scoped_release release;
    return jobs::page_of(outcome, pages::PageHead{.date = date}, after);
  }();
  const std::string html = value_of(std::move(made));
  return nb::bytes(html.data(), html.size());
}

}  // namespace

void add_tasks(nb::module_& module) {
  nb::class_<Gyro>(module, "Gyro").def(nb::new_(&gyro_of), "times"_a, "rates"_a, "epoch"_a, "is_dated"_a);
  nb::class_<TaskOutcome>(module, "TaskOutcome")
      .def_prop_ro("keys", &keys_of)
      .def_prop_ro("warnings", [](const TaskOutcome& outcome) { return warnings_of(outcome.warnings); })
      .def("attributes",
           [](const TaskOutcome& outcome) {
             return std::visit([](const auto& finding) { return attributes(*finding); }, outcome.finding);
           })
      .def("members", [](const TaskOutcome& outcome) { return object_of(outcome.document); })
      .def("summary", [](const TaskOutcome& outcome) { return shown(outcome.summary); })
      .def("page", &page, "date"_a, "after"_a = "")
      .def("sigmas", &sigmas_of)
      .def("covers", &covers, "t"_a)
      .def("aligned", &aligned_keys, "keys"_a)
      .def("keys_of", &compared_keys, "row"_a)
      .def("scene", &scene_of, "before"_a);
  module.def("weighted", &weighted, "keys"_a, "weights"_a);
  module.def("chordal_mean", &chordal_mean_of, "rotations"_a, "weights"_a.none());
  module.def("run", &run, "task"_a, "inputs"_a, "options"_a = nb::dict(), "settings"_a = nb::dict(),
             "method"_a = nb::none(), "methods"_a = nb::list(), "decimations"_a = nb::list());
}

}  // namespace orispline::python
