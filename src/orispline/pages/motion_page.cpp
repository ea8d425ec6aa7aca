// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/task_pages.hpp>

#include <utility>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/analysis/curve_measures.hpp>
#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/families/method_text.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/pages/curve_page.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

namespace {

/// `keys.csv: auto, 5 keys`
std::string title_of(const Track& track, std::string_view methods) {
  const std::string keys = formatted("{}, {}", methods, counted(track.keys.size(), "key"));
  return track.name.empty() ? keys : formatted("{}: {}", file_name_of(track.name), keys);
}

Measures shape_of(const AnyCurve& curve, Seam seam, const Eigen::Matrix3d& inertia) {
  const Continuities continuities = continuities_at_keys(curve, seam);
  return {.continuity = continuities.in_time,
          .shape = continuities.of_shape,
          .energies = energies(curve, inertia),
          .peaks = peaks(curve, inertia),
          .angle_travelled = AngleTravelled(curve).total()};
}

}  // namespace

report::Page keys_page(const Track& track, std::span<const MethodOnKeys> methods, const PageHead& head,
                       const std::optional<Eigen::Matrix3d>& inertia) {
  const CurvePage curves{.measures = inertia ? measures_of({MeasureGroup::shape, MeasureGroup::torque})
                                             : measures_of({MeasureGroup::shape}),
                         .inertia = inertia};
  const std::string shown = methods.size() == 1 ? methods.front().name : counted(methods.size(), "method");
  report::Page page = begun_page(title_of(track, shown), head, track.epoch, track.keys);
  page.columns = measure_columns(curves.measures);
  page.methods.resize(methods.size());
  parallel_for(methods.size(), 0, [&](std::size_t i) {
    const auto& [name, curve, seam] = methods[i];
    if (!curve) {
      page.methods[i] = {.name = name, .failure = describe(curve.error())};
      return;
    }
    const Measures measures = shape_of(curve->orientation, seam, inertia.value_or(Eigen::Matrix3d::Identity()));
    page.methods[i] = method_of(curves, {name, track.keys, *curve, measures});
  });
  return page;
}

Expected<report::Page> motion_page(const Track& track, const Method& method, const PageHead& head,
                                   const std::optional<Eigen::Matrix3d>& inertia) {
  return curve_beside_gaps(method, track.keys, track.recipe.gap).map([&](PoseCurve curve) {
    PageHead titled = head;
    if (titled.title.empty()) titled.title = title_of(track, method.name);
    const MethodOnKeys shown{text_of(method), std::move(curve), method.options.loop ? Seam::closed : Seam::open};
    return keys_page(track, {&shown, 1}, titled, inertia);
  });
}

report::Page curves_page(std::span<const NamedCurve> curves, const PageHead& head, const Keyframes& truth) {
  const CurvePage of_shape{.measures = measures_of({MeasureGroup::shape})},
      of_truth{.recording = truth, .measures = measures_of({MeasureGroup::distance, MeasureGroup::shape})};
  const bool has_truth = truth.size() > 0;
  report::Page page = begun_page("", head, Decimal(), curves.front().keys);
  if (has_truth) page.reference = report::thinned(path_of(truth), samples_of_few);
  page.columns = measure_columns((has_truth ? of_truth : of_shape).measures);
  for (const auto& [name, keys, curve, knows] : curves) {
    const bool compared = has_truth && knows == Truth::known;
    Measures measures = shape_of(curve.orientation, Seam::open, Eigen::Matrix3d::Identity());
    if (compared) measures.distance = distance_to_reference(curve.orientation, {truth.times(), truth.orientations()});
    const report::PageMethod method = method_of(compared ? of_truth : of_shape, {name, keys, curve, measures});
    page.methods.push_back(compared ? with_errors(method, errors_at(curve, path_of(truth)), [](double) { return true; })
                                    : method);
  }
  return page;
}

}}}  // namespace orispline::pages
