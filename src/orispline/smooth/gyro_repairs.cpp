// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_repairs.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_noise.hpp>
#include <orispline/smooth/turn_filter.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double batch_share = 0.2;  // of the mean interval: as near stand the stamps of one batch

constexpr double wrap = 1.5;             // of the largest rate: a step that long is one round
constexpr std::size_t fewest_wraps = 4;  // of a counter that comes round rather than rates that are wrong

constexpr double shows_a_turn =
    5.0;  // in medians of what the rates of live axes differ by from those of the orientations

constexpr double far_off = 0.05;      // [rad]: what is mounted nearer is found with the rest of the calibration
constexpr double nearer_share = 0.4;  // of what rates differ by from those of the orientations, once they are turned

constexpr double gap = 1.5;             // in usual intervals
constexpr std::size_t most_gaps = 8;    // that are tried
constexpr double price_of_jump = 40.0;  // by which -2 log of the likelihood has to fall

/// The largest gaps, by the rate behind each, from the first one to the last.
std::vector<std::size_t> largest_gaps(const std::vector<double>& times, double interval) {
  std::vector<std::size_t> gaps;
  for (std::size_t k = 1; k < times.size(); ++k)
    if (times[k] - times[k - 1] > gap * interval) gaps.push_back(k);
  const auto length = [&times](std::size_t k) { return times[k - 1] - times[k]; };
  std::ranges::sort(gaps, {}, length);
  gaps.resize(std::min(gaps.size(), most_gaps));
  std::ranges::sort(gaps);
  return gaps;
}

/// By which the rates of an axis jump, where they do, but for the trend about the jump; 0: they do not.
double range_of(const GyroRates& gyro, Eigen::Index axis) {
  double largest = 0.0;
  for (const Eigen::Vector3d& rate : gyro.rates) largest = std::max(largest, std::abs(rate[axis]));
  std::vector<double> jumps;
  for (std::size_t k = 2; k + 1 < gyro.rates.size(); ++k) {
    const double step = gyro.rates[k][axis] - gyro.rates[k - 1][axis];
    if (std::abs(step) < wrap * largest) continue;
    const double trend =
        0.5 * (gyro.rates[k - 1][axis] - gyro.rates[k - 2][axis] + gyro.rates[k + 1][axis] - gyro.rates[k][axis]);
    if (std::abs(trend) < 0.5 * largest) jumps.push_back(std::abs(step - trend));
  }
  return jumps.size() < fewest_wraps ? 0.0 : median(std::move(jumps));
}

/// The rates of an axis with whole ranges added, so that no step is longer than half of one. They begin as they are,
/// and the median is nearest to 0.
void unwind(GyroRates& gyro, Eigen::Index axis, double range) {
  double turns_over = 0.0;
  std::vector<double> all;
  double before = gyro.rates.front()[axis];
  for (Eigen::Vector3d& rate : gyro.rates) {
    const double step = rate[axis] - before;
    before = rate[axis];
    if (std::abs(step) > 0.5 * range) turns_over -= std::copysign(1.0, step);
    rate[axis] += turns_over * range;
    all.push_back(rate[axis]);
  }
  const double shift = range * std::round(median(std::move(all)) / range);
  for (Eigen::Vector3d& rate : gyro.rates) rate[axis] -= shift;
}

/// Whether there were batches, which are spread.
bool spread_batches(GyroRates& gyro) {
  const std::vector<double> times = gyro.times;
  const double mean = (times.back() - times.front()) / static_cast<double>(times.size() - 1);
  if (median_interval(times) >= batch_share * mean) return false;
  std::optional<double> end_before;
  for (std::size_t first = 0, last = 0; first < times.size(); first = last) {
    for (last = first + 1; last < times.size() && times[last] - times[last - 1] < mean;) ++last;
    const double end = times[last - 1], all = static_cast<double>(last - first);
    // The first batch, and one behind a gap, have rates at the usual pace.
    const double interval = end_before ? std::min((end - *end_before) / all, 2.0 * mean) : mean;
    for (std::size_t k = first; k < last; ++k) gyro.times[k] = end - interval * static_cast<double>(last - 1 - k);
    end_before = end;
  }
  return true;
}

std::array<bool, 3> dead_axes_of(const SeenPoses& poses, const GyroRates& gyro) {
  std::array<bool, 3> dead{};
  std::array<std::vector<double>, 3> off;
  for (std::size_t k = 0; k < gyro.times.size(); ++k)
    if (const auto turned = rate_of_poses(poses, gyro.times[k]))
      for (Eigen::Index axis = 0; axis < 3; ++axis)
        off[static_cast<std::size_t>(axis)].push_back(std::abs(gyro.rates[k][axis] - (*turned)[axis]));
  double usual = 0.0;
  std::array<double, 3> medians{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto same = [&](const Eigen::Vector3d& rate) {
      return rate[static_cast<Eigen::Index>(axis)] == gyro.rates.front()[static_cast<Eigen::Index>(axis)];
    };
    dead[axis] = std::ranges::all_of(gyro.rates, same);
    medians[axis] = off[axis].empty() ? 0.0 : median(std::move(off[axis]));
    if (!dead[axis]) usual = std::max(usual, medians[axis]);
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
    dead[axis] = dead[axis] && medians[axis] > shows_a_turn * std::max(least_noise, usual);
  return std::ranges::count(dead, true) < 3 ? dead : std::array<bool, 3>{};
}

/// The rotation that brings rates to those of the orientations but for a bias, where it is large and brings them much
/// nearer; else none. Source: Umeyama 1991.
Eigen::Matrix3d far_mount(const SeenPoses& poses, const GyroRates& gyro) {
  Eigen::Matrix3Xd from(3, gyro.times.size()), to(3, gyro.times.size());
  Eigen::Index count = 0;
  for (std::size_t k = 0; k < gyro.times.size(); ++k)
    if (const auto turned = rate_of_poses(poses, gyro.times[k])) {
      from.col(count) = gyro.rates[k];
      to.col(count++) = *turned;
    }
  const Eigen::Matrix3d none = Eigen::Matrix3d::Identity();
  if (count < 3) return none;
  from.conservativeResize(3, count);
  to.conservativeResize(3, count);
  const Eigen::Matrix3d mount = Eigen::umeyama(from, to, false).topLeftCorner<3, 3>();
  const auto usual_length = [](const Eigen::Matrix3Xd& vectors) {  // about their mean
    const Eigen::VectorXd lengths = (vectors.colwise() - vectors.rowwise().mean()).colwise().norm();
    return median({lengths.begin(), lengths.end()});
  };
  if (Eigen::AngleAxisd(mount).angle() < far_off) return none;
  const double usual = std::min(usual_length(from - to), usual_length(to));
  return usual_length(mount * from - to) < nearer_share * usual ? mount : none;
}

}  // namespace

RepairedGyro::RepairedGyro(const GyroRates& gyro, const SeenPoses& poses) : rates(gyro) {
  if (gyro.clock == GyroRates::Clock::own) came_in_batches = spread_batches(rates);
  dead_axes = dead_axes_of(poses, gyro);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto row = static_cast<Eigen::Index>(axis);
    if (dead_axes[axis]) {
      for (std::size_t k = 0; k < rates.times.size(); ++k)
        rates.rates[k][row] = rate_of_poses(poses, rates.times[k]).value_or(rates.rates[k])[row];
    } else if (const double range = range_of(rates, row); range > 0.0) {
      unwind(rates, row, range);
      unwound_axes[axis] = true;
    }
  }
  if (!has_dead_axis()) mount = far_mount(poses, rates);
  for (Eigen::Vector3d& rate : rates.rates) rate = (mount * rate).eval();
}

std::vector<GyroFinding::ClockJump> close_jumps(GyroRates& gyro, const SeenPoses& poses, const CountedRates& counts,
                                                const GyroAlignment& alignment, double rate_noise) {
  const GyroCalibration near{.correction = alignment.correction, .offset = alignment.offset};
  const GyroNoises noises{.rate = rate_noise, .white = poses.noise};
  const CalibrationPrior prior{.scale = 0.01, .mount = 0.01, .offset = 0.1};
  CalibrationUnknowns present = CalibrationUnknowns::Zero();
  present.segment<3>(calibration_columns::correction) = near.correction;
  const auto evidence = [&](const GyroRates& rates) {
    return solved(filtered(path_turns(poses, rates, counts, near), noises), present, prior).evidence;
  };
  const double interval = median_interval(gyro.times);
  const std::vector<std::size_t> gaps = largest_gaps(gyro.times, interval);
  std::vector<GyroFinding::ClockJump> jumps;
  double least = gaps.empty() ? 0.0 : evidence(gyro);
  for (const std::size_t first : gaps) {
    const double seconds = gyro.times[first] - gyro.times[first - 1] - interval;
    GyroRates closed = gyro;
    for (std::size_t k = first; k < closed.times.size(); ++k) closed.times[k] -= seconds;
    const double there = evidence(closed);
    if (!(there + price_of_jump < least)) continue;
    least = there;
    gyro = std::move(closed);
    jumps.push_back({.rate = first, .seconds = seconds});
  }
  return jumps;
}

}}  // namespace orispline
