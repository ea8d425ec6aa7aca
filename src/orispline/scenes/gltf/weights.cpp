// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/weights.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include <orispline/clip/clip_motion.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// The floats of an accessor of a sampler; nothing where it has others, or more than `most`.
std::optional<std::vector<double>> floats_of(const Document& document, const Object& sampler, const char* key,
                                             std::size_t most) {
  const auto accessor =
      sampler.index(key, document.root().list("accessors").value()->size()).and_then([&](std::size_t index) {
        return accessor_of(document, index);
      });
  if (!accessor || accessor->type != ComponentType::f32 || accessor->components != 1 || accessor->count > most)
    return std::nullopt;
  auto values = values_of(document, *accessor);
  if (!values || !std::ranges::all_of(*values, [](double v) { return std::isfinite(v); })) return std::nullopt;
  return std::move(*values);
}

std::optional<ChannelInterpolation> interpolation_of(const Object& sampler) {
  const auto word = sampler.text_or("interpolation", "LINEAR");
  if (!word) return std::nullopt;
  if (*word == "LINEAR") return ChannelInterpolation::linear;
  if (*word == "STEP") return ChannelInterpolation::step;
  return *word == "CUBICSPLINE" ? std::optional(ChannelInterpolation::cubicspline) : std::nullopt;
}

/// Up to three numbers from one on, with zeros behind.
Eigen::Vector3d triple_at(const std::vector<double>& numbers, std::size_t first, std::size_t count) {
  Eigen::Vector3d triple = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < std::min<std::size_t>(count, 3); ++i)
    triple[static_cast<Eigen::Index>(i)] = numbers[first + i];
  return triple;
}

std::vector<double> times_of(const WeightChannels& weights) {
  std::vector<double> times;
  for (const VectorChannel& channel : weights.triples)
    times.insert(times.end(), channel.times.begin(), channel.times.end());
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

/// One interpolation that all channels can have; a channel of one key has any.
ChannelInterpolation interpolation_of(const WeightChannels& weights) {
  ChannelInterpolation shared = ChannelInterpolation::step;
  bool moves = false;
  for (const VectorChannel& channel : weights.triples) {
    if (channel.size() == 1) continue;
    if (!moves || channel.interpolation == ChannelInterpolation::cubicspline) shared = channel.interpolation;
    moves = true;
  }
  return moves ? shared : ChannelInterpolation::linear;
}

/// A value with the derivatives before and behind it.
struct WeightKey {
  Eigen::Vector3d before = Eigen::Vector3d::Zero(), value, behind = Eigen::Vector3d::Zero();
};

WeightKey key_at(const VectorChannel& channel, const ChannelCurve<Eigen::Vector3d>& curve, double time) {
  WeightKey key{.value = curve.at(time)};
  if (channel.size() == 1 || time < channel.times.front() || time > channel.times.back()) return key;
  const Knots& knots = curve.knots();
  const std::size_t left = knots.segment_at(time, Side::left), right = knots.segment_at(time, Side::right);
  if (time > channel.times.front()) key.before = curve.curve().motion(time, left).velocity;
  if (time < channel.times.back()) key.behind = curve.curve().motion(time, right).velocity;
  return key;
}

bool are_equal(const WeightChannels& a, const WeightChannels& b) {
  const auto same = [](const VectorChannel& one, const VectorChannel& other) {
    return one.interpolation == other.interpolation && one.times == other.times && one.values == other.values &&
           one.in_tangents == other.in_tangents && one.out_tangents == other.out_tangents;
  };
  return a.joint == b.joint && a.count == b.count && std::ranges::equal(a.triples, b.triples, same);
}

}  // namespace

std::optional<WeightChannels> weights_in(const Document& document, const Object& sampler, std::size_t joint,
                                         std::size_t most) {
  const auto interpolation = interpolation_of(sampler);
  auto times = floats_of(document, sampler, "input", most);
  const auto numbers = floats_of(document, sampler, "output", most);
  if (!interpolation || !times || !numbers || times->empty()) return std::nullopt;
  if (std::ranges::adjacent_find(*times, std::ranges::greater_equal()) != times->end()) return std::nullopt;
  const bool is_cubic = *interpolation == ChannelInterpolation::cubicspline;
  const std::size_t keys = times->size(), width = is_cubic ? 3 : 1, count = numbers->size() / (keys * width);
  if (count == 0 || numbers->size() != count * keys * width) return std::nullopt;
  WeightChannels weights{.joint = joint, .count = count};
  const SharedList<double> shared = std::move(*times);
  for (std::size_t first = 0; first < count; first += 3) {
    VectorChannel& channel =
        weights.triples.emplace_back(VectorChannel{.joint = joint, .interpolation = *interpolation, .times = shared});
    for (std::size_t k = 0; k < keys; ++k) {
      const std::size_t at = k * width * count + first;
      if (is_cubic) channel.in_tangents.push_back(triple_at(*numbers, at, count - first));
      channel.values.push_back(triple_at(*numbers, at + (is_cubic ? count : 0), count - first));
      if (is_cubic) channel.out_tangents.push_back(triple_at(*numbers, at + 2 * count, count - first));
    }
  }
  return weights;
}

const WeightChannels* changed_weights(const Source& source, const Clip& clip, const Object& animation,
                                      const AnimationChannel& channel) {
  if (!channel.weights_of) return nullptr;
  const std::size_t joint = source.nodes().joint_of_node[*channel.weights_of];
  const auto found = std::ranges::find(clip.weights, joint, &WeightChannels::joint);
  const auto sampler = animation.entry("samplers", "sampler", channel.sampler);
  if (found == clip.weights.end() || !sampler) return nullptr;
  const auto before = weights_in(source.document(), *sampler, joint, std::numeric_limits<std::size_t>::max());
  return before && !are_equal(*before, *found) ? &*found : nullptr;
}

WeightKeys keys_of(const WeightChannels& weights) {
  WeightKeys keys{.interpolation = interpolation_of(weights), .times = times_of(weights)};
  const bool is_cubic = keys.interpolation == ChannelInterpolation::cubicspline && keys.times.size() > 1;
  if (!is_cubic && keys.interpolation == ChannelInterpolation::cubicspline)
    keys.interpolation = ChannelInterpolation::linear;
  const std::vector<ChannelCurve<Eigen::Vector3d>> curves(weights.triples.begin(), weights.triples.end());
  for (const double time : keys.times) {
    std::vector<WeightKey> at;
    for (std::size_t k = 0; k < curves.size(); ++k) at.push_back(key_at(weights.triples[k], curves[k], time));
    const auto append = [&](Eigen::Vector3d WeightKey::*part) {
      for (std::size_t i = 0; i < weights.count; ++i)
        keys.numbers.push_back((at[i / 3].*part)[static_cast<Eigen::Index>(i % 3)]);
    };
    if (is_cubic) append(&WeightKey::before);
    append(&WeightKey::value);
    if (is_cubic) append(&WeightKey::behind);
  }
  return keys;
}

}}}  // namespace orispline::scenes::gltf
