// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <nanobind/stl/optional.h>

#include <orispline/jobs.hpp>
#include <orispline/scenes.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "files.hpp"
#include "interruption.hpp"
#include "tasks.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

/// A scene as Python holds it: shared, for it never changes.
struct SharedScene {
  std::shared_ptr<const scenes::Scene> scene;

  explicit SharedScene(scenes::Scene made) : scene(std::make_shared<const scenes::Scene>(std::move(made))) {}
};

nb::tuple read_scene(const std::string& path, bool drop_duplicates, const std::optional<nb::bytes>& bytes) {
  const io::Input input = input_of(path, bytes);
  auto read = [&] {
    const nb::gil_scoped_release release;
    return scenes::read_scene(input, {.drop_duplicates = drop_duplicates});
  }();
  if (!read) raise(in_words(std::move(read.error())));
  const nb::list warnings = told(read->warnings);
  return nb::make_tuple(SharedScene(*std::move(read)), warnings);
}

/// The bytes of a file of that name, and warnings.
nb::tuple written_scene(const SharedScene& shared, const std::string& path, const std::optional<std::string>& euler,
                        std::optional<double> rate, bool bones) {
  scenes::SceneWriting writing{.rate = rate, .bones = bones};
  if (euler) {
    writing.euler = euler_order_of(*euler);
    if (!writing.euler || writing.euler->is_proper() || writing.euler->axes != EulerOrder::Axes::of_body)
      raise({ErrorCode::bad_argument,
             "found '" + *euler + "', wanted three different axes of the body, such as ZYX",
             {},
             "output_euler"});
  }
  auto written = [&] {
    const nb::gil_scoped_release release;
    return scenes::written_scene(*shared.scene, path, writing);
  }();
  if (!written) raise(in_words(std::move(written.error())));
  return nb::make_tuple(nb::bytes(written->bytes.data(), written->bytes.size()), told(written->warnings));
}

FloatArray array(const std::vector<Eigen::Quaterniond>& rows) {
  return array_of(rows.empty() ? nullptr : rows.front().coeffs().data(), rows.size(), 4);
}
FloatArray array(const std::vector<Eigen::Vector3d>& rows) {
  return array_of(rows.empty() ? nullptr : rows.front().data(), rows.size(), 3);
}

/// Names, parents (-1: none), and the translations, rotations and scales of the rest pose.
nb::tuple skeleton_of(const SharedScene& shared) {
  nb::list names, parents;
  std::vector<Eigen::Vector3d> translations, scales;
  std::vector<Eigen::Quaterniond> rotations;
  for (const Joint& joint : shared.scene->skeleton.joints()) {
    names.append(text(joint.name));
    parents.append(joint.parent == no_parent ? -1 : static_cast<std::ptrdiff_t>(joint.parent));
    translations.push_back(joint.rest.translation);
    rotations.push_back(joint.rest.rotation);
    scales.push_back(joint.rest.scale);
  }
  return nb::make_tuple(names, parents, array(translations), array(rotations), array(scales));
}

std::string_view word_of(ChannelInterpolation interpolation) {
  switch (interpolation) {
    case ChannelInterpolation::step:
      return "step";
    case ChannelInterpolation::cubicspline:
      return "cubicspline";
    case ChannelInterpolation::linear:
      break;
  }
  return "linear";
}

template <CurvePoint P>
void append(nb::list& all, std::string_view property, const std::vector<Channel<P>>& channels) {
  for (const Channel<P>& channel : channels) {
    const bool has_tangents = !channel.in_tangents.empty();
    all.append(nb::make_tuple(channel.joint, text(property), text(word_of(channel.interpolation)),
                              array_of(channel.times.data(), channel.times.size(), 0), array(channel.values),
                              has_tangents ? nb::object(array(channel.in_tangents)) : nb::none(),
                              has_tangents ? nb::object(array(channel.out_tangents)) : nb::none()));
  }
}

const Clip& clip_of(const SharedScene& shared, std::size_t clip) { return shared.scene->clips.at(clip); }

/// Joint, property, interpolation, times, values and tangents of every channel.
nb::list channels_of(const SharedScene& shared, std::size_t clip) {
  nb::list all;
  append(all, "rotation", clip_of(shared, clip).rotations);
  append(all, "translation", clip_of(shared, clip).translations);
  append(all, "scale", clip_of(shared, clip).scales);
  return all;
}

/// Name, start and end of every clip.
nb::list clips_of(const SharedScene& shared) {
  nb::list all;
  for (const Clip& clip : shared.scene->clips)
    all.append(nb::make_tuple(text(clip.name), clip.whole_domain().start, clip.whole_domain().end));
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

nb::dict attributes_of_reduction(const jobs::ReduceSceneOutcome& outcome) {
  const ClipTotals totals = outcome.totals();
  nb::dict attributes;
  attributes["rotation_keys"] = totals.rotation_keys;
  attributes["rotation_keys_before"] = totals.rotation_keys_before;
  attributes["rotation_tracks"] = totals.rotation_tracks;
  attributes["open_tracks"] = totals.open_tracks;
  attributes["translation_keys"] = totals.translation_keys;
  attributes["translation_keys_before"] = totals.translation_keys_before;
  attributes["angle"] = worst_of(outcome, totals.angle, &ClipReduction::angle);
  attributes["translation"] = worst_of(outcome, totals.translation, &ClipReduction::translation, outcome.metres());
  attributes["distance"] = worst_of(outcome, totals.distance, &ClipReduction::distance, outcome.metres());
  attributes["from_smooth"] = worst_of(outcome, totals.from_smooth, &ClipReduction::from_smooth);
  attributes["from_stored"] = worst_of(outcome, totals.from_stored, &ClipReduction::from_stored);
  return attributes;
}

nb::bytes page_of_reduction(const jobs::ReduceSceneOutcome& outcome, const std::string& date) {
  return bytes_of(
      [&] { return report::skeleton_document(page_of(outcome, "reduced", pages::PageHead{.date = date})); });
}

jobs::ClipFile file_of(const scenes::Scene& scene) {
  if (!scene.format) return {.name = scene.name};
  return {.name = scene.name,
          .format = scene.format->file,
          .has_no_unit = scene.format->has_no_unit,
          .is_single_precise = scene.format->holds_floats};
}

nb::tuple reduce_scene(const SharedScene& shared, const MethodText& method, const nb::dict& stated, bool closed,
                       std::optional<double> position_scale, unsigned threads) {
  scenes::Scene scene = *shared.scene;
  jobs::ReduceSceneRequest request{.file = file_of(scene),
                                   .skeleton = scene.skeleton,
                                   .clips = std::exchange(scene.clips, {}),
                                   .options = options_in<ClipReduceOptions>(stated),
                                   .position_scale = position_scale,
                                   .threads = threads};
  request.options.method = method.words == cubicspline_method ? Method{method.words} : method.method();
  request.options.closed = closed;
  auto outcome = value_of(interruptible([&](const Progress&) { return jobs::reduce_scene(std::move(request)); }));
  scene.clips = outcome.clips();
  return nb::make_tuple(SharedScene(std::move(scene)), std::move(outcome));
}

bool has_no_unit(const scenes::Scene& scene) { return scene.format && scene.format->has_no_unit; }

nb::tuple smooth_scene(const SharedScene& shared, const nb::dict& stated, unsigned threads) {
  scenes::Scene scene = *shared.scene;
  jobs::SmoothClipsRequest request{.name = scene.name,
                                   .skeleton = scene.skeleton,
                                   .clips = std::exchange(scene.clips, {}),
                                   .options = options_in<SmoothOptions>(stated),
                                   .threads = threads,
                                   .has_no_unit = has_no_unit(scene)};
  auto outcome = value_of(interruptible([&](const Progress&) { return jobs::smooth_clips(std::move(request)); }));
  for (const ClipSmoothing& smoothed : outcome.clips) scene.clips.push_back(smoothed.clip);
  return nb::make_tuple(SharedScene(std::move(scene)), std::move(outcome));
}

/// Clip, joint and what was found of every rotation that was smoothed.
nb::list joints_of(const jobs::SmoothClipsOutcome& outcome) {
  nb::list all;
  for (const ClipSmoothing& clip : outcome.clips)
    for (const auto& [joint, found, change, at] : clip.joints)
      all.append(nb::make_tuple(text(clip.clip.name), text(outcome.request.skeleton[joint].name), found.smoothing_time,
                                found.noise, found.rejected.size(), change, at));
  return all;
}

/// How many rotations were left as they were, and how many of them since they could not be smoothed.
nb::tuple left_by(const jobs::SmoothClipsOutcome& outcome) {
  std::size_t left = 0, refused = 0;
  for (const ClipSmoothing& clip : outcome.clips) {
    left += clip.left + clip.refused.size();
    refused += clip.refused.size();
  }
  return nb::make_tuple(left, refused);
}

nb::bytes page_of_smoothing(const jobs::SmoothClipsOutcome& outcome, const std::string& date) {
  return bytes_of([&] { return report::skeleton_document(page_of(outcome, "smooth", pages::PageHead{.date = date})); });
}

jobs::MotionFile motion_of(const SharedScene& shared) {
  const scenes::Scene& scene = *shared.scene;
  return {.name = scene.name, .skeleton = scene.skeleton, .clips = scene.clips, .has_no_unit = has_no_unit(scene)};
}

/// Of all clips, or of one.
nb::bytes page_of_scene(const SharedScene& shared, const std::string& date, std::optional<std::size_t> clip) {
  return bytes_of([&] {
    jobs::MotionFile file = motion_of(shared);
    if (clip) file.clips = {clip_of(shared, *clip)};
    const auto outcome = jobs::inspect_scene({.file = std::move(file)});
    return report::skeleton_document(page_of(outcome, pages::PageHead{.date = date}));
  });
}

/// By the names of clips and joints of the first scene, all of whose clips are compared; of equal names the largest.
/// Beside it the warnings.
nb::tuple shell_distances(const SharedScene& first, const SharedScene& second, double shell) {
  nb::dict distances;
  if (first.scene->clips.empty()) return nb::make_tuple(distances, nb::list());
  const auto outcome = value_of(interruptible([&](const Progress&) {
    return jobs::difference({.first = motion_of(first), .second = motion_of(second), .shell = shell});
  }));
  if (!outcome.only_in_first.empty())
    raise({ErrorCode::bad_data,
           "found no clip '" + outcome.only_in_first.front() + "', wanted every clip of a",
           {},
           "b"});
  for (const jobs::ClipDifference& clip : outcome.clips) {
    const nb::str name = text(outcome.name_of(clip));
    if (!distances.contains(name)) distances[name] = nb::dict();
    nb::dict joints = nb::borrow<nb::dict>(distances[name]);
    for (std::size_t i = 0; i < clip.joints.size(); ++i) {
      const nb::str joint = text(first.scene->skeleton[clip.joints[i]].name);
      const double before = joints.contains(joint) ? nb::cast<double>(joints[joint]) : 0.0;
      joints[joint] = std::max(before, clip.worst[i].distance.value);
    }
  }
  return nb::make_tuple(distances, told(outcome.warnings));
}

}  // namespace

void add_scenes(nb::module_& module) {
  scenes::join_formats();
  nb::class_<SharedScene>(module, "Scene")
      .def_prop_ro("name", [](const SharedScene& shared) { return text(shared.scene->name); })
      .def_prop_ro("skeleton", &skeleton_of)
      .def_prop_ro("clips", &clips_of)
      .def("channels", &channels_of, "clip"_a)
      .def("page", &page_of_scene, "date"_a, "clip"_a = nb::none())
      .def("shell_distances", &shell_distances, "second"_a, "shell"_a)
      .def("reduced", &reduce_scene, "method"_a, "options"_a, "closed"_a, "position_scale"_a.none(), "threads"_a)
      .def("smoothed", &smooth_scene, "options"_a, "threads"_a)
      .def("written", &written_scene, "path"_a, "euler"_a.none(), "rate"_a.none(), "bones"_a);
  auto outcome_class = nb::class_<jobs::ReduceSceneOutcome>(module, "SceneReduction");
  outcome_class.def("attributes", &attributes_of_reduction).def("page", &page_of_reduction, "date"_a);
  add_words(outcome_class);
  auto smoothing_class = nb::class_<jobs::SmoothClipsOutcome>(module, "SceneSmoothing");
  smoothing_class.def_prop_ro("joints", &joints_of)
      .def_prop_ro("left", &left_by)
      .def("page", &page_of_smoothing, "date"_a);
  add_words(smoothing_class);
  module.def("read_scene", &read_scene, "path"_a, "drop_duplicates"_a, "bytes"_a.none());
}

}  // namespace orispline::python
