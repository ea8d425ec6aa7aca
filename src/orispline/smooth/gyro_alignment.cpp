// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_alignment.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

#include <orispline/math/median.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double widest_search = 5.0, searched_share = 0.25;  // [s]; of the recording
constexpr std::size_t most_compared = 1500;                   // orientations, in the search
constexpr double trusted_share = 0.85;                        // of the rates, in the search
constexpr double clearly_better = 0.8;                        // of the misfit without an offset

constexpr double longest_window = 10.0;  // [s], for a bias drifts
constexpr std::size_t fewest_in_window = 8, usual_in_window = 30;
constexpr double huber = 2.5;  // in units of the noise
constexpr int most_iterations = 12;
constexpr std::size_t block = 8;  // of residuals whose means show what the gyro does slowly

double misfit_at(const std::vector<double>& times, const std::vector<Eigen::Vector3d>& turned, const GyroPath& path,
                 double offset) {
  std::vector<Eigen::Vector3d> differences;
  for (std::size_t k = 0; k < times.size(); ++k)
    if (const auto rate = path.rate_at(times[k] + offset)) differences.emplace_back(*rate - turned[k]);
  if (2 * differences.size() < times.size()) return std::numeric_limits<double>::infinity();
  const Eigen::Vector3d middle = median_of_each(differences);
  std::vector<double> squares;
  for (const Eigen::Vector3d& d : differences) squares.push_back((d - middle).squaredNorm());
  const auto trusted = static_cast<std::size_t>(trusted_share * static_cast<double>(squares.size()));
  std::ranges::nth_element(squares, squares.begin() + static_cast<std::ptrdiff_t>(trusted));
  double sum = 0.0;
  for (std::size_t k = 0; k < trusted; ++k) sum += squares[k];
  return sum / static_cast<double>(std::max<std::size_t>(trusted, 1));
}

/// An orientation against the path of the gyro: the turn of the path into the world, constant where the gyro is right,
/// and by which it moves with offset and correction.
struct Beside {
  Eigen::Quaterniond turn;
  Eigen::Matrix<double, 3, 4> slopes;
};

/// Successive ones that share one turn.
using Window = std::vector<Beside>;

Eigen::Quaterniond mean_turn(const Window& window) {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (const Beside& one : window) {
    const Eigen::Vector4d& q = one.turn.coeffs();
    sum += q.dot(window.front().turn.coeffs()) < 0.0 ? Eigen::Vector4d(-q) : q;
  }
  Eigen::Quaterniond mean;
  mean.coeffs() = sum.normalized();
  return mean;
}

std::vector<Window> windows_of(const SeenPoses& poses, const GyroPath& path, double offset, double length) {
  std::vector<Window> windows;
  double begin = 0.0;
  std::optional<std::size_t> piece;
  for (std::size_t i = 0; i < poses.times.size(); ++i) {
    if (!poses.counts[i]) continue;
    const auto point = path.at(poses.times[i] + offset);
    if (!point) continue;
    if (point->piece != piece || poses.times[i] - begin > length) {
      windows.emplace_back();
      begin = poses.times[i];
      piece = point->piece;
    }
    Beside beside{poses.orientations[i] * point->orientation.conjugate(), {}};
    beside.slopes << point->rate, point->by_correction;
    beside.slopes = (point->orientation.toRotationMatrix() * beside.slopes).eval();
    windows.back().push_back(beside);
  }
  std::erase_if(windows, [](const Window& window) { return window.size() < 3; });
  return windows;
}

/// One step of Gauss and Newton, and how sure it is.
struct Step {
  Eigen::Vector4d change;
  Eigen::Matrix4d covariance;
};

class Regression {
 public:
  explicit Regression(const std::vector<Window>& windows) {
    std::vector<double> lengths;
    for (const Window& window : windows) {
      const Eigen::Quaterniond mean = mean_turn(window);
      auto& residuals = residuals_.emplace_back();
      for (const Beside& one : window) residuals.push_back(shortest_increment(mean, one.turn));
      // An outlier pulls the mean little, but a window of three much.
      for (const Eigen::Vector3d& r : residuals) lengths.push_back(r.norm());
    }
    noise_ = std::max(least_noise, median(std::move(lengths)) / median_length);
  }

  [[nodiscard]] std::optional<Step> step(const std::vector<Window>& windows, bool finds_offset) const {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t w = 0; w < windows.size(); ++w) add(windows[w], residuals_[w], normal, right);
    if (!finds_offset) {
      normal.row(0).setZero();
      normal.col(0).setZero();
      normal(0, 0) = 1.0;
      right[0] = 0.0;
    }
    const Eigen::Vector4d scale = normal.diagonal().cwiseSqrt().cwiseMax(1e-300).cwiseInverse();
    const Eigen::LDLT<Eigen::Matrix4d> solver(scale.asDiagonal() * normal * scale.asDiagonal());
    if (!(solver.vectorD().minCoeff() > 1e-9)) return std::nullopt;
    const Eigen::Matrix4d inverse = scale.asDiagonal() * solver.solve(Eigen::Matrix4d::Identity()) * scale.asDiagonal();
    return Step{inverse * right, noise_ * noise_ * slowness() * inverse};
  }

 private:
  void add(const Window& window, const std::vector<Eigen::Vector3d>& residuals, Eigen::Matrix4d& normal,
           Eigen::Vector4d& right) const {
    Eigen::Matrix<double, 3, 4> mean_slopes = Eigen::Matrix<double, 3, 4>::Zero();
    double sum = 0.0;
    const auto weight = [&](std::size_t i) {
      const double length = residuals[i].norm();
      return length > huber * noise_ ? huber * noise_ / length : 1.0;
    };
    for (std::size_t i = 0; i < window.size(); ++i) {
      mean_slopes += weight(i) * window[i].slopes;
      sum += weight(i);
    }
    for (std::size_t i = 0; i < window.size(); ++i) {
      const Eigen::Matrix<double, 3, 4> slopes = window[i].slopes - mean_slopes / sum;
      normal += weight(i) * slopes.transpose() * slopes;
      right += weight(i) * slopes.transpose() * residuals[i];  // the slopes are without their mean
    }
  }

  /// How much more than by chance the residuals keep together: the variance of their means over successive ones.
  [[nodiscard]] double slowness() const {
    double of_means = 0.0, of_all = 0.0, means = 0.0, all = 0.0;
    for (const auto& residuals : residuals_)
      for (std::size_t begin = 0; begin + block <= residuals.size(); begin += block) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (std::size_t i = begin; i < begin + block; ++i) {
          sum += residuals[i];
          of_all += residuals[i].squaredNorm();
        }
        of_means += sum.squaredNorm() / static_cast<double>(block);
        means += 1.0;
        all += static_cast<double>(block);
      }
    return all > 0.0 && of_all > 0.0 ? std::max(1.0, of_means / means / (of_all / all)) : 1.0;
  }

  std::vector<std::vector<Eigen::Vector3d>> residuals_;
  double noise_ = 0.0;
};

}  // namespace

std::optional<Eigen::Vector3d> rate_of_poses(const SeenPoses& poses, double t) {
  const auto& times = poses.times;
  if (times.size() < 2 || t < times.front() || t > times.back()) return std::nullopt;
  const auto behind = static_cast<std::size_t>(std::ranges::upper_bound(times, t) - times.begin());
  const std::size_t k = std::min(behind, times.size() - 1) - 1;
  const double h = times[k + 1] - times[k], u = (t - times[k]) / h;
  const SmoothedNodes& fit = *poses.fitted;
  return (1.0 + 2.0 * u) * (1.0 - u) * (1.0 - u) * fit.angular_velocities[k] +
         u * u * (3.0 - 2.0 * u) * fit.angular_velocities[k + 1] +
         h * u * (1.0 - u) * ((1.0 - u) * fit.angular_accelerations[k] - u * fit.angular_accelerations[k + 1]);
}

double coarse_offset(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts) {
  const GyroPath path(gyro, counts, Eigen::Vector3d::Zero());
  const std::size_t stride = poses.times.size() / most_compared + 1;
  std::vector<double> times;
  std::vector<Eigen::Vector3d> turned;
  for (std::size_t i = 0; i < poses.times.size(); i += stride) {
    times.push_back(poses.times[i]);
    turned.push_back(poses.fitted->angular_velocities[i]);
  }
  const double span = poses.times.back() - poses.times.front();
  const double step = std::max(path.interval(), 0.5 * median_interval(poses.times));
  const double widest = std::min(widest_search, searched_share * span);
  if (!(step > 0.0)) return 0.0;
  const double without = misfit_at(times, turned, path, 0.0);
  double best = 0.0, least = without;
  for (int k = 1; k * step <= widest; ++k)
    for (const double offset : {k * step, -k * step})
      if (const double misfit = misfit_at(times, turned, path, offset); misfit < least) {
        least = misfit;
        best = offset;
      }
  return least < clearly_better * without ? best : 0.0;
}

GyroAlignment aligned(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts, double gyro_noise,
                      GyroAlignment near, bool finds_offset) {
  const double pose_interval = median_interval(poses.times);
  const double gyro_interval = GyroPath(gyro, counts, near.correction).interval();
  const double surer = poses.noise * poses.noise / (gyro_noise * gyro_noise * gyro_interval);  // [s]
  const double length = std::clamp(surer, static_cast<double>(fewest_in_window) * pose_interval,
                                   std::max(longest_window, static_cast<double>(usual_in_window) * pose_interval));
  GyroAlignment found = near;
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const GyroPath path(gyro, counts, found.correction);
    const std::vector<Window> windows = windows_of(poses, path, found.offset, length);
    if (windows.empty()) return near;
    const auto step = Regression(windows).step(windows, finds_offset);
    if (!step) return finds_offset ? aligned(poses, gyro, counts, gyro_noise, near, false) : near;
    const double most = 2.0 * std::max(gyro_interval, pose_interval), change = std::clamp(step->change[0], -most, most);
    found.offset += change;
    found.correction += step->change.tail<3>();
    found.offset_sigma = finds_offset ? std::optional(std::sqrt(step->covariance(0, 0))) : std::nullopt;
    const Eigen::Vector4d sigmas = step->covariance.diagonal().cwiseSqrt();
    if (std::abs(change) <= 1e-3 * sigmas[0] && step->change.tail<3>().norm() <= 1e-3 * sigmas.tail<3>().norm()) break;
  }
  return found;
}

}}  // namespace orispline
