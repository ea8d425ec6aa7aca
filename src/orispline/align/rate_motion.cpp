// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/rate_motion.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/align/alignment_guess.hpp>
#include <orispline/align/clock_search.hpp>
#include <orispline/align/steady_samples.hpp>
#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/curve/key_check.hpp>
#include <orispline/families/registry.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr int rounds_of_guess = 4;  // of the rotation, and of the correction beside it

Expected<void> check_rates(const GyroRates& gyro) {
  if (gyro.times.size() != gyro.rates.size())
    return failure(ErrorCode::bad_data, formatted("found {} times and {} rates, wanted one rate for each time",
                                                  gyro.times.size(), gyro.rates.size()));
  if (gyro.times.size() < least_aligned)
    return failure(ErrorCode::bad_data,
                   formatted("found {}, wanted {} at least", counted(gyro.times.size(), "rate"), least_aligned));
  for (std::size_t k = 0; k < gyro.times.size(); ++k) {
    if (!gyro.rates[k].allFinite() || !std::isfinite(gyro.times[k]) || (k > 0 && gyro.times[k] <= gyro.times[k - 1]))
      return failure(ErrorCode::bad_data,
                     formatted("rate {}: its time {} s or a number is not finite, or the time does not come after the "
                               "one before it",
                               k, gyro.times[k]));
    if (!is_in_range(gyro.rates[k]))
      return failure(ErrorCode::bad_data, formatted("rate {}: a component is {:.6g} rad/s, wanted {:.0e} at most", k,
                                                    gyro.rates[k].cwiseAbs().maxCoeff(), largest_component));
  }
  return {};
}

std::vector<double> counted_times(const GyroRates& gyro, const CountedRates& counts) {
  std::vector<double> times;
  for (std::size_t k = 0; k < gyro.times.size(); ++k)
    if (counts[k]) times.push_back(gyro.times[k]);
  return times;
}

/// The rates over some intervals [rad/s], as the gyro and the body see them.
struct RatesBeside {
  std::vector<Eigen::Vector3d> gyro, body;
};

std::optional<RatesBeside> rates_beside(const AnyCurve& gyro, const AnyCurve& body, double interval, double offset) {
  const auto intervals = common_intervals(gyro.domain(), body.domain(), interval, offset);
  if (!intervals) return std::nullopt;
  RatesBeside rates{turns_in_intervals(gyro, intervals->start + offset, intervals->length, intervals->count),
                    turns_in_intervals(body, intervals->start, intervals->length, intervals->count)};
  for (auto* some : {&rates.gyro, &rates.body})
    for (Eigen::Vector3d& rate : *some) rate /= intervals->length;
  return rates;
}

/// What the body turns more than the gyro says.
std::vector<Eigen::Vector3d> left_between(const RatesBeside& rates, const Eigen::Quaterniond& mounting) {
  std::vector<Eigen::Vector3d> left;
  for (std::size_t i = 0; i < rates.gyro.size(); ++i)
    left.emplace_back(rates.body[i] - to_world<double>(mounting, rates.gyro[i]));
  return left;
}

}  // namespace

Expected<GyroMotion> gyro_motion(const GyroRates& gyro) {
  if (auto checked = check_rates(gyro); !checked) return tl::unexpected(std::move(checked.error()));
  CountedRates counts = steady_rates(gyro);
  const GyroPath path(gyro, counts, Eigen::Vector3d::Zero());
  KeyframeData data{.times = counted_times(gyro, counts)};
  for (const double t : data.times) data.orientations.push_back(path.at(t)->orientation);
  auto keys = Keyframes::make(std::move(data));
  if (!keys) return tl::unexpected(std::move(keys.error()));
  auto curve = make_curve("slerp", *keys);
  if (!curve) return tl::unexpected(std::move(curve.error()));
  return GyroMotion{.counts = std::move(counts),
                    .curve = std::move(*curve),
                    .noise = std::max(least_noise, local_noise(gyro.times, gyro.rates)),
                    .interval = path.interval()};
}

RateFitData data_beside(const GyroRates& gyro, const GyroMotion& motion, const GyroRates& other,
                        const GyroMotion& other_motion) {
  RateFitData data{.gyro = gyro,
                   .counts = motion.counts,
                   .walk = motion.walk() + other_motion.walk(),
                   .gyro_noise = motion.noise,
                   .gyro_interval = motion.interval};
  const GyroPath path(other, other_motion.counts, Eigen::Vector3d::Zero());
  for (const double t : counted_times(other, other_motion.counts)) {
    const auto point = path.at(t);
    const bool goes_on = !data.pieces.empty() && data.pieces.back() == point->piece;
    if (goes_on && t - data.times.back() < least_turn_time * (1.0 - 1e-6)) continue;
    data.times.push_back(t);
    data.orientations.push_back(point->orientation);
    data.pieces.push_back(point->piece);
  }
  return data;
}

std::optional<RateTransform> guess_rates(const AnyCurve& gyro, const AnyCurve& body, double interval, double offset,
                                         bool finds_body) {
  constexpr double by_chance = 5.0;  // standard deviations of what independent vectors have in common
  const auto rates = rates_beside(gyro, body, interval, offset);
  if (!rates) return std::nullopt;
  const double pull = by_chance / std::sqrt(static_cast<double>(rates->gyro.size()));
  RateTransform guess{.offset = offset};
  Eigen::Vector3d more = Eigen::Vector3d::Zero();
  for (int round = 0; round < rounds_of_guess; ++round) {
    std::vector<Eigen::Vector3d> without = rates->body;
    for (Eigen::Vector3d& rate : without) rate -= more;
    if (finds_body) guess.body = rotation_between(rates->gyro, without, pull);
    more = median_of_each(left_between(*rates, guess.body));
  }
  guess.correction = to_body<double>(guess.body, more);
  return guess;
}

double disagreement(const AnyCurve& gyro, const AnyCurve& body, double interval, const RateTransform& transform) {
  const auto rates = rates_beside(gyro, body, interval, transform.offset);
  if (!rates) return 0.0;
  const Eigen::Vector3d more = to_world<double>(transform.body, transform.correction);
  const double left = median_distance_from(more, left_between(*rates, transform.body));
  const double varies = median_distance_from(median_of_each(rates->body), rates->body);
  return varies > 0.0 ? left / varies : 0.0;
}

}}  // namespace orispline
