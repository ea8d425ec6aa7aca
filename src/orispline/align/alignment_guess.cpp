// SPDX-License-Identifier: Apache-2.0
#include <orispline/align/alignment_guess.hpp>

#include <algorithm>
#include <span>
#include <vector>

#include <Eigen/Core>

#include <orispline/align/clock_search.hpp>
#include <orispline/math/eigensystem.hpp>
#include <orispline/math/median.hpp>
#include <orispline/mean/mean.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr double least_pull = 1e-3;  // towards no rotation, where all turns have one axis

/// Horn's form of a pair of vectors: qᵀ M q = to · R(q) from, with q = (w, x, y, z).
Eigen::Matrix4d horn_form(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  const double dot = from.dot(to);
  const Eigen::Vector3d cross = from.cross(to);
  Eigen::Matrix4d form;
  form(0, 0) = dot;
  form.block<3, 1>(1, 0) = cross;
  form.block<1, 3>(0, 1) = cross.transpose();
  form.block<3, 3>(1, 1) = from * to.transpose() + to * from.transpose() - dot * Eigen::Matrix3d::Identity();
  return form;
}

/// W for a given B, or B where W is taken to be none: the median of those at some times.
void complete(Transform& guess, const AlignmentData& data, const AnyCurve& fixed, const Intervals& intervals) {
  constexpr std::size_t enough = 256;  // of which a median is near to that of all
  const std::size_t stride = 1 + intervals.count / enough;
  const bool is_of_world = data.options.world_turn;
  std::vector<Eigen::Quaterniond> seen;
  for (std::size_t i = 0; i <= intervals.count; i += stride) {
    const double t = intervals.start + static_cast<double>(i) * intervals.length;
    const Eigen::Quaterniond there = data.moved.orientation(t + guess.offset) * guess.body.conjugate();
    const Eigen::Quaterniond here = fixed(t);
    seen.push_back(is_of_world ? here * there.conjugate() : here.conjugate() * there);
  }
  // Only orientations that cancel have no median: then none of them is a better guess than no rotation.
  if (const auto middle = mean({.orientations = seen}, {.kind = MeanKind::median}))
    (is_of_world ? guess.world : guess.body) = middle->orientation;
}

/// Scale and origin that suit the rotations: the ratio of the distances from the middles, and what is between these.
void place(Transform& guess, const AlignmentData& data) {
  const Domain domain = data.moved.orientation.domain();
  const auto times = data.fixed.times();
  Points moved, fixed;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (const double t = times[i] + guess.offset; domain.contains(t)) {
      moved.push_back(to_world<double>(guess.world, data.moved.position->linear_motion(t).position));
      fixed.push_back(data.fixed.positions()[i]);
    }
  if (moved.empty()) return;
  const Eigen::Vector3d middle_of_moved = median_of_each(moved), middle_of_fixed = median_of_each(fixed);
  const double spread_of_moved = median_distance_from(middle_of_moved, moved);
  const double spread_of_fixed = median_distance_from(middle_of_fixed, fixed);
  if (data.options.scale && spread_of_moved > 0.0 && spread_of_fixed > 0.0)
    guess.scale = spread_of_fixed / spread_of_moved;
  if (data.options.translation) guess.translation = middle_of_fixed - guess.scale * middle_of_moved;
}

}  // namespace

double median_distance_from(const Eigen::Vector3d& middle, std::vector<Eigen::Vector3d> points) {
  for (Eigen::Vector3d& p : points) p -= middle;
  return median_of_lengths(points);
}

// Source: Horn 1987, the largest eigenvector of the sum of the forms, weighted anew by the distances that are left.
Eigen::Quaterniond rotation_between(std::span<const Eigen::Vector3d> from, std::span<const Eigen::Vector3d> to,
                                    double pull) {
  constexpr int rounds = 15;
  double sizes = 0.0;
  for (const Eigen::Vector3d& v : to) sizes += v.norm();
  const double least_distance = 1e-3 * sizes / static_cast<double>(to.size()) + 1e-300;
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  std::vector<double> weights(from.size(), 1.0);
  for (int round = 0; round < rounds; ++round) {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    double weight = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) {
      sum += weights[i] * horn_form(from[i], to[i]);
      weight += weights[i] * (from[i].norm() * to[i].norm());
    }
    sum(0, 0) += pull * weight;
    const Eigen::Vector4d best = eigensystem<4>(sum).vectors.col(3);
    rotation = Eigen::Quaterniond(best[0], best[1], best[2], best[3]).normalized();
    for (std::size_t i = 0; i < from.size(); ++i)
      weights[i] = 1.0 / std::max((to_world<double>(rotation, from[i]) - to[i]).norm(), least_distance);
  }
  return rotation;
}

std::optional<Intervals> common_intervals(Domain moved, Domain fixed, double interval, double offset) {
  constexpr double most = 4096;
  const double start = std::max(fixed.start, moved.start - offset), end = std::min(fixed.end, moved.end - offset);
  const double length = std::max(interval, (end - start) / most);
  if (!(end - start >= length * static_cast<double>(least_aligned))) return std::nullopt;
  return Intervals{start, length, static_cast<std::size_t>((end - start) / length)};
}

std::optional<Transform> guess_alignment(const AlignmentData& data, const AnyCurve& fixed, double interval,
                                         double offset) {
  const AnyCurve& moved = data.moved.orientation;
  const auto intervals = common_intervals(moved.domain(), fixed.domain(), interval, offset);
  if (!intervals) return std::nullopt;
  Transform guess{.offset = offset};
  const auto& [start, length, count] = *intervals;
  if (data.options.body_turn && data.options.world_turn)
    guess.body = rotation_between(turns_in_intervals(moved, start + offset, length, count),
                                  turns_in_intervals(fixed, start, length, count), least_pull);
  if (data.options.body_turn || data.options.world_turn) complete(guess, data, fixed, *intervals);
  if (data.has_positions) place(guess, data);
  return guess;
}

}}  // namespace orispline
