// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/document.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

/// Zeros that no byte of the file stands for are made up to this many.
constexpr std::size_t most_zeros = 65536;

struct Shape {
  std::string_view name;
  std::size_t rows, columns;
};
constexpr std::array<Shape, 7> shapes{
    {{"SCALAR", 1, 1}, {"VEC2", 2, 1}, {"VEC3", 3, 1}, {"VEC4", 4, 1}, {"MAT2", 2, 2}, {"MAT3", 3, 3}, {"MAT4", 4, 4}}};

std::size_t size_of(ComponentType type) {
  switch (type) {
    case ComponentType::i8:
    case ComponentType::u8:
      return 1;
    case ComponentType::i16:
    case ComponentType::u16:
      return 2;
    case ComponentType::u32:
    case ComponentType::f32:
      break;
  }
  return 4;
}

Expected<ComponentType> component_type_of(const Object& object) {
  return object.count("componentType").and_then([&](std::size_t number) -> Expected<ComponentType> {
    if (number >= 5120 && number <= 5126 && number != 5124) return static_cast<ComponentType>(number);
    return object.fault(formatted("found componentType {}, wanted 5120 to 5126 without 5124", number));
  });
}

Expected<Shape> shape_of(const Object& object) {
  return object.text("type").and_then([&](const std::string& name) -> Expected<Shape> {
    const auto found = std::ranges::find(shapes, std::string_view(name), &Shape::name);
    if (found != shapes.end()) return *found;
    return object.fault(
        formatted("found type {}, wanted one of {}", in_quotes(name), "SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4"));
  });
}

struct ViewRange {
  View view{};
  std::size_t offset = 0;  ///< within the view
};

/// The view that an object refers to, and its own offset there.
Expected<ViewRange> range_of(const Document& document, const Object& object) {
  const auto index = object.index("bufferView", document.views.size());
  if (!index) return tl::unexpected(index.error());
  const auto offset = object.count_or("byteOffset", 0);
  if (!offset) return tl::unexpected(offset.error());
  const auto& view = document.views[*index];
  if (!view) return object.fault(formatted("found bufferView {} without data, wanted uncompressed data", *index));
  return ViewRange{*view, *offset};
}

/// Where `extent` bytes of a range begin in the binary.
Expected<std::size_t> start_of(const Object& object, const ViewRange& range, std::size_t extent) {
  if (range.offset + extent > range.view.length)
    return object.fault(formatted("found {} bytes from byte {}, wanted them within the {} of its bufferView", extent,
                                  range.offset, range.view.length));
  return range.view.offset + range.offset;
}

Expected<std::size_t> packed_start(const Document& document, const Object& object, std::size_t extent) {
  return range_of(document, object).and_then([&](const ViewRange& range) { return start_of(object, range, extent); });
}

Expected<Sparse> sparse_of(const Document& document, const Object& object, const Accessor& accessor) {
  const auto count = object.count("count");
  if (!count) return tl::unexpected(count.error());
  if (*count == 0 || *count > accessor.count)
    return object.fault(formatted("found a count of {}, wanted 1 to the {} of the accessor", *count, accessor.count));
  const auto indices = object.object("indices"), values = object.object("values");
  if (!indices) return tl::unexpected(indices.error());
  if (!values) return tl::unexpected(values.error());
  const auto type = component_type_of(*indices);
  if (!type) return tl::unexpected(type.error());
  if (*type != ComponentType::u8 && *type != ComponentType::u16 && *type != ComponentType::u32)
    return indices->fault(formatted("found componentType {}, wanted 5121, 5123 or 5125", static_cast<int>(*type)));
  const auto indices_start = packed_start(document, *indices, *count * size_of(*type));
  if (!indices_start) return tl::unexpected(indices_start.error());
  const auto values_start = packed_start(document, *values, *count * accessor.element_size);
  if (!values_start) return tl::unexpected(values_start.error());
  return Sparse{*count, *indices_start, *values_start, *type};
}

/// What is said of the elements, without where they lie.
Expected<Accessor> elements_of(const Object& object) {
  const auto count = object.count("count");
  if (!count) return tl::unexpected(count.error());
  const auto type = component_type_of(object);
  if (!type) return tl::unexpected(type.error());
  const auto shape = shape_of(object);
  if (!shape) return tl::unexpected(shape.error());
  const auto is_normalised = object.flag("normalized");
  if (!is_normalised) return tl::unexpected(is_normalised.error());
  if (*count == 0) return object.fault("found no elements, wanted one at least");
  const std::size_t column = shape->rows * size_of(*type);
  const std::size_t size = shape->columns == 1 ? column : (column + 3) / 4 * 4 * shape->columns;
  return Accessor{.count = *count,
                  .components = shape->rows * shape->columns,
                  .type = *type,
                  .is_normalised = *is_normalised,
                  .element_size = size,
                  .stride = size};
}

Expected<Accessor> placed(const Document& document, const Object& object, Accessor accessor) {
  if (!object.has("bufferView")) {
    if (accessor.count > most_zeros)
      return object.fault(
          formatted("found {} elements without a bufferView, wanted {} at most", accessor.count, most_zeros));
    return accessor;
  }
  const auto range = range_of(document, object);
  if (!range) return tl::unexpected(range.error());
  accessor.is_strided = range->view.stride != 0;
  if (accessor.is_strided) accessor.stride = range->view.stride;
  if (accessor.stride < accessor.element_size)
    return object.fault(formatted("found elements of {} bytes every {} bytes, wanted them apart", accessor.element_size,
                                  accessor.stride));
  const auto start = start_of(object, *range, accessor.extent());
  if (!start) return tl::unexpected(start.error());
  accessor.offset = *start;
  return accessor;
}

template <class T>
T number_at(std::string_view bytes, std::size_t at) {
  T number{};
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

template <class T>
double integer_at(std::string_view bytes, std::size_t at, bool is_normalised) {
  const auto number = static_cast<double>(number_at<T>(bytes, at));
  return is_normalised ? std::max(number / static_cast<double>(std::numeric_limits<T>::max()), -1.0) : number;
}

double component_at(std::string_view bytes, std::size_t at, ComponentType type, bool is_normalised) {
  switch (type) {
    case ComponentType::i8:
      return integer_at<std::int8_t>(bytes, at, is_normalised);
    case ComponentType::u8:
      return integer_at<std::uint8_t>(bytes, at, is_normalised);
    case ComponentType::i16:
      return integer_at<std::int16_t>(bytes, at, is_normalised);
    case ComponentType::u16:
      return integer_at<std::uint16_t>(bytes, at, is_normalised);
    case ComponentType::u32:
      return integer_at<std::uint32_t>(bytes, at, is_normalised);
    case ComponentType::f32:
      break;
  }
  return static_cast<double>(number_at<float>(bytes, at));
}

/// Reads the element at a byte. Padding is of matrices alone, which are not read.
void read_element(std::string_view bytes, std::size_t at, const Accessor& accessor, double* to) {
  for (std::size_t c = 0; c < accessor.components; ++c)
    to[c] = component_at(bytes, at + c * size_of(accessor.type), accessor.type, accessor.is_normalised);
}

Expected<std::vector<double>> with_sparse(std::vector<double> values, std::string_view bytes,
                                          const Accessor& accessor) {
  const Sparse& sparse = *accessor.sparse;
  for (std::size_t i = 0, next = 0; i < sparse.count; ++i) {
    const std::size_t at = sparse.indices + i * size_of(sparse.index_type);
    const auto index = static_cast<std::size_t>(component_at(bytes, at, sparse.index_type, false));
    if (index < next || index >= accessor.count)
      return failure(ErrorCode::bad_data,
                     formatted("found sparse index {}, wanted {} to {}", index, next, accessor.count - 1));
    read_element(bytes, sparse.values + i * accessor.element_size, accessor, &values[index * accessor.components]);
    next = index + 1;
  }
  return values;
}

/// All components of all elements: integers as they are or, where they are normalised, within [-1, 1].
///
/// Errors (bad_data): the indices of sparse elements do not rise or are too large.
Expected<std::vector<double>> values_of(const Document& document, const Accessor& accessor) {
  std::vector<double> values(accessor.count * accessor.components);
  if (accessor.offset)
    for (std::size_t i = 0; i < accessor.count; ++i)
      read_element(document.binary, *accessor.offset + i * accessor.stride, accessor, &values[i * accessor.components]);
  if (!accessor.sparse) return values;
  return with_sparse(std::move(values), document.binary, accessor);
}

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

}  // namespace

Expected<Accessor> accessor_of(const Document& document, std::size_t index) {
  const auto object = document.root().entry("accessors", "accessor", index);
  if (!object) return tl::unexpected(object.error());
  auto accessor = elements_of(*object).and_then([&](const Accessor& read) { return placed(document, *object, read); });
  if (!accessor || !object->has("sparse")) return accessor;
  const auto sparse =
      object->object("sparse").and_then([&](const Object& read) { return sparse_of(document, read, *accessor); });
  if (!sparse) return tl::unexpected(sparse.error());
  accessor->sparse = *sparse;
  return accessor;
}

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
  const auto time = [&](std::size_t key) {
    return component_at(document.binary, *input->offset + key * input->stride, input->type, false);
  };
  const Domain domain{time(0), time(input->count - 1)};
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

Expected<std::vector<AnimationChannel>> animation_channels(const Document& document, const Object& animation) {
  const auto samplers = animation.list("samplers");
  if (!samplers) return tl::unexpected(samplers.error());
  const auto list = animation.list("channels");
  if (!list) return tl::unexpected(list.error());
  const std::size_t nodes = document.root().list("nodes").value()->size();
  std::vector<AnimationChannel> channels((*list)->size());
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const auto channel = animation.entry("channels", "channel", i);
    if (!channel) return tl::unexpected(channel.error());
    const auto sampler = channel->index("sampler", (*samplers)->size());
    if (!sampler) return tl::unexpected(sampler.error());
    const auto target = channel->object("target").and_then([&](const Object& read) { return target_of(read, nodes); });
    if (!target) return tl::unexpected(target.error());
    channels[i] = {*sampler, *target};
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
      if (sampler) clip.passed_on = joined(clip.passed_on, sampler_domain(document_, *sampler));
      continue;
    }
    const std::string place = place_of(nodes_.skeleton, clip, nodes_.joint_of_node[channel.target->node]);
    auto more = sampler.and_then([&](const Object& found) { return with(std::move(clip), found, *channel.target); });
    if (!more) return tl::unexpected(within(place, std::move(more.error())));
    clip = std::move(*more);
  }
  return clip;
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
