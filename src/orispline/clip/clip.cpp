// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/clip.hpp>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/finite_keys.hpp>
#include <orispline/curve/keyframe.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

Expected<void> check(const std::vector<Joint>& joints, std::size_t i) {
  const Joint& joint = joints[i];
  const auto fault = [&](std::string_view found, std::string_view wanted) {
    return failure(ErrorCode::bad_data,
                   formatted("joint {}: found {}, wanted {}", in_quotes(joint.name), found, wanted));
  };
  if (joint.parent != no_parent && joint.parent >= i)
    return fault(formatted("joint {} as its parent", joint.parent), "a parent that comes before it");
  if (!joint.rest.translation.allFinite() || !joint.rest.scale.allFinite() || !joint.rest.rotation.coeffs().allFinite())
    return fault("a rest pose with a number that is not finite", "finite numbers");
  if (const double norm = joint.rest.rotation.norm(); std::abs(norm - 1.0) > unit_norm_tolerance)
    return fault(formatted("a rest rotation of norm {}", norm), "a unit quaternion");
  return {};
}

/// What is wrong with the value of a key; empty if nothing is.
std::string fault_of(const Eigen::Quaterniond& value) {
  if (const double norm = value.norm(); std::abs(norm - 1.0) > unit_norm_tolerance)
    return formatted("found a quaternion of norm {}, wanted norm 1", norm);
  return {};
}
std::string fault_of(const Eigen::Vector3d&) { return {}; }

/// Checks the channels of one list.
class ChannelCheck {
 public:
  ChannelCheck(const Skeleton& skeleton, const Clip& clip) : skeleton_(skeleton), clip_(clip) {}

  template <CurvePoint P>
  Expected<void> all(const std::vector<Channel<P>>& channels, std::string_view property) const {
    std::vector<bool> seen(skeleton_.size());
    for (const Channel<P>& channel : channels) {
      if (channel.joint >= skeleton_.size())
        return failure(ErrorCode::bad_data,
                       formatted("clip {}: found a channel of joint {}, wanted one of the {} joints",
                                 in_quotes(clip_.name), channel.joint, skeleton_.size()));
      if (seen[channel.joint])
        return fault(channel.joint, formatted("found a second channel of its {}, wanted one", property));
      seen[channel.joint] = true;
      if (auto sound = keys_of(channel); !sound) return sound;
    }
    return {};
  }

  [[nodiscard]] Expected<void> all(const std::vector<WeightChannels>& list) const {
    std::vector<bool> is_there(skeleton_.size());
    for (const WeightChannels& weights : list) {
      if (weights.joint >= skeleton_.size() || is_there[weights.joint] ||
          weights.triples.size() != (weights.count + 2) / 3 || weights.count == 0)
        return failure(ErrorCode::bad_data,
                       formatted("clip {}: found {} channels for {} weights of joint {}, wanted one for three, and a "
                                 "joint once",
                                 in_quotes(clip_.name), weights.triples.size(), weights.count, weights.joint));
      is_there[weights.joint] = true;
      for (const VectorChannel& channel : weights.triples)
        if (auto sound = keys_of(channel); !sound) return sound;
    }
    return {};
  }

 private:
  template <CurvePoint P>
  Expected<void> keys_of(const Channel<P>& channel) const {
    const std::size_t keys = channel.size();
    if (keys == 0) return fault(channel.joint, "found no key, wanted one at least");
    if (channel.values.size() != keys)
      return fault(channel.joint,
                   formatted("found {} values at {} times, wanted one each", channel.values.size(), keys));
    const std::size_t tangents = channel.interpolation == ChannelInterpolation::cubicspline ? keys : 0;
    if (channel.in_tangents.size() != tangents || channel.out_tangents.size() != tangents)
      return fault(channel.joint, formatted("found {} and {} tangents, wanted {} each", channel.in_tangents.size(),
                                            channel.out_tangents.size(), tangents));
    for (std::size_t i = 0; i < keys; ++i)
      if (std::string found = fault_of(channel, i); !found.empty())
        return fault(channel.joint, formatted("key {}: {}", i, found));
    return {};
  }

  template <CurvePoint P>
  static std::string fault_of(const Channel<P>& channel, std::size_t i) {
    const double time = channel.times[i];
    if (!std::isfinite(time)) return formatted("found time {}, wanted a finite number", time);
    if (i > 0 && time <= channel.times[i - 1])
      return formatted("found time {} after {}, wanted increasing times", time, channel.times[i - 1]);
    if (!is_finite(channel.values[i]) ||
        (!channel.in_tangents.empty() && !(is_finite(channel.in_tangents[i]) && is_finite(channel.out_tangents[i]))))
      return "found a number that is not finite, wanted finite ones";
    return orispline::fault_of(channel.values[i]);
  }

  [[nodiscard]] Expected<void> fault(std::size_t joint, std::string_view found) const {
    return failure(ErrorCode::bad_data, formatted("{}: {}", place_of(skeleton_, clip_, joint), found));
  }

  const Skeleton& skeleton_;
  const Clip& clip_;
};

template <CurvePoint P>
void extend(Domain& domain, const std::vector<Channel<P>>& channels) {
  for (const Channel<P>& channel : channels) {
    domain.start = std::min(domain.start, channel.times.front());
    domain.end = std::max(domain.end, channel.times.back());
  }
}

constexpr std::size_t names_shown = 6;  // of the joints above and the joint

}  // namespace

Expected<Skeleton> Skeleton::make(std::vector<Joint> joints) {
  for (std::size_t i = 0; i < joints.size(); ++i)
    if (auto sound = check(joints, i); !sound) return tl::unexpected(std::move(sound.error()));
  for (Joint& joint : joints) joint.rest.rotation.normalize();
  return Skeleton(std::move(joints));
}

Skeleton::Skeleton(std::vector<Joint> joints) : joints_(std::move(joints)), shares_name_(joints_.size()) {
  std::unordered_map<std::string_view, std::size_t> first;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto [found, is_new] = first.try_emplace(joints_[i].name, i);
    if (!is_new) shares_name_[i] = shares_name_[found->second] = true;
  }
}

std::string Skeleton::shown_name(std::size_t joint) const {
  std::string shown = joints_[joint].name;
  if (!shares_name_[joint]) return shown;
  std::size_t names = 1;
  for (std::size_t above = joints_[joint].parent; above != no_parent; above = joints_[above].parent) {
    if (names++ == names_shown) return formatted("…/{}", shown);
    shown = formatted("{}/{}", joints_[above].name, shown);
  }
  return shown;
}

std::optional<std::size_t> Skeleton::find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(joints_, name, &Joint::name);
  if (found == joints_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - joints_.begin());
}

Domain Clip::domain() const noexcept {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Domain domain{infinity, -infinity};
  extend(domain, rotations);
  extend(domain, translations);
  extend(domain, scales);
  for (const WeightChannels& one : weights) extend(domain, one.triples);
  return domain.start <= domain.end ? domain : Domain{0.0, 0.0};
}

Domain Clip::whole_domain() const noexcept {
  const bool has_channel = !rotations.empty() || !translations.empty() || !scales.empty() || !weights.empty();
  if (!passed_on) return domain();
  if (!has_channel) return *passed_on;
  const Domain own = domain();
  return {std::min(own.start, passed_on->start), std::max(own.end, passed_on->end)};
}

Expected<void> check_clip(const Skeleton& skeleton, const Clip& clip) {
  const ChannelCheck check(skeleton, clip);
  return check.all(clip.rotations, "rotation")
      .and_then([&] { return check.all(clip.translations, "translation"); })
      .and_then([&] { return check.all(clip.scales, "scale"); })
      .and_then([&] { return check.all(clip.weights); });
}

std::string place_of(const Skeleton& skeleton, const Clip& clip, std::size_t joint) {
  return formatted("clip {}, joint {}", in_quotes(clip.name), in_quotes(skeleton.shown_name(joint)));
}

}}  // namespace orispline
