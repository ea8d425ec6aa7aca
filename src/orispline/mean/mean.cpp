// SPDX-License-Identifier: Apache-2.0
#include <orispline/mean/mean.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include <Eigen/LU>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/eigensystem.hpp>
#include <orispline/mean/axis_median.hpp>
#include <orispline/mean/descent.hpp>
#include <orispline/mean/only_one.hpp>
#include <orispline/mean/rough_sums.hpp>
#include <orispline/mean/smallest_ball.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using mean_of::AxisMedian;
using mean_of::Ball;
using mean_of::Descent;
using mean_of::Found;
using mean_of::Weighted;

constexpr double half_pi = 0.5 * std::numbers::pi;
constexpr double at_rest = 1e-12;  // residual
/// Of that across: with less, as where all but turn about one axis, few samples tell how certain a median is along it.
constexpr double least_curvature = 0.01;

Expected<void> check(const OrientationSet& given) {
  const std::size_t count = given.orientations.size();
  if (count == 0) return failure(ErrorCode::bad_data, "found no orientations, wanted one at least");
  for (const auto& [what, size] :
       {std::pair("position", given.positions.size()), std::pair("weight", given.weights.size())})
    if (size != 0 && size != count)
      return failure(ErrorCode::bad_data, formatted("found {} of {}, wanted one of each", counted(size, what),
                                                    counted(count, "orientation")));
  for (std::size_t k = 0; k < count; ++k) {
    if (const double norm = given.orientations[k].norm(); !(std::abs(norm - 1.0) <= norm_error_limit))
      return failure(ErrorCode::bad_data, formatted("the quaternion has norm {:.6g}, wanted 1 within 0.001", norm),
                     {.key = k});
    if (!given.positions.empty() &&
        !(given.positions[k].allFinite() && given.positions[k].cwiseAbs().maxCoeff() <= largest_component))
      return failure(ErrorCode::bad_data, "found a position that is not finite or above 1e18, wanted numbers",
                     {.key = k});
    if (!given.weights.empty() && !(given.weights[k] >= 0.0 && std::isfinite(given.weights[k])))
      return failure(ErrorCode::bad_data,
                     formatted("found the weight {}, wanted 0 or a number above it", given.weights[k]), {.key = k});
  }
  return {};
}

/// The entries with a weight, and where they are in the lists that were given.
struct WithWeight {
  std::vector<std::size_t> indices{};
  std::vector<double> weights{};  ///< their sum is 1
  double sum = 0.0;               ///< of the weights as they were given
};

Expected<WithWeight> with_weight_in(const OrientationSet& given) {
  WithWeight heavy;
  const bool alike = given.weights.empty();
  for (std::size_t k = 0; k < given.orientations.size(); ++k) {
    const double weight = alike ? 1.0 : given.weights[k];
    heavy.sum += weight;
    if (weight > 0.0) heavy.indices.push_back(k), heavy.weights.push_back(weight);
  }
  if (heavy.indices.empty())
    return failure(ErrorCode::bad_data, "found the weight 0 at every orientation, wanted one above 0 at least");
  if (!std::isfinite(heavy.sum))
    return failure(ErrorCode::bad_data, "found weights whose sum is not finite, wanted smaller ones");
  for (double& weight : heavy.weights) weight /= heavy.sum;
  return heavy;
}

template <CurvePoint P>
Weighted<P> weighted(std::span<const P> all, const WithWeight& heavy) {
  Weighted<P> given{.weights = heavy.weights};
  for (const std::size_t k : heavy.indices) {
    if constexpr (std::same_as<P, Eigen::Quaterniond>) given.points.push_back(all[k].normalized());
    else given.points.push_back(all[k]);
  }
  return given;
}

/// Where a search begins: for orientations the unit quaternion of the largest Σ w (q·p)², which is the mean of squared
/// chords; nothing where several are equally good. Source: Markley, Cheng, Crassidis, Oshman 2007.
std::optional<Eigen::Quaterniond> start_of(const Weighted<Eigen::Quaterniond>& given) {
  Eigen::Matrix4d moments = Eigen::Matrix4d::Zero();
  for (std::size_t k = 0; k < given.size(); ++k) {
    const Eigen::Vector4d q = given.points[k].coeffs();
    moments += given.weights[k] * q * q.transpose();
  }
  const Eigensystem<4> axes = eigensystem<4>(moments);
  if (axes.values[3] - axes.values[2] <= 1e-9) return std::nullopt;
  return Eigen::Quaterniond(Eigen::Vector4d(axes.vectors.col(3).normalized()));
}
std::optional<Eigen::Vector3d> start_of(const Weighted<Eigen::Vector3d>& given) {
  mean_of::VectorSum sum;
  for (std::size_t k = 0; k < given.size(); ++k) sum.add(given.weights[k] * given.points[k]);
  return sum.value();
}

/// The best place to begin where there may be several valleys: some of the points themselves are tried beside their
/// middle, which bad points, half of all, may have drawn far away.
Eigen::Quaterniond best_start(MeanKind kind, const Weighted<Eigen::Quaterniond>& given,
                              const Eigen::Quaterniond& middle) {
  constexpr std::size_t most_ways = 1000000, fewest_tried = 20;
  const std::size_t tried = std::min(given.size(), std::max(fewest_tried, most_ways / given.size()));
  const mean_of::RoughSums sums(kind, given);
  Eigen::Quaterniond best = middle;
  double least = sums.at(middle, std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < tried; ++i) {
    const Eigen::Quaterniond& point = given.points[i * given.size() / tried];
    if (const double sum = sums.at(point, least); sum < least) least = sum, best = point;
  }
  return best;
}

/// The mean or the median, and how far others go that are as good, where all lie on an axis.
template <CurvePoint P>
struct Middle {
  Found<P> found;
  double half_range = 0.0;
};

template <CurvePoint P>
Middle<P> middle_of(MeanKind kind, const Weighted<P>& given, const P& start) {
  if constexpr (std::same_as<P, Eigen::Quaterniond>)
    if (kind == MeanKind::chordal) return {{{start, mean_of::chordal_pull_at(given, start)}}};
  if (kind == MeanKind::median)
    if (const auto axis = mean_of::common_axis(given, start)) {
      const AxisMedian<P> median = mean_of::median_on_axis(given, start, *axis);
      return {{{median.point, mean_of::pull_at(kind, given, median.point)}}, median.half_range};
    }
  return {Descent<P>(kind, given).from(start)};
}

/// How many equal weights say as much.
double effective_count(const std::vector<double>& weights) {
  return 1.0 / std::inner_product(weights.begin(), weights.end(), weights.begin(), 0.0);
}

/// What a point at that distance pulls at the middle, over the distance and squared.
template <CurvePoint P>
double score_of(MeanKind kind, double distance) {
  if (kind == MeanKind::median) return 1.0 / (distance * distance);
  if (kind == MeanKind::mean || std::same_as<P, Eigen::Vector3d>) return 1.0;
  double sine, cosine;
  sin_cos(distance, sine, cosine);
  return sine * sine / (distance * distance);
}

/// How far points are from their middle.
struct Distances {
  double rms = 0.0, largest = 0.0;
  std::size_t farthest = 0;
  std::optional<Eigen::Matrix3d> spread{}, covariance{};
};

template <CurvePoint P>
Distances distances_from(MeanKind kind, const Weighted<P>& given, const Middle<P>& middle) {
  Distances found;
  const P& point = middle.found.place.point;
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero(), scores = Eigen::Matrix3d::Zero();
  double squares = 0.0;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const mean_of::Way way = mean_of::way_to(point, given.points[k]);
    const double weight = given.weights[k], square = way.length * way.length;
    if (way.length > found.largest) found.largest = way.length, found.farthest = k;
    squares += weight * square;
    const Eigen::Matrix3d products = weight * way.vector * way.vector.transpose();
    moments += products;
    if (way.length > mean_of::rounding_of(point)) scores += score_of<P>(kind, way.length) * products;
  }
  found.rms = std::sqrt(squares);
  const double count = effective_count(given.weights);
  if (!(count > 1.0 + 1e-9)) return found;
  found.spread = count / (count - 1.0) * moments;
  const Eigen::Matrix3d& hessian = middle.found.place.pull.hessian;
  const Eigen::Vector3d curvatures = eigensystem<3>(hessian).values;
  const bool is_flat = middle.half_range > 0.0 || !(curvatures[0] > least_curvature * curvatures[2]);
  if (found.largest == 0.0) found.covariance = Eigen::Matrix3d::Zero();
  else if (!is_flat) {
    const Eigen::Matrix3d inverse = hessian.inverse();
    const Eigen::Matrix3d covariance = inverse * scores * inverse / (count - 1.0);
    found.covariance = 0.5 * (covariance + covariance.transpose());
  }
  return found;
}

/// No median is farther from this place [rad]: beyond, the share of the weight that is near it outweighs all else.
/// Nothing where there is no such share. Proof: docs/mean.md.
std::optional<double> others_within(const Weighted<Eigen::Quaterniond>& given, const Eigen::Quaterniond& median) {
  std::vector<std::pair<double, double>> distances;
  for (std::size_t k = 0; k < given.size(); ++k)
    distances.emplace_back(angular_distance(median, given.points[k]), given.weights[k]);
  std::ranges::sort(distances);
  std::optional<double> least;
  double weight = 0.0, moment = 0.0;
  for (const auto& [distance, its_weight] : distances) {
    weight += its_weight;
    moment += its_weight * distance;
    if (weight <= 0.5 + 1e-9) continue;
    const double bound = 2.0 * moment / (2.0 * weight - 1.0);
    if (!least || bound < *least) least = bound;
  }
  return least && *least < std::numbers::pi ? least : std::nullopt;
}

/// What is proved of a middle that is at rest: how far others are that are as good. Nothing where that is not known.
/// Proofs: docs/mean.md.
std::optional<double> proved_within(MeanKind kind, const Weighted<Eigen::Quaterniond>& given,
                                    const Eigen::Quaterniond& q, double half_range, const Ball& ball) {
  if (kind == MeanKind::chordal) return 0.0;  // for one eigenvalue is larger than all others
  if (ball.radius < half_pi && angular_distance(ball.centre, q) <= ball.radius + at_rest) return half_range;
  if (kind == MeanKind::mean) return mean_of::is_only_mean(given, q) ? std::optional(0.0) : std::nullopt;
  if (half_range != 0.0) return std::nullopt;
  const auto within = others_within(given, q);
  // The sum is convex as far as that: the median that was found is the only one.
  const double reach = within.value_or(std::numbers::pi);
  const double largest = mean_of::ball_round(q, given.points).radius;
  return reach < half_pi && reach + largest < std::numbers::pi ? std::optional(0.0) : within;
}

/// A middle, and how far others are that are as good, as far as that is known.
struct Judged {
  Middle<Eigen::Quaterniond> middle;
  std::optional<double> others_within;
};

/// The middle below a start where it can be proved to be the best; else that below the best start.
Judged judged_middle(MeanKind kind, const Weighted<Eigen::Quaterniond>& given, const Eigen::Quaterniond& start,
                     const Ball& ball) {
  const auto below = [&](const Eigen::Quaterniond& beginning) {
    Judged found{middle_of(kind, given, beginning), {}};
    const auto& [q, pull] = found.middle.found.place;
    if (kind == MeanKind::chordal || pull.residual() <= at_rest)
      found.others_within = proved_within(kind, given, q, found.middle.half_range, ball);
    return found;
  };
  const bool is_hopeful = proved_within(kind, given, start, 0.0, ball) == 0.0;  // for the middle is not far from it
  if (is_hopeful)
    if (Judged found = below(start); found.others_within == found.middle.half_range) return found;
  return below(best_start(kind, given, start));
}

Warning not_certified(const Mean& found, MeanKind kind) {
  std::string message = formatted(
      "found orientations that no ball of less than 90° holds, up to {:.4g}° from their {}: there may be another that "
      "is "
      "as good or better",
      found.largest_distance * degrees, word_of(kind));
  if (found.others_within) message += formatted(", within {:.4g}° of it", *found.others_within * degrees);
  return {.code = "mean_not_certified",
          .message = std::move(message),
          .numbers = {{"largest_distance_deg", found.largest_distance * degrees}}};
}

Warning of_a_range(double half_range) {
  return {.code = "median_of_a_range",
          .message = formatted("found orientations about one axis of which half are on either side: every one within "
                               "{:.4g}° along it is a median as well, and the middle of them is given",
                               half_range * degrees),
          .numbers = {{"half_range_deg", half_range * degrees}}};
}

Error cancelling(MeanKind kind) {
  return {ErrorCode::bad_data,
          formatted("found orientations that cancel, such as two that are 180° apart: several are their {} alike, "
                    "wanted some that agree, or weights that prefer some",
                    word_of(kind))};
}

void add_positions(Mean& found, MeanKind kind, const OrientationSet& given, const WithWeight& heavy) {
  const auto positions = weighted(given.positions, heavy);
  const auto middle = middle_of(kind, positions, *start_of(positions));
  const Distances distances = distances_from(kind, positions, middle);
  found.position = middle.found.place.point;
  found.position_rms_distance = distances.rms;
  found.position_largest_distance = distances.largest;
  found.farthest_position = heavy.indices[distances.farthest];
  found.position_spread = distances.spread;
  found.position_covariance = distances.covariance;
}

std::optional<Eigen::Vector3d> deviations(const std::optional<Eigen::Matrix3d>& covariance) {
  if (!covariance) return std::nullopt;
  return Eigen::Vector3d(covariance->diagonal().cwiseMax(0.0).cwiseSqrt());
}

Eigen::Quaterniond with_positive_scalar(const Eigen::Quaterniond& q) {
  const Eigen::Vector4d zero = Eigen::Vector4d::Zero();
  return Eigen::Quaterniond(q.w() < 0.0 ? Eigen::Vector4d(zero - q.coeffs())
                                        : Eigen::Vector4d(zero + q.coeffs()));  // no -0
}

/// What a search begins with.
struct Beginning {
  WithWeight heavy;
  Weighted<Eigen::Quaterniond> orientations;
  Eigen::Quaterniond start;
};

Expected<Beginning> beginning_of(const OrientationSet& given, MeanKind kind) {
  if (auto checked = check(given); !checked) return tl::unexpected(std::move(checked.error()));
  auto heavy = with_weight_in(given);
  if (!heavy) return tl::unexpected(heavy.error());
  auto orientations = weighted(given.orientations, *heavy);
  const auto start = start_of(orientations);
  if (!start) return tl::unexpected(cancelling(kind));
  return Beginning{std::move(*heavy), std::move(orientations), *start};
}

}  // namespace

std::optional<Eigen::Vector3d> sigma_of(const Mean& mean) { return deviations(mean.covariance); }
std::optional<Eigen::Vector3d> position_sigma_of(const Mean& mean) { return deviations(mean.position_covariance); }

Expected<Mean> mean(const OrientationSet& given, const MeanOptions& options) {
  const auto beginning = beginning_of(given, options.kind);
  if (!beginning) return tl::unexpected(beginning.error());
  const auto& [heavy, orientations, start] = *beginning;
  const Ball ball = mean_of::smallest_ball(orientations.points);
  const auto [middle, others] = judged_middle(options.kind, orientations, start, ball);
  const Distances distances = distances_from(options.kind, orientations, middle);
  Mean found{.orientation = with_positive_scalar(middle.found.place.point),
             .count = orientations.size(),
             .weight = heavy.sum,
             .certified = others == 0.0,
             .ball_radius = std::min(ball.radius, distances.largest),
             .others_within = others,
             .residual = middle.found.place.pull.residual(),
             .iterations = middle.found.iterations,
             .rms_distance = distances.rms,
             .largest_distance = distances.largest,
             .farthest = heavy.indices[distances.farthest],
             .spread = distances.spread,
             .covariance = distances.covariance};
  if (middle.half_range > 0.0) found.warnings.push_back(of_a_range(middle.half_range));
  else if (!found.certified) found.warnings.push_back(not_certified(found, options.kind));
  if (!given.positions.empty()) add_positions(found, options.kind, given, heavy);
  return found;
}

Expected<Eigen::Quaterniond> chordal_mean(const OrientationSet& given) {
  return beginning_of(given, MeanKind::chordal).map([](const Beginning& beginning) {
    return with_positive_scalar(beginning.start);
  });
}

}}  // namespace orispline
