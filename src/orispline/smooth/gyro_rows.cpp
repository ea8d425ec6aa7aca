// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/gyro_rows.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <orispline/base/formatted.hpp>
#include <orispline/math/degrees.hpp>
#include <orispline/math/median.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double counted_turn = 5.0 / 6.0 * pi;    // between two orientations [rad], from which on turns are counted
constexpr double counted_share = 0.1;              // of the intervals
constexpr double undecided_turn = 2.0 / 3.0 * pi;  // off the next orientation [rad]
constexpr int rounds_of_correction = 3;
constexpr double longest_turn = 2.0 / 3.0 * pi;  // in one step of the curve [rad]
constexpr double turn_between = 0.5 * pi;        // nodes that are put into a longer one [rad]
constexpr double same_time = 1e-3;               // of an interval, of two clocks; of one the rounding
constexpr double same_row = 1e-9;

/// An orientation that counts, and the turn of the gyro's path into the world there.
struct Anchor {
  double time;
  Eigen::Quaterniond orientation;
  std::optional<GyroPath::Point> point;
};

std::vector<Anchor> anchors_of(const SeenPoses& poses, const GyroPath& path, double offset) {
  std::vector<Anchor> anchors;
  for (std::size_t i = 0; i < poses.times.size(); ++i)
    if (poses.counts[i])
      anchors.push_back({poses.times[i], poses.fitted ? poses.fitted->orientations[i] : poses.orientations[i],
                         path.at(poses.times[i] + offset)});
  return anchors;
}

/// From one orientation to the next one as the path turns, and what is left to it.
Eigen::Vector3d left_after(const Anchor& from, const Anchor& to) {
  const Eigen::Quaterniond there = from.orientation * (from.point->orientation.conjugate() * to.point->orientation);
  return shortest_increment(there, to.orientation);
}

bool of_one_piece(const Anchor& from, const Anchor& to) {
  return from.point && to.point && from.point->piece == to.point->piece;
}

Eigen::Quaterniond between(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to, double share) {
  return from * exp<double>(Eigen::Vector3d(share * shortest_increment(from, to)));
}

/// Orientations that follow the gyro from anchor to anchor; what is left at the next one is made up for evenly.
class LedOrientations {
 public:
  LedOrientations(std::vector<Anchor> anchors, const GyroPath& path, double offset)
      : anchors_(std::move(anchors)), path_(path), offset_(offset) {}

  [[nodiscard]] Eigen::Quaterniond at(double t) {
    while (next_ < anchors_.size() && anchors_[next_].time <= t) ++next_;
    const auto point = path_.at(t + offset_);
    if (next_ == 0) return led(anchors_.front(), point);
    const Anchor& before = anchors_[next_ - 1];
    if (next_ == anchors_.size()) return led(before, point);
    const Anchor& after = anchors_[next_];
    const double share = (t - before.time) / (after.time - before.time);
    const bool leads_there = point && of_one_piece(before, after) && point->piece == before.point->piece;
    if (!leads_there) return between(led(before, point), led(after, point), share);
    const Eigen::Quaterniond turn = between(before.orientation * before.point->orientation.conjugate(),
                                            after.orientation * after.point->orientation.conjugate(), share);
    return (turn * point->orientation).normalized();
  }

 private:
  [[nodiscard]] static Eigen::Quaterniond led(const Anchor& anchor, const std::optional<GyroPath::Point>& point) {
    if (!point || !anchor.point || point->piece != anchor.point->piece) return anchor.orientation;
    return (anchor.orientation * anchor.point->orientation.conjugate() * point->orientation).normalized();
  }

  std::vector<Anchor> anchors_;
  const GyroPath& path_;
  double offset_;
  std::size_t next_ = 0;
};

/// The times of nodes, and which orientation and which rate belong to each.
struct NodeTimes {
  std::vector<double> times{};
  std::vector<std::optional<std::size_t>> poses{};
  std::vector<std::optional<std::size_t>> rates{};

  void add(double t, std::optional<std::size_t> pose, std::optional<std::size_t> rate) {
    times.push_back(t);
    poses.push_back(pose);
    rates.push_back(rate);
  }
};

NodeTimes merged(const SeenPoses& poses, const GyroRates& gyro, double offset) {
  const bool one_clock = gyro.clock == GyroRates::Clock::of_the_recording;
  const double shift = one_clock ? 0.0 : offset;
  const double same =
      (one_clock ? same_row : same_time) * std::min(median_interval(poses.times), median_interval(gyro.times));
  NodeTimes nodes;
  std::size_t pose = 0, rate = 0;
  while (pose < poses.times.size() || rate < gyro.times.size()) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double at_pose = pose < poses.times.size() ? poses.times[pose] : infinity;
    const double at_rate = rate < gyro.times.size() ? gyro.times[rate] - shift : infinity;
    const bool both = std::abs(at_pose - at_rate) <= same;
    const bool is_pose = both || at_pose < at_rate, is_rate = both || !is_pose;
    nodes.add(is_pose ? at_pose : at_rate, is_pose ? std::optional(pose) : std::nullopt,
              is_rate ? std::optional(rate) : std::nullopt);
    pose += is_pose ? 1 : 0;
    rate += is_rate ? 1 : 0;
  }
  return nodes;
}

/// With nodes in between where the body turns farther than one step of a curve should.
NodeTimes with_nodes_in_turns(const NodeTimes& nodes, const GyroPath& path, double offset) {
  NodeTimes all;
  for (std::size_t i = 0; i < nodes.times.size(); ++i) {
    all.add(nodes.times[i], nodes.poses[i], nodes.rates[i]);
    if (i + 1 == nodes.times.size()) break;
    const auto from = path.at(nodes.times[i] + offset), to = path.at(nodes.times[i + 1] + offset);
    if (!from || !to || from->piece != to->piece || to->turned - from->turned <= longest_turn) continue;
    const double parts = std::ceil((to->turned - from->turned) / turn_between * (1.0 - same_row));
    for (double k = 1.0; k < parts; k += 1.0)
      all.add(nodes.times[i] + k / parts * (nodes.times[i + 1] - nodes.times[i]), std::nullopt, std::nullopt);
  }
  return all;
}

/// Where the gyro says nothing they are those of the orientations beside.
void set_rates(SmoothedNodes& start, std::span<const double> times, const GyroPath& path, double offset) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (const auto rate = path.rate_at(times[i] + offset)) {
      start.angular_velocities.push_back(*rate);
      continue;
    }
    const std::size_t before = i == 0 ? 0 : i - 1, after = std::min(i + 1, times.size() - 1);
    Eigen::Vector3d way = Eigen::Vector3d::Zero();
    for (std::size_t k = before; k < after; ++k)
      way += shortest_increment(start.orientations[k], start.orientations[k + 1]);
    start.angular_velocities.emplace_back(way / (times[after] - times[before]));
  }
  start.angular_accelerations.assign(times.size(), Eigen::Vector3d::Zero());
}

}  // namespace

bool counts_turns(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts) {
  const GyroPath path(gyro, counts, Eigen::Vector3d::Zero());
  std::size_t far = 0;
  std::optional<GyroPath::Point> before;
  for (const double t : poses.times) {
    const auto point = path.at(t);
    if (before && point && point->turned - before->turned > counted_turn) ++far;
    before = point;
  }
  return static_cast<double>(far) > counted_share * static_cast<double>(poses.times.size() - 1);
}

Expected<TurnCount> counted_turns(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts,
                                  double offset) {
  TurnCount count{Eigen::Vector3d::Zero(), 0.0};
  for (int round = 0;; ++round) {
    const GyroPath path(gyro, counts, count.correction);
    const std::vector<Anchor> anchors = anchors_of(poses, path, offset);
    std::array<std::vector<double>, 3> corrections;
    std::vector<double> lengths;
    for (std::size_t i = 0; i + 1 < anchors.size(); ++i) {
      if (!of_one_piece(anchors[i], anchors[i + 1])) continue;
      const double h = anchors[i + 1].time - anchors[i].time;
      const Eigen::Vector3d left = left_after(anchors[i], anchors[i + 1]);
      if (left.norm() > undecided_turn)
        return failure(
            ErrorCode::bad_data,
            formatted("it is undecided how often the body turned in the {:.6g} s to the next orientation: "
                      "the gyro leads to {:.3g}° beside it, and orientations tell rates but for 360°/{:.3g} s "
                      "= {:.4g} °/s, wanted orientations nearer to each other or a gyro that is nearer to "
                      "the truth",
                      h, left.norm() * degrees, h, 360.0 / h),
            {.key = i});
      for (std::size_t axis = 0; axis < 3; ++axis)
        corrections[axis].push_back(left[static_cast<Eigen::Index>(axis)] / h);
      lengths.push_back(left.norm());
    }
    count.noise = std::max(least_noise, median(std::move(lengths)) / median_length / std::sqrt(2.0));
    if (round == rounds_of_correction) return count;
    for (std::size_t axis = 0; axis < 3; ++axis)
      count.correction[static_cast<Eigen::Index>(axis)] += median(std::move(corrections[axis]));
  }
}

GyroRows rows_of(const SeenPoses& poses, const GyroRates& gyro, const CountedRates& counts, double gyro_noise,
                 const GyroAlignment& alignment) {
  const GyroPath path(gyro, counts, alignment.correction), uncorrected(gyro, counts, Eigen::Vector3d::Zero());
  NodeTimes nodes = with_nodes_in_turns(merged(poses, gyro, alignment.offset), path, alignment.offset);
  GyroRows rows;
  LedOrientations led(anchors_of(poses, path, alignment.offset), path, alignment.offset);
  for (std::size_t i = 0; i < nodes.times.size(); ++i) {
    const auto pose = nodes.poses[i];
    rows.start.orientations.push_back(led.at(nodes.times[i]));
    if (pose) rows.places.push_back(i);
    rows.problem.orientations.push_back(pose ? poses.orientations[*pose] : rows.start.orientations.back());
    const double share = pose && !poses.shares.empty() ? poses.shares[*pose] : 1.0;
    rows.problem.weights.push_back(pose && poses.counts[*pose] ? share / (poses.noise * poses.noise) : 0.0);
    if (!poses.shares.empty()) rows.problem.shares.push_back(share);
    const auto rate = nodes.rates[i] ? uncorrected.measured_at(nodes.times[i] + alignment.offset) : std::nullopt;
    rows.problem.gyro.push_back(rate.value_or(Eigen::Vector3d::Zero()));
    rows.problem.gyro_weights.push_back(rate ? 1.0 / (gyro_noise * gyro_noise) : 0.0);
  }
  set_rates(rows.start, nodes.times, path, alignment.offset);
  rows.start.gyro_correction = alignment.correction;
  for (std::size_t i = 0; i + 1 < nodes.times.size(); ++i)
    rows.unled.push_back(!path.at(0.5 * (nodes.times[i] + nodes.times[i + 1]) + alignment.offset));
  rows.problem.times = std::move(nodes.times);
  rows.rates = std::move(nodes.rates);
  return rows;
}

}}  // namespace orispline
