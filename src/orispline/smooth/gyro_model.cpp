// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_model.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numeric>

#include <orispline/math/median.hpp>
#include <orispline/math/number.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

namespace columns = calibration_columns;
using elementary::exponential, elementary::natural_logarithm;

constexpr int rounds = 3;  // of slopes
constexpr std::size_t fewest_turns = 8, most_turns_of_search = 3000, search_parts = 4;

// Standard deviations that are expected of scale and mount [rad]: of none, those of a good sensor, and of one that was
// put on by hand and never calibrated; of the rate of its clock, which may be that of the orientations; and of the
// offset [s].
constexpr std::array scale_widths{0.0, 0.005, 0.05}, mount_widths{0.0, 0.002, 0.05};
// Off by more in scale or mount [rad] it is no sensor; where the orientations are said to have noise that correlates,
// with which such a shape can be taken for it, it is none sooner.
constexpr double widest_shape = 0.4, widest_shape_beside_correlation = 0.15;
constexpr std::array clock_rate_widths{0.0, 3e-5, 5e-4};
constexpr double offset_width = 0.02;
constexpr double trend_width = 5e-3;  // of the bias [rad/s²]
constexpr double sure = 3.0;          // in standard deviations: a smaller scale, mount or clock rate is not told

// By so much -2 log of the likelihood has to fall for a wide prior and for a further noise; for a walk of the bias,
// which every gyro has, it has to fall only.
constexpr double price_of_width = 6.0, price = 8.0, price_of_correlation = 16.0;

/// Whether turns jump about one axis of the body more than about the others, as those of a vehicle in its plane do.
bool is_about_one_axis(std::span<const PathTurn> turns) {
  std::vector<Eigen::Vector3d> jumps;
  for (std::size_t k = 1; k + 1 < turns.size(); ++k) {
    if (turns[k].starts || turns[k + 1].starts) continue;
    const double share = turns[k].interval / (turns[k].interval + turns[k + 1].interval);
    jumps.emplace_back(turns[k].to_world.transpose() *
                       (turns[k].turn - (1.0 - share) * turns[k - 1].turn - share * turns[k + 1].turn));
  }
  return !jumps.empty() && lopsided_deviation(jumps) > 0.0;
}

/// The noises that explain turns best.
class NoiseSearch {
 public:
  struct Found {
    GyroNoises noises{};
    double evidence = std::numeric_limits<double>::infinity();
  };

  NoiseSearch(std::span<const PathTurn> turns, const GyroModelPlan& plan, const CalibrationUnknowns& present,
              bool has_trend)
      : turns_(turns), plan_(plan), present_(present) {
    widest_ = {.scale = scale_widths.back(),
               .mount = mount_widths.back(),
               .trend = has_trend ? trend_width : 0.0,
               .offset = plan.finds_offset ? offset_width : 0.0,
               .clock_rate = plan.finds_clock_rate ? clock_rate_widths.back() : 0.0};
  }

  [[nodiscard]] const CalibrationPrior& widest() const noexcept { return widest_; }

  /// Of rates whose calibration is only near.
  [[nodiscard]] Found rough() const {
    return from({.rate = rough_rate_noise(), .white = plan_.pose_noise}, {&GyroNoises::rate});
  }
  /// The same, of a bias that walks.
  [[nodiscard]] Found rough_walk() const {
    return from({.rate = rough_rate_noise(), .drift = rough_rate_noise(), .white = plan_.pose_noise},
                {&GyroNoises::rate, &GyroNoises::drift});
  }

  /// `interval`: usual one between turns [s].
  [[nodiscard]] GyroNoises best(double interval) const {
    const Found plain = from({.rate = plan_.rate_noise, .white = plan_.pose_noise}, {});
    Found least = plain;
    if (plan_.bias == GyroBias::drifting) least.evidence = std::numeric_limits<double>::infinity();
    const auto consider = [&least](const Found& other, double its_price) {
      if (other.evidence + its_price < least.evidence) least = other;
    };
    if (plan_.bias != GyroBias::constant)
      for (const double drift : {plan_.rate_noise, 10.0 * plan_.rate_noise})
        consider(from(with(plain.noises, &GyroNoises::drift, drift), {&GyroNoises::drift}), 0.0);
    if (plan_.finds_clock_rate && !is_about_one_axis(turns_))
      consider(from(with(plain.noises, &GyroNoises::clock, 1e-3), {&GyroNoises::clock}), price);
    const GyroNoises noisier = with(least.noises, &GyroNoises::rate, 3.0 * least.noises.rate);
    if (noisier.drift > 0.0) consider(from(noisier, {&GyroNoises::rate, &GyroNoises::drift}), price);
    else consider(from(noisier, {&GyroNoises::rate}), price);
    if (!plan_.states_pose_noise)
      for (const double intervals : {3.0, 30.0, 300.0})
        consider_correlated(plain.noises, intervals * interval, consider);
    return least.noises;
  }

 private:
  using Noise = double GyroNoises::*;

  static GyroNoises with(GyroNoises noises, Noise one, double value) {
    noises.*one = value;
    return noises;
  }

  /// Noise that correlates about so long [s], without a walk of the bias and with one.
  template <class Consider>
  void consider_correlated(const GyroNoises& plain, double time, Consider consider) const {
    GyroNoises start = plain;
    start.correlated = plain.white;
    start.white = 0.5 * plain.white;
    start.correlation_time = time;
    const Found correlates = from(start, {&GyroNoises::correlated, &GyroNoises::correlation_time});
    if (plan_.bias != GyroBias::drifting) consider(correlates, price_of_correlation);
    if (plan_.bias == GyroBias::constant) return;
    consider(from(with(correlates.noises, &GyroNoises::drift, plan_.rate_noise),
                  {&GyroNoises::correlated, &GyroNoises::correlation_time, &GyroNoises::drift}),
             price_of_correlation);
  }

  /// From there by a compass search in logarithms; the white noise is sought too, unless it is stated. The calibration
  /// stays what it is for the start.
  [[nodiscard]] Found from(GyroNoises noises, std::initializer_list<Noise> others) const {
    constexpr double first_step = 1.4, last_step = 0.1, shorter = 0.4;
    std::vector<Noise> sought(others);
    if (!plan_.states_pose_noise) sought.push_back(&GyroNoises::white);
    for (int twice = 0; twice < 2; ++twice) {
      const CalibrationUnknowns change = solved(filtered(turns_, noises), present_, widest_).values - present_;
      double least = likelihood(turns_, noises, change);
      for (double step = twice == 0 ? first_step : 3.0 * last_step; step > last_step; step *= shorter)
        for (bool moved = true; moved;) {
          moved = false;
          for (const Noise one : sought) moved = descends(noises, least, change, one, step) || moved;
        }
    }
    return {noises, solved(filtered(turns_, noises), present_, widest_).evidence};
  }

  /// Up or down, as long as it helps.
  bool descends(GyroNoises& noises, double& least, const CalibrationUnknowns& change, Noise one, double step) const {
    constexpr double least_gain = 0.05;
    for (const double factor : {exponential(step), exponential(-step)})
      for (bool moved = false;; moved = true) {
        GyroNoises there = with(noises, one, std::max(noises.*one * factor, least_of(one, noises)));
        // By how much such noise changes within a short time is told far better than either, and stays.
        if (one == &GyroNoises::correlation_time) there.correlated *= std::sqrt(factor);
        const double value = there.*one == noises.*one ? least : likelihood(turns_, there, change);
        if (value < least - least_gain) {
          noises = there;
          least = value;
        } else if (moved) {
          return true;
        } else {
          break;
        }
      }
    return false;
  }
  [[nodiscard]] double rough_rate_noise() const { return std::max(plan_.rate_noise, 0.3 * plan_.pose_noise); }
  [[nodiscard]] double least_of(Noise one, const GyroNoises& noises) const {
    if (one == &GyroNoises::rate) return plan_.rate_noise;
    return one == &GyroNoises::white ? std::max(least_noise, 0.02 * noises.correlated) : 1e-12;
  }

  std::span<const PathTurn> turns_;
  const GyroModelPlan& plan_;
  CalibrationUnknowns present_;
  CalibrationPrior widest_;
};

/// All of them, or parts that are evenly spread.
std::vector<PathTurn> representative(const std::vector<PathTurn>& turns) {
  if (turns.size() <= most_turns_of_search) return turns;
  std::vector<PathTurn> parts;
  const std::size_t size = most_turns_of_search / search_parts;
  for (std::size_t k = 0; k < search_parts; ++k) {
    const std::size_t first = k * (turns.size() - size) / (search_parts - 1);
    const auto begin = turns.begin() + static_cast<std::ptrdiff_t>(first);
    parts.insert(parts.end(), begin, begin + static_cast<std::ptrdiff_t>(size));
    parts[parts.size() - size].starts = true;
  }
  return parts;
}

/// Whether a trend of the bias explains turns better than noisier rates do, and than a walk.
bool shows_trend(std::span<const PathTurn> turns, const GyroModelPlan& plan, const CalibrationUnknowns& present) {
  if (!plan.finds_trend) return false;
  const NoiseSearch with(turns, plan, present, true), without(turns, plan, present, false);
  const double evidence = with.rough().evidence + price;
  return evidence < without.rough().evidence && evidence < without.rough_walk().evidence;
}

/// The mean of calibrations by their evidence, and how far they are apart as a part of its covariance.
FoundCalibration mean_of(const std::vector<FoundCalibration>& all) {
  FoundCalibration mean;
  for (const FoundCalibration& one : all) mean.evidence = std::min(mean.evidence, one.evidence);
  std::vector<double> weights;
  for (const FoundCalibration& one : all) weights.push_back(exponential(0.5 * (mean.evidence - one.evidence)));
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  mean.evidence -= 2.0 * natural_logarithm(sum);
  for (std::size_t k = 0; k < all.size(); ++k) mean.values += weights[k] / sum * all[k].values;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const CalibrationUnknowns apart = all[k].values - mean.values;
    mean.covariance += weights[k] / sum * (all[k].covariance + apart * apart.transpose());
  }
  mean.sigmas = mean.covariance.diagonal().cwiseSqrt();
  return mean;
}

/// The mean over the widths of scale and mount; `prior` has the others.
FoundCalibration mean_calibration(const TurnInnovations& innovations, const CalibrationUnknowns& present,
                                  CalibrationPrior prior) {
  std::vector<FoundCalibration> all;
  for (const double scale : scale_widths)
    for (const double mount : mount_widths) {
      prior.scale = scale;
      prior.mount = mount;
      all.push_back(solved(innovations, present, prior));
      for (const bool is_wide : {scale == scale_widths.back(), mount == mount_widths.back()})
        all.back().evidence += is_wide ? price_of_width : 0.0;
    }
  return mean_of(all);
}

/// The calibration of the greatest evidence under these noises.
FoundCalibration best_calibration(const TurnInnovations& innovations, const CalibrationUnknowns& present,
                                  const GyroModelPlan& plan, double trend) {
  FoundCalibration best;
  const bool has_offset = plan.finds_offset && plan.near.offset != 0.0;
  for (const double clock_rate : clock_rate_widths)
    for (const double offset : {0.0, offset_width}) {
      if (clock_rate > 0.0 && !plan.finds_clock_rate) continue;
      if (offset > 0.0 ? !plan.finds_offset : has_offset) continue;
      const FoundCalibration found =
          mean_calibration(innovations, present, {.trend = trend, .offset = offset, .clock_rate = clock_rate});
      if (found.evidence < best.evidence) best = found;
    }
  return best;
}

/// Of the orientations by the unknowns but for the correction by itself, which the fit of the motion finds too.
double variance_by(const FoundCalibration& found, const TurnInnovations& innovations, const CalibrationMatrix& left) {
  const Eigen::Matrix3d of_correction =
      innovations.products.block<3, 3>(1 + columns::correction, 1 + columns::correction).inverse();
  // Of symmetric matrices, the trace of their product.
  return found.covariance.cwiseProduct(left).sum() -
         of_correction.cwiseProduct(left.block<3, 3>(columns::correction, columns::correction)).sum();
}

/// -2 log of the likelihood of the turns if the gyro told nothing but that the rate is constant.
double evidence_without(const SeenPoses& poses, GyroRates gyro, const CountedRates& counts, const GyroModel& model) {
  std::ranges::fill(gyro.rates, Eigen::Vector3d::Zero());
  GyroCalibration none = model.calibration;
  none.correction.setZero();
  none.trend.setZero();
  return solved(filtered(path_turns(poses, gyro, counts, none), model.noises), CalibrationUnknowns::Zero(), {})
      .evidence;
}

}  // namespace

GyroModel gyro_model(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                     const GyroModelPlan& plan) {
  GyroModel model{.calibration = plan.near, .noises = {.rate = plan.rate_noise, .white = plan.pose_noise}};
  model.calibration.origin = plan.near.offset + std::midpoint(poses.times.front(), poses.times.back());
  model.values.segment<3>(columns::correction) = plan.near.correction;
  FoundCalibration found;
  bool has_trend = false;
  for (int round = 0; round < rounds; ++round) {
    const std::vector<PathTurn> turns = path_turns(poses, gyro, counts, model.calibration);
    model.seen = turns.size();
    if (turns.size() < fewest_turns) return model;
    const std::vector<PathTurn> parts = representative(turns);
    if (round == 0) has_trend = shows_trend(parts, plan, model.values);
    const NoiseSearch search(parts, plan, model.values, has_trend);
    model.noises = round == 0 ? search.rough().noises : search.best(median_interval(poses.times));
    const TurnInnovations innovations = filtered(turns, model.noises);
    found = round == 0 ? solved(innovations, model.values, search.widest())
                       : best_calibration(innovations, model.values, plan, search.widest().trend);
    if (round + 1 == rounds) model.variance = variance_by(found, innovations, left_by_smoother(turns, model.noises));
    model.values = found.values;
    model.sigmas = found.sigmas;
    model.calibration.correction = found.values.segment<3>(columns::correction);
    model.calibration.trend = found.values.segment<3>(columns::trend);
    model.calibration.shape = shape_of(found.values);
    model.calibration.offset = plan.near.offset + found.values[columns::offset];
    model.calibration.clock_rate = found.values[columns::clock_rate];
  }
  const auto tells = [&](int first, int count) {
    return (model.values.segment(first, count).cwiseAbs() - sure * model.sigmas.segment(first, count)).maxCoeff() > 0.0;
  };
  const auto shape = model.values.segment<columns::trend - columns::scale>(columns::scale);
  const double widest = model.noises.correlated > 0.0 ? widest_shape_beside_correlation : widest_shape;
  model.explains =
      shape.cwiseAbs().maxCoeff() < widest && found.evidence + price < evidence_without(poses, gyro, counts, model);
  model.has_scale = tells(columns::scale, 3);
  model.has_mount = tells(columns::mount, 3);
  model.has_trend = tells(columns::trend, 3);
  model.has_clock_rate = tells(columns::clock_rate, 1);
  return model;
}

}}  // namespace orispline
