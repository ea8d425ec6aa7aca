// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/path_turns.hpp>

#include <algorithm>
#include <utility>

#include <orispline/math/so3.hpp>
#include <orispline/smooth/smoothing_element.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

namespace columns = calibration_columns;

constexpr std::ptrdiff_t reference_reach = 8;  // orientations on either side whose mean a turn is seen from
constexpr int of_rates = columns::offset;      // the columns before are integrals along the path

using Slopes = Eigen::Matrix<double, 3, of_rates>;

/// By which scales, mount and cross-talk change a rate.
Eigen::Matrix<double, 3, 9> by_shape(const Eigen::Vector3d& rate) {
  Eigen::Matrix<double, 3, 9> slopes = Eigen::Matrix<double, 3, 9>::Zero();
  slopes.leftCols<3>().diagonal() = rate;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    slopes.col(3 + k) = Eigen::Vector3d::Unit(k).cross(rate);
    slopes(i, 6 + k) = rate[j];
    slopes(j, 6 + k) = rate[i];
  }
  return slopes;
}

/// What a calibration adds to the rates at a time of the path [rad/s].
Eigen::Vector3d added(const GyroCalibration& calibration, double t) {
  return calibration.correction + (t - calibration.origin) * calibration.trend;
}

/// The integral of what the unknowns change in the rates, in the frame of the path.
class PathIntegral {
 public:
  PathIntegral(const GyroPath& path, const GyroCalibration& calibration) : path_(path), calibration_(calibration) {}

  /// Forgets what was; times do not decrease.
  void start_at(double t) {
    at_ = t;
    from_ = path_.at(t);
    while (next_ < path_.times().size() && path_.times()[next_] <= t) ++next_;
  }

  /// From the time before.
  [[nodiscard]] Slopes to(double t) {
    Slopes sum = Slopes::Zero();
    for (; next_ < path_.times().size() && path_.times()[next_] < t; ++next_) advance(sum, path_.times()[next_]);
    if (t > at_) advance(sum, t);
    return sum;
  }

 private:
  /// By the rule of midpoints.
  void advance(Slopes& sum, double t) {
    const auto to = path_.at(t);
    if (from_ && to && from_->piece == to->piece) {
      const Eigen::Matrix3d turn = from_->orientation.slerp(0.5, to->orientation).toRotationMatrix();
      const double middle = 0.5 * (at_ + t);
      const Eigen::Vector3d rate = 0.5 * (from_->rate + to->rate) - added(calibration_, middle);
      sum.middleCols<3>(columns::correction) += (t - at_) * turn;
      sum.middleCols<9>(columns::scale) += (t - at_) * turn * by_shape(rate);
      sum.middleCols<3>(columns::trend) += (t - at_) * (middle - calibration_.origin) * turn;
    }
    from_ = to;
    at_ = t;
  }

  const GyroPath& path_;
  const GyroCalibration& calibration_;
  std::optional<GyroPath::Point> from_;
  double at_ = 0.0;
  std::size_t next_ = 0;
};

/// An orientation against the path.
struct Beside {
  double time;
  Eigen::Quaterniond turn;
  GyroPath::Point point;
  double share;
};

std::vector<Beside> all_beside(const SeenPoses& poses, const GyroPath& path, double offset) {
  std::vector<Beside> all;
  for (std::size_t i = 0; i < poses.times.size(); ++i) {
    const auto point = poses.counts[i] ? path.at(poses.times[i] + offset) : std::nullopt;
    if (!point) continue;
    Eigen::Quaterniond turn = poses.orientations[i] * point->orientation.conjugate();
    if (!all.empty() && turn.dot(all.back().turn) < 0.0) turn.coeffs() = -turn.coeffs();
    all.push_back({poses.times[i], turn, *point, poses.shares.empty() ? 1.0 : poses.shares[i]});
  }
  return all;
}

/// The mean turn of those about one, of the same piece.
Eigen::Quaterniond mean_about(const std::vector<Beside>& all, std::ptrdiff_t i) {
  const auto count = static_cast<std::ptrdiff_t>(all.size());
  const std::ptrdiff_t reach = std::min({reference_reach, i, count - 1 - i});
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (std::ptrdiff_t k = i - reach; k <= i + reach; ++k) {
    const Beside& other = all[static_cast<std::size_t>(k)];
    if (other.point.piece == all[static_cast<std::size_t>(i)].point.piece) sum += other.turn.coeffs();
  }
  Eigen::Quaterniond mean;
  mean.coeffs() = sum.normalized();
  return mean;
}

/// The turn x in the world [rad] with to = exp(x) from.
Eigen::Vector3d world_increment(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) {
  return shortest_increment(to.conjugate(), from.conjugate());
}

}  // namespace

GyroRates calibrated(const GyroRates& gyro, const GyroCalibration& calibration) {
  GyroRates rates = gyro;
  for (std::size_t k = 0; k < rates.times.size(); ++k) {
    double& t = rates.times[k];
    if (calibration.clock_rate != 0.0) t -= calibration.clock_rate * (t - calibration.origin);
    rates.rates[k] = (calibration.shape * rates.rates[k] + (t - calibration.origin) * calibration.trend).eval();
  }
  return rates;
}

Eigen::Matrix3d shape_of(const CalibrationUnknowns& unknowns) {
  Eigen::Matrix3d shape = Eigen::Matrix3d::Identity();
  for (int k = 0; k < 3; ++k) shape.col(k) += by_shape(Eigen::Vector3d::Unit(k)) * unknowns.segment<9>(columns::scale);
  return shape;
}

std::vector<PathTurn> path_turns(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                                 const GyroCalibration& calibration) {
  const GyroPath path(calibrated(gyro, calibration), counts, calibration.correction);
  const std::vector<Beside> all = all_beside(poses, path, calibration.offset);
  PathIntegral integral(path, calibration);
  std::vector<PathTurn> turns;
  Eigen::Vector3d way = Eigen::Vector3d::Zero();
  Slopes slopes = Slopes::Zero();
  Eigen::Quaterniond before = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < all.size(); ++i) {
    const Beside& here = all[i];
    const double at = here.time + calibration.offset;
    const Eigen::Quaterniond reference = mean_about(all, static_cast<std::ptrdiff_t>(i));
    PathTurn& turn = turns.emplace_back();
    turn.starts = i == 0 || here.point.piece != all[i - 1].point.piece;
    turn.share = here.share;
    turn.walked.setZero();
    if (turn.starts) {
      integral.start_at(at);
    } else {
      turn.interval = here.time - all[i - 1].time;
      way += world_increment(before, reference);
      const Slopes step = reference.toRotationMatrix() * integral.to(at);
      turn.walked = step.leftCols<3>();
      slopes += step;
    }
    turn.turn = way + world_increment(reference, here.turn);
    turn.to_world = (reference * here.point.orientation).toRotationMatrix();
    turn.slopes.leftCols<of_rates>() = slopes;
    turn.slopes.col(columns::offset) = turn.to_world * here.point.rate;
    // A clock that runs fast stretches the time over which rates are integrated: so much less than with its stamps.
    turn.slopes.col(columns::clock_rate) =
        (at - calibration.origin) * turn.to_world * (here.point.rate - added(calibration, at)) -
        slopes.middleCols<3>(columns::scale).rowwise().sum();
    before = reference;
  }
  return turns;
}

}}  // namespace orispline
