// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_faults.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/rate_comparison.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Vectors = std::vector<Eigen::Vector3d>;

// All in medians of what they are compared with.
constexpr double single_fault = 20.0;  // a rate: the errors of the orientations' own rates come in bursts
constexpr double far = 5.0;            // a rate, or the mean of some, that may be wrong
constexpr double rim = 2.5;            // a rate beside such ones that may be wrong too
constexpr double jump = 5.0;           // of the turn between path and world across rates that are wrong
constexpr double zero_fault = 4.0;     // zeros in all three axes
constexpr double clipped_excess = 1.0;

constexpr double untold_turn = 0.5;  // [rad]: what integrating may be off by where rates tell nothing of the turn

constexpr double widest_step = 3.0;  // between orientations that tell a rate, in the median one

constexpr std::size_t longest_pair = 2, joined_over = 2;  // rates
constexpr std::size_t beside_run = 8;                     // orientations on either side of a run that say where it led
constexpr std::size_t fewest_clipped = 2;                 // in a row
constexpr double clipped_share = 0.8;                     // of the rates: with more it is a steady turn

/// Root of the mean square about the mean.
double spread(const Vectors& vectors) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& v : vectors) mean += v / static_cast<double>(vectors.size());
  double sum = 0.0;
  for (const Eigen::Vector3d& v : vectors) sum += (v - mean).squaredNorm();
  return std::sqrt(sum / static_cast<double>(vectors.size()));
}

/// The rates that count less those of the orientations, but for what they have in common.
struct Differences {
  std::vector<std::size_t> rows;  // of the gyro
  Vectors values;
  Eigen::Vector3d common = Eigen::Vector3d::Zero();

  Differences(const SeenPoses& poses, const GyroRates& gyro, double offset, const CountedRates& counts) {
    const double widest = widest_step * median_interval(poses.times);
    for (std::size_t k = 0; k < gyro.times.size(); ++k) {
      const double t = gyro.times[k] - offset;
      if (!counts[k] || !tells_rate(poses, t, widest)) continue;
      if (const auto turned = rate_of_poses(poses, t)) {
        rows.push_back(k);
        values.emplace_back(gyro.rates[k] - *turned);
      }
    }
    common = median_of_each(values);
    for (Eigen::Vector3d& value : values) value -= common;
  }

  /// Whether orientations stand near to both sides of a time.
  [[nodiscard]] static bool tells_rate(const SeenPoses& poses, double t, double widest) {
    const auto behind = std::ranges::lower_bound(poses.times, t);
    if (behind == poses.times.end() || behind == poses.times.begin())
      return behind != poses.times.end() && *behind == t;
    return *behind - *(behind - 1) <= widest;
  }
};

/// Successive ones of the differences, from `first` up to before `last`.
struct Run {
  std::size_t first, last;
};

/// Those that are far, by themselves or in the mean over one of several lags.
std::vector<bool> far_ones(const Vectors& values) {
  const double usual = std::max(least_noise, median_of_lengths(values));
  std::vector<bool> marked(values.size(), false);
  for (std::size_t i = 0; i < values.size(); ++i) marked[i] = values[i].norm() > far * usual;
  Vectors sums{Eigen::Vector3d::Zero()};
  for (const Eigen::Vector3d& v : values) sums.emplace_back(sums.back() + v);
  for (std::size_t lag = 2; lag <= values.size() / 10; lag *= 2) {
    Vectors means;
    for (std::size_t i = 0; i + lag <= values.size(); ++i)
      means.emplace_back((sums[i + lag] - sums[i]) / static_cast<double>(lag));
    const double limit = far * std::max(least_noise, median_of_lengths(means));
    for (std::size_t i = 0; i < means.size(); ++i)
      if (means[i].norm() > limit)
        for (std::size_t k = i; k < i + lag; ++k) marked[k] = marked[k] || values[k].norm() > rim * usual;
  }
  return marked;
}

std::vector<Run> runs_of(const std::vector<bool>& marked) {
  std::vector<Run> runs;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    if (!marked[i]) continue;
    if (!runs.empty() && i <= runs.back().last + joined_over) runs.back().last = i + 1;
    else runs.push_back({i, i + 1});
  }
  return runs;
}

/// The turn between the path of the gyro and the world, seen from the orientations; constant where the gyro is right.
class PathTurns {
 public:
  PathTurns(const SeenPoses& poses, const GyroRates& gyro, const GyroAlignment& alignment, const CountedRates& counts) {
    const GyroPath path(gyro, counts, alignment.correction);
    sums_.emplace_back(Eigen::Vector4d::Zero());
    Eigen::Vector4d before = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < poses.times.size(); ++i) {
      if (!poses.counts[i]) continue;
      const auto point = path.at(poses.times[i] + alignment.offset);
      if (!point) continue;
      Eigen::Vector4d turn = (poses.orientations[i] * point->orientation.conjugate()).coeffs();
      if (turn.dot(before) < 0.0) turn = -turn;
      before = turn;
      sums_.emplace_back(sums_.back() + turn);
      times_.push_back(poses.times[i] + alignment.offset);
    }
  }

  /// By how much it changes from before one time of the gyro to behind another, but for that angle [rad], in medians of
  /// such changes.
  [[nodiscard]] double change_beyond(double angle, double from, double to) const {
    const auto behind = std::ranges::upper_bound(times_, to), ahead = std::ranges::lower_bound(times_, from);
    const auto first = static_cast<std::size_t>(ahead - times_.begin()),
               last = static_cast<std::size_t>(behind - times_.begin());
    if (first < 2 || last + 2 > times_.size()) return 0.0;
    return (change(first, last) - angle) / std::max(least_noise, usual_change(last - first));
  }

 private:
  [[nodiscard]] Eigen::Quaterniond mean(std::size_t first, std::size_t last) const {
    Eigen::Quaterniond q;
    q.coeffs() = (sums_[last] - sums_[first]).normalized();
    return q;
  }
  [[nodiscard]] double change(std::size_t first, std::size_t last) const {
    return angular_distance(mean(first - std::min(first, beside_run), first),
                            mean(last, std::min(times_.size(), last + beside_run)));
  }
  [[nodiscard]] double usual_change(std::size_t length) const {
    std::vector<double> changes;
    for (std::size_t first = beside_run; first + length + beside_run <= times_.size(); ++first)
      changes.push_back(change(first, first + length));
    return median(std::move(changes));
  }

  std::vector<double> times_;
  std::vector<Eigen::Vector4d> sums_;
};

/// What integrating by trapezoids is off by at most [rad], of rates in a row and those beside them.
double integration_error(const GyroRates& gyro, std::size_t first, std::size_t last) {
  double sum = 0.0;
  for (std::size_t k = std::max<std::size_t>(first, 1); k <= last && k + 1 < gyro.rates.size(); ++k)
    sum += 0.5 * (gyro.times[k + 1] - gyro.times[k - 1]) / 12.0 *
           (gyro.rates[k + 1] - 2.0 * gyro.rates[k] + gyro.rates[k - 1]).norm();
  return sum;
}

bool all_zero(const Eigen::Vector3d& rate) { return (rate.array() == 0.0).all(); }

constexpr std::size_t fewest_stuck = 5;  // rates in a row that are the same to the last bit
constexpr std::size_t usual_runs = 4;    // as long as so many usual runs: a sensor that repeats itself is none

/// Successive rates that are all the same in three axes, for longer than this gyro repeats itself as a rule.
std::vector<Run> stuck_runs(const GyroRates& gyro) {
  std::vector<Run> runs;
  for (std::size_t k = 0; k < gyro.rates.size(); ++k) {
    if (k > 0 && gyro.rates[k] == gyro.rates[k - 1]) runs.back().last = k + 1;
    else runs.push_back({k, k + 1});
  }
  std::vector<double> lengths;
  for (const Run& run : runs)
    lengths.insert(lengths.end(), run.last - run.first, static_cast<double>(run.last - run.first));
  const auto longest =
      std::max<std::size_t>(fewest_stuck, usual_runs * static_cast<std::size_t>(median(std::move(lengths))));
  std::erase_if(runs, [longest](const Run& run) { return run.last - run.first < longest; });
  return runs;
}

/// Rates that stay the same while the orientations turn otherwise; the first of them was measured.
void leave_out_stuck(const Differences& differences, const GyroRates& gyro, double usual, CountedRates& counts) {
  std::vector<double> off(gyro.rates.size(), 0.0);
  for (std::size_t i = 0; i < differences.rows.size(); ++i) off[differences.rows[i]] = differences.values[i].norm();
  for (const Run& run : stuck_runs(gyro)) {
    const auto begin = off.begin() + static_cast<std::ptrdiff_t>(run.first),
               end = off.begin() + static_cast<std::ptrdiff_t>(run.last);
    if (*std::max_element(begin, end) > zero_fault * usual)
      for (std::size_t k = run.first + 1; k < run.last; ++k) counts[k] = false;
  }
}

/// Rates of one axis that stay at its largest absolute value while the orientations turn faster that way.
void leave_out_clipped(const Differences& differences, const GyroRates& gyro, Eigen::Index axis, CountedRates& counts) {
  double largest = 0.0;
  std::vector<double> sizes;
  for (std::size_t i = 0; i < differences.rows.size(); ++i) {
    largest = std::max(largest, std::abs(gyro.rates[differences.rows[i]][axis]));
    sizes.push_back(std::abs(differences.values[i][axis]));
  }
  std::vector<std::size_t> clipped;
  double excess = 0.0;
  std::size_t longest = 0, run = 0;
  for (std::size_t i = 0; i < differences.rows.size(); ++i) {
    const double rate = gyro.rates[differences.rows[i]][axis];
    const bool is_largest = largest > 0.0 && std::abs(rate) == largest;
    run = is_largest ? run + 1 : 0;
    longest = std::max(longest, run);
    if (!is_largest) continue;
    clipped.push_back(differences.rows[i]);
    excess -= rate > 0.0 ? differences.values[i][axis] : -differences.values[i][axis];
  }
  if (longest < fewest_clipped ||
      static_cast<double>(clipped.size()) > clipped_share * static_cast<double>(sizes.size()))
    return;
  if (excess / static_cast<double>(clipped.size()) <= clipped_excess * median(std::move(sizes))) return;
  for (const std::size_t row : clipped) counts[row] = false;
}

/// The rates of the gyro at the times of the orientations, beside theirs.
struct RatesBeside {
  std::vector<Eigen::Quaterniond> orientations{};
  Vectors fitted{}, measured{}, differences{};

  RatesBeside(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts, double offset) {
    const GyroPath path(gyro, counts, Eigen::Vector3d::Zero());
    for (std::size_t i = 0; i < poses.times.size(); ++i) {
      const auto rate = path.rate_at(poses.times[i] + offset);
      if (!rate) continue;
      orientations.push_back(poses.fitted->orientations[i]);
      fitted.push_back(poses.fitted->angular_velocities[i]);
      measured.push_back(*rate);
      differences.emplace_back(*rate - fitted.back());
    }
  }

  [[nodiscard]] Expected<void> check_frame() const {
    const RateComparison comparison{orientations, measured, fitted, RateComparison::Bias::constant};
    const auto meaning = orientations.empty() ? std::nullopt : comparison.better_meaning();
    if (!meaning) return {};
    return failure(ErrorCode::bad_data,
                   formatted("the gyro's rates contradict the orientations: they vary by {:.3g} rad/s, those of the "
                             "orientations by {:.3g} rad/s, the difference by {:.3g} rad/s; {}",
                             spread(measured), spread(fitted), spread(differences), meaning->cure));
  }
};

/// Without rates so fast that they are rather faults than motion.
CountedRates usual_rates(const GyroRates& gyro) {
  const double limit = single_fault * median_of_lengths(gyro.rates);
  CountedRates counts;
  for (const Eigen::Vector3d& rate : gyro.rates) counts.push_back(rate.norm() <= limit);
  return counts;
}

}  // namespace

bool leave_out_faults(const SeenPoses& poses, const GyroRates& gyro, const GyroAlignment& alignment,
                      CountedRates& counts) {
  const CountedRates before = counts;
  const Differences differences(poses, gyro, alignment.offset, counts);
  if (differences.rows.size() < beside_run) return false;
  for (Eigen::Index axis = 0; axis < 3; ++axis) leave_out_clipped(differences, gyro, axis, counts);
  const double usual = std::max(least_noise, median_of_lengths(differences.values));
  leave_out_stuck(differences, gyro, usual, counts);
  const PathTurns turns(poses, gyro, alignment, before);
  for (const Run& run : runs_of(far_ones(differences.values))) {
    double farthest = 0.0;
    for (std::size_t i = run.first; i < run.last; ++i) farthest = std::max(farthest, differences.values[i].norm());
    const bool single = run.last - run.first <= longest_pair && farthest > single_fault * usual;
    const double half = 0.5 * median_interval(gyro.times);
    const std::size_t first = differences.rows[run.first], last = differences.rows[run.last - 1];
    const double rounding = integration_error(gyro, first, last + 1);
    if (!single && rounding < untold_turn &&
        turns.change_beyond(rounding, gyro.times[first] - half, gyro.times[last] + half) < jump)
      continue;
    for (std::size_t i = run.first; i < run.last; ++i) counts[differences.rows[i]] = false;
  }
  for (std::size_t i = 0; i < differences.rows.size(); ++i)
    if (all_zero(gyro.rates[differences.rows[i]]) && differences.values[i].norm() > zero_fault * usual)
      counts[differences.rows[i]] = false;
  return counts != before;
}

Expected<void> check_frame(const SeenPoses& poses, const GyroRates& gyro) {
  return RatesBeside(poses, gyro, usual_rates(gyro), 0.0).check_frame();
}

Expected<void> check_meaning(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts, double offset) {
  constexpr double unit_threshold = 20.0;    // between right rates and those in degrees, 57 times as large
  constexpr double noise_threshold = 10.0;   // of the rates, in their noise: below it they tell nothing
  constexpr double against_threshold = 1.5;  // of independent rates the difference is √2 times one of them at most
  const RatesBeside rates(poses, gyro, counts, offset);
  if (rates.orientations.empty()) return {};
  if (auto checked = rates.check_frame(); !checked) return checked;
  const double fitted = spread(rates.fitted), measured = spread(rates.measured), difference = spread(rates.differences);
  const double noise = local_noise(gyro.times, gyro.rates);
  if (measured > unit_threshold * fitted && measured > noise_threshold * noise)
    return failure(ErrorCode::bad_data, formatted("the gyro's rates vary by {:.3g} rad/s, those of the orientations by "
                                                  "{:.3g} rad/s, wanted a gyro in rad/s",
                                                  measured, fitted));
  if (difference > against_threshold * std::max(fitted, measured))
    return failure(
        ErrorCode::bad_data,
        formatted("the gyro turns against the orientations: their rates vary by {:.3g} and {:.3g} rad/s, the "
                  "difference by {:.3g} rad/s, wanted rates of the body in its own frame, and `gyro_offset` where the "
                  "clocks differ by a quarter of the recording or by 5 s",
                  measured, fitted, difference));
  return {};
}

}}  // namespace orispline
