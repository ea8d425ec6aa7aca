// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <nanobind/stl/optional.h>

#include <orispline/scenes.hpp>

#include "arrays.hpp"
#include "errors.hpp"
#include "files.hpp"
#include "keys.hpp"
#include "scenes.hpp"
#include "text.hpp"

namespace nb = nanobind;
using namespace nanobind::literals;

namespace orispline::python {

namespace {

nb::tuple read_scene(const std::string& path, bool drop_duplicates, const std::optional<std::string>& signs,
                     bool salvage, std::optional<std::size_t> rest_frame, const std::optional<nb::bytes>& bytes) {
  const io::Input input = input_of(path, bytes);
  scenes::SceneReading reading{.drop_duplicates = drop_duplicates, .salvage = salvage, .rest_frame = rest_frame};
  if (signs) reading.signs = *signs == "as-given" ? Signs::as_given : Signs::shortest;
  auto read = [&] {
    const nb::gil_scoped_release release;
    return scenes::read_scene(input, reading);
  }();
  if (!read) raise(in_words(std::move(read.error())));
  const nb::list warnings = told(read->warnings);
  return nb::make_tuple(SharedScene(*std::move(read)), warnings);
}

/// The bytes of a file of that name, and warnings.
nb::tuple written_scene(const SharedScene& shared, const std::string& path, const std::optional<std::string>& euler,
                        std::optional<double> rate, std::optional<double> position_scale,
                        const std::optional<std::string>& compress, bool bones) {
  scenes::SceneWriting writing{.rate = rate, .position_scale = position_scale, .bones = bones};
  if (euler) {
    writing.euler = euler_order_of(*euler);
    if (!writing.euler || writing.euler->is_proper() || writing.euler->axes != EulerOrder::Axes::of_body)
      raise({ErrorCode::bad_argument,
             "found '" + *euler + "', wanted three different axes of the body, such as ZYX",
             {},
             "output_euler"});
  }
  if (compress) {
    const auto compression = key_compression_in(*compress);
    if (!compression) raise(compression.error());
    writing.compression = *compression;
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

/// With one clip alone.
SharedScene with_clip(const SharedScene& shared, std::size_t clip) {
  scenes::Scene scene = *shared.scene;
  scene.clips = {clip_of(shared, clip)};
  return SharedScene(std::move(scene));
}

}  // namespace

void add_scenes(nb::module_& module) {
  scenes::join_formats();
  nb::class_<SharedScene>(module, "Scene")
      .def_prop_ro("name", [](const SharedScene& shared) { return text(shared.scene->name); })
      .def_prop_ro("skeleton", &skeleton_of)
      .def_prop_ro("clips", &clips_of)
      .def("channels", &channels_of, "clip"_a)
      .def("with_clip", &with_clip, "clip"_a)
      .def("written", &written_scene, "path"_a, "euler"_a.none(), "rate"_a.none(), "position_scale"_a.none(),
           "compress"_a.none(), "bones"_a);
  module.def("read_scene", &read_scene, "path"_a, "drop_duplicates"_a, "signs"_a.none(), "salvage"_a,
             "rest_frame"_a.none(), "bytes"_a.none());
}

}  // namespace orispline::python
