// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <orispline/analysis/measure_info.hpp>
#include <orispline/pages/task_pages.hpp>
#include <orispline/report/page_samples.hpp>

// What the pages have alike.

namespace orispline { inline namespace ORISPLINE_ABI { namespace pages {

/// A page that says what it is about, with the keys; of very many some, and a note that says so.
[[nodiscard]] report::Page begun_page(const std::string& title, const PageHead& head, const Decimal& epoch,
                                      const Keyframes& keys);

/// Orientations over time, all of them.
[[nodiscard]] report::PagePath path_of(std::span<const double> times, std::span<const Eigen::Quaterniond> orientations);
[[nodiscard]] report::PagePath path_of(const Keyframes& keys);

/// The columns of measures, the ones first that people look at first.
[[nodiscard]] std::vector<report::PageColumn> measure_columns(std::vector<MeasureInfo> measures);

/// Moments are told as all times of a page are: from the epoch on.
[[nodiscard]] constexpr MeasureTimes on_page(std::span<const double> recording) noexcept { return {{}, recording}; }

/// A curve as a page shows it, its torques too where the inertia [kg m²] is known.
[[nodiscard]] report::PageSamples samples_of(const PoseCurve& curve, const std::optional<Eigen::Matrix3d>& inertia,
                                             const report::Fineness& fineness);

/// `C2`
[[nodiscard]] std::string continuity_of(const Measures& measures);

/// A curve that a page shows, with its own keys.
struct ShownCurve {
  std::string name;
  Keyframes keys;
  PoseCurve curve;
  Measures measures;
};

/// What all curves of a page have alike.
struct CurvePage {
  Keyframes recording{};  ///< or keys, that the curves are measured against
  std::vector<MeasureInfo> measures{};
  std::optional<Eigen::Matrix3d> inertia{};  ///< [kg m²]: torques are shown too
  report::Covers covers{};                   ///< where there is a motion; absent: everywhere

  [[nodiscard]] RecordedMotion recorded() const {
    return {recording.times(), recording.orientations(), recording.angular_velocities()};
  }
};

/// How many samples of a curve, of a recording and of errors a page has at most where it has few curves.
inline constexpr std::size_t samples_of_few = 2000;

/// So many of the places of a list, or of fewer all, with both ends.
[[nodiscard]] std::vector<std::size_t> evenly_picked(std::size_t count, std::size_t most = samples_of_few);

/// The curve with its keys and measures, not yet with errors.
[[nodiscard]] report::PageMethod method_of(const CurvePage& page, const ShownCurve& curve);

/// One time more of a band, from `low` to `high` there; NaN ends the band before it.
void extend(report::PageBand& band, double t, double low, double high);

using Bands = std::map<std::string, report::PageBand, std::less<>>;

/// Where the truth may be within an angle [rad] of the path at each time: about the error, and about the angle from the
/// start. Nowhere where the angle is not finite.
[[nodiscard]] Bands bands_about(const report::PagePath& path, const std::string& label,
                                const std::function<double(double)>& radius);

/// Angles [deg] between the curve and a recording, at times of the recording that lie on the curve.
[[nodiscard]] report::PageErrors errors_at(const PoseCurve& curve, const report::PagePath& recording);

/// Whether a recording of these times has a motion at a time: it has none in intervals longer than the gap [s].
[[nodiscard]] report::Covers covers_of(std::span<const double> times, std::optional<double> gap);

/// What the head says where errors at so many samples are not all drawn.
[[nodiscard]] std::vector<std::string> notes_on_samples(std::size_t samples, std::size_t drawn = samples_of_few);

/// The method with the largest of these errors, and none over the gaps.
[[nodiscard]] report::PageMethod with_errors(report::PageMethod method, const report::PageErrors& errors,
                                             const report::Covers& covers);

}}}  // namespace orispline::pages
