// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/gltf/compressed_keys.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include <orispline/clip/filtered_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::gltf {

namespace {

constexpr std::string_view quaternion_filter = "QUATERNION", exponential_filter = "EXPONENTIAL";

template <class T>
void append_bytes(std::string& bytes, const T& number) {
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

/// Rotations of keys, x, y, z, w; nothing where the filter does not hold them as they are.
std::optional<std::string> as_quaternions(std::span<const float> numbers) {
  RotationChannel channel;
  for (std::size_t i = 0; i < numbers.size(); i += 4) {
    channel.times.push_back(static_cast<double>(i));
    channel.values.push_back(quaternion_at(&numbers[i]));
  }
  const auto bits = filter_bits(channel);
  if (!bits) return std::nullopt;
  std::string bytes;
  for (const Eigen::Quaterniond& value : std::as_const(channel.values)) {
    const auto stored = filtered_as_it_is(value, *bits);
    for (const std::int16_t number : *stored) append_bytes(bytes, number);
  }
  return bytes;
}

/// Whole numbers of 24 bits with an exponent of 8 above them, which is the same for all; nothing where these do not
/// hold them as they are.
std::optional<std::string> as_whole_numbers(std::span<const float> numbers, bool are_rotations, bool is_spline) {
  const auto whole = whole_numbers(numbers, are_rotations, is_spline);
  if (!whole) return std::nullopt;
  std::string bytes;
  for (const std::int32_t number : whole->numbers) append_bytes(bytes, exponential(number, whole->exponent));
  return bytes;
}

struct Filtered {
  std::string_view filter{};
  std::string bytes{};
};

Filtered filtered_of(const KeyStore::Entry& entry, std::span<const float> numbers) {
  if (entry.type == "SCALAR")
    return {{}, std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes())};
  const bool are_rotations = entry.type == quaternion_type.word;
  if (are_rotations && entry.kind != KeyStore::Kind::spline)
    if (auto bytes = as_quaternions(numbers)) return {quaternion_filter, *std::move(bytes)};
  if (auto bytes = as_whole_numbers(numbers, are_rotations, (entry.kind == KeyStore::Kind::spline)))
    return {exponential_filter, *std::move(bytes)};
  return {{}, std::string(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes())};
}

}  // namespace

KeyStreams streams_of(const KeyStore& store) {
  KeyStreams all;
  std::map<std::tuple<std::string_view, std::size_t>, std::size_t> known;
  for (std::size_t i = 0; i < store.size(); ++i) {
    const KeyStore::Entry& entry = store.entry(i);
    const std::vector<float> numbers = store.numbers(i);
    Filtered keys = filtered_of(entry, numbers);
    const std::size_t stride = keys.bytes.size() / entry.count;
    const auto [found, is_new] = known.try_emplace({keys.filter, stride}, all.streams.size());
    if (is_new) all.streams.push_back({.stride = stride, .filter = keys.filter});
    KeyStream& stream = all.streams[found->second];
    const ComponentType component = keys.filter == quaternion_filter ? ComponentType::i16 : ComponentType::f32;
    Json accessor = store.accessor(i, component, stream.bytes.size());
    all.stream_of.push_back(found->second);
    all.accessors.push_back(std::move(accessor));
    stream.bytes += keys.bytes;
  }
  return all;
}

}}}  // namespace orispline::scenes::gltf
