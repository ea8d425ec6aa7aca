// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/document.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/scenes/gltf/weights.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

Expected<ChannelInterpolation> interpolation_of(const Object& sampler) {
  return sampler.text_or("interpolation", "LINEAR").and_then([&](const std::string& word) {
    if (word == "LINEAR") return Expected<ChannelInterpolation>(ChannelInterpolation::linear);
    if (word == "STEP") return Expected<ChannelInterpolation>(ChannelInterpolation::step);
    if (word == "CUBICSPLINE") return Expected<ChannelInterpolation>(ChannelInterpolation::cubicspline);
    return Expected<ChannelInterpolation>(
        sampler.fault(formatted("found interpolation {}, wanted LINEAR, STEP or CUBICSPLINE", in_quotes(word))));
  });
}

/// From the start of the first to the end of the last of them.
std::optional<Domain> joined(const std::optional<Domain>& a, const std::optional<Domain>& b) {
  if (!a || !b) return a ? a : b;
  return Domain{std::min(a->start, b->start), std::max(a->end, b->end)};
}

struct Column {
  Accessor accessor{};
  std::size_t index = 0;
};

/// The accessor that a sampler refers to, of a type that keys have.
Expected<Column> column_of(const Document& document, const Object& sampler, const char* key, const ValueType& type) {
  const auto index = sampler.index(key, document.root().list("accessors").value()->size());
  if (!index) return tl::unexpected(index.error());
  const auto word = document.root().entry("accessors", "accessor", *index).and_then([](const Object& accessor) {
    return accessor.text("type");
  });
  if (!word) return tl::unexpected(word.error());
  if (*word != type.word)
    return failure(ErrorCode::bad_data,
                   formatted("accessor {}: found type {}, wanted {}", *index, in_quotes(*word), type.word));
  return accessor_of(document, *index).and_then([&](const Accessor& accessor) -> Expected<Column> {
    const bool is_time = type.components == 1;
    if (accessor.type == ComponentType::f32) return Column{accessor, *index};
    if (!is_time && accessor.is_normalised && accessor.type != ComponentType::u32) return Column{accessor, *index};
    return failure(ErrorCode::bad_data,
                   formatted("accessor {}: found {}integers of componentType {}, wanted {}", *index,
                             accessor.is_normalised ? "normalised " : "", static_cast<int>(accessor.type),
                             is_time ? "floats" : "floats or normalised integers of 8 or 16 bits"));
  });
}

/// The name of a number in single precision, as it stands in the file.
std::string single(double time) { return formatted("{}", static_cast<float>(time)); }

tl::unexpected<Error> time_fault(std::size_t key, double time, double before) {
  std::string message = formatted("found time {} after {}, wanted increasing times", single(time), single(before));
  if (time == before) return mended_by("drop_duplicates", std::move(message), {.key = key});
  return failure(ErrorCode::bad_data, std::move(message), {.key = key});
}

/// The keys that stay: all, or the first of those at equal times.
Expected<std::vector<std::size_t>> keys_at_rising_times(const std::vector<double>& times, const SceneReading& reading) {
  std::vector<std::size_t> kept;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (!std::isfinite(times[i]))
      return failure(ErrorCode::bad_data, formatted("found time {}, wanted a finite number", single(times[i])),
                     {.key = i});
    const bool is_late = kept.empty() || times[i] > times[kept.back()];
    if (!is_late && !(reading.drop_duplicates && times[i] == times[kept.back()]))
      return time_fault(i, times[i], times[kept.back()]);
    if (is_late) kept.push_back(i);
  }
  return kept;
}

SamplerKeys only(const std::vector<std::size_t>& kept, SamplerKeys keys) {
  if (kept.size() == keys.size()) return keys;
  const std::size_t width = keys.outputs.size() / keys.size();
  for (std::size_t i = 0; i < kept.size(); ++i) {
    keys.times[i] = keys.times[kept[i]];
    for (std::size_t c = 0; c < width; ++c) keys.outputs[i * width + c] = keys.outputs[kept[i] * width + c];
  }
  keys.times.resize(kept.size());
  keys.outputs.resize(kept.size() * width);
  return keys;
}

Expected<void> check_counts(const Column& times, const Column& outputs, std::size_t per_key) {
  if (outputs.accessor.count == times.accessor.count * per_key) return {};
  return failure(ErrorCode::bad_data,
                 formatted("found {} in accessor {} for {}, wanted {}", counted(outputs.accessor.count, "output"),
                           outputs.index, counted(times.accessor.count, "key"), times.accessor.count * per_key));
}

template <CurvePoint P>
P point_at(const double* numbers) {
  return P(numbers);
}

std::string value_fault(const Eigen::Quaterniond& value) { return norm_fault(value.norm()); }
std::string value_fault(const Eigen::Vector3d&) { return {}; }

double size_to_take(const Eigen::Quaterniond& value) { return value.norm(); }
double size_to_take(const Eigen::Vector3d&) { return 1.0; }

template <CurvePoint P>
P divided(P value, double divisor) {
  if constexpr (std::same_as<P, Eigen::Quaterniond>) {
    value.coeffs() /= divisor;
  } else {
    value /= divisor;
  }
  return value;
}

constexpr std::array all_properties{Property::rotation, Property::translation, Property::scale};

Expected<std::optional<ChannelTarget>> target_of(const Object& target, std::size_t nodes) {
  const auto path = target.text("path");
  if (!path) return tl::unexpected(path.error());
  for (const Property property : all_properties) {
    if (*path != word_of(property) || !target.has("node")) continue;
    return target.index("node", nodes).map([&](std::size_t node) {
      return std::optional(ChannelTarget{node, property});
    });
  }
  return std::nullopt;
}

/// The node whose morph targets it weighs.
Expected<std::size_t> weighed_node(const Object& target, std::size_t nodes) {
  const auto path = target.text("path");
  if (!path) return tl::unexpected(path.error());
  if (*path != "weights") return target.fault("found no weights");
  return target.index("node", nodes);
}

}  // namespace

Expected<SamplerPlaces> sampler_places(const Document& document, const Object& sampler, const ValueType& type) {
  const auto interpolation = interpolation_of(sampler);
  if (!interpolation) return tl::unexpected(interpolation.error());
  const auto input = column_of(document, sampler, "input", {"SCALAR", 1});
  if (!input) return tl::unexpected(input.error());
  const auto output = column_of(document, sampler, "output", type);
  if (!output) return tl::unexpected(output.error());
  const std::size_t per_key = *interpolation == ChannelInterpolation::cubicspline ? 3 : 1;
  return check_counts(*input, *output, per_key).map([&] {
    return SamplerPlaces{*interpolation, input->accessor, output->accessor};
  });
}

Expected<SamplerKeys> sampler_keys(const Document& document, const SamplerPlaces& places, const SceneReading& reading) {
  auto times = values_of(document, places.input), outputs = values_of(document, places.output);
  if (!times) return tl::unexpected(std::move(times.error()));
  if (!outputs) return tl::unexpected(std::move(outputs.error()));
  SamplerKeys keys{places.interpolation, std::move(*times), std::move(*outputs)};
  return keys_at_rising_times(keys.times, reading).map([&](const std::vector<std::size_t>& kept) {
    return only(kept, std::move(keys));
  });
}

std::optional<Domain> sampler_domain(const Document& document, const Object& sampler) {
  const auto input =
      sampler.index("input", document.root().list("accessors").value()->size()).and_then([&](std::size_t index) {
        return accessor_of(document, index);
      });
  if (!input || input->type != ComponentType::f32 || input->components != 1 || !input->offset || input->sparse)
    return std::nullopt;
  const Domain domain{first_component(document, *input, 0), first_component(document, *input, input->count - 1)};
  return std::isfinite(domain.start) && std::isfinite(domain.end) && domain.start <= domain.end ? std::optional(domain)
                                                                                                : std::nullopt;
}

template <CurvePoint P>
Expected<Channel<P>> channel_of(const SamplerKeys& keys, std::size_t joint, Norm norm) {
  constexpr std::size_t n = std::same_as<P, Eigen::Quaterniond> ? 4 : 3;
  Channel<P> channel{.joint = joint, .interpolation = keys.interpolation, .times = keys.times};
  const bool is_spline = keys.interpolation == ChannelInterpolation::cubicspline;
  const std::size_t width = is_spline ? 3 * n : n;
  channel.values.reserve(keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const double* numbers = &keys.outputs[i * width];
    if (!std::all_of(numbers, numbers + width, [](double number) { return std::isfinite(number); }))
      return failure(ErrorCode::bad_data, "found a number that is not finite, wanted finite ones", {.key = i});
    const P value = point_at<P>(is_spline ? numbers + n : numbers);
    if (const std::string fault = value_fault(value); !fault.empty())
      return failure(ErrorCode::bad_data, fault, {.key = i});
    const double divisor = norm == Norm::one ? size_to_take(value) : 1.0;
    channel.values.push_back(divided(value, divisor));
    if (!is_spline) continue;
    channel.in_tangents.push_back(divided(point_at<P>(numbers), divisor));
    channel.out_tangents.push_back(divided(point_at<P>(numbers + 2 * n), divisor));
  }
  return channel;
}

template Expected<RotationChannel> channel_of(const SamplerKeys&, std::size_t, Norm);
template Expected<VectorChannel> channel_of(const SamplerKeys&, std::size_t, Norm);

std::optional<Property> property_of(std::string_view word) noexcept {
  const auto found = std::ranges::find(all_properties, word, [](Property property) { return word_of(property); });
  return found == all_properties.end() ? std::nullopt : std::optional(*found);
}

std::string_view word_of(Property property) noexcept {
  switch (property) {
    case Property::rotation:
      return "rotation";
    case Property::translation:
      return "translation";
    case Property::scale:
      break;
  }
  return "scale";
}

Expected<Object> animation_of(const Document& document, std::size_t animation) {
  return document.root().entry("animations", "animation", animation);
}

Expected<std::string> animation_name(const Object& animation, std::size_t index) {
  return animation.text_or("name", "").map([&](std::string name) {
    return name.empty() ? formatted("animation {}", index) : std::move(name);
  });
}

namespace {

/// The nodes whose translations are no places but the weights of an avatar's expressions: so does VRM animate these.
std::vector<std::size_t> expression_nodes(const Document& document) {
  std::vector<std::size_t> nodes;
  const Json::json_pointer place("/extensions/VRMC_vrm_animation/expressions");
  if (!document.json.contains(place)) return nodes;
  for (const Json& kind : document.json.at(place))
    for (const Json& expression : kind.is_object() ? kind : Json::object())
      if (const auto node = expression.is_object() ? expression.find("node") : expression.end();
          node != expression.end() && node->is_number_unsigned())
        nodes.push_back(*node);
  return nodes;
}

}  // namespace

Expected<std::vector<AnimationChannel>> animation_channels(const Document& document, const Object& animation) {
  const auto samplers = animation.list("samplers");
  if (!samplers) return tl::unexpected(samplers.error());
  const auto list = animation.list("channels");
  if (!list) return tl::unexpected(list.error());
  const std::size_t nodes = document.root().list("nodes").value()->size();
  const std::vector<std::size_t> weights = expression_nodes(document);
  std::vector<AnimationChannel> channels((*list)->size());
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto channel = animation.entry("channels", "channel", i);
    if (!channel) return tl::unexpected(channel.error());
    const auto sampler = channel->index("sampler", (*samplers)->size());
    if (!sampler) return tl::unexpected(sampler.error());
    const auto target = channel->object("target").and_then([&](const Object& read) { return target_of(read, nodes); });
    if (!target) return tl::unexpected(target.error());
    channels[i] = {*sampler, *target};
    if (const auto weighed =
            channel->object("target").and_then([&](const Object& read) { return weighed_node(read, nodes); }))
      channels[i].weights_of = *weighed;
    std::optional<ChannelTarget>& ours = channels[i].target;
    if (ours && ours->property == Property::translation && std::ranges::find(weights, ours->node) != weights.end())
      ours.reset();
  }
  return channels;
}

Expected<Clip> AnimationReader::next() {
  const std::size_t index = animation_++;
  const auto animation = animation_of(document_, index);
  if (!animation) return tl::unexpected(animation.error());
  auto name = animation_name(*animation, index);
  if (!name) return tl::unexpected(std::move(name.error()));
  const auto channels = animation_channels(document_, *animation);
  if (!channels) return tl::unexpected(channels.error());
  Clip clip{.name = std::move(*name)};
  for (const AnimationChannel& channel : *channels) {
    const auto sampler = animation->entry("samplers", "sampler", channel.sampler);
    if (!channel.target) {
      if (!sampler || (channel.weights_of && took_weights(clip, *sampler, *channel.weights_of))) continue;
      clip.passed_on = joined(clip.passed_on, sampler_domain(document_, *sampler));
      continue;
    }
    const std::string place = place_of(nodes_.skeleton, clip, nodes_.joint_of_node[channel.target->node]);
    auto more = sampler.and_then([&](const Object& found) { return with(std::move(clip), found, *channel.target); });
    if (!more) return tl::unexpected(within(place, std::move(more.error())));
    clip = std::move(*more);
  }
  return clip;
}

bool AnimationReader::took_weights(Clip& clip, const Object& sampler, std::size_t node) {
  const std::size_t joint = nodes_.joint_of_node[node];
  if (std::ranges::find(clip.weights, joint, &WeightChannels::joint) != clip.weights.end()) return false;
  auto weights = weights_in(document_, sampler, joint, stored_left_);
  if (!weights) return false;
  stored_left_ -= weights->triples.front().size() * weights->count;
  clip.weights.push_back(std::move(*weights));
  return true;
}

Expected<Clip> AnimationReader::with(Clip clip, const Object& sampler, const ChannelTarget& target) {
  const std::size_t joint = nodes_.joint_of_node[target.node];
  if (target.property == Property::rotation)
    return channel(sampler, joint, rotations_).map([&](RotationChannel found) {
      clip.rotations.push_back(std::move(found));
      return std::move(clip);
    });
  auto& channels = target.property == Property::translation ? clip.translations : clip.scales;
  return channel(sampler, joint, vectors_).map([&](VectorChannel found) {
    channels.push_back(std::move(found));
    return std::move(clip);
  });
}

template <CurvePoint P>
Expected<Channel<P>> AnimationReader::channel(const Object& sampler, std::size_t joint, KnownChannels<P>& known) {
  const ValueType& type = std::same_as<P, Eigen::Quaterniond> ? quaternion_type : vector_type;
  const auto places = sampler_places(document_, sampler, type);
  if (!places) return tl::unexpected(places.error());
  if (places->input.count > keys_left_)
    return failure(ErrorCode::bad_data, "found more than 64 million keys in the file, wanted fewer");
  auto found = known.find(*places);
  if (found == known.end()) {
    auto channel = read<P>(*places);
    if (!channel) return channel;
    note_strides(sampler, *places);
    found = known.emplace(*places, std::move(*channel)).first;
  }
  keys_left_ -= found->second.size();
  Channel<P> channel = found->second;
  channel.joint = joint;
  return channel;
}

template <CurvePoint P>
Expected<Channel<P>> AnimationReader::read(const SamplerPlaces& places) {
  if (places.input.count > stored_left_)
    return failure(ErrorCode::bad_data,
                   formatted("found more than {} keys in accessors that overlap or have no data, wanted channels that "
                             "share accessors",
                             most_stored_));
  stored_left_ -= places.input.count;
  found_integers_ = found_integers_ || places.output.type != ComponentType::f32;
  return sampler_keys(document_, places, reading_)
      .and_then([](const SamplerKeys& keys) { return channel_of<P>(keys, 0); })
      .map([&](Channel<P> channel) {
        channel.times = times_.try_emplace(places.input, channel.times).first->second;
        return channel;
      });
}

void AnimationReader::note_strides(const Object& sampler, const SamplerPlaces& places) {
  const auto note = [&](const char* key, const Accessor& accessor) {
    if (accessor.is_strided) strided_.push_back(formatted("accessor {}", shown(*sampler.find(key))));
  };
  note("input", places.input);
  note("output", places.output);
}

std::vector<Warning> AnimationReader::warnings() const {
  if (strided_.empty()) return {};
  return {
      {.code = "strided_animation",
       .message = formatted("{} of animations in a bufferView with a byteStride, which glTF forbids there; they were "
                            "read by it, the first is {}",
                            counted(strided_.size(), "accessor"), strided_.front())}};
}

}}}  // namespace orispline::scenes::gltf
