// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/plot.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include <orispline/analysis/segment_motions.hpp>
#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/report/motion_drawing.hpp>
#include <orispline/report/page_samples.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::string title_of(const PlotRequest& request) {
  const Track& track = *request.keys;
  const std::string start = track.epoch == Decimal() ? "" : formatted(", t = 0 at {}", track.time_text(track.epoch));
  return formatted("{}: {}{}", printable(request.name), counted(track.keys.size(), "key"), start);
}

/// Segment by segment, which is faster than motion by motion.
report::PageSamples samples_of(const PoseCurve& curve) {
  const auto look = [&](std::size_t segment, std::span<const double> times, std::span<Motion> found) {
    SegmentMotions motions(curve.orientation, segment, MotionPart::all);
    motions.evaluate(times);
    for (std::size_t k = 0; k < times.size(); ++k) found[k] = motions.motion(k);
  };
  return report::sampled(curve, report::samples_to_draw, look);
}

}  // namespace

std::string picture_of(const PictureLook& look, const Keyframes& keys, std::span<const NamedCurve> curves) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
  const auto axis = static_cast<std::size_t>(look.axis);
  report::MotionPicture picture{.title = look.title,
                                .keys = report::page_keys(keys),
                                .body_axis = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis)),
                                .axis_name = std::string(names[axis]),
                                .ghosts = look.ghosts};
  for (const NamedCurve& one : curves) picture.methods.push_back({.name = one.name, .samples = samples_of(one.curve)});
  return report::motion_drawing(picture).document();
}

Expected<PlotOutcome> plot(const PlotRequest& request) {
  std::vector<PoseCurve> curves;
  PlotOutcome outcome;
  for (const Method& method : request.methods) {
    auto curve = shaped_curve(method, *request.keys);
    if (!curve) return tl::unexpected(std::move(curve.error()));
    std::ranges::move(warnings_of(method, *request.keys), std::back_inserter(outcome.warnings));
    curves.push_back(std::move(*curve));
  }
  std::vector<NamedCurve> named;
  const auto labels = labels_of(request.methods);
  for (std::size_t i = 0; i < curves.size(); ++i) named.push_back({labels[i], curves[i]});
  outcome.svg = picture_of({title_of(request), request.axis, request.ghosts}, request.keys->keys, named);
  return outcome;
}

}}}  // namespace orispline::jobs
