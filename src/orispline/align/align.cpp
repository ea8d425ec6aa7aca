// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/align.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <Eigen/Core>

#include <orispline/align/alignment_fit.hpp>
#include <orispline/align/alignment_guess.hpp>
#include <orispline/align/clock_search.hpp>
#include <orispline/align/steady_samples.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/frame_change.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double farthest_median = 30.0 / degrees;  // [rad]: what motions that are not the same come to
constexpr int decimals_of_offset = 9;               // whole nanoseconds, as stamps have them
constexpr double poor_ratio = 3.0;                  // residuals beside the noise of both recordings
constexpr double least_poor_noise = 0.1 / degrees;  // [rad]

/// A recording as a smooth curve, and the noise that was found in it [rad].
struct SmoothMotion {
  PoseCurve curve;
  double noise;
};

/// Interpolated samples would have less noise between them than at them, which draws the offset to half of an interval.
Expected<SmoothMotion> smooth_motion(const Track& recording, const Progress& progress) {
  if (recording.keys.size() < least_aligned)
    return tl::unexpected(recording.located(
        {.code = ErrorCode::bad_data,
         .message = formatted("found {} orientations, wanted {} at least", recording.keys.size(), least_aligned)}));
  auto smoothed = smooth(recording.at(steady_samples(recording.keys)), {}, progress);
  if (!smoothed) return tl::unexpected(std::move(smoothed.error()));
  auto curve = make_pose_curve(smoothed->method, smoothed->track.keys);
  if (!curve) return tl::unexpected(std::move(curve.error()));
  return SmoothMotion{std::move(*curve), smoothed->local_noise};
}

/// Samples no denser than this: what lies between two samples of the other recording is known from both of them, and
/// says nothing new.
std::vector<std::size_t> no_denser_than(double interval, std::span<const double> times) {
  std::vector<std::size_t> some{0};
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] - times[some.back()] >= 0.999 * interval) some.push_back(i);
  return some;
}

BestOfOffsets<AlignmentFit> fits_from(std::span<const double> offsets, const AlignmentData& data, const AnyCurve& fixed,
                                      double interval) {
  BestOfOffsets<AlignmentFit> fits;
  for (const double offset : offsets)
    if (const auto guess = guess_alignment(data, fixed, interval, offset)) fits.add(fit_alignment(data, *guess));
  return fits;
}

std::string parts_text(const OpenDirection& open) {
  std::vector<std::string> parts;
  const auto turn = [&](const Eigen::Vector3d& v, std::string_view whose) {
    if (v.norm() <= told_from) return;
    const Eigen::Vector3d axis = (1e3 * v.normalized()).array().round() / 1e3 + 0.0;  // and no negative zero
    parts.push_back(formatted("a turn of the {} about ({}, {}, {})", whose, axis.x(), axis.y(), axis.z()));
  };
  turn(open.world, "world");
  turn(open.body, "body");
  if (leaves_offset(open)) parts.emplace_back("the offset of the clocks");
  if (std::abs(open.scale) > told_from) parts.emplace_back("the scale");
  if (open.translation.norm() > told_from) parts.emplace_back("the translation");
  return joined(parts, ", ");
}

std::vector<Warning> warnings_of(const Alignment& alignment, const SmoothMotion& moved, const SmoothMotion& fixed) {
  std::vector<Warning> warnings;
  for (const OpenDirection& open : alignment.open)
    warnings.push_back({.code = "open_alignment",
                        .message = formatted("the recordings do not tell apart: {}; what cannot be told is left as it "
                                             "was, and motion about other axes would tell it",
                                             parts_text(open))});
  const double expected = std::sqrt(moved.noise * moved.noise + fixed.noise * fixed.noise);
  if (alignment.noise > std::max(poor_ratio * expected, least_poor_noise))
    warnings.push_back({.code = "poor_alignment",
                        .message = formatted("the aligned recordings stay {:.3g}° apart per axis, and their own noise "
                                             "explains {:.3g}°: constant rotations and an offset of the clocks are not "
                                             "all that lies between them; one of them may drift, as a gyro's does, or "
                                             "they are of two motions",
                                             alignment.noise * degrees, expected * degrees),
                        .numbers = {{"noise_deg", alignment.noise * degrees}, {"expected_deg", expected * degrees}}});
  return warnings;
}

Alignment alignment_of(AlignmentFit fit, std::span<const std::size_t> samples, bool has_positions) {
  const auto named = [&](std::vector<std::size_t> indices) {
    for (std::size_t& i : indices) i = samples[i];
    return indices;
  };
  Alignment alignment{.world = fit.transform.world,
                      .body = fit.transform.body,
                      .sigmas = fit.sigmas,
                      .open = std::move(fit.open),
                      .compared = named(std::move(fit.compared)),
                      .rejected = named(std::move(fit.rejected)),
                      .distance = distance_statistics(std::move(fit.angles)),
                      .noise = fit.noise};
  for (Eigen::Quaterniond* q : {&alignment.world, &alignment.body})
    if (q->w() < 0.0) q->coeffs() = -q->coeffs();
  if (!has_positions) return alignment;
  alignment.scale = fit.transform.scale;
  alignment.translation = fit.transform.translation;
  alignment.position_distance = distance_statistics(std::move(fit.distances));
  alignment.position_noise = fit.position_noise;
  return alignment;
}

/// The offsets to begin with, of times that count from the epochs: none, and those at which the motions are alike.
std::vector<double> offsets_to_try(const SmoothMotion& moved, const SmoothMotion& fixed, const AlignOptions& options,
                                   double interval, double between_epochs) {
  std::vector<double> offsets{options.offset.value_or(0.0) - between_epochs};
  if (options.offset) return offsets;
  const auto likely = offsets_in_question(moved.curve.orientation, fixed.curve.orientation, interval);
  offsets.insert(offsets.end(), likely.begin(), likely.end());
  return offsets;
}

tl::unexpected<Error> too_little_overlap(const Track& moved, const Track& fixed, const AlignOptions& options) {
  const auto span = [](const Track& track) {
    return track.span_text(track.time_of(0), track.time_of(track.keys.size() - 1));
  };
  const std::string found =
      formatted("found recordings from {} and from {}, of which fewer than {} samples lie side by side", span(moved),
                span(fixed), least_aligned);
  if (options.offset)
    return bad_option("offset", found + " with it, wanted an offset that brings them together, or none");
  return failure(ErrorCode::bad_data, found + ", wanted two recordings of one motion at one time");
}

}  // namespace

Expected<Alignment> align(const Track& moved, const Track& fixed, const AlignOptions& options,
                          const Progress& progress) {
  if (options.offset && !std::isfinite(*options.offset))
    return bad_option("offset", formatted("found {}, wanted a finite time [s]", *options.offset));
  const auto moved_motion = smooth_motion(moved, progress);
  if (!moved_motion) return tl::unexpected(moved_motion.error());
  const auto fixed_motion = smooth_motion(fixed, progress);
  if (!fixed_motion) return tl::unexpected(fixed_motion.error());
  const double moved_interval = median_interval(moved.keys.times());
  const double interval = std::max(moved_interval, median_interval(fixed.keys.times()));
  const auto samples = no_denser_than(moved_interval, fixed.keys.times());
  const AlignmentData data{.moved = moved_motion->curve,
                           .fixed = fixed.keys.at(samples),
                           .has_positions = moved_motion->curve.position && !fixed.keys.positions().empty(),
                           .options = options};
  const Decimal between_epochs = moved.epoch - fixed.epoch;
  const auto fits =
      fits_from(offsets_to_try(*moved_motion, *fixed_motion, options, interval, between_epochs.to_double()), data,
                fixed_motion->curve.orientation, interval);
  if (!fits.best()) return too_little_overlap(moved, fixed, options);
  const double found = fits.best()->transform.offset;
  Alignment alignment = alignment_of(*fits.best(), samples, data.has_positions);
  alignment.offset = options.offset ? Decimal::from_double(*options.offset)
                                    : (Decimal::from_double(found) + between_epochs).rounded(decimals_of_offset);
  if (alignment.distance.median > farthest_median)
    return failure(ErrorCode::bad_data,
                   formatted("half of the orientations stay farther than {:.3g}° apart however they are turned and "
                             "delayed, wanted two recordings of one motion",
                             alignment.distance.median * degrees));
  alignment.warnings = warnings_of(alignment, *moved_motion, *fixed_motion);
  warn_of_rival(alignment, fits, interval);
  return alignment;
}

Expected<Track> aligned(const Track& moved, const Track& fixed, const Alignment& alignment) {
  auto turned = in_frames(moved, {.world = {.rotation = alignment.world}, .body = {.rotation = alignment.body}});
  if (!turned) return turned;
  KeyframeData data = turned->keys.data();
  for (std::size_t i = 0; i < data.times.size(); ++i)
    data.times[i] = (moved.time_of(i) - alignment.offset - fixed.epoch).to_double();
  if (alignment.translation)
    for (Eigen::Vector3d& p : data.positions) p = *alignment.scale * p + *alignment.translation;
  for (Decimal& time : turned->exact_times) time = time - alignment.offset;
  for (double& time : turned->positions_apart.times)
    time = (moved.epoch + Decimal::from_double(time) - alignment.offset - fixed.epoch).to_double();
  turned->as_read.clear();
  turned->epoch = fixed.epoch;
  turned->is_dated = fixed.is_dated;
  return Keyframes::make(std::move(data), Signs::as_given).map([&](const Keyframes& there) {
    return turned->with_keys(there);
  });
}

}}  // namespace orispline
