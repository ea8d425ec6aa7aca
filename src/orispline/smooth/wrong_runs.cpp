// SPDX-License-Identifier: Apache-2.0
#include <orispline/smooth/wrong_runs.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <utility>

#include <orispline/smooth/clip_smoothing.hpp>
#include <orispline/smooth/smoothing_element.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t beside = 3;      // steps on either side that foretell one
constexpr std::size_t around = 8;      // steps on either side of a run that tell what is usual
constexpr double clearly = 4.0;        // a jump beside what is usual
constexpr double with_others = 1.3;    // where a joint above or below jumps at the same time
constexpr double back = 0.5;           // of a jump by which a run may miss where it came from
constexpr double going_on = 0.25;      // of the pace at which a hold is caught up, before and behind it
constexpr double share_of_cuts = 0.8;  // of all that move
constexpr double still = 1e-7;         // [rad]: a step of a joint that rests, in single precision

double median_of(std::span<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  if (values.size() % 2 == 1) return *middle;
  return (*middle + *std::max_element(values.begin(), middle)) / 2;
}

/// The steps of a rotation from key to key, and by how much each jumps.
class Steps {
 public:
  explicit Steps(const RotationChannel& channel)
      : channel_(channel), turns_(channel.size() - 1), jumps_(turns_.size()) {
    for (std::size_t k = 0; k < turns_.size(); ++k)
      turns_[k] = shortest_increment(channel.values[k], channel.values[k + 1]);
    for (std::size_t k = 0; k < jumps_.size(); ++k) {
      jumps_[k] = turns_[k] - interval(k) * usual_rate(k);
      sizes_.push_back(jumps_[k].norm());
    }
  }

  [[nodiscard]] const std::vector<double>& sizes() const noexcept { return sizes_; }
  [[nodiscard]] bool moves() const {
    return std::ranges::any_of(sizes_, [](double size) { return size > still; });
  }

  /// Whether step `in` goes away and step `out` comes back, both so many times as far as what is usual around.
  [[nodiscard]] bool are_clear(std::size_t in, std::size_t out, double times) const {
    const double least = std::min(sizes_[in], sizes_[out]);
    return least >= least_jump && least >= times * usual(in, out);
  }
  /// Whether it comes back to where it left, or to where the motion before and behind leads.
  [[nodiscard]] bool comes_back(std::size_t in, std::size_t out) const {
    const auto [least, most] = std::minmax(sizes_[in], sizes_[out]);
    return (jumps_[in] + jumps_[out]).norm() <= back * most || off_the_way(in, out) <= back * least;
  }
  /// Whether a motion stands still from the key before `in`, catches up by step `out` and goes on.
  [[nodiscard]] bool holds(std::size_t in, std::size_t out) const {
    for (std::size_t k = in; k < out; ++k)
      if (turns_[k].norm() > still) return false;
    const double pace = going_on * sizes_[out] / static_cast<double>(out - in + 1);
    const bool moves_before = in > 0 && turns_[in - 1].norm() > pace;
    const bool moves_behind = out + 1 < turns_.size() && turns_[out + 1].norm() > pace;
    return moves_before && moves_behind && sizes_[out] >= least_jump && sizes_[out] >= clearly * usual(out, out) &&
           off_the_way(in, out) <= back * sizes_[out];
  }

 private:
  [[nodiscard]] double interval(std::size_t k) const { return channel_.times[k + 1] - channel_.times[k]; }

  /// The median of the rates of these steps but one, by component.
  [[nodiscard]] Eigen::Vector3d median_rate(std::size_t first, std::size_t end, std::size_t but) const {
    Eigen::Vector3d rate = Eigen::Vector3d::Zero();
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      std::array<double, 2 * beside> values{};
      std::size_t count = 0;
      for (std::size_t k = first; k < end; ++k)
        if (k != but) values[count++] = turns_[k][axis] / interval(k);
      if (count > 0) rate[axis] = median_of(std::span(values).first(count));
    }
    return rate;
  }
  [[nodiscard]] static std::size_t before(std::size_t k, std::size_t count) { return k > count ? k - count : 0; }
  [[nodiscard]] std::size_t behind(std::size_t k, std::size_t count) const {
    return std::min(k + count + 1, turns_.size());
  }
  [[nodiscard]] Eigen::Vector3d usual_rate(std::size_t k) const {
    return median_rate(before(k, beside), behind(k, beside), k);
  }

  /// The largest jump around a run but its own two.
  [[nodiscard]] double usual(std::size_t in, std::size_t out) const {
    double largest = 0.0;
    for (std::size_t k = before(in, around); k < behind(out, around); ++k)
      if (k != in && k != out) largest = std::max(largest, sizes_[k]);
    return largest;
  }

  /// How far the key behind a run is from where the rates before and behind lead [rad].
  [[nodiscard]] double off_the_way(std::size_t in, std::size_t out) const {
    const std::size_t none = turns_.size();
    Eigen::Vector3d rate_before = median_rate(before(in, beside), in, none);
    Eigen::Vector3d rate_behind = median_rate(out + 1, behind(out, beside), none);
    if (in == 0) rate_before = rate_behind;
    if (out + 1 == none) rate_behind = rate_before;
    const double time = channel_.times[out + 1] - channel_.times[in];
    return (shortest_increment(channel_.values[in], channel_.values[out + 1]) - time * (rate_before + rate_behind) / 2)
        .norm();
  }

  const RotationChannel& channel_;
  std::vector<Eigen::Vector3d> turns_, jumps_;
  std::vector<double> sizes_{};
};

/// Rotations with the same key times, by their joints.
using Together = std::map<std::size_t, Steps>;
/// The step away from the last good key, and the step back.
using Places = std::pair<std::size_t, std::size_t>;

void add_runs_of(std::size_t joint, const Steps& steps, std::map<Places, std::vector<std::size_t>>& runs) {
  const auto& sizes = steps.sizes();
  std::vector<std::size_t> far;
  for (std::size_t k = 0; k < sizes.size(); ++k)
    if (sizes[k] >= least_jump) far.push_back(k);
  for (auto out = far.begin(); out != far.end(); ++out) {
    for (auto in = far.begin(); in != out; ++in)
      if (const std::size_t count = *out - *in; shortest_run <= count && count <= longest_run)
        if (steps.are_clear(*in, *out, clearly) && steps.comes_back(*in, *out)) runs[{*in, *out}].push_back(joint);
    for (std::size_t count = shortest_run; count <= std::min(longest_run, *out); ++count)
      if (steps.holds(*out - count, *out)) runs[{*out - count, *out}].push_back(joint);
  }
}

/// Joints above and below one of a run that jump with it, though not so clearly.
void add_relatives(const Skeleton& skeleton, const Together& all, const Places& places,
                   std::vector<std::size_t>& joints) {
  const auto is_in = [&](std::size_t joint) { return std::ranges::find(joints, joint) != joints.end(); };
  const auto is_beside = [&](std::size_t joint) {
    return is_in(skeleton[joint].parent) ||
           std::ranges::any_of(joints, [&](std::size_t other) { return skeleton[other].parent == joint; });
  };
  for (bool grows = true; grows;) {
    grows = false;
    for (const auto& [joint, steps] : all)
      if (!is_in(joint) && is_beside(joint) && steps.are_clear(places.first, places.second, with_others))
        joints.push_back(joint), grows = true;
  }
  std::ranges::sort(joints);
}

void add_runs(const Skeleton& skeleton, const Together& all, std::span<const double> times,
              std::vector<WrongRun>& found) {
  std::map<Places, std::vector<std::size_t>> runs;
  std::size_t moving = 0;
  for (const auto& [joint, steps] : all) {
    add_runs_of(joint, steps, runs);
    if (steps.moves()) ++moving;
  }
  for (auto& [places, joints] : runs) {
    const auto& [in, out] = places;
    add_relatives(skeleton, all, places, joints);
    const bool is_cut =
        joints.size() > 1 && static_cast<double>(joints.size()) > share_of_cuts * static_cast<double>(moving);
    if (is_cut) continue;
    WrongRun run{.joints = joints, .first = in + 1, .count = out - in, .start = times[in + 1], .end = times[out]};
    for (const std::size_t joint : joints) {
      const auto& sizes = all.at(joint).sizes();
      run.jump = std::max({run.jump, sizes[in], sizes[out]});
    }
    found.push_back(std::move(run));
  }
}

}  // namespace

std::vector<WrongRun> wrong_runs(const Skeleton& skeleton, const Clip& clip) {
  std::vector<WrongRun> found;
  std::vector<bool> is_done(clip.rotations.size());
  for (std::size_t i = 0; i < clip.rotations.size(); ++i) {
    const auto& times = clip.rotations[i].times;
    Together all;
    for (std::size_t k = i; k < clip.rotations.size(); ++k) {
      const RotationChannel& channel = clip.rotations[k];
      if (is_done[k] || channel.interpolation != ChannelInterpolation::linear || channel.times != times) continue;
      is_done[k] = true;
      if (channel.size() >= fewest_smoothed_keys) all.emplace(channel.joint, Steps(channel));
    }
    add_runs(skeleton, all, times, found);
  }
  std::ranges::sort(found, {}, [](const WrongRun& run) { return std::pair(run.start, run.first); });
  return found;
}

}}  // namespace orispline
