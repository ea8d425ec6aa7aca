// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/cubic_keys.hpp>

#include <algorithm>
#include <optional>

namespace orispline::inline ORISPLINE_ABI {
namespace {

/// How many earlier ends of a span are tried: more hardly ever lead farther.
constexpr std::size_t most_tried = 64;

/// Chains of spans from the first sample on, longer by a span in every round.
template <CurvePoint P>
class CubicChains {
 public:
  CubicChains(const CubicSamples<P>& samples, double tolerance)
      : samples_(samples),
        spans_(samples.targets, tolerance),
        last_(samples.size() - 1),
        before_(samples.size(), none) {}

  /// The keys of a chain to the last sample.
  [[nodiscard]] std::vector<std::size_t> to_end() {
    std::size_t reached = 0, earlier = 0;
    while (reached < last_) {
      const std::size_t next = extended(reached, earlier);
      earlier = reached + 1;
      reached = next;
    }
    std::vector<std::size_t> keys{last_};
    while (keys.back() != 0) keys.push_back(before_[keys.back()]);
    std::ranges::reverse(keys);
    return keys;
  }

  [[nodiscard]] Channel<P> channel(const std::vector<std::size_t>& keys) const {
    Channel<P> channel{.interpolation = ChannelInterpolation::cubicspline};
    std::vector<CubicTangents<P>> tangents;
    for (std::size_t k = 0; k + 1 < keys.size(); ++k) {
      const std::size_t i = at(keys[k]), j = at(keys[k + 1]);
      tangents.push_back(spans_.within(i, j).value_or(spans_.nearest(i, j)));
    }
    for (std::size_t k = 0; k < keys.size(); ++k) {
      channel.times.push_back(samples_.targets.times[at(keys[k])]);
      channel.values.emplace_back(samples_.targets.points[at(keys[k])]);
      channel.in_tangents.emplace_back(k > 0 ? tangents[k - 1].arriving : Components<P>::Zero().eval());
      channel.out_tangents.emplace_back(k + 1 < keys.size() ? tangents[k].leaving : Components<P>::Zero().eval());
    }
    return channel;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  [[nodiscard]] std::size_t at(std::size_t sample) const { return sample * samples_.stride; }
  [[nodiscard]] bool holds(std::size_t i, std::size_t j) const {
    return j == i + 1 || spans_.within(at(i), at(j)).has_value();
  }

  /// The last sample that a span from sample i was found to reach, from j on, which it reaches.
  [[nodiscard]] std::size_t farthest(std::size_t i, std::size_t j) const {
    std::size_t step = 1, beyond = last_ + 1;
    while (j < last_) {
      const std::size_t next = std::min(j + step, last_);
      if (!holds(i, next)) {
        beyond = next;
        break;
      }
      j = next;
      step *= 2;
    }
    while (beyond - j > 1) {
      const std::size_t middle = j + (beyond - j) / 2;
      (holds(i, middle) ? j : beyond) = middle;
    }
    return j;
  }

  /// The last sample that one more span reaches, from `reached` or from an earlier sample that as many spans reach.
  std::size_t extended(std::size_t reached, std::size_t earlier) {
    std::size_t best = farthest(reached, reached + 1);
    before_[best] = reached;
    const std::size_t first = std::max({earlier, reached - std::min(reached, most_tried), std::size_t{1}});
    for (std::size_t i = reached; i-- > first && best < last_;) {
      if (!holds(i, best + 1) || !is_reached(i, before_[reached])) continue;
      best = farthest(i, best + 1);
      before_[best] = i;
    }
    return best;
  }

  /// Whether a chain as long as that over `parent` reaches the sample: tried from the same parent only.
  bool is_reached(std::size_t sample, std::size_t parent) {
    if (!holds(parent, sample)) return false;
    before_[sample] = parent;
    return true;
  }

  const CubicSamples<P>& samples_;
  CubicSpans<P> spans_;
  std::size_t last_;
  std::vector<std::size_t> before_;  ///< the key before each sample in its chain
};

}  // namespace

template <CurvePoint P>
Channel<P> fewest_cubics(const CubicSamples<P>& samples, double tolerance) {
  CubicChains<P> chains(samples, tolerance);
  return chains.channel(chains.to_end());
}

template Channel<Eigen::Quaterniond> fewest_cubics(const CubicSamples<Eigen::Quaterniond>&, double);
template Channel<Eigen::Vector3d> fewest_cubics(const CubicSamples<Eigen::Vector3d>&, double);

}  // namespace orispline::inline ORISPLINE_ABI
