// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/alignment_fit.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

#include <orispline/align/robust_equations.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/number.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr Eigen::Index world_at = 0, body_at = 3, offset_at = 6, scale_at = 7, translation_at = 8, unknowns = 11;
using Unknowns = Eigen::Matrix<double, unknowns, 1>;
using Equations = RobustEquations<unknowns>;
using Residual = Linear<unknowns>;
using Slopes = Eigen::Matrix<double, 3, unknowns>;

constexpr double least_residual = 1e-6;  // [rad], of positions times their spread
constexpr int most_steps = 100;
constexpr double least_step = 1e-5;  // of one σ

/// A sample of the fixed motion beside the moved one.
struct Pair {
  std::size_t sample;
  Motion moved;
  LinearMotion path{};
};

/// The sum of the squares of both kinds near a Transform.
class Sum {
 public:
  Sum(const AlignmentData& data, const Transform& at, const Eigen::Vector3d& middle)
      : data_(data), at_(at), middle_(middle) {
    const Domain domain = data.moved.orientation.domain();
    const auto times = data.fixed.times();
    for (std::size_t i = 0; i < times.size(); ++i) {
      const double t = times[i] + at.offset;
      if (!domain.contains(t)) continue;
      pairs_.push_back({i, data.moved.orientation.motion(t)});
      if (data.has_positions) pairs_.back().path = data.moved.position->linear_motion(t);
    }
  }

  [[nodiscard]] const std::vector<Pair>& pairs() const noexcept { return pairs_; }

  /// Turns of W are turns of the fixed world, those of B of the fixed body.
  [[nodiscard]] Residual orientation(const Pair& pair) const {
    const Eigen::Quaterniond found = at_.world * pair.moved.orientation * at_.body.conjugate();
    Residual linear{shortest_increment(data_.fixed.orientations()[pair.sample], found), Slopes::Zero()};
    linear.slopes.block<3, 3>(0, world_at) = found.toRotationMatrix().transpose();
    linear.slopes.block<3, 3>(0, body_at) = -Eigen::Matrix3d::Identity();
    linear.slopes.col(offset_at) = to_world<double>(at_.body, pair.moved.angular_velocity);
    return linear;
  }

  /// The unknown of the translation is where the middle of the moved positions comes to, which the turns leave alone.
  [[nodiscard]] Residual position(const Pair& pair) const {
    const Eigen::Vector3d turned =
        at_.scale * to_world<double>(at_.world, Eigen::Vector3d(pair.path.position - middle_));
    const Eigen::Vector3d origin = at_.scale * to_world<double>(at_.world, middle_) + at_.translation;
    Residual linear{turned + origin - data_.fixed.positions()[pair.sample], Slopes::Zero()};
    linear.slopes.block<3, 3>(0, world_at) = -skew(turned);
    linear.slopes.col(offset_at) = at_.scale * to_world<double>(at_.world, pair.path.velocity);
    linear.slopes.col(scale_at) = turned;
    linear.slopes.block<3, 3>(0, translation_at) = Eigen::Matrix3d::Identity();
    return linear;
  }

 private:
  const AlignmentData& data_;
  const Transform& at_;
  Eigen::Vector3d middle_;
  std::vector<Pair> pairs_;
};

/// Robust standard deviations per axis, and how far from the middle the positions are.
struct Noise {
  double angle = 0.0, length = 0.0;
  std::vector<double> angles{}, lengths{};  // of the residuals of each pair
};

struct Scales {
  Unknowns units = Unknowns::Ones();  // of unknowns: a turn of 1 rad, or what moves the body as far
  double spread = 1.0;                // of positions about their middle [m]
};

Noise noise_of(const Sum& sum, bool has_positions, double spread) {
  Noise noise;
  for (const Pair& pair : sum.pairs()) {
    noise.angles.push_back(sum.orientation(pair).value.norm());
    if (has_positions) noise.lengths.push_back(sum.position(pair).value.norm());
  }
  noise.angle = std::max(median(noise.angles) / median_length, least_residual);
  noise.length = std::max(median(noise.lengths) / median_length, least_residual * spread);
  return noise;
}

Equations equations_of(const Sum& sum, const Noise& noise, bool has_positions) {
  const std::size_t pairs = sum.pairs().size(), in_block = samples_in_block(pairs);
  Equations equations;
  for (std::size_t i = 0; i < pairs; ++i) {
    equations.add(sum.orientation(sum.pairs()[i]), noise.angle);
    if (has_positions) equations.add(sum.position(sum.pairs()[i]), noise.length);
    if ((i + 1) % in_block == 0 || i + 1 == pairs) equations.end_block();
  }
  return equations;
}

std::vector<Eigen::Index> free_unknowns(const AlignmentData& data) {
  std::vector<Eigen::Index> free;
  const auto add_some = [&](bool is_free, Eigen::Index first, Eigen::Index count) {
    for (Eigen::Index k = first; is_free && k < first + count; ++k) free.push_back(k);
  };
  add_some(data.options.world_turn, world_at, 3);
  add_some(data.options.body_turn, body_at, 3);
  add_some(!data.options.offset, offset_at, 1);
  add_some(data.has_positions && data.options.scale, scale_at, 1);
  add_some(data.has_positions && data.options.translation, translation_at, 3);
  return free;
}

Transform moved_by(const Transform& from, const Unknowns& step, const Eigen::Vector3d& middle) {
  const auto turn = [](const Unknowns& s, Eigen::Index at) { return exp<double>(Eigen::Vector3d(s.segment<3>(at))); };
  Transform to = from;
  to.world = (turn(step, world_at) * from.world).normalized();
  to.body = (turn(step, body_at) * from.body).normalized();
  to.offset += step[offset_at];
  to.scale *= elementary::exponential(std::clamp(step[scale_at], -1.0, 1.0));
  const Eigen::Vector3d origin =
      from.scale * to_world<double>(from.world, middle) + from.translation + step.segment<3>(translation_at);
  to.translation = origin - to.scale * to_world<double>(to.world, middle);
  return to;
}

/// What turns and scale leave alone: the middle of the moved positions where the translation is looked for as well.
Eigen::Vector3d middle_of(const AlignmentData& data) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  if (!data.has_positions || !data.options.translation) return middle;
  const auto times = data.moved.position->knots().times();
  for (const double t : times) middle += data.moved.position->linear_motion(t).position;
  return middle / static_cast<double>(times.size());
}

/// A turn of 1 rad, and the time, the scale and the length that move the body as far; no time is longer than the
/// motion.
Scales scales_of(const Sum& sum, const Transform& at, const Eigen::Vector3d& middle, double duration) {
  double rates = 0.0, spread = 0.0;
  for (const Pair& pair : sum.pairs()) {
    rates += pair.moved.angular_velocity.squaredNorm();
    spread += (pair.path.position - middle).squaredNorm();
  }
  const auto count = static_cast<double>(sum.pairs().size());
  Scales scales;
  scales.units[offset_at] = rates > 0.0 ? std::min(duration, 1.0 / std::sqrt(rates / count)) : duration;
  if (spread > 0.0) scales.spread = at.scale * std::sqrt(spread / count);
  scales.units.segment<3>(translation_at).setConstant(scales.spread);
  return scales;
}

OpenDirection open_direction(const Unknowns& u) {
  return {u.segment<3>(world_at), u.segment<3>(body_at), u[offset_at], u[scale_at], u.segment<3>(translation_at)};
}

/// Of the translation of the origin, which the turn and the scale move about the middle.
AlignmentSigmas sigmas_of(const Eigen::MatrixXd& covariance, const Transform& at, const Eigen::Vector3d& middle) {
  const auto sigma = [&](Eigen::Index k) { return std::sqrt(std::max(0.0, covariance(k, k))); };
  const auto three = [&](Eigen::Index k) { return Eigen::Vector3d(sigma(k), sigma(k + 1), sigma(k + 2)); };
  const Eigen::Vector3d arm = at.scale * to_world<double>(at.world, middle);
  Slopes origin = Slopes::Zero();
  origin.block<3, 3>(0, world_at) = skew(arm);
  origin.col(scale_at) = -arm;
  origin.block<3, 3>(0, translation_at) = Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d of_origin = origin * covariance * origin.transpose();
  return {three(world_at), three(body_at), sigma(offset_at), at.scale * sigma(scale_at),
          of_origin.diagonal().cwiseMax(0.0).cwiseSqrt()};
}

}  // namespace

double AlignmentFit::cost() const {
  return 6.0 * static_cast<double>(angles.size()) * elementary::natural_logarithm(noise / std::numbers::pi);
}

std::optional<AlignmentFit> fit_alignment(const AlignmentData& data, const Transform& guess) {
  const auto free = free_unknowns(data);
  const Eigen::Vector3d middle = middle_of(data);
  const Domain domain = data.moved.orientation.domain();
  AlignmentFit fit{.transform = guess};
  for (int step = 0;; ++step) {
    const Sum sum(data, fit.transform, middle);
    const std::size_t pairs = sum.pairs().size();
    if (pairs < least_aligned) return std::nullopt;
    const Scales scales = scales_of(sum, fit.transform, middle, domain.end - domain.start);
    const Noise noise = noise_of(sum, data.has_positions, scales.spread);
    const Equations equations = equations_of(sum, noise, data.has_positions);
    const NormalInverse<unknowns> inverse(equations.matrix, scales.units, free, pairs);
    const Unknowns change = -(inverse.matrix * equations.gradient);
    const double size = std::sqrt(std::max(0.0, change.dot(equations.matrix * change)));
    if (size > least_step && step < most_steps) {
      fit.transform = moved_by(fit.transform, change, middle);
      continue;
    }
    fit.sigmas = sigmas_of(covariance_of(equations, inverse, pairs, free.size()), fit.transform, middle);
    for (const Unknowns& direction : inverse.open)
      fit.open.push_back(open_direction(direction.cwiseQuotient(scales.units)));
    for (std::size_t i = 0; i < pairs; ++i) {
      fit.compared.push_back(sum.pairs()[i].sample);
      const bool is_far = noise.angles[i] > rejected_from * noise.angle ||
                          (data.has_positions && noise.lengths[i] > rejected_from * noise.length);
      if (is_far) fit.rejected.push_back(sum.pairs()[i].sample);
    }
    fit.angles = noise.angles;
    fit.distances = noise.lengths;
    fit.noise = noise.angle;
    fit.position_noise = noise.length;
    return fit;
  }
}

}}  // namespace orispline
