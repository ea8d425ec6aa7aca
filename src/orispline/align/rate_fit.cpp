// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/rate_fit.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <orispline/align/align.hpp>
#include <orispline/align/robust_equations.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/number.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr Eigen::Index mounting_at = 0, delay_at = 3, correction_at = 4, rate_unknowns = 7;
using RateUnknowns = Eigen::Matrix<double, rate_unknowns, 1>;
using RateMatrix = Eigen::Matrix<double, rate_unknowns, rate_unknowns>;
using RateSlopes = Eigen::Matrix<double, 3, rate_unknowns>;

constexpr int most_rate_steps = 60;
constexpr double least_rate_step = 1e-4;  // of one σ
constexpr double least_excess = 1e-6;
constexpr std::size_t anew_after = 5;  // orientations in a row that are too far: then it is the gyro that went wrong

/// An orientation beside the path of the gyro: the turn of the path into the world, which is constant where the gyro is
/// right, and how it changes with the unknowns, as turns of the path's world.
struct Turn {
  std::size_t sample, piece;
  double time;
  Eigen::Quaterniond value;
  RateSlopes slopes;
};

/// Turns of B are turns of the body.
std::vector<Turn> turns_of(const RateFitData& data, const RateTransform& at) {
  const GyroPath path(data.gyro, data.counts, at.correction);
  const Eigen::Matrix3d to_gyro = at.body.conjugate().toRotationMatrix();
  std::vector<Turn> turns;
  for (std::size_t i = 0; i < data.times.size(); ++i) {
    const auto point = path.at(data.times[i] + at.offset);
    if (!point) continue;
    const Eigen::Matrix3d to_path = point->orientation.toRotationMatrix();
    Turn turn{.sample = i,
              .piece = point->piece,
              .time = data.times[i],
              .value = data.orientations[i] * at.body * point->orientation.conjugate(),
              .slopes = RateSlopes::Zero()};
    turn.slopes.block<3, 3>(0, mounting_at) = to_path * to_gyro;
    turn.slopes.col(delay_at) = -to_path * point->rate;
    turn.slopes.block<3, 3>(0, correction_at) = -to_path * point->by_correction;
    turns.push_back(turn);
  }
  return turns;
}

/// How far an orientation is from where the gyro leads from those before it.
struct Innovation {
  std::size_t sample;
  double step;   // [s]
  double sigma;  // of the noise [rad]
  Linear<rate_unknowns> linear;
};

/// What is known of the turn while orientations come one by one.
class Level {
 public:
  explicit Level(const RateFitData& data) : data_(data) {}

  void begin(const Turn& turn) {
    value_ = turn.value;
    slopes_ = turn.slopes;
    variance_ = data_.noise * data_.noise;
    time_ = turn.time;
  }

  [[nodiscard]] Innovation innovation(const Turn& turn) const {
    const double step = turn.time - time_;
    const double variance = variance_ + data_.walk * step + data_.noise * data_.noise;
    return {turn.sample, step, std::sqrt(variance), {shortest_increment(value_, turn.value), turn.slopes - slopes_}};
  }

  void take(const Innovation& innovation) {
    const double before = variance_ + data_.walk * innovation.step;
    const double gain = before / (innovation.sigma * innovation.sigma);
    value_ = (value_ * exp<double>(Eigen::Vector3d(gain * innovation.linear.value))).normalized();
    slopes_ += gain * innovation.linear.slopes;
    variance_ = gain * data_.noise * data_.noise;
    time_ += innovation.step;
  }

 private:
  const RateFitData& data_;
  Eigen::Quaterniond value_ = Eigen::Quaterniond::Identity();
  RateSlopes slopes_ = RateSlopes::Zero();
  double variance_ = 0.0, time_ = 0.0;
};

/// Of all turns but the first of each piece. Those beyond the limit, in units of their noise, tell nothing of the
/// level; but with exact orientations the next one is compared with them.
std::vector<Innovation> innovations_of(const RateFitData& data, const std::vector<Turn>& turns, double limit) {
  const bool are_exact = data.noise == 0.0;
  std::vector<Innovation> innovations;
  Level level(data);
  std::size_t too_far = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const bool goes_on = i > 0 && turns[i].piece == turns[i - 1].piece &&
                         data.pieces[turns[i].sample] == data.pieces[turns[i - 1].sample];
    if (!goes_on || too_far == anew_after) {
      if (goes_on) {
        i -= anew_after;
        innovations.resize(innovations.size() - anew_after);
      }
      level.begin(turns[i]);
      too_far = 0;
      continue;
    }
    innovations.push_back(level.innovation(turns[i]));
    const Innovation& last = innovations.back();
    const bool is_near = are_exact || last.linear.value.norm() <= limit * last.sigma;
    too_far = is_near ? 0 : too_far + 1;
    if (is_near) level.take(last);
  }
  return innovations;
}

double excess_of(const std::vector<Innovation>& innovations) {
  std::vector<double> lengths;
  lengths.reserve(innovations.size());
  for (const Innovation& one : innovations) lengths.push_back(one.linear.value.norm() / one.sigma);
  return std::max(least_excess, median(std::move(lengths)) / median_length);
}

RobustEquations<rate_unknowns> equations_of(const std::vector<Innovation>& innovations, double excess) {
  const std::size_t in_block = samples_in_block(innovations.size());
  RobustEquations<rate_unknowns> equations;
  for (std::size_t i = 0; i < innovations.size(); ++i) {
    equations.add(innovations[i].linear, excess * innovations[i].sigma);
    if ((i + 1) % in_block == 0 || i + 1 == innovations.size()) equations.end_block();
  }
  return equations;
}

/// What the noise of the rates alone adds to the normal matrix, where a turn or a delay of noise looks like an answer.
RateMatrix told_by_noise(const RateFitData& data, const std::vector<Innovation>& innovations, double excess) {
  const double rate = data.gyro_noise * data.gyro_noise;
  const bool are_exact = data.noise == 0.0;
  RateMatrix told = RateMatrix::Zero();
  for (const Innovation& one : innovations) {
    const double weight = 1.0 / (excess * excess * one.sigma * one.sigma);
    told(delay_at, delay_at) += weight * 3.0 * rate * (are_exact ? 2.0 : 1.0);
    for (Eigen::Index k = mounting_at; k < mounting_at + 3; ++k)
      told(k, k) += weight * 2.0 * rate * data.gyro_interval * one.step;
  }
  return told;
}

std::vector<Eigen::Index> free_rate_unknowns(const RateFitData& data) {
  std::vector<Eigen::Index> free;
  for (Eigen::Index k = 0; k < rate_unknowns; ++k)
    if (k >= correction_at || (k == delay_at ? data.finds_offset : data.finds_body)) free.push_back(k);
  return free;
}

/// A turn of 1 rad, a rate of 1 rad/s, and the time in which the body turns by 1 rad, which is no longer than the
/// motion.
RateUnknowns units_of(const RateFitData& data, const std::vector<Turn>& turns) {
  double squares = 0.0;
  for (const Turn& turn : turns) squares += turn.slopes.col(delay_at).squaredNorm();
  const double duration = data.times.back() - data.times.front();
  RateUnknowns units = RateUnknowns::Ones();
  units[delay_at] =
      squares > 0.0 ? std::min(duration, std::sqrt(static_cast<double>(turns.size()) / squares)) : duration;
  return units;
}

RateTransform stepped(const RateTransform& from, const RateUnknowns& step) {
  return {.body = (exp<double>(Eigen::Vector3d(step.segment<3>(mounting_at))) * from.body).normalized(),
          .offset = from.offset + step[delay_at],
          .correction = from.correction + step.segment<3>(correction_at)};
}

void describe_covariance(RateFit& fit, const RateMatrix& covariance) {
  fit.body_covariance = covariance.block<3, 3>(mounting_at, mounting_at);
  fit.offset_sigma = std::sqrt(std::max(0.0, covariance(delay_at, delay_at)));
  fit.correction_sigma = covariance.diagonal().segment<3>(correction_at).cwiseMax(0.0).cwiseSqrt();
}

void describe_innovations(RateFit& fit, const std::vector<Innovation>& innovations, double excess) {
  std::vector<double> sigmas;
  for (const Innovation& one : innovations) {
    const double distance = one.linear.value.norm();
    fit.compared.push_back(one.sample);
    if (distance > rejected_from * excess * one.sigma) fit.rejected.push_back(one.sample);
    fit.distances.push_back(distance);
    fit.steps.push_back(one.step);
    sigmas.push_back(one.sigma);
  }
  fit.usual = median(std::move(sigmas));
  fit.excess = excess;
}

}  // namespace

double RateFit::cost() const {
  return 6.0 * static_cast<double>(distances.size()) * elementary::natural_logarithm(excess * usual / std::numbers::pi);
}

std::optional<RateFit> fit_rates(const RateFitData& data, const RateTransform& guess) {
  const auto free = free_rate_unknowns(data);
  RateFit fit{.transform = guess};
  double limit = std::numeric_limits<double>::infinity();
  for (int step = 0;; ++step) {
    const std::vector<Turn> turns = turns_of(data, fit.transform);
    if (turns.size() < least_aligned) return std::nullopt;
    const std::vector<Innovation> innovations = innovations_of(data, turns, limit);
    if (innovations.size() < least_aligned) return std::nullopt;
    const double excess = excess_of(innovations);
    const RobustEquations<rate_unknowns> equations = equations_of(innovations, excess);
    const RateMatrix told = equations.matrix - told_by_noise(data, innovations, excess);
    const NormalInverse<rate_unknowns> inverse(told, units_of(data, turns), free, innovations.size());
    const RateUnknowns change = -(inverse.matrix * equations.gradient);
    const double size = std::sqrt(std::max(0.0, change.dot(equations.matrix * change)));
    const bool is_limited = limit < std::numeric_limits<double>::infinity();
    limit = rejected_from * excess;
    if ((size > least_rate_step || !is_limited) && step < most_rate_steps) {
      fit.transform = stepped(fit.transform, change);
      continue;
    }
    describe_covariance(fit, covariance_of(equations, inverse, innovations.size(), free.size()));
    for (const RateUnknowns& open : inverse.open)
      fit.open.push_back({open.segment<3>(mounting_at), open[delay_at], open.segment<3>(correction_at)});
    describe_innovations(fit, innovations, excess);
    return fit;
  }
}

}}  // namespace orispline
