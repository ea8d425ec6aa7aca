// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include <orispline/base/base64.hpp>
#include <orispline/base/counted.hpp>
#include <orispline/base/file_name.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/clip/clip.hpp>
#include <orispline/io/file_system.hpp>
#include <orispline/scenes/gltf/bits_of_file.hpp>
#include <orispline/scenes/gltf/compressed_views.hpp>
#include <orispline/scenes/gltf/document.hpp>
#include <orispline/scenes/gltf/integers.hpp>
#include <orispline/scenes/gltf/packing.hpp>
#include <orispline/scenes/gltf/weights.hpp>
#include <orispline/scenes/gltf/written_lists.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// A channel in single precision, as the file holds it.
struct WrittenChannel {
  std::size_t joint = 0;
  Property property = Property::rotation;
  ChannelInterpolation interpolation = ChannelInterpolation::linear;
  SharedList<float> times{};
  float end = 0.0F;                              ///< of the last key, also where that was left out
  SharedList<float> outputs{};                   ///< of splines with a tangent before and after each value
  ComponentType component = ComponentType::f32;  ///< of the outputs, which are such numbers
};

/// Weights in single precision, as the file holds them.
struct WrittenWeights {
  ChannelInterpolation interpolation = ChannelInterpolation::linear;
  std::vector<float> times{}, outputs{};
};

std::array<double, 4> numbers_of(const Eigen::Quaterniond& value) {
  return {value.x(), value.y(), value.z(), value.w()};
}
std::array<double, 3> numbers_of(const Eigen::Vector3d& value) { return {value.x(), value.y(), value.z()}; }

/// A spline stays the curve that it is: the signs of its keys are part of it.
RotationChannel with_signs_aligned(RotationChannel channel) {
  if (channel.interpolation == ChannelInterpolation::cubicspline) return channel;
  for (std::size_t i = 1; i < channel.size(); ++i)
    if (channel.values[i - 1].dot(channel.values[i]) < 0.0) channel.values[i].coeffs() *= -1.0;
  return channel;
}

Expected<std::vector<float>> single_times(const std::vector<double>& times) {
  std::vector<float> singles;
  singles.reserve(times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto time = static_cast<float>(times[i]);
    if (!std::isfinite(time) || time < 0.0F)
      return failure(ErrorCode::bad_data, formatted("found time {}, wanted one from 0 on", times[i]), {.key = i});
    if (i > 0 && time <= singles.back())
      return failure(ErrorCode::bad_data,
                     formatted("found time {} after {}, which are {} and {} in single precision, wanted "
                               "increasing times",
                               times[i], times[i - 1], time, singles.back()),
                     {.key = i});
    singles.push_back(time == 0.0F ? 0.0F : time);  // not -0, which some readers hold against it
  }
  return singles;
}

template <CurvePoint P>
Expected<std::vector<float>> single_outputs(const Channel<P>& channel) {
  const bool is_spline = channel.interpolation == ChannelInterpolation::cubicspline;
  std::vector<float> singles;
  const auto append = [&](const P& value) {
    for (const double number : numbers_of(value)) singles.push_back(static_cast<float>(number));
  };
  for (std::size_t i = 0; i < channel.size(); ++i) {
    const std::size_t before = singles.size();
    if (is_spline) append(channel.in_tangents[i]);
    append(channel.values[i]);
    if (is_spline) append(channel.out_tangents[i]);
    if (!std::all_of(singles.begin() + static_cast<std::ptrdiff_t>(before), singles.end(),
                     [](float number) { return std::isfinite(number); }))
      return failure(ErrorCode::bad_data, "found a number beyond single precision, wanted smaller ones", {.key = i});
  }
  return singles;
}

/// Whether nothing moves: all values equal bit for bit, and the tangents zero.
bool is_constant(const WrittenChannel& channel, std::size_t components) {
  const bool is_spline = channel.interpolation == ChannelInterpolation::cubicspline;
  const std::size_t width = channel.outputs.size() / channel.times.size(), at = is_spline ? components : 0;
  for (std::size_t i = 0; i < channel.times.size(); ++i) {
    const float* key = &channel.outputs[i * width];
    if (std::memcmp(key + at, &channel.outputs[at], components * sizeof(float)) != 0) return false;
    const auto is_zero = [](float number) { return number == 0.0F; };
    if (is_spline && !(std::all_of(key, key + at, is_zero) && std::all_of(key + 2 * at, key + 3 * at, is_zero)))
      return false;
  }
  return true;
}

/// One key where nothing moves, and of a spline of one key its value: glTF has no such spline.
WrittenChannel shortened(WrittenChannel channel, std::size_t components) {
  const bool is_spline = channel.interpolation == ChannelInterpolation::cubicspline;
  if (!is_constant(channel, components) && !(is_spline && channel.times.size() == 1)) return channel;
  if (is_spline) {
    std::copy_n(channel.outputs.begin() + static_cast<std::ptrdiff_t>(components), components, channel.outputs.begin());
    channel.interpolation = ChannelInterpolation::linear;
  }
  channel.times.resize(1);
  channel.outputs.resize(components);
  return channel;
}

template <CurvePoint P>
Expected<WrittenChannel> in_single(const Channel<P>& channel, Property property) {
  auto times = single_times(channel.times);
  if (!times) return tl::unexpected(std::move(times.error()));
  auto outputs = single_outputs(channel);
  if (!outputs) return tl::unexpected(std::move(outputs.error()));
  constexpr std::size_t components = std::same_as<P, Eigen::Quaterniond> ? 4 : 3;
  const float end = times->back();
  return shortened({.joint = channel.joint,
                    .property = property,
                    .interpolation = channel.interpolation,
                    .times = std::move(*times),
                    .end = end,
                    .outputs = std::move(*outputs)},
                   components);
}

/// Signs of neighbours agree, but those of splines stay; a channel that does not move has one key. Errors (bad_data): a
/// time below 0, times that do not rise in single precision, a number beyond it.
Expected<WrittenChannel> written(const RotationChannel& channel, const RotationOfFile* of_file, SameKey same) {
  return in_single(with_signs_aligned(of_file == nullptr ? channel : with_bits_of_file(channel, *of_file, same)),
                   Property::rotation);
}

Expected<WrittenChannel> written(const VectorChannel& channel, Property property) {
  return in_single(channel, property);
}

/// With its last key again, which was left out because nothing moves.
WrittenChannel held_to_end(WrittenChannel channel) {
  channel.times.push_back(channel.end);
  const std::size_t components = channel.outputs.size();
  channel.outputs.resize(2 * components);
  std::copy_n(channel.outputs.begin(), components, channel.outputs.begin() + static_cast<std::ptrdiff_t>(components));
  return channel;
}

/// Which animation of the document each clip takes the place of: that at its place where there are as many, else the
/// next one of its name.
struct AnimationPlan {
  std::vector<std::optional<std::size_t>> of_clip{};
  KeptSamplers kept{};  ///< those of channels that are not ours, in animations that stay
};

/// The list of animations, whose keys are in the store.
struct WrittenAnimations {
  Json list = Json::array();
  KeyStore store;
  WrittenKeys keys{};
  std::vector<Warning> warnings{};
};

using Place = std::pair<std::size_t, Property>;  ///< a node, and what of it moves

/// The channels of the animation that a clip takes the place of.
struct OldAnimation {
  Json json = Json::object();
  std::string name{};
  std::vector<AnimationChannel> channels{};
  std::map<Place, std::size_t> sampler_of{};
};

Expected<OldAnimation> old_animation(const Document& document, std::optional<std::size_t> index) {
  if (!index) return OldAnimation{};
  const auto object = animation_of(document, *index);
  if (!object) return tl::unexpected(object.error());
  auto name = animation_name(*object, *index);
  if (!name) return tl::unexpected(std::move(name.error()));
  return animation_channels(document, *object).map([&](std::vector<AnimationChannel> channels) {
    OldAnimation old{document.json["animations"][*index], std::move(*name), std::move(channels), {}};
    for (const AnimationChannel& channel : old.channels)
      if (channel.target)
        old.sampler_of.emplace(Place(channel.target->node, channel.target->property), channel.sampler);
    return old;
  });
}

std::string_view word_of(ChannelInterpolation interpolation) {
  return interpolation == ChannelInterpolation::step ? "STEP" : "CUBICSPLINE";
}

/// One key less may shorten the clip: then one channel that does not move keeps its last.
std::vector<WrittenChannel> with_end(std::vector<WrittenChannel> channels) {
  const auto last = [](const WrittenChannel& channel) { return channel.times.back(); };
  if (channels.empty()) return channels;
  const auto longest = std::ranges::max_element(channels, {}, &WrittenChannel::end);
  if (std::ranges::max(channels, {}, last).times.back() < longest->end) *longest = held_to_end(std::move(*longest));
  return channels;
}

/// Channels and samplers of an animation, made one by one; equal samplers are one.
class SamplerList {
 public:
  /// A sampler that stays as it was.
  [[nodiscard]] std::size_t kept(std::size_t old, const Json& samplers) {
    const auto [found, is_new] = of_old_.try_emplace(old, list_.size());
    if (is_new) list_.push_back(samplers[old]);
    return found->second;
  }
  [[nodiscard]] std::size_t made(std::size_t input, std::size_t output, ChannelInterpolation interpolation) {
    const auto [found, is_new] = of_keys_.try_emplace({input, output, interpolation}, list_.size());
    if (!is_new) return found->second;
    Json sampler{{"input", input}, {"output", output}};
    if (interpolation != ChannelInterpolation::linear) sampler["interpolation"] = word_of(interpolation);
    list_.push_back(std::move(sampler));
    return found->second;
  }
  [[nodiscard]] Json list() && { return std::move(list_); }

 private:
  Json list_ = Json::array();
  std::map<std::size_t, std::size_t> of_old_{};
  std::map<std::tuple<std::size_t, std::size_t, ChannelInterpolation>, std::size_t> of_keys_{};
};

class Writer {
 public:
  Writer(const Scene& scene, const Source& source, KeyStore store, SameKey same)
      : scene_(scene), source_(source), same_(same), result_{.store = std::move(store)} {}

  [[nodiscard]] Expected<WrittenAnimations> all(const AnimationPlan& plan) && {
    for (std::size_t i = 0; i < scene_.clips.size(); ++i) {
      const auto old = old_animation(source_.document(), plan.of_clip[i]);
      if (!old) return tl::unexpected(old.error());
      auto channels = channels_of(scene_.clips[i], *old);
      if (!channels) return tl::unexpected(std::move(channels.error()));
      const auto weights = weights_of(scene_.clips[i], *old, plan.of_clip[i]);
      if (!weights) return tl::unexpected(weights.error());
      append(scene_.clips[i], *old, with_end(std::move(*channels)), *weights);
    }
    return std::move(result_);
  }

 private:
  [[nodiscard]] Expected<std::vector<WrittenChannel>> channels_of(const Clip& clip, const OldAnimation& old) {
    std::vector<WrittenChannel> channels;
    const auto append_to = [&]<CurvePoint P>(const std::vector<Channel<P>>& list, auto&& write) -> Expected<void> {
      std::map<PlacesOfKeys<P>, std::size_t> known;
      for (const Channel<P>& channel : list) {
        const auto [same, is_new] = known.try_emplace(places_of_keys(channel), channels.size());
        if (!is_new) {
          channels.push_back(channels[same->second]);
          channels.back().joint = channel.joint;
          continue;
        }
        auto done = write(channel);
        const std::string place = place_of(scene_.skeleton, clip, channel.joint);
        if (!done) return tl::unexpected(within(place, std::move(done.error())));
        channels.push_back(std::move(*done));
      }
      return {};
    };
    const auto vectors = [](Property property) {
      return [property](const VectorChannel& channel) { return written(channel, property); };
    };
    return append_to(clip.rotations, [&](const RotationChannel& channel) { return written_rotation(channel, old); })
        .and_then([&] { return append_to(clip.translations, vectors(Property::translation)); })
        .and_then([&] { return append_to(clip.scales, vectors(Property::scale)); })
        .map([&] { return std::move(channels); });
  }

  [[nodiscard]] Expected<WrittenChannel> written_rotation(const RotationChannel& channel, const OldAnimation& old) {
    const auto found = old.sampler_of.find({node_of(channel.joint), Property::rotation});
    if (found == old.sampler_of.end()) return written(channel, nullptr, same_);
    const Object sampler = Object::of(old.json["samplers"][found->second], "").value();
    const auto keys = sampler_places(source_.document(), sampler, quaternion_type).and_then([&](const auto& places) {
      return sampler_keys(source_.document(), places, source_.reading());
    });
    if (!keys) return tl::unexpected(keys.error());
    auto raw = channel_of<Eigen::Quaterniond>(*keys, channel.joint, Norm::as_in_file);
    auto read = channel_of<Eigen::Quaterniond>(*keys, channel.joint);
    if (!raw || !read) return tl::unexpected(raw ? read.error() : raw.error());
    const RotationOfFile of_file{std::move(*raw), std::move(*read)};
    const auto places = sampler_places(source_.document(), sampler, quaternion_type);
    return written(channel, &of_file, same_).map([&](WrittenChannel done) {
      const ComponentType before = places->output.type;
      if (bytes_in(before, done.outputs)) done.component = before;
      return done;
    });
  }

  /// Of old channels by their places: those whose weights have changed.
  [[nodiscard]] Expected<std::map<std::size_t, WrittenWeights>> weights_of(const Clip& clip, const OldAnimation& old,
                                                                           std::optional<std::size_t> index) const {
    std::map<std::size_t, WrittenWeights> changed;
    if (!index) return changed;
    const auto animation = animation_of(source_.document(), *index);
    if (!animation) return tl::unexpected(animation.error());
    for (std::size_t i = 0; i < old.channels.size(); ++i) {
      const WeightChannels* const weights = changed_weights(source_, clip, *animation, old.channels[i]);
      if (!weights) continue;
      const WeightKeys keys = gltf::keys_of(*weights);
      auto times = single_times(keys.times);
      if (!times) return tl::unexpected(within(place_of(scene_.skeleton, clip, weights->joint), times.error()));
      changed[i] = {keys.interpolation, std::move(*times),
                    std::vector<float>(keys.numbers.begin(), keys.numbers.end())};
    }
    return changed;
  }

  [[nodiscard]] std::size_t node_of(std::size_t joint) const { return source_.nodes().node_of_joint[joint]; }

  [[nodiscard]] std::size_t sampler_of(const WrittenChannel& channel, SamplerList& samplers) {
    const ValueType& type = channel.property == Property::rotation ? quaternion_type : vector_type;
    const std::size_t input = result_.store.times(channel.times);
    (channel.property == Property::rotation      ? result_.keys.rotations
     : channel.property == Property::translation ? result_.keys.translations
                                                 : result_.keys.scales) += channel.times.size();
    const bool is_spline = channel.interpolation == ChannelInterpolation::cubicspline;
    const std::size_t output = result_.store.outputs(channel.outputs, type, is_spline);
    if (channel.component != ComponentType::f32) result_.store.write_in(channel.component, output);
    return samplers.made(input, output, channel.interpolation);
  }

  [[nodiscard]] std::size_t sampler_of(const WrittenWeights& weights, SamplerList& samplers) {
    const std::size_t input = result_.store.times(weights.times);
    const bool is_spline = weights.interpolation == ChannelInterpolation::cubicspline;
    return samplers.made(input, result_.store.outputs(weights.outputs, {"SCALAR", 1}, is_spline),
                         weights.interpolation);
  }

  /// Channels that were there stay at their place in the list, with what else they say.
  void append(const Clip& clip, const OldAnimation& old, const std::vector<WrittenChannel>& written_channels,
              const std::map<std::size_t, WrittenWeights>& weights) {
    std::map<Place, const WrittenChannel*> left;
    for (const WrittenChannel& channel : written_channels)
      left.emplace(Place(node_of(channel.joint), channel.property), &channel);
    SamplerList samplers;
    Json channels = Json::array();
    for (std::size_t i = 0; i < old.channels.size(); ++i) {
      const auto& target = old.channels[i].target;
      const auto found = target ? left.find({target->node, target->property}) : left.end();
      if (target && found == left.end()) continue;
      Json channel = old.json["channels"][i];
      const auto weighs = weights.find(i);
      channel["sampler"] = target                    ? sampler_of(*found->second, samplers)
                           : weighs != weights.end() ? sampler_of(weighs->second, samplers)
                                                     : samplers.kept(old.channels[i].sampler, old.json["samplers"]);
      channels.push_back(std::move(channel));
      if (target) left.erase(found);
    }
    for (const WrittenChannel& channel : written_channels) {
      const Place place(node_of(channel.joint), channel.property);
      if (left.contains(place))
        channels.push_back({{"sampler", sampler_of(channel, samplers)},
                            {"target", {{"node", place.first}, {"path", gltf::word_of(place.second)}}}});
    }
    append(clip, old, std::move(channels), std::move(samplers).list());
  }

  void append(const Clip& clip, const OldAnimation& old, Json channels, Json samplers) {
    const bool was_empty = old.channels.empty() && !old.json.empty();
    if (channels.empty() && !was_empty) {
      result_.warnings.push_back(
          {.code = "empty_clip",
           .message =
               formatted("clip {} has no keys and is left out, for glTF has no such animation", in_quotes(clip.name))});
      return;
    }
    Json animation = old.json;
    if (!channels.empty()) {
      animation["channels"] = std::move(channels);
      animation["samplers"] = std::move(samplers);
    }
    if (clip.name != old.name) animation["name"] = clip.name;
    result_.list.push_back(std::move(animation));
  }

  const Scene& scene_;
  const Source& source_;
  SameKey same_;
  WrittenAnimations result_;
};

Expected<AnimationPlan> plan_of(const Source& source, const std::vector<Clip>& clips) {
  const Document& document = source.document();
  const Json& animations = *document.root().list("animations").value();
  AnimationPlan plan{.of_clip = std::vector<std::optional<std::size_t>>(clips.size()),
                     .kept = KeptSamplers(animations.size())};
  std::multimap<std::string, std::size_t> by_name;
  for (std::size_t a = 0; a < animations.size(); ++a) {
    const auto animation = animation_of(document, a);
    if (!animation) return tl::unexpected(animation.error());
    auto name = animation_name(*animation, a);
    if (!name) return tl::unexpected(std::move(name.error()));
    by_name.emplace(std::move(*name), a);
    plan.kept[a].resize(animation->list("samplers").value()->size());
  }
  for (std::size_t i = 0; i < clips.size(); ++i) {
    const auto found = by_name.lower_bound(clips[i].name);
    if (clips.size() == animations.size()) plan.of_clip[i] = i;
    else if (found != by_name.end() && found->first == clips[i].name) plan.of_clip[i] = by_name.extract(found).mapped();
    if (!plan.of_clip[i]) continue;
    const auto channels = animation_channels(document, animation_of(document, *plan.of_clip[i]).value());
    if (!channels) return tl::unexpected(channels.error());
    const auto animation = animation_of(document, *plan.of_clip[i]);
    for (const AnimationChannel& channel : *channels)
      if (!channel.target && !(animation && changed_weights(source, clips[i], *animation, channel)))
        plan.kept[*plan.of_clip[i]][channel.sampler] = true;
  }
  return plan;
}

/// Errors (bad_data), which name the clip, the joint and the key: times that are one in single precision, or below 0.
Expected<WrittenAnimations> written_animations(const Scene& scene, const Source& source, const AnimationPlan& plan,
                                               KeyStore store, SameKey same) {
  return Writer(scene, source, std::move(store), same).all(plan);
}

constexpr std::string_view binary_extension = ".glb", text_extension = ".gltf";
/// Of files that hold an avatar and a motion for one, by the extensions that say so.
constexpr std::string_view avatar_extension = ".vrm", avatar_motion_extension = ".vrma";
constexpr std::array file_extensions{binary_extension, text_extension, avatar_extension, avatar_motion_extension};

/// Errors (bad_argument): the name of a file for avatars, without what makes it one.
Expected<void> check_name(const Json& json, const std::string& path) {
  const auto extensions = json.find("extensions");
  const auto has = [&](std::string_view name) { return extensions != json.end() && extensions->contains(name); };
  if (has_extension(path, avatar_extension) && !has("VRMC_vrm") && !has("VRM"))
    return failure(ErrorCode::bad_argument, "found no VRM avatar for a .vrm file, wanted a name that ends in .glb");
  if (has_extension(path, avatar_motion_extension) && !has("VRMC_vrm_animation"))
    return failure(ErrorCode::bad_argument, "found no VRM animation for a .vrma file, wanted a name that ends in .glb");
  return {};
}

/// The bytes of a file. Names of strangers need not be UTF-8: what is not is replaced.
Expected<std::string> file_of(Json json, const std::string& binary, const std::string& path) {
  const auto text = [&](int indent) { return json.dump(indent, ' ', false, Json::error_handler_t::replace); };
  if (!has_extension(path, text_extension)) return glb_of(text(-1), binary);
  if (!binary.empty()) json["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64_of(binary);
  return text(2) + "\n";
}

/// Images stay where they are: what is missing beside a file in another folder.
std::vector<Warning> warnings_of_images(const Json& json, const std::string& from, const std::string& to) {
  const auto images = json.find("images");
  if (images == json.end() || !images->is_array() || from.empty()) return {};
  if (io::are_in_one_folder(from, to)) return {};
  const auto count = std::ranges::count_if(*images, [](const Json& image) {
    const auto uri = image.is_object() ? image.find("uri") : image.end();
    return image.is_object() && uri != image.end() && uri->is_string() &&
           !uri->get_ref<const std::string&>().starts_with("data:");
  });
  if (count == 0) return {};
  return {{.code = "images_elsewhere",
           .message = formatted(
               "found {} in files beside the input, which the output looks for in its own folder; copy them there",
               counted(static_cast<std::size_t>(count), "image")),
           .where = {.file = to}}};
}

Expected<SceneWritten> written_from(const Source& source, const Scene& scene, const std::string& path,
                                    KeyCompression compression) {
  const Document& document = source.document();
  if (auto named = check_name(document.json, path); !named) return tl::unexpected(std::move(named.error()));
  const auto plan = plan_of(source, scene.clips);
  if (!plan) return tl::unexpected(plan.error());
  const Uses uses = uses_of(document, plan->kept);
  KeyStore store(uses.free_accessors, document.root().list("accessors").value()->size());
  // What is rounded to be compressed is to stay so.
  const SameKey same = compression == KeyCompression::none ? SameKey::to_rounding : SameKey::to_the_bit;
  auto animations = written_animations(scene, source, *plan, std::move(store), same);
  if (!animations) return tl::unexpected(std::move(animations.error()));
  auto lists = packed(document, uses, animations->store, compression);
  if (!lists) return tl::unexpected(std::move(lists.error()));
  Json json = document.json;
  set_list(json, "animations", std::move(animations->list));
  take_matrices_apart(json, source.nodes());
  set_lists(json, document, *lists);
  std::ranges::move(warnings_of_images(json, scene.name, path), std::back_inserter(animations->warnings));
  return file_of(std::move(json), lists->bytes, path).map([&](std::string bytes) {
    return SceneWritten{std::move(bytes), animations->keys, std::move(animations->warnings)};
  });
}

Expected<Scene> scene_of(Document document, const SceneReading& reading) {
  Scene scene;
  auto nodes = nodes_of(document);
  if (!nodes) return tl::unexpected(std::move(nodes.error()));
  auto warnings = extension_warnings(document);
  if (!warnings) return tl::unexpected(std::move(warnings.error()));
  scene.bytes = document.bytes_beside;
  scene.skeleton = nodes->skeleton;
  scene.warnings = std::move(*warnings);
  AnimationReader animations(document, *nodes, reading);
  for (std::size_t i = document.root().list("animations").value()->size(); i > 0; --i) {
    auto clip = animations.next();
    if (!clip) return tl::unexpected(std::move(clip.error()));
    scene.clips.push_back(std::move(*clip));
  }
  for (Warning& warning : animations.warnings()) scene.warnings.push_back(std::move(warning));
  scene.has_integer_keys = animations.found_integers();
  scene.next_tool = compressing_tool(document);
  scene.source = std::make_shared<const Source>(std::move(document), std::move(*nodes), reading);
  return scene;
}

}  // namespace

Expected<Scene> read_scene(std::string_view bytes, const io::Input& from, const SceneReading& reading) {
  return document_of(bytes, from).and_then(with_animations_decoded).and_then([&](Document document) {
    return scene_of(std::move(document), reading);
  });
}

/// The scene as a GLB, or as text where the path ends in `.gltf`. Errors: bad_data for what glTF cannot hold; those of
/// check_name().
Expected<SceneWritten> written_scene(const Scene& scene, const std::string& path, const SceneWriting& writing) {
  const auto* source = dynamic_cast<const Source*>(scene.source.get());
  const auto rooted = source ? with_new_root(*source, scene.skeleton) : std::nullopt;
  if (rooted) source = &*rooted;
  const bool is_ours = source != nullptr && source->nodes().skeleton.size() == scene.skeleton.size();
  return (is_ours ? written_from(*source, scene, path, writing.compression)
                  : written_from(made_source(scene.skeleton, writing), scene, path, writing.compression))
      .map_error([&](Error error) {
        error.where.file = path;
        return error;
      });
}

}}}  // namespace orispline::scenes::gltf

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

constinit const SceneFormat gltf_format{{.title = "glTF", .file = "a glTF file", .holds_floats = true},
                                        "gltf",
                                        "glTF 2.0, in one file or as text, and VRM",
                                        gltf::file_extensions,
                                        gltf::check_start,
                                        gltf::read_scene,
                                        gltf::written_scene};

}}}  // namespace orispline::scenes
