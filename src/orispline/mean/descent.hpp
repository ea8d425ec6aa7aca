// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Eigen/Cholesky>

#include <orispline/mean/mean.hpp>
#include <orispline/mean/weighted.hpp>

// The point that makes a sum over weighted points least: ½ Σ w d² for the mean, Σ w d for the median, Σ w (1 − cos d)
// for the chordal mean. Written once for orientations and for positions. Proofs: docs/mean.md.

namespace orispline { inline namespace ORISPLINE_ABI { namespace mean_of {

/// What the sum does beside a point.
struct Pull {
  double sum = 0.0;
  Eigen::Vector3d towards = Eigen::Vector3d::Zero();  ///< less the gradient, without the points that are here
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();  ///< of the same points
  double bound = 0.0;        ///< of the curvature in every direction: a step `towards`/bound lowers the sum
  double weight_here = 0.0;  ///< of points that are here, of the median: there its sum has a corner
  std::size_t nearest = 0;
  double nearest_distance = std::numeric_limits<double>::infinity();

  /// Length of the gradient: 0 too in the corner of the points here, where their weight holds against all others.
  [[nodiscard]] double slope() const { return std::max(0.0, towards.norm() - weight_here); }
  /// Length of the safe step [rad] or [m]; of the mean that of the gradient.
  [[nodiscard]] double residual() const { return bound > 0.0 ? slope() / bound : 0.0; }
  /// By how much that step lowers the sum, at least.
  [[nodiscard]] double promised() const { return 0.5 * slope() * residual(); }
};

/// Points nearer than this are the same.
[[nodiscard]] inline double rounding_of(const Eigen::Quaterniond&) { return 1e-15; }
[[nodiscard]] inline double rounding_of(const Eigen::Vector3d& point) { return 4e-16 * norm_of<double>(point); }

template <CurvePoint P>
[[nodiscard]] Pull pull_at(MeanKind kind, const Weighted<P>& given, const P& point) {
  Pull pull;
  VectorSum towards;
  double across = 0.0;  // what the Hessian is in every direction, beside what it is along the ways
  for (std::size_t k = 0; k < given.size(); ++k) {
    const Way way = way_to(point, given.points[k]);
    const double weight = given.weights[k];
    if (way.length < pull.nearest_distance) pull.nearest = k, pull.nearest_distance = way.length;
    const Eigen::Vector3d direction = way.length > 0.0 ? Eigen::Vector3d(way.vector / way.length) : way.vector;
    if (kind != MeanKind::median) {
      pull.sum += 0.5 * weight * way.length * way.length;
      pull.bound += weight;
      across += weight * way.across;
      pull.hessian += weight * (1.0 - way.across) * direction * direction.transpose();
      towards.add(weight * way.vector);
    } else if (way.length <= rounding_of(point)) {
      pull.weight_here += weight;
    } else {
      const double curvature = weight / way.length * way.across;
      pull.sum += weight * way.length;
      pull.bound += weight / way.length;
      across += curvature;
      pull.hessian -= curvature * direction * direction.transpose();
      towards.add(weight * direction);
    }
  }
  pull.hessian.diagonal().array() += across;
  pull.towards = towards.value();
  return pull;
}

/// The same of the chordal mean, whose term is 2 sin²(θ/2) with the Hessian cos²(θ/2) across the way, cos θ along it.
[[nodiscard]] inline Pull chordal_pull_at(const Weighted<Eigen::Quaterniond>& given, const Eigen::Quaterniond& point) {
  Pull pull;
  VectorSum towards;
  double across = 0.0;
  for (std::size_t k = 0; k < given.size(); ++k) {
    const Eigen::Quaterniond turn = shortest_turn(point, given.points[k]);
    const double weight = given.weights[k];
    pull.sum += 2.0 * weight * turn.vec().squaredNorm();
    pull.bound += weight;
    across += weight * turn.w() * turn.w();
    pull.hessian -= weight * turn.vec() * turn.vec().transpose();
    towards.add(2.0 * weight * turn.w() * turn.vec());
  }
  pull.hessian.diagonal().array() += across;
  pull.towards = towards.value();
  return pull;
}

/// A point, and what the sum does there.
template <CurvePoint P>
struct Place {
  P point;
  Pull pull;
};

template <CurvePoint P>
struct Found {
  Place<P> place;
  std::size_t iterations = 0;
};

/// Goes down from a point until rounding stops it.
template <CurvePoint P>
class Descent {
 public:
  Descent(MeanKind kind, const Weighted<P>& given) : kind_(kind), given_(given) {}

  [[nodiscard]] Found<P> from(const P& start) const {
    constexpr std::size_t enough = 1000;  // steps; a handful reach rounding, but where a median is all but a sample
    Found<P> found{at(start)};
    for (; found.iterations < enough && found.place.pull.slope() > 0.0; ++found.iterations) {
      if (const auto sample = nearest_if_least(found.place.pull, 1.0 + 1e-12)) return {*sample, found.iterations};
      const auto next = stepped(found.place);
      if (!next) break;
      found.place = *next;
    }
    if (const auto sample = nearest_if_least(found.place.pull, 1.0 - 1e-9);
        sample && sample->pull.residual() < found.place.pull.residual())
      found.place = *sample;
    return found;
  }

 private:
  [[nodiscard]] Place<P> at(const P& point) const { return {point, pull_at(kind_, given_, point)}; }

  /// The nearest point of those given if it is the median, since its weight there holds against all others.
  [[nodiscard]] std::optional<Place<P>> nearest_if_least(const Pull& pull, double share) const {
    if (kind_ != MeanKind::median) return std::nullopt;
    const Place<P> sample = at(given_.points[pull.nearest]);
    const bool is_least = share * sample.pull.towards.norm() <= sample.pull.weight_here;
    return is_least ? std::optional(sample) : std::nullopt;
  }

  /// By Newton's step, else by the safe one, longer while that is better; nothing where rounding hides what is lower.
  [[nodiscard]] std::optional<Place<P>> stepped(const Place<P>& here) const {
    const Pull& pull = here.pull;
    if (pull.weight_here == 0.0) {
      const Eigen::Vector3d newton = pull.hessian.ldlt().solve(pull.towards);
      if (newton.allFinite())
        if (Place<P> there = at(moved(here.point, newton)); is_lower(here.pull, there.pull)) return there;
    }
    Eigen::Vector3d step = pull.residual() / pull.towards.norm() * pull.towards;
    std::optional<Place<P>> best;
    for (Place<P> there = at(moved(here.point, step)); is_below(best ? best->pull : pull, there.pull);
         there = at(moved(here.point, step)))
      best = there, step *= 4.0;
    return best;
  }

  /// By half of what is promised at least.
  [[nodiscard]] static bool is_lower(const Pull& here, const Pull& there) {
    const bool is_clear = here.promised() > rounding * here.sum;
    return is_clear ? there.sum <= here.sum - 0.5 * here.promised() : there.residual() < here.residual();
  }
  /// Near the end sums differ by their rounding alone: there the gradient decides.
  [[nodiscard]] static bool is_below(const Pull& here, const Pull& there) {
    const double lower = here.sum - there.sum;
    return lower > rounding * here.sum || (lower > -rounding * here.sum && there.residual() < here.residual());
  }

  static constexpr double rounding = 1e-14;  // of sums, of which each term has some
  MeanKind kind_;
  const Weighted<P>& given_;
};

}}}  // namespace orispline::mean_of
