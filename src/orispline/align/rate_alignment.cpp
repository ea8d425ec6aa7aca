// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/rate_alignment.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/align/clock_search.hpp>
#include <orispline/align/rate_fit.hpp>
#include <orispline/align/rate_motion.hpp>
#include <orispline/align/robust_equations.hpp>
#include <orispline/align/steady_samples.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/gyro_faults.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int most_fault_rounds = 3;  // of looking for faults beside an alignment, and of aligning without them
constexpr double poor_excess = 3.0;   // of what the noise of both explains
constexpr double least_poor_angle = 0.1 / degrees, least_poor_rate = 0.5 / degrees;  // [rad], [rad/s]
constexpr double nothing_in_common = 0.5;                                            // of how the rates vary
constexpr int decimals_of_rate_offset = 9;       // whole nanoseconds, as stamps have them
constexpr std::size_t most_open_of_turning = 3;  // beside a known offset; a body at rest leaves that open too

/// The orientations of a body and the smooth motion in them.
struct PoseMotion {
  std::vector<std::size_t> samples;  // of the recording, but for single wild ones
  Track steady;                      // of these
  Smoothing smoothing;
  AnyCurve curve;
};

Expected<PoseMotion> pose_motion(const Track& recording, const Progress& progress) {
  if (recording.keys.size() < least_aligned)
    return failure(ErrorCode::bad_data,
                   formatted("found {} orientations, wanted {} at least", recording.keys.size(), least_aligned));
  std::vector<std::size_t> samples = steady_samples(recording.keys);
  Track steady = recording.at(samples);
  auto smoothing = smooth(steady, {}, progress);
  if (!smoothing) return tl::unexpected(std::move(smoothing.error()));
  auto curve = make_curve(smoothing->method, smoothing->track.keys);
  if (!curve) return tl::unexpected(std::move(curve.error()));
  return PoseMotion{std::move(samples), std::move(steady), std::move(*smoothing), std::move(*curve)};
}

RateFitData data_beside(const GyroRates& gyro, const GyroMotion& motion, const PoseMotion& poses) {
  const auto times = poses.steady.keys.times();
  const auto orientations = poses.steady.keys.orientations();
  return {.gyro = gyro,
          .counts = motion.counts,
          .times = {times.begin(), times.end()},
          .orientations = {orientations.begin(), orientations.end()},
          .pieces = std::vector<std::size_t>(times.size(), 0),
          .noise = std::max(least_noise, poses.smoothing.noise),
          .walk = motion.walk(),
          .gyro_noise = motion.noise,
          .gyro_interval = motion.interval};
}

/// A gyro that is looked at beside a body, whichever of the two is to be moved.
struct Sides {
  const GyroMotion& gyro;
  const AnyCurve& body;
  double interval;         // [s], no shorter than samples of either are apart
  Decimal between_epochs;  // that of the gyro less that of the body
};

/// From every likely offset.
BestOfOffsets<RateFit> rate_fits(const Sides& sides, const RateFitData& data,
                                 const std::optional<double>& stated_offset) {
  std::vector<double> offsets{stated_offset.value_or(0.0) - sides.between_epochs.to_double()};
  if (!stated_offset) {
    const auto likely = offsets_in_question(sides.gyro.curve, sides.body, sides.interval);
    offsets.insert(offsets.end(), likely.begin(), likely.end());
  }
  BestOfOffsets<RateFit> fits;
  for (const double offset : offsets)
    if (const auto guess = guess_rates(sides.gyro.curve, sides.body, sides.interval, offset, data.finds_body))
      fits.add(fit_rates(data, *guess));
  return fits;
}

/// The rates that the orientations contradict do not count, and what is left is fitted anew.
void fit_without_faults(RateFit& fit, RateFitData& data, const PoseMotion& poses) {
  const Smoothing& smoothing = poses.smoothing;
  std::vector<bool> counts(smoothing.keys.size(), true);
  for (std::size_t i = 0; i < counts.size(); ++i)
    counts[i] = !std::ranges::binary_search(smoothing.rejected, smoothing.keys[i]);
  for (int round = 0; round < most_fault_rounds; ++round) {
    const Eigen::Quaterniond& mounting = fit.transform.body;
    SmoothedNodes of_gyro = smoothing.nodes;
    for (Eigen::Quaterniond& q : of_gyro.orientations) q = q * mounting;
    for (auto* vectors : {&of_gyro.angular_velocities, &of_gyro.angular_accelerations})
      for (Eigen::Vector3d& v : *vectors) v = to_body<double>(mounting, v);
    std::vector<double> times;
    std::vector<Eigen::Quaterniond> orientations;
    for (const std::size_t key : smoothing.keys) {
      times.push_back(data.times[key]);
      orientations.push_back(data.orientations[key] * mounting);
    }
    const SeenPoses seen{
        .times = times, .orientations = orientations, .counts = counts, .fitted = &of_gyro, .noise = data.noise};
    const GyroAlignment near{.offset = fit.transform.offset, .correction = fit.transform.correction};
    if (!leave_out_faults(seen, data.gyro, near, data.counts)) return;
    auto without = fit_rates(data, fit.transform);
    if (!without) return;
    fit = std::move(*without);
  }
}

Expected<void> check_fit(const RateFit& fit, const Sides& sides, const RateFitData& data) {
  const double apart = disagreement(sides.gyro.curve, sides.body, sides.interval, fit.transform);
  if (fit.excess > poor_excess && apart > nothing_in_common)
    return failure(ErrorCode::bad_data,
                   formatted("what is left between the rates of the recordings is {:.2g} of how these vary, however "
                             "they are turned and delayed, wanted two recordings of one motion",
                             apart));
  if (data.finds_body && data.finds_offset && fit.open.size() > most_open_of_turning)
    return failure(ErrorCode::bad_data,
                   "found no change of the rates that stands out of the noise, as where a body rests or turns evenly, "
                   "wanted one that turns to and fro, best about two axes or three");
  return {};
}

std::string parts_text(const OpenRateDirection& open) {
  const auto rounded = [](const Eigen::Vector3d& v) { return Eigen::Vector3d((1e3 * v).array().round() / 1e3 + 0.0); };
  std::vector<std::string> parts;
  if (open.body.norm() > told_from) {
    const Eigen::Vector3d axis = rounded(open.body.normalized());
    parts.push_back(formatted("a turn of the body about ({}, {}, {})", axis.x(), axis.y(), axis.z()));
  }
  if (leaves_offset(open)) parts.emplace_back("the offset of the clocks");
  if (open.bias.norm() > told_from) parts.emplace_back("the bias");
  return joined(parts, ", ");
}

void warn_of(RateAlignment& found, const RateFit& fit, bool has_poses) {
  for (const OpenRateDirection& open : found.open)
    found.warnings.push_back({.code = "open_alignment",
                              .message = formatted("the recordings do not tell apart: {}; what cannot be told is left "
                                                   "as it was, and motion about other axes would tell it",
                                                   parts_text(open))});
  const DistanceStatistics& left = has_poses ? *found.distance : *found.rate_distance;
  if (fit.excess <= poor_excess || left.median <= (has_poses ? least_poor_angle : least_poor_rate)) return;
  found.warnings.push_back(
      {.code = "poor_alignment",
       .message = formatted("what is left between the recordings is {:.2g} times what their noise explains, {:.3g} {} "
                            "in the median: a constant rotation, an offset of the clocks and a constant bias are not "
                            "all that lies between them; a gyro may have errors of scale, or a bias that drifts, or "
                            "the frame between the two is not rigid",
                            fit.excess, left.median * degrees, has_poses ? "°" : "°/s"),
       .numbers = {{"excess", fit.excess}}});
}

/// As the fit has it: the gyro is what is moved.
RateAlignment alignment_of(const RateFit& fit, const RateFitData& data, const Sides& sides, bool has_poses) {
  RateAlignment found{
      .body = fit.transform.body,
      .offset = (Decimal::from_double(fit.transform.offset) + sides.between_epochs).rounded(decimals_of_rate_offset),
      .bias = -fit.transform.correction,
      .body_sigma = fit.body_covariance.diagonal().cwiseMax(0.0).cwiseSqrt(),
      .offset_sigma = fit.offset_sigma,
      .bias_sigma = fit.correction_sigma,
      .compared = fit.compared.size(),
      .excess = fit.excess};
  for (const OpenRateStep& open : fit.open) found.open.push_back({open.body, open.offset, -open.correction});
  for (std::size_t k = 0; k < data.counts.size(); ++k)
    if (!data.counts[k]) found.rejected_moved.push_back(k);
  std::vector<double> left = fit.distances;
  if (!has_poses)
    for (std::size_t i = 0; i < left.size(); ++i) left[i] /= fit.steps[i];
  (has_poses ? found.distance : found.rate_distance) = distance_statistics(std::move(left));
  warn_of(found, fit, has_poses);
  return found;
}

/// The same where the body is moved onto the gyro.
RateAlignment the_other_way(RateAlignment found, const RateFit& fit) {
  const Eigen::Matrix3d turn = found.body.conjugate().toRotationMatrix();
  found.body_sigma = (turn * fit.body_covariance * turn.transpose()).diagonal().cwiseMax(0.0).cwiseSqrt();
  found.body = found.body.conjugate();
  found.offset = -found.offset;
  for (OpenRateDirection& open : found.open) {
    open.body = -(turn * open.body);
    open.offset = -open.offset;
  }
  std::swap(found.rejected_moved, found.rejected_fixed);
  return found;
}

RateAlignment with_signs(RateAlignment found, const AlignOptions& options) {
  if (found.body.w() < 0.0) found.body.coeffs() = -found.body.coeffs();
  if (options.offset) found.offset = Decimal::from_double(*options.offset);
  return found;
}

Expected<void> check_offset(const AlignOptions& options) {
  if (!options.offset || std::isfinite(*options.offset)) return {};
  return bad_option("offset", formatted("found {}, wanted a finite time [s]", *options.offset));
}

tl::unexpected<Error> too_few_turns(const AlignOptions& options, double interval) {
  const std::string found =
      formatted("found recordings of which fewer than {} turns of {:.3g} s lie side by side", least_aligned, interval);
  if (options.offset)
    return bad_option("offset", found + " with it, wanted an offset that brings them together, or none");
  return failure(ErrorCode::bad_data, found + ", wanted two recordings of one motion at one time");
}

/// The alignment of a gyro that is moved onto orientations, and the fit that it is of.
struct BesidePoses {
  RateFit fit;
  RateAlignment alignment;
};

Expected<BesidePoses> beside_poses(const GyroTrack& gyro, const Track& body, const AlignOptions& options,
                                   const std::optional<double>& offset, const Progress& progress) {
  if (auto checked = check_offset(options); !checked) return tl::unexpected(std::move(checked.error()));
  const auto motion = gyro_motion(gyro.rates);
  if (!motion) return tl::unexpected(motion.error());
  const auto poses = pose_motion(body, progress);
  if (!poses) return tl::unexpected(body.located(poses.error()));
  const Sides sides{.gyro = *motion,
                    .body = poses->curve,
                    .interval = std::max({least_turn_time, motion->interval, median_interval(body.keys.times())}),
                    .between_epochs = gyro.epoch - body.epoch};
  RateFitData data = data_beside(gyro.rates, *motion, *poses);
  data.finds_body = options.body_turn;
  data.finds_offset = !offset;
  const auto fits = rate_fits(sides, data, offset);
  std::optional<RateFit> fit = fits.best();
  if (!fit) return too_few_turns(options, sides.interval);
  fit_without_faults(*fit, data, *poses);
  if (auto checked = check_fit(*fit, sides, data); !checked) return tl::unexpected(std::move(checked.error()));
  RateAlignment found = alignment_of(*fit, data, sides, true);
  warn_of_rival(found, fits, sides.interval);
  std::vector<bool> is_steady(body.keys.size(), false);
  for (const std::size_t sample : poses->samples) is_steady[sample] = true;
  for (const std::size_t i : fit->rejected) is_steady[poses->samples[i]] = false;
  for (std::size_t i = 0; i < is_steady.size(); ++i)
    if (!is_steady[i]) found.rejected_fixed.push_back(i);
  return BesidePoses{std::move(*fit), std::move(found)};
}

/// Rates of the gyro that is not moved which do not count: wild ones, and those of turns that the other one
/// contradicts, where it contradicts the rates themselves.
std::vector<std::size_t> rejected_rates(const GyroRates& gyro, const GyroMotion& motion, const RateFit& fit,
                                        const RateFitData& data) {
  const GyroPath other(data.gyro, data.counts, fit.transform.correction);
  const double limit =
      rejected_from * fit.excess * std::sqrt(motion.noise * motion.noise + data.gyro_noise * data.gyro_noise);
  std::vector<std::size_t> rejected;
  std::size_t turn = 0;
  for (std::size_t k = 0; k < gyro.times.size(); ++k) {
    const double t = gyro.times[k];
    while (turn < fit.rejected.size() && data.times[fit.rejected[turn]] < t) ++turn;
    const bool is_in_turn = turn < fit.rejected.size() && data.times[fit.rejected[turn] - 1] < t;
    const auto rate = is_in_turn ? other.rate_at(t + fit.transform.offset) : std::nullopt;
    const bool is_far = rate && (to_world<double>(fit.transform.body, *rate) - gyro.rates[k]).norm() > limit;
    if (!motion.counts[k] || is_far) rejected.push_back(k);
  }
  return rejected;
}

}  // namespace

Decimal GyroTrack::time_of(std::size_t rate) const {
  return rates.exact_times.empty() ? epoch + Decimal::from_double(rates.times[rate]) : rates.exact_times[rate];
}

Expected<RateAlignment> align(const GyroTrack& moved, const GyroTrack& fixed, const AlignOptions& options,
                              const Progress& progress) {
  if (auto checked = check_offset(options); !checked) return tl::unexpected(std::move(checked.error()));
  const auto moved_motion = gyro_motion(moved.rates);
  if (!moved_motion) return tl::unexpected(moved_motion.error());
  const auto fixed_motion = gyro_motion(fixed.rates);
  if (!fixed_motion) return tl::unexpected(fixed_motion.error());
  if (progress.stopped()) return cancellation();
  const Sides sides{.gyro = *moved_motion,
                    .body = fixed_motion->curve,
                    .interval = std::max({least_turn_time, moved_motion->interval, fixed_motion->interval}),
                    .between_epochs = moved.epoch - fixed.epoch};
  RateFitData data = data_beside(moved.rates, *moved_motion, fixed.rates, *fixed_motion);
  data.finds_body = options.body_turn;
  data.finds_offset = !options.offset;
  const auto fits = rate_fits(sides, data, options.offset);
  const std::optional<RateFit>& fit = fits.best();
  if (!fit) return too_few_turns(options, sides.interval);
  if (auto checked = check_fit(*fit, sides, data); !checked) return tl::unexpected(std::move(checked.error()));
  RateAlignment found = alignment_of(*fit, data, sides, false);
  warn_of_rival(found, fits, sides.interval);
  found.rejected_fixed = rejected_rates(fixed.rates, *fixed_motion, *fit, data);
  return with_signs(std::move(found), options);
}

Expected<RateAlignment> align(const GyroTrack& moved, const Track& fixed, const AlignOptions& options,
                              const Progress& progress) {
  return beside_poses(moved, fixed, options, options.offset, progress).map([&](BesidePoses found) {
    return with_signs(std::move(found.alignment), options);
  });
}

Expected<RateAlignment> align(const Track& moved, const GyroTrack& fixed, const AlignOptions& options,
                              const Progress& progress) {
  const std::optional<double> offset = options.offset ? std::optional(-*options.offset) : std::nullopt;
  return beside_poses(fixed, moved, options, offset, progress).map([&](BesidePoses found) {
    return with_signs(the_other_way(std::move(found.alignment), found.fit), options);
  });
}

GyroTrack aligned(const GyroTrack& moved, const Decimal& fixed_epoch, const RateAlignment& alignment) {
  GyroTrack there{.rates = moved.rates, .epoch = fixed_epoch};
  for (Eigen::Vector3d& rate : there.rates.rates)
    rate = to_world<double>(alignment.body, Eigen::Vector3d(rate - alignment.bias));
  for (std::size_t k = 0; k < there.rates.times.size(); ++k)
    there.rates.times[k] = (moved.time_of(k) - alignment.offset - fixed_epoch).to_double();
  for (Decimal& time : there.rates.exact_times) time = time - alignment.offset;
  return there;
}

Expected<Track> aligned(const Track& moved, const GyroTrack& fixed, const RateAlignment& alignment) {
  Track on_clock;
  on_clock.epoch = fixed.epoch;
  on_clock.is_dated = fixed.is_dated;
  return aligned(moved, on_clock, Alignment{.body = alignment.body, .offset = alignment.offset});
}

}}  // namespace orispline
