// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/align.hpp>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <orispline/align/alignment_fit.hpp>
#include <orispline/align/clock_search.hpp>
#include <orispline/align/steady_rows.hpp>
#include <orispline/base/expect.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/curve/frame_change.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/median.hpp>
#include <orispline/mean/mean.hpp>
#include <orispline/smooth/smooth.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double farthest_median = 30.0 / degrees;  // [rad]: what motions that are not the same come to
constexpr int decimals_of_offset = 9;
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
  const auto steady = steady_samples(recording.keys);
  Track samples = recording.at(steady);
  samples.name = recording.name;
  auto smoothed = smooth(samples, {}, progress);
  if (!smoothed) return tl::unexpected(std::move(smoothed.error()));
  auto curve = make_pose_curve(smoothed->method, smoothed->track.keys);
  if (!curve) return tl::unexpected(std::move(curve.error()));
  return SmoothMotion{std::move(*curve), smoothed->local_noise};
}

/// The rotation that takes vectors to others with the least robust squares; about an axis that they leave open none.
///
/// Source: Horn 1987, of the largest eigenvector, here weighted anew by the distances that are left.
Eigen::Quaterniond rotation_between(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to) {
  constexpr int rounds = 15;
  constexpr double pull = 1e-3;  // towards no rotation, where all vectors have one axis
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  double sizes = 0.0;
  for (const Eigen::Vector3d& v : to) sizes += v.norm();
  const double least = 1e-3 * sizes / static_cast<double>(to.size());
  std::vector<double> weights(from.size(), 1.0);
  for (int round = 0; round < rounds; ++round) {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();  // of w, x, y, z
    double weight = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      const double dot = from[i].dot(to[i]);
      const Eigen::Vector3d cross = from[i].cross(to[i]);
      Eigen::Matrix4d form;
      form(0, 0) = dot;
      form.block<3, 1>(1, 0) = cross;
      form.block<1, 3>(0, 1) = cross.transpose();
      form.block<3, 3>(1, 1) =
          from[i] * to[i].transpose() + to[i] * from[i].transpose() - dot * Eigen::Matrix3d::Identity();
      sum += weights[i] * form;
      weight += weights[i] * (from[i].norm() * to[i].norm());
    }
    sum(0, 0) += pull * weight;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix4d> eigen(sum);
    const Eigen::Vector4d best = eigen.eigenvectors().col(3);
    rotation = Eigen::Quaterniond(best[0], best[1], best[2], best[3]).normalized();
    for (std::size_t i = 0; i < from.size(); ++i)
      weights[i] = 1.0 / std::max((to_world<double>(rotation, from[i]) - to[i]).norm(), least + 1e-300);
  }
  return rotation;
}

class Search {
 public:
  Search(const AlignmentData& data, const SmoothMotion& fixed, double interval)
      : data_(data), fixed_(fixed), interval_(interval) {}

  /// Rotations that suit an offset.
  [[nodiscard]] Expected<Transform> guess(double offset) const {
    Transform guess{.offset = offset};
    const Domain moved = data_.moved.orientation.domain(), fixed = fixed_.curve.orientation.domain();
    const double start = std::max(fixed.start, moved.start - offset), end = std::min(fixed.end, moved.end - offset);
    const double length = std::max(interval_, (end - start) / most_intervals);
    if (!(end - start >= length * static_cast<double>(least_aligned)))
      return failure(ErrorCode::bad_data, "the recordings do not overlap");
    const auto count = static_cast<std::size_t>((end - start) / length);
    if (data_.options.body_rotation && data_.options.world_rotation)
      guess.body = rotation_between(turns_in_intervals(data_.moved.orientation, start + offset, length, count),
                                    turns_in_intervals(fixed_.curve.orientation, start, length, count));
    if (!data_.options.world_rotation && !data_.options.body_rotation) return guess;
    std::vector<Eigen::Quaterniond> seen;
    for (std::size_t i = 0; i <= count; ++i) {
      const double t = start + static_cast<double>(i) * length;
      const Eigen::Quaterniond there = data_.moved.orientation(t + offset) * guess.body.conjugate();
      const Eigen::Quaterniond here = fixed_.curve.orientation(t);
      seen.push_back(data_.options.world_rotation ? here * there.conjugate() : here.conjugate() * there);
    }
    auto middle = mean({.orientations = seen}, {.kind = MeanKind::median});
    if (!middle) return tl::unexpected(std::move(middle.error()));
    (data_.options.world_rotation ? guess.world : guess.body) = middle->orientation;
    return guess;
  }

 private:
  static constexpr double most_intervals = 4096;
  const AlignmentData& data_;
  const SmoothMotion& fixed_;
  double interval_;
};

/// Scale and origin that suit the rotations: robust ratio of distances from the middle, and the middle that is left.
void place(Transform& guess, const AlignmentData& data) {
  if (!data.has_positions) return;
  const Domain domain = data.moved.orientation.domain();
  std::vector<Eigen::Vector3d> moved, fixed;
  const auto times = data.fixed.times();
  for (std::size_t i = 0; i < times.size(); ++i)
    if (const double t = times[i] + guess.offset; domain.contains(t)) {
      moved.push_back(to_world<double>(guess.world, data.moved.position->linear_motion(t).position));
      fixed.push_back(data.fixed.positions()[i]);
    }
  const auto middle_of = [](const std::vector<Eigen::Vector3d>& points) {
    Eigen::Vector3d middle;
    for (Eigen::Index k = 0; k < 3; ++k) {
      std::vector<double> coordinates;
      for (const Eigen::Vector3d& p : points) coordinates.push_back(p[k]);
      middle[k] = median(std::move(coordinates));
    }
    return middle;
  };
  const auto spread_of = [](const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& middle) {
    std::vector<double> distances;
    for (const Eigen::Vector3d& p : points) distances.push_back((p - middle).norm());
    return median(std::move(distances));
  };
  const Eigen::Vector3d middle_of_moved = middle_of(moved), middle_of_fixed = middle_of(fixed);
  const double spread = spread_of(moved, middle_of_moved);
  if (data.options.scale && spread > 0.0) guess.scale = spread_of(fixed, middle_of_fixed) / spread;
  if (!(guess.scale > 0.0)) guess.scale = 1.0;
  if (data.options.translation) guess.translation = middle_of_fixed - guess.scale * middle_of_moved;
}

/// Samples no denser than this: what lies between two samples of the other recording is known from both of them, and
/// says nothing new.
std::vector<std::size_t> no_denser_than(double interval, std::span<const double> times) {
  std::vector<std::size_t> some{0};
  for (std::size_t i = 1; i < times.size(); ++i)
    if (times[i] - times[some.back()] >= 0.999 * interval) some.push_back(i);
  return some;
}

/// Fits from every likely offset; the best.
Expected<AlignmentFit> best_fit(const AlignmentData& data, const SmoothMotion& fixed, double interval,
                                std::span<const double> offsets) {
  const Search search(data, fixed, interval);
  Expected<AlignmentFit> best = failure(ErrorCode::bad_data, "the recordings do not overlap");
  for (const double offset : offsets) {
    auto fit = search.guess(offset).and_then([&](Transform guess) {
      place(guess, data);
      return fit_alignment(data, guess);
    });
    if (!best || (fit && fit->cost() < best->cost())) best = std::move(fit);
  }
  return best;
}

std::string parts_text(const OpenDirection& open) {
  constexpr double told_from = 0.05;
  std::vector<std::string> parts;
  const auto turn = [&](const Eigen::Vector3d& v, std::string_view whose) {
    if (const double size = v.norm(); size > told_from)
      parts.push_back(formatted("a turn of the {} about ({:.3g}, {:.3g}, {:.3g})", whose, v.x() / size, v.y() / size,
                                v.z() / size));
  };
  turn(open.world, "world");
  turn(open.body, "body");
  if (std::abs(open.offset) > told_from) parts.emplace_back("the offset of the clocks");
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
                        .message = formatted("the aligned recordings stay {:.3g}° apart per axis, while their own "
                                             "noise explains {:.3g}°: they are not one motion but for constant "
                                             "rotations and an offset, such as a gyro that drifts",
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

/// With what was aligned where.
Error of_both(const Track& moved, const Track& fixed, const AlignOptions& options, Error error) {
  const auto span = [](const Track& track) {
    return track.span_text(track.time_of(0), track.time_of(track.keys.size() - 1));
  };
  error.message += formatted("; the recordings lie from {} and from {}", span(moved), span(fixed));
  if (options.offset) error.option = "offset";
  return error;
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
                           .options = options,
                           .is_offset_free = !options.offset};
  const Decimal between_epochs = moved.epoch - fixed.epoch;
  auto fit = best_fit(data, *fixed_motion, interval,
                      offsets_to_try(*moved_motion, *fixed_motion, options, interval, between_epochs.to_double()));
  if (!fit) return tl::unexpected(of_both(moved, fixed, options, std::move(fit.error())));
  const double found = fit->transform.offset;
  Alignment alignment = alignment_of(std::move(*fit), samples, data.has_positions);
  alignment.offset = options.offset ? Decimal::from_double(*options.offset)
                                    : (Decimal::from_double(found) + between_epochs).rounded(decimals_of_offset);
  if (alignment.distance.median > farthest_median)
    return failure(ErrorCode::bad_data,
                   formatted("half of the orientations stay farther than {:.3g}° apart however they are turned and "
                             "delayed, wanted two recordings of one motion",
                             alignment.distance.median * degrees));
  alignment.warnings = warnings_of(alignment, *moved_motion, *fixed_motion);
  return alignment;
}

Expected<Track> aligned(const Track& moved, const Alignment& alignment) {
  auto track = in_frames(moved, {.world = {.rotation = alignment.world}, .body = {.rotation = alignment.body}});
  if (!track) return track;
  track->epoch = moved.epoch - alignment.offset;
  for (Decimal& time : track->exact_times) time = time - alignment.offset;
  if (!alignment.translation) return track;
  const Keyframes& turned = track->keys;
  const auto copied = [](auto values) { return std::vector(values.begin(), values.end()); };
  KeyframeData data{.times = copied(turned.times()),
                    .orientations = copied(turned.orientations()),
                    .positions = copied(turned.positions()),
                    .angular_velocities = copied(turned.angular_velocities()),
                    .angular_accelerations = copied(turned.angular_accelerations()),
                    .angular_jerks = copied(turned.angular_jerks())};
  for (Eigen::Vector3d& p : data.positions) p = *alignment.scale * p + *alignment.translation;
  return Keyframes::make(std::move(data), Signs::as_given).map([&](const Keyframes& keys) {
    return track->with_keys(keys);
  });
}

}}  // namespace orispline
