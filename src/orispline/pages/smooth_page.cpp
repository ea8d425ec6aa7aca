// SPDX-License-Identifier: Apache-2.0
#include <orispline/pages/task_pages.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include <orispline/analysis/curve_in_stretches.hpp>
#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/parallel.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/pages/curve_page.hpp>
#include <orispline/smooth/smoothed_band.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {
namespace {

constexpr std::string_view rms_of_accepted = "rms_accepted_deg";

/// The energies and peaks of the curve.
Measures shape_of(const AnyCurve& curve) { return {.energies = energies(curve), .peaks = peaks(curve)}; }

Peak larger(const Peak& a, const Peak& b) {
  Peak peak = b.value > a.value ? b : a;
  peak.bound = a.bound && b.bound ? std::optional(std::max(*a.bound, *b.bound)) : std::nullopt;
  return peak;
}

/// What the whole curve does in its stretches, and not what it would do in the gaps between them.
Expected<Measures> shape_of(const Candidate& whole, const std::vector<Stretch>& stretches) {
  constexpr Peak none{.value = 0.0, .time = 0.0, .bound = 0.0};
  Measures measures{.peaks = {none, none, none}};
  std::size_t first = 0;
  for (const Stretch& stretch : stretches) {
    std::vector<std::size_t> indices(stretch.count);
    std::iota(indices.begin(), indices.end(), std::exchange(first, first + stretch.count));
    auto part = make_curve(whole.method, whole.keys.at(indices)).map([](const AnyCurve& c) { return shape_of(c); });
    if (!part) return part;
    measures.energies.acceleration += part->energies.acceleration;
    measures.energies.jerk += part->energies.jerk;
    measures.peaks.angular_velocity = larger(measures.peaks.angular_velocity, part->peaks.angular_velocity);
    measures.peaks.angular_acceleration = larger(measures.peaks.angular_acceleration, part->peaks.angular_acceleration);
  }
  return measures;
}

/// The rejected samples are rising.
bool is_accepted(const Smoothing& smoothing, std::size_t key) {
  return !std::ranges::binary_search(smoothing.rejected, smoothing.keys[key]);
}

/// Of the samples that are not rejected.
report::PageErrors accepted_ones(const report::PageErrors& errors, const Smoothing& smoothing) {
  report::PageErrors few;
  for (std::size_t key = 0; key < errors.times.size(); ++key) {
    if (!is_accepted(smoothing, key)) continue;
    few.times.push_back(errors.times[key]);
    few.values.push_back(errors.values[key]);
  }
  return few;
}

double root_mean_square(const std::vector<double>& values) {
  const double sum = std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Without the angle travelled, of which noise has no end.
std::vector<MeasureInfo> without_angle_travelled(std::vector<MeasureInfo> measures) {
  std::erase_if(measures, [](const MeasureInfo& measure) { return measure.id == "angle_travelled_deg"; });
  return measures;
}

/// Over the gaps, where nothing is shown of it, but not over jumps, which have no time.
Expected<PoseCurve> curve_beside_jumps(const Method& method, const Keyframes& keys) {
  return curve_beside_gaps(method, keys, std::nullopt);
}

/// What the page is made of.
struct Source {
  const Smoothing& smoothing;
  const CurvePage& curves;

  [[nodiscard]] const Keyframes& smoothed() const { return smoothing.track.keys; }
};

/// The curve of the method with the measures of its shape, and nothing in the gaps.
report::PageMethod method_of(const Source& source, const CurvePage& page, ShownCurve shown, std::string_view method) {
  auto shape = shape_of({.method = std::string(method), .keys = shown.keys}, source.smoothing.stretches);
  if (!shape) return {.name = std::move(shown.name), .failure = describe(shape.error())};
  const Continuities continuities = continuities_at_keys(shown.curve.orientation);
  shown.measures.continuity = continuities.in_time;
  shown.measures.shape = continuities.of_shape;
  shown.measures.energies = shape->energies;
  shown.measures.peaks = shape->peaks;
  report::PageMethod result = method_of(page, shown);
  result.keys.reset();  // those of the page
  return result;
}

/// One standard deviation of |ω| about itself; ended where a gap begins.
report::PageBand band_of_rate(const Source& source) {
  report::PageBand band{.label = "one standard deviation"};
  for (const std::size_t key : evenly_picked(source.smoothed().size())) {
    const double t = source.smoothed().times()[key];
    const Eigen::Vector3d& w = source.smoothed().angular_velocities()[key];
    const double speed = w.norm();
    const double spread = source.smoothing.sigmas->angular_velocities[key]
                              .cwiseProduct(speed > 0.0 ? Eigen::Vector3d(w / speed) : Eigen::Vector3d::Ones())
                              .norm();
    const double before = band.times.empty() ? t : band.times.back();
    if (!source.smoothing.covers(0.5 * (before + t))) extend(band, t, std::nan(""), std::nan(""));
    extend(band, t, std::max(0.0, speed - spread), speed + spread);
  }
  return band;
}

/// Where standard deviations were asked for.
Bands bands_of(const Source& source, const report::PagePath& path) {
  if (!source.smoothing.sigmas) return {};
  const auto band = SmoothedBand::make(source.smoothing.track, 0.9);
  Bands bands = band ? bands_about(path, "90 % of the truth, as the samples tell", *band) : Bands();
  bands["w"] = band_of_rate(source);
  return bands;
}

report::PageMethod smoothed_one(const Source& source, const PoseCurve& curve) {
  const Keyframes& samples = source.curves.recording;
  const auto errors = errors_at(curve, path_of(samples));
  const Measures distances{.distance =
                               distance_to_reference(curve.orientation, {samples.times(), samples.orientations()})};
  const auto accepted = accepted_ones(errors, source.smoothing);
  report::PageMethod method =
      method_of(source, source.curves, {"smoothed", source.smoothed(), curve, distances}, smoothed_method);
  method.measures.emplace(rms_of_accepted, root_mean_square(accepted.values));
  method.bands = bands_of(source, method.samples.path);
  return with_errors(std::move(method), accepted, source.curves.covers);
}

/// It passes all samples: distances say nothing.
report::PageMethod as_read(const Source& source) {
  const Keyframes& samples = source.curves.recording;
  const auto curve = curve_beside_jumps(default_method, samples);
  if (!curve) return {.name = "as read", .failure = describe(curve.error())};
  const CurvePage shape{.recording = samples,
                        .measures = without_angle_travelled(measures_of({MeasureGroup::shape})),
                        .covers = source.curves.covers};
  return method_of(source, shape, {"as read", samples, *curve, {}}, default_method);
}

/// The rejected samples, with how far they are from the smoothed curve.
std::optional<report::PageMarks> marks_of(const Source& source, const Keyframes& recording, const PoseCurve& curve) {
  const auto& rejected = source.smoothing.rejected;
  if (rejected.empty()) return std::nullopt;
  report::PageMarks marks{.label = "rejected",
                          .path = report::thinned(path_of(recording.at(rejected)), samples_of_few)};
  marks.errors = errors_at(curve, marks.path).values;
  return marks;
}

std::vector<std::string> notes_of(const Smoothing& smoothing) {
  std::vector<std::string> notes{formatted(
      "'as read' is the curve of {} through all samples. Errors are measured at the samples.", default_method)};
  if (const std::size_t rejected = smoothing.rejected.size(); rejected > 0)
    notes.push_back(formatted("{} as outliers and marked with a cross{}; the line of errors leaves them out.",
                              counted(rejected, "sample") + (rejected == 1 ? " is rejected" : " are rejected"),
                              rejected > samples_of_few ? formatted(", {} of them", samples_of_few) : ""));
  if (smoothing.sigmas)
    notes.emplace_back(
        "Bands of angles and errors are meant to hold 90 % of the truth; that of the angular velocity is one standard "
        "deviation of its length.");
  if (const std::size_t kept = smoothing.retained_outlier_runs.size(); kept > 0)
    notes.push_back(formatted(
        "{} far from what the others predict, and so are the samples beside or many others: they are kept as motion.",
        counted(kept, "sample") + (kept == 1 ? " is" : " are")));
  if (smoothing.stretches.size() > 1)
    notes.push_back(formatted("The gaps leave {} stretches. In a gap there is no curve, and nothing is measured.",
                              smoothing.stretches.size()));
  if (const std::size_t few = smoothing.samples_in_short_stretches.size(); few > 0)
    notes.push_back(formatted("{} left out, because too few lie between two gaps.",
                              counted(few, "sample") + (few == 1 ? " is" : " are")));
  return notes;
}

std::string title_of(const Track& recording, const Smoothing& smoothing) {
  return formatted("{} smoothed: {}, {} rejected, smoothing time {:.4g} s (cut-off {:.4g} Hz)",
                   file_name_of(recording.name), counted(recording.keys.size(), "sample"), smoothing.rejected.size(),
                   smoothing.smoothing_time, smoothing.cutoff());
}

/// Measures of all samples, and of the accepted ones where some are not.
std::vector<report::PageColumn> columns_of(const CurvePage& curves, const Smoothing& smoothing) {
  std::vector<report::PageColumn> columns = measure_columns(curves.measures);
  if (!smoothing.rejected.empty())
    columns.insert(columns.begin() + 1,
                   {std::string(rms_of_accepted), "RMS of the accepted", "deg",
                    "Root mean square of the angle to the samples that are not rejected", Better::less});
  return columns;
}

}  // namespace

report::Page smooth_page(const Track& recording, const Smoothing& smoothing, const PageHead& head) {
  const CurvePage curves{
      .recording = recording.keys.at(smoothing.keys),
      .measures = without_angle_travelled(measures_of({MeasureGroup::distance, MeasureGroup::shape})),
      .covers = [&](double t) { return smoothing.covers(t); }};
  const Source source{smoothing, curves};
  report::Page page = begun_page(title_of(recording, smoothing), head, recording.epoch, source.smoothed());
  std::ranges::move(notes_of(smoothing), std::back_inserter(page.notes));
  std::ranges::move(notes_on_samples(curves.recording.size()), std::back_inserter(page.notes));
  page.reference = report::with_gaps(report::thinned(path_of(recording.keys), samples_of_few), source.curves.covers);
  page.columns = columns_of(curves, smoothing);
  const auto curve = curve_beside_jumps(smoothed_method, source.smoothed());
  if (!curve) return page.methods = {{.name = "smoothed", .failure = describe(curve.error())}}, page;
  page.marks = marks_of(source, recording.keys, *curve);
  page.methods.resize(2);
  parallel_for(2, 0, [&](std::size_t i) { page.methods[i] = i == 0 ? smoothed_one(source, *curve) : as_read(source); });
  return page;
}

}}}  // namespace orispline::pages
