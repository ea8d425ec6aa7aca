// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/motion_page.hpp>

#include <utility>

#include <orispline/analysis/angle_travelled.hpp>
#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/pages/curve_page.hpp>

namespace orispline::inline ORISPLINE_ABI::pages {
namespace {

std::string title_of(const Track& track, const Method& method) {
  const std::string keys = formatted("{}, {}", method.name, counted(track.keys.size(), "key"));
  return track.name.empty() ? keys : formatted("{}: {}", file_name_of(track.name), keys);
}

Measures shape_of(const AnyCurve& curve, const Method& method, const Eigen::Matrix3d& inertia) {
  const Seam seam = method.options.loop ? Seam::closed : Seam::open;
  return {.continuity = continuity_at_keys(curve, seam),
          .shape = shape_continuity_at_keys(curve, seam),
          .energies = energies(curve, inertia),
          .peaks = peaks(curve, inertia),
          .angle_travelled = AngleTravelled(curve).total()};
}

}  // namespace

Expected<report::Page> motion_page(const Track& track, const Method& method, const PageHead& head,
                                   const std::optional<Eigen::Matrix3d>& inertia) {
  return make_pose_curve(method, track.keys).map([&](const PoseCurve& curve) {
    const CurvePage curves{.measures = inertia ? measures_of({MeasureGroup::shape, MeasureGroup::torque})
                                               : measures_of({MeasureGroup::shape}),
                           .inertia = inertia};
    Measures measures = shape_of(curve.orientation, method, inertia.value_or(Eigen::Matrix3d::Identity()));
    report::Page page = begun_page(title_of(track, method), head, track.epoch, track.keys);
    page.columns = measure_columns(curves.measures);
    page.methods.push_back(method_of(curves, {text_of(method), track.keys, curve, std::move(measures)}));
    return page;
  });
}

}  // namespace orispline::inline ORISPLINE_ABI::pages
