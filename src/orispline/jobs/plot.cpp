// SPDX-License-Identifier: Apache-2.0
#include <orispline/jobs/plot.hpp>

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/method_list.hpp>
#include <orispline/families/method_warnings.hpp>
#include <orispline/jobs/curve_of_keys.hpp>
#include <orispline/report/motion_drawing.hpp>
#include <orispline/report/page_samples.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

namespace {

std::string title_of(const PlotRequest& request) {
  const Track& track = *request.keys;
  const std::string start = track.epoch == Decimal() ? "" : formatted(", t = 0 at {} s", track.epoch.to_string());
  return formatted("{}: {}{}", printable(request.name), counted(track.keys.size(), "key"), start);
}

}  // namespace

Expected<PlotOutcome> plot(const PlotRequest& request) {
  constexpr std::array<std::string_view, 3> names{"x", "y", "z"};
  const auto axis = static_cast<std::size_t>(request.axis);
  report::MotionPicture picture{.title = title_of(request),
                                .keys = report::page_keys(request.keys->keys),
                                .body_axis = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(axis)),
                                .axis_name = std::string(names[axis]),
                                .ghosts = request.ghosts};
  PlotOutcome outcome;
  const auto labels = labels_of(request.methods);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const Method& method = request.methods[i];
    const auto curve = shaped_curve(method, *request.keys);
    if (!curve) return tl::unexpected(curve.error());
    std::ranges::move(warnings_of(method, *request.keys), std::back_inserter(outcome.warnings));
    picture.methods.push_back({.name = labels[i], .samples = report::sampled(*curve, report::samples_to_draw)});
  }
  outcome.svg = report::motion_drawing(picture).document();
  return outcome;
}

}}}  // namespace orispline::jobs
