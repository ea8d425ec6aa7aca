// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf_written_channel.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <utility>

#include <orispline/base/formatted.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

std::array<double, 4> numbers_of(const Eigen::Quaterniond& value) {
  return {value.x(), value.y(), value.z(), value.w()};
}
std::array<double, 3> numbers_of(const Eigen::Vector3d& value) { return {value.x(), value.y(), value.z()}; }

/// Each key that is as it was read, as the file had it.
RotationChannel with_bits_of_file(RotationChannel channel, const RotationOfFile& file) {
  const bool is_spline = channel.interpolation == ChannelInterpolation::cubicspline;
  const auto& times = file.read.times;
  for (std::size_t i = 0; i < channel.size(); ++i) {
    const auto found = std::ranges::lower_bound(times, channel.times[i]);
    if (found == times.end() || *found != channel.times[i]) continue;
    const auto k = static_cast<std::size_t>(found - times.begin());
    if (channel.values[i].coeffs() != file.read.values[k].coeffs()) continue;
    channel.values[i] = file.raw.values[k];
    if (!is_spline || file.read.in_tangents.empty()) continue;
    if (channel.in_tangents[i].coeffs() == file.read.in_tangents[k].coeffs())
      channel.in_tangents[i] = file.raw.in_tangents[k];
    if (channel.out_tangents[i].coeffs() == file.read.out_tangents[k].coeffs())
      channel.out_tangents[i] = file.raw.out_tangents[k];
  }
  return channel;
}

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

}  // namespace

Expected<WrittenChannel> written(const RotationChannel& channel, const RotationOfFile* of_file) {
  return in_single(with_signs_aligned(of_file == nullptr ? channel : with_bits_of_file(channel, *of_file)),
                   Property::rotation);
}

Expected<WrittenChannel> written(const VectorChannel& channel, Property property) {
  return in_single(channel, property);
}

WrittenChannel held_to_end(WrittenChannel channel) {
  channel.times.push_back(channel.end);
  const std::size_t components = channel.outputs.size();
  channel.outputs.resize(2 * components);
  std::copy_n(channel.outputs.begin(), components, channel.outputs.begin() + static_cast<std::ptrdiff_t>(components));
  return channel;
}

}}}  // namespace orispline::scenes::gltf
