// SPDX-License-Identifier: Apache-2.0
#include <orispline/reduce/cubic_keys.hpp>

#include <algorithm>
#include <optional>

namespace orispline { inline namespace ORISPLINE_ABI {

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

  /// The last sample that a span from that one may reach.
  [[nodiscard]] std::size_t end_of(std::size_t sample) const {
    const auto next = std::ranges::upper_bound(samples_.parted_at, sample);
    return next == samples_.parted_at.end() ? last_ : *next;
  }

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

  /// Tangents of every span of a chain.
  [[nodiscard]] std::vector<CubicTangents<P>> tangents(const std::vector<std::size_t>& keys) const {
    std::vector<CubicTangents<P>> found;
    for (std::size_t k = 0; k + 1 < keys.size(); ++k) found.push_back(nearest(keys[k], keys[k + 1], {}));
    return found;
  }

  /// Gives the first and the last span one tangent where the motion begins again: without more keys, else with keys in
  /// these spans that leave little to the tangent.
  void close(std::vector<std::size_t>& keys, std::vector<CubicTangents<P>>& found) const {
    const double sign = sign_at_seam();
    const Components<P> leaving = found.front().leaving, arriving = sign * found.back().arriving;
    const Components<P> mean = 0.5 * (leaving + arriving);
    for (const Components<P>& seam : {mean, leaving, arriving})
      if (keys.size() > 2 && joined(keys, found, seam)) return;
    const GivenTangents<P> first{.leaving = mean, .arriving = {}}, last{.leaving = {}, .arriving = sign * mean};
    if (keys.size() == 2 || !holds(0, keys[1], first)) {
      std::size_t key = keys[1] - 1;
      while (key > 1 && !(holds(0, key, first) && holds(key, keys[1]))) --key;
      if (key > 0) insert(keys, 0, key);
    }
    if (const std::size_t before = keys[keys.size() - 2]; !holds(before, last_, last)) {
      std::size_t key = before + 1;
      while (key + 1 < last_ && !(holds(key, last_, last) && holds(before, key))) ++key;
      insert(keys, keys.size() - 2, key);
    }
    found = tangents(keys);
    found.front() = nearest(0, keys[1], first);
    found.back() = nearest(keys[keys.size() - 2], last_, last);
  }

  [[nodiscard]] Channel<P> channel(const std::vector<std::size_t>& keys, const std::vector<CubicTangents<P>>& found,
                                   bool closed) const {
    const CubicTangents<P> outer =  // of the spans beyond the ends
        closed ? CubicTangents<P>{sign_at_seam() * found.front().leaving, sign_at_seam() * found.back().arriving}
               : CubicTangents<P>{};
    Channel<P> channel{.interpolation = ChannelInterpolation::cubicspline};
    for (std::size_t k = 0; k < keys.size(); ++k) {
      channel.times.push_back(samples_.targets.times[at(keys[k])]);
      channel.values.emplace_back(samples_.targets.points[at(keys[k])]);
      channel.in_tangents.emplace_back(k > 0 ? found[k - 1].arriving : outer.arriving);
      channel.out_tangents.emplace_back(k + 1 < keys.size() ? found[k].leaving : outer.leaving);
    }
    return channel;
  }

 private:
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  [[nodiscard]] std::size_t at(std::size_t sample) const { return sample * samples_.stride; }
  [[nodiscard]] bool holds(std::size_t i, std::size_t j, const GivenTangents<P>& given = {}) const {
    return j == i + 1 || (j <= end_of(i) && spans_.within(at(i), at(j), given).has_value());
  }
  /// Those that hold, else those that miss least.
  [[nodiscard]] CubicTangents<P> nearest(std::size_t i, std::size_t j, const GivenTangents<P>& given) const {
    if (auto found = spans_.within(at(i), at(j), given)) return *std::move(found);
    return spans_.nearest(at(i), at(j), given);
  }

  /// Of a quaternion that is the same rotation as the first one.
  [[nodiscard]] double sign_at_seam() const {
    if constexpr (std::same_as<P, Eigen::Quaterniond>)
      if (samples_.targets.points.front().dot(samples_.targets.points.back()) < 0.0) return -1.0;
    return 1.0;
  }

  /// A key between the k-th one and the next, and those that join it to them.
  void insert(std::vector<std::size_t>& keys, std::size_t k, std::size_t key) const {
    const std::size_t next = keys[k + 1];
    std::vector<std::size_t> inner;
    for (std::size_t from = keys[k]; !holds(from, key); inner.push_back(from))
      from = std::min(farthest(from, from + 1), key - 1);
    inner.push_back(key);
    for (std::size_t from = key; !holds(from, next); inner.push_back(from))
      from = std::min(farthest(from, from + 1), next - 1);
    keys.insert(keys.begin() + static_cast<std::ptrdiff_t>(k) + 1, inner.begin(), inner.end());
  }

  /// Whether both spans at the seam hold with that tangent, which they then have.
  bool joined(const std::vector<std::size_t>& keys, std::vector<CubicTangents<P>>& found,
              const Components<P>& seam) const {
    const std::size_t before = keys[keys.size() - 2];
    const GivenTangents<P> after{.leaving = seam, .arriving = {}},
        until{.leaving = {}, .arriving = sign_at_seam() * seam};
    if (!holds(0, keys[1], after) || !holds(before, last_, until)) return false;
    found.front() = nearest(0, keys[1], after);
    found.back() = nearest(before, last_, until);
    return true;
  }

  /// The last sample that a span from sample i was found to reach, from j on, which it reaches.
  [[nodiscard]] std::size_t farthest(std::size_t i, std::size_t j) const {
    const std::size_t last = end_of(i);
    std::size_t step = 1, beyond = last + 1;
    while (j < last) {
      const std::size_t next = std::min(j + step, last);
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
    for (std::size_t i = reached; i-- > first && best < end_of(i);) {
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

constexpr std::size_t points_a_sample = 4;  // three points between two samples

Eigen::Vector4d components(const Eigen::Quaterniond& point) { return point.coeffs(); }
Eigen::Vector3d components(const Eigen::Vector3d& point) { return point; }

/// With the sign of the nearer of the two quaternions that are that orientation.
void append(std::vector<Eigen::Vector4d>& points, Eigen::Vector4d point) {
  if (!points.empty() && points.back().dot(point) < 0.0) point = -point;
  points.push_back(point);
}
void append(std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& point) { points.push_back(point); }

}  // namespace

template <CurvePoint P>
Channel<P> fewest_cubics(const CubicSamples<P>& samples, double tolerance, bool closed) {
  CubicChains<P> chains(samples, tolerance);
  std::vector<std::size_t> keys = chains.to_end();
  std::vector<CubicTangents<P>> tangents = chains.tangents(keys);
  if (closed) chains.close(keys, tangents);
  return chains.channel(keys, tangents, closed);
}

template Channel<Eigen::Quaterniond> fewest_cubics(const CubicSamples<Eigen::Quaterniond>&, double, bool);
template Channel<Eigen::Vector3d> fewest_cubics(const CubicSamples<Eigen::Vector3d>&, double, bool);

template <CurvePoint P>
CubicSamples<P> cubic_samples(const Channel<P>& keys, const ChannelCurve<P>& motion, std::span<const Cut> cuts) {
  CubicSamples<P> samples{.targets = {}, .stride = points_a_sample};
  pass_stretches<P>(keys, cuts, [&](std::size_t, std::size_t last) {
    if (last + 1 < keys.size()) samples.parted_at.push_back(last);
  });
  auto& [times, points] = samples.targets;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    times.push_back(keys.times[i]);
    append(points, components(keys.values[i]));
    if (i + 1 == keys.size()) break;
    for (std::size_t k = 1; k < points_a_sample; ++k) {
      const double share = static_cast<double>(k) / points_a_sample;
      times.push_back(keys.times[i] + share * (keys.times[i + 1] - keys.times[i]));
      append(points, components(motion.at(times.back())));
    }
  }
  return samples;
}

template <CurvePoint P>
CubicSamples<P> cubic_samples(const Channel<P>& channel, BetweenSamples between) {
  return cubic_samples(channel, motion_between(channel, between));
}

template CubicSamples<Eigen::Quaterniond> cubic_samples(const RotationChannel&, const ChannelCurve<Eigen::Quaterniond>&,
                                                        std::span<const Cut>);
template CubicSamples<Eigen::Vector3d> cubic_samples(const VectorChannel&, const ChannelCurve<Eigen::Vector3d>&,
                                                     std::span<const Cut>);
template CubicSamples<Eigen::Quaterniond> cubic_samples(const RotationChannel&, BetweenSamples);
template CubicSamples<Eigen::Vector3d> cubic_samples(const VectorChannel&, BetweenSamples);

}}  // namespace orispline
