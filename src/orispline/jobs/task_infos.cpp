// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <utility>

#include <orispline/align/rate_alignment.hpp>
#include <orispline/analysis/comparison.hpp>
#include <orispline/analysis/decimation.hpp>
#include <orispline/edit/clip_edits.hpp>
#include <orispline/jobs/bake.hpp>
#include <orispline/jobs/task_list.hpp>
#include <orispline/mean/mean.hpp>
#include <orispline/reduce/reduce.hpp>
#include <orispline/retime/retime.hpp>
#include <orispline/smooth/smooth.hpp>
#include <orispline/tune/tune.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

template <class... Structs>
std::vector<FieldInfo> fields() {
  std::vector<FieldInfo> all;
  const auto append = [&](std::span<const FieldInfo> some) { all.insert(all.end(), some.begin(), some.end()); };
  (append(fields_of<Structs>()), ...);
  return all;
}

constexpr TaskSetting one_method{"method", "The text of the method whose curve it is about"};
constexpr TaskSetting several_methods{"methods", "The texts of methods, with commas between them"};
constexpr TaskSetting cutoff_setting{
    "cutoff", "Cut-off frequency 1/(2 pi tau) [Hz] instead of the smoothing time: half of a motion at it is left"};
constexpr TaskSetting threads_setting{"threads", "At most so many at work; 0: one per core"};

constexpr TaskInput keys_input{"keys", "The keys"};
constexpr TaskKinds gyros_too{.gyros = true}, scenes_too{.scenes = true};
constexpr TaskKinds gyros_alone{.tracks = false, .gyros = true}, scenes_alone{.tracks = false, .scenes = true};

constexpr TaskInput not_required(std::string_view name, std::string_view sentence) { return {name, sentence, false}; }
constexpr TaskInput several_of(std::string_view name, std::string_view sentence, TaskKinds takes = {}) {
  return {name, sentence, true, true, takes};
}

}  // namespace

TaskInfo smooth_info() {
  return {"smooth",
          "A noisy recording as a smooth motion with rates",
          fields<SmoothOptions>(),
          fields<Smoothing>(),
          {{.name = "recording", .sentence = "The recording, or a skeleton with its clips", .takes = scenes_too},
           {"gyro", "The rates of a gyro with a clock of its own", false, false, gyros_alone}},
          {cutoff_setting, threads_setting},
          run_smooth,
          check_smooth,
          {},
          {run_smooth_scene, check_smooth}};
}

TaskInfo tune_info() {
  return {"tune",
          "The tensions that make a curve smoothest, or nearest to a recording",
          fields<TuneOptions>(),
          fields<Tuning>(),
          {keys_input, not_required("reference", "The recording to come near to")},
          {one_method},
          run_tune,
          check_typed<TuneOptions>};
}

TaskInfo reduce_tracks_info() {
  std::vector<TaskSetting> settings{several_methods, threads_setting, {"smooth", "Smooth the recordings first"}};
  for (const FieldInfo& field : fields_of<SmoothOptions>()) settings.push_back({field.name, field.sentence});
  settings.push_back(cutoff_setting);
  return {"reduce",
          "The fewest keys that reproduce a recording within a tolerance",
          fields<ReduceOptions>(),
          fields<Reduction>(),
          {several_of("recording", "The recording, or several")},
          std::move(settings),
          run_reduce,
          check_reduce};
}

TaskInfo reduce_info() {
  TaskInfo info = reduce_tracks_info();
  info.inputs = {several_of("recording", "The recording, or several; or a skeleton with its clips", scenes_too)};
  const std::array of_scenes{
      TaskSetting{"closed", "Of a skeleton: channels that end as they begin have the same tangent at both ends"},
      TaskSetting{"position_scale",
                  "Of a skeleton: metres in one unit of length of its file, whose lengths become metres"}};
  info.settings.insert(info.settings.begin() + 3, of_scenes.begin(), of_scenes.end());  // before those of smoothing
  info.on_scene = {run_reduce_scene, check_reduce_scene, fields<ClipReduceOptions>()};
  return info;
}

TaskInfo retime_info() {
  return {"retime",
          "The least slowing that keeps a motion within limits",
          fields<RetimeOptions>(),
          fields<Retiming>(),
          {{.name = "keys", .sentence = "The keys, or a skeleton with its clips", .takes = scenes_too}},
          {one_method},
          run_retime,
          check_retime,
          {},
          {run_retime_scene, check_retime_scene}};
}

TaskInfo bake_info() {
  return {"bake",
          "A curve as polynomials that players evaluate",
          fields<BakeSettings>(),
          fields<BakeOutcome>(),
          {keys_input},
          {one_method},
          run_bake,
          check_bake};
}

TaskInfo mean_info() {
  return {
      "mean",
      "The mean or the median of many orientations",
      fields<MeanOptions>(),
      fields<Mean>(),
      {several_of("rows", "The orientations, with weights where they have the setting weight; several are one set")},
      {},
      run_mean,
      check_typed<MeanOptions>};
}

TaskInfo align_info() {
  return {"align",
          "What brings one recording onto another one of the same motion",
          fields<AlignOptions>(),
          fields<Alignment>(),
          {{.name = "moved", .sentence = "The recording that is brought", .takes = gyros_too},
           {.name = "fixed", .sentence = "The one that it is brought onto", .takes = gyros_too}},
          {},
          run_align,
          check_typed<AlignOptions>,
          fields<RateAlignment>()};
}

TaskInfo compare_info() {
  return {"compare",
          "How near the curves of methods come to a recording",
          fields<Decimation, MeasureOptions>(),
          {},
          {{"keys", "A recording, of which some samples become keys; with a reference the keys themselves"},
           not_required("reference", "The recording to compare with")},
          {several_methods,
           threads_setting,
           {"tune", "Methods with tensions once more, tuned"},
           {"align", "Bring the keys onto the reference first"},
           {"sort", "The word of the measure to sort by"}},
          run_compare,
          check_compare};
}

TaskInfo inspect_info() {
  return {"inspect",
          "What keys are like, and where the rates of curves through them jump; or what a skeleton's clips hold",
          {},
          {},
          {{.name = "keys", .sentence = "The keys, or a skeleton with its clips", .takes = scenes_too}},
          {several_methods},
          run_inspect,
          nullptr,
          {},
          {run_inspect_scene}};
}

TaskInfo difference_info() {
  return {"difference",
          "How far the motions of a skeleton in two files are apart",
          {field_named(fields_of<ClipReduceOptions>(), "shell")},
          {},
          {{.name = "first", .sentence = "A skeleton with its clips", .takes = scenes_alone},
           {.name = "second", .sentence = "The same skeleton with other clips", .takes = scenes_alone}},
          {{"rate", "Look between keys too: at so many times per second, and beside the largest differences [Hz]"},
           threads_setting},
          run_difference};
}

TaskInfo clip_info() {
  return {"clip",
          "Clips of a skeleton cut, turned round, joined, closed into loops, or with the way of a root taken out",
          fields<ClipEdits>(),
          {},
          {{.name = "scene", .sentence = "A skeleton with its clips, each of which is edited", .takes = scenes_alone},
           {"append", "The same skeleton with the clip that comes behind", false, false, scenes_alone}},
          {{"append_clip", "The name of that clip, where its file has several"},
           {"root", "The joint whose way a loop keeps, and goes on in the appended clip"},
           {"extract_root", "The joint whose way across and heading about up go into a node above it"},
           {"root_node", "That node, in the place of the topmost one"},
           {"in_place", "The joint whose way across and heading about up are taken out"},
           threads_setting},
          run_clip,
          check_clip_edits};
}

}}}  // namespace orispline::jobs
