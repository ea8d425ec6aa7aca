// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_keys.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <orispline/base/counted.hpp>
#include <orispline/base/formatted.hpp>
#include <orispline/base/quoted.hpp>
#include <orispline/scenes/gltf_accessor.hpp>
#include <orispline/scenes/gltf_nodes.hpp>

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

Expected<void> check_counts(const Column& times, const Column& outputs, std::size_t per_key, std::size_t most) {
  if (times.accessor.count > most)
    return failure(ErrorCode::bad_data, "found more than 64 million keys in the file, wanted fewer");
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

}  // namespace

Expected<SamplerKeys> sampler_keys(const Document& document, const Object& sampler, const ValueType& type,
                                   const SceneReading& reading, std::size_t most) {
  const auto interpolation = interpolation_of(sampler);
  if (!interpolation) return tl::unexpected(interpolation.error());
  const auto input = column_of(document, sampler, "input", {"SCALAR", 1});
  if (!input) return tl::unexpected(input.error());
  const auto output = column_of(document, sampler, "output", type);
  if (!output) return tl::unexpected(output.error());
  const std::size_t per_key = *interpolation == ChannelInterpolation::cubicspline ? 3 : 1;
  if (auto fit = check_counts(*input, *output, per_key, most); !fit) return tl::unexpected(std::move(fit.error()));
  auto times = values_of(document, input->accessor), outputs = values_of(document, output->accessor);
  if (!times) return tl::unexpected(std::move(times.error()));
  if (!outputs) return tl::unexpected(std::move(outputs.error()));
  SamplerKeys keys{*interpolation, std::move(*times), std::move(*outputs)};
  for (const Column* column : {&*input, &*output})
    if (column->accessor.is_strided) keys.strided.push_back(formatted("accessor {}", column->index));
  return keys_at_rising_times(keys.times, reading).map([&](const std::vector<std::size_t>& kept) {
    return only(kept, std::move(keys));
  });
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

}}}  // namespace orispline::scenes::gltf
