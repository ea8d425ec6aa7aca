// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/joints_together.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <orispline/curve/keyframe.hpp>
#include <orispline/math/median.hpp>
#include <orispline/math/so3.hpp>
#include <orispline/smooth/correlated_fit.hpp>
#include <orispline/smooth/shared_motion.hpp>
#include <orispline/smooth/smoothing_choice.hpp>
#include <orispline/smooth/smoothing_element.hpp>
#include <orispline/smooth/smoothing_noise.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double uneven_share = 0.01;  // of the interval

bool are_even(std::span<const double> times) {
  const double interval = median_interval(times);
  for (std::size_t i = 1; i < times.size(); ++i)
    if (std::abs(times[i] - times[i - 1] - interval) > uneven_share * interval) return false;
  return true;
}

using Columns = Eigen::Matrix<double, Eigen::Dynamic, 3>;

void set_row(Columns& columns, std::size_t i, const Eigen::Vector3d& value) {
  columns.row(static_cast<Eigen::Index>(i)) = value.transpose();
}
Eigen::Vector3d row_of(const Columns& columns, std::size_t i) {
  return columns.row(static_cast<Eigen::Index>(i)).transpose();
}

/// The sum of the turns of a smooth motion [rad]: its way.
Columns way_of(const std::vector<Eigen::Quaterniond>& orientations) {
  Columns way = Columns::Zero(static_cast<Eigen::Index>(orientations.size()), 3);
  for (std::size_t i = 1; i < orientations.size(); ++i)
    set_row(way, i, row_of(way, i - 1) + shortest_increment(orientations[i - 1], orientations[i]));
  return way;
}

/// That way, and beside it what was recorded.
Columns recorded_way(const SmoothedJoint& joint, Columns way) {
  const auto& smooth = joint.smoothing->nodes.orientations;
  for (std::size_t i = 0; i < smooth.size(); ++i)
    if (!std::ranges::binary_search(joint.smoothing->rejected, i))
      set_row(way, i, row_of(way, i) + shortest_increment(smooth[i], joint.rotation->values[i]));
  return way;
}

Columns recorded_places(const SmoothedJoint& joint) {
  Columns places(static_cast<Eigen::Index>(joint.translation->size()), 3);
  const auto& found = joint.smoothing->positions;
  for (std::size_t i = 0; i < joint.translation->size(); ++i) {
    const bool is_rejected = found && std::ranges::binary_search(found->rejected, i);
    set_row(places, i, is_rejected ? joint.smoothing->nodes.positions[i] : joint.translation->values[i]);
  }
  return places;
}

/// Whether values leave the line from the first to the last by more than rounding.
bool bends(const Eigen::VectorXd& values, double least) {
  const Eigen::VectorXd line = Eigen::VectorXd::LinSpaced(values.size(), values[0], values[values.size() - 1]);
  return (values - line).cwiseAbs().maxCoeff() > least;
}

/// The columns of all joints, of which those that bend are channels.
class Collected {
 public:
  /// Where its columns are, from the first.
  std::size_t add(const Columns& columns, std::size_t kind, double least) {
    const std::size_t first = places_.size();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const bool is_channel = bends(columns.col(axis), least);
      places_.push_back(is_channel ? static_cast<std::ptrdiff_t>(columns_.size()) : -1);
      if (!is_channel) continue;
      columns_.emplace_back(columns.col(axis));
      channels_.joints.push_back(groups_);
      channels_.kinds.push_back(kind);
    }
    const bool has_channels = std::ranges::any_of(at(first), [](std::ptrdiff_t channel) { return channel >= 0; });
    if (has_channels) ++groups_;
    return first;
  }

  [[nodiscard]] bool has_channels() const noexcept { return !columns_.empty(); }
  /// With the values of all.
  const Channels& channels() {
    channels_.values.resize(columns_.front().size(), static_cast<Eigen::Index>(columns_.size()));
    for (std::size_t c = 0; c < columns_.size(); ++c) channels_.values.col(static_cast<Eigen::Index>(c)) = columns_[c];
    return channels_;
  }

  /// The channels of three columns that were added there, absent -1.
  [[nodiscard]] std::array<std::ptrdiff_t, 3> at(std::size_t first) const {
    return {places_[first], places_[first + 1], places_[first + 2]};
  }

 private:
  Channels channels_{};
  std::vector<Eigen::VectorXd> columns_{};
  std::vector<std::ptrdiff_t> places_{};
  std::size_t groups_ = 0;
};

/// Of three columns those that are channels become what they are without noise.
void take(Columns& columns, const std::array<std::ptrdiff_t, 3>& channels, const Eigen::MatrixXd& smooth) {
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (const std::ptrdiff_t c = channels[static_cast<std::size_t>(axis)]; c >= 0) columns.col(axis) = smooth.col(c);
}

/// Noise and smoothing time of a joint by itself, over the channels that it has.
void set_findings(Smoothing& smoothing, const std::array<std::ptrdiff_t, 3>& channels, const SharedMotion& motion) {
  double lambdas = 0.0, count = 0.0;
  for (const std::ptrdiff_t c : channels) {
    if (c < 0) continue;
    smoothing.noise = motion.sigmas[c];
    lambdas += 1.0 / lambda_alone(motion, c);
    count += 1.0;
  }
  if (count == 0.0) return;
  // λ in intervals³ over σ² is (τ/Δt)⁴.
  smoothing.smoothing_time = smoothing.interval * std::sqrt(std::sqrt(count / lambdas));
  smoothing.smoothing_times.clear();
  smoothing.lambda = lambda_of(smoothing.smoothing_time, Penalty::acceleration, smoothing.noise, smoothing.interval);
  smoothing.criterion = SmoothingCriterion::reml;
  smoothing.edge = LambdaChoice::Edge::none;
  smoothing.degrees_of_freedom.reset();
  smoothing.correlated_noise.reset();
  if (motion.noise_time > 0.0)
    smoothing.correlated_noise = {.sigma = smoothing.noise, .time = motion.noise_time * smoothing.interval};
}

/// What was found of a joint, at its keys and without rates.
void set_nodes(Smoothing& smoothing, SmoothedNodes nodes) {
  const Keyframes& before = smoothing.track.keys;
  KeyframeData data{.orientations = nodes.orientations, .positions = nodes.positions};
  data.times.assign(before.times().begin(), before.times().end());
  auto keys = Keyframes::make(std::move(data));
  if (!keys) return;
  smoothing.track = smoothing.track.with_keys(*std::move(keys));
  smoothing.nodes = std::move(nodes);
}

}  // namespace

bool are_smoothed_together(const SmoothOptions& options) {
  return !options.smoothing_time && options.loss == Loss::robust &&
         options.penalty.value_or(Penalty::acceleration) == Penalty::acceleration && !options.gap;
}

bool can_be_smoothed_together(std::size_t joints, std::span<const double> times) {
  return joints >= fewest_joints_together && times.size() >= fewest_times_together && are_even(times);
}

void smooth_together(const std::vector<SmoothedJoint>& joints, const SmoothOptions& options) {
  if (joints.empty() || !can_be_smoothed_together(joints.size(), joints.front().rotation->times)) return;
  const double interval = median_interval(joints.front().rotation->times);
  Collected collected;
  std::vector<Columns> ways;
  std::vector<std::size_t> turns, moves;
  for (const SmoothedJoint& joint : joints) {
    ways.push_back(way_of(joint.smoothing->nodes.orientations));
    turns.push_back(collected.add(recorded_way(joint, ways.back()), 0, rest_angle));
    moves.push_back(joint.translation ? collected.add(recorded_places(joint), 1, rest_length) : 0);
  }
  if (!collected.has_channels()) return;
  const Channels& channels = collected.channels();
  ChannelNoise known{.sigmas{options.noise, options.position_noise}};
  if (options.noise_time && check_noise_time(*options.noise_time, joints.front().rotation->times))
    known.time = *options.noise_time / interval;
  const SharedMotion motion = shared_motion(channels, known);
  const Eigen::MatrixXd smooth = smoothed_channels(channels, motion);
  for (std::size_t j = 0; j < joints.size(); ++j) {
    Smoothing& smoothing = *joints[j].smoothing;
    SmoothedNodes nodes{.orientations = smoothing.nodes.orientations};
    Columns way = ways[j];
    take(way, collected.at(turns[j]), smooth);
    for (std::size_t i = 0; i < nodes.orientations.size(); ++i)
      nodes.orientations[i] = (nodes.orientations[i] * exp<double>(row_of(way, i) - row_of(ways[j], i))).normalized();
    if (joints[j].translation) {
      Columns places(static_cast<Eigen::Index>(joints[j].translation->size()), 3);
      for (std::size_t i = 0; i < joints[j].translation->size(); ++i) set_row(places, i, smoothing.nodes.positions[i]);
      take(places, collected.at(moves[j]), smooth);
      for (std::size_t i = 0; i < joints[j].translation->size(); ++i) nodes.positions.push_back(row_of(places, i));
    }
    set_findings(smoothing, collected.at(turns[j]), motion);
    set_nodes(smoothing, std::move(nodes));
  }
}

}}  // namespace orispline
