// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_path.hpp>

#include <algorithm>
#include <cmath>

#include <orispline/math/median.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double longest_bridge = 3.5;  // in intervals: two rates that are missing
constexpr double uneven = 3.0;          // ratio of intervals from which on no cubic is laid through rates

/// The turn under a rate that changes linearly within h: the first two terms of Magnus' series.
Eigen::Vector3d turn_of(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double h) {
  return 0.5 * h * (from + to) + h * h / 12.0 * from.cross(to);
}

GyroPath::Point moved(const GyroPath::Point& from, const Eigen::Vector3d& rate, double h) {
  const Eigen::Vector3d turn = turn_of(from.rate, rate, h);
  const Eigen::Quaterniond step = exp<double>(turn), half = exp<double>(Eigen::Vector3d(0.5 * turn));
  return {.orientation = (from.orientation * step).normalized(),
          .rate = rate,
          .by_correction =
              step.conjugate().toRotationMatrix() * from.by_correction + h * half.conjugate().toRotationMatrix(),
          .turned = from.turned + 0.5 * h * (from.rate.norm() + rate.norm()),
          .piece = from.piece};
}

}  // namespace

GyroPath::GyroPath(const GyroRates& gyro, const CountedRates& counts, const Eigen::Vector3d& correction) {
  for (std::size_t k = 0; k < gyro.times.size(); ++k) {
    if (!counts[k]) continue;
    rows_.push_back(k);
    times_.push_back(gyro.times[k]);
    rates_.emplace_back(gyro.rates[k] + correction);
  }
  interval_ = median_interval(times_);
  for (std::size_t k = 0; k < times_.size(); ++k) {
    if (k == 0) {
      points_.push_back({Eigen::Quaterniond::Identity(), rates_[0], Eigen::Matrix3d::Zero(), 0.0, 0});
      continue;
    }
    const double h = times_[k] - times_[k - 1];
    points_.push_back(moved(points_.back(), rates_[k], h));
    if (h > longest_bridge * interval_) ++points_.back().piece;
  }
}

std::optional<std::size_t> GyroPath::interval_about(double t) const {
  if (times_.size() < 2 || t < times_.front() || t > times_.back()) return std::nullopt;
  const auto behind = std::ranges::upper_bound(times_, t);
  const std::size_t k = std::min(static_cast<std::size_t>(behind - times_.begin()), times_.size() - 1) - std::size_t{1};
  if (points_[k].piece != points_[k + 1].piece && t != times_[k] && t != times_[k + 1]) return std::nullopt;
  return k;
}

Eigen::Vector3d GyroPath::rate_in(std::size_t k, double t) const {
  const double h = times_[k + 1] - times_[k], share = (t - times_[k]) / h;
  Eigen::Vector3d straight = (1.0 - share) * rates_[k] + share * rates_[k + 1];
  if (k == 0 || k + 2 >= times_.size()) return straight;
  const double before = times_[k] - times_[k - 1], after = times_[k + 2] - times_[k + 1];
  if (std::max({before, h, after}) > uneven * std::min({before, h, after})) return straight;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // Lagrange's form
  for (std::size_t i = k - 1; i < k + 3; ++i) {
    double weight = 1.0;
    for (std::size_t j = k - 1; j < k + 3; ++j)
      if (j != i) weight *= (t - times_[j]) / (times_[i] - times_[j]);
    sum += weight * rates_[i];
  }
  return sum;
}

std::optional<Eigen::Vector3d> GyroPath::rate_at(double t) const {
  const auto k = interval_about(t);
  return k ? std::optional(rate_in(*k, t)) : std::nullopt;
}

std::optional<Eigen::Vector3d> GyroPath::measured_at(double t) const {
  const auto k = interval_about(t);
  if (!k) return std::nullopt;
  const double rounding = 1e-9 * interval_;
  if (std::abs(t - times_[*k]) <= rounding) return rates_[*k];
  if (std::abs(t - times_[*k + 1]) <= rounding) return rates_[*k + 1];
  const bool beside = rows_[*k] + 1 == rows_[*k + 1] && points_[*k].piece == points_[*k + 1].piece;
  return beside ? std::optional(rate_in(*k, t)) : std::nullopt;
}

std::optional<GyroPath::Point> GyroPath::at(double t) const {
  const auto k = interval_about(t);
  if (!k) return std::nullopt;
  if (t == times_[*k + 1]) return points_[*k + 1];
  return moved(points_[*k], rate_in(*k, t), t - times_[*k]);
}

}}  // namespace orispline
