// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/compressed_bytes.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include <orispline/clip/filtered_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr std::size_t run_length = 16;  // elements that are packed together

/// Of one byte of as many elements, by what its differences take: nothing, 2 or 4 bits with the larger ones behind, or
/// all 8; and 2 bits that say which.
std::size_t bits_of_group(const std::array<unsigned char, run_length>& differences) {
  const auto above = [&](unsigned char most) {
    return static_cast<std::size_t>(std::ranges::count_if(differences, [&](unsigned char d) { return d >= most; }));
  };
  const std::size_t by_two = 2 * run_length + 8 * above(3), by_four = 4 * run_length + 8 * above(15);
  return 2 + (above(1) == 0 ? 0 : std::min({by_two, by_four, 8 * run_length}));
}

unsigned char zigzag(unsigned char difference) {
  const unsigned int bits = difference;
  return static_cast<unsigned char>((bits << 1U) ^ (bits >= 0x80U ? 0xFFU : 0U));
}

template <class T>
void append(std::vector<unsigned char>& bytes, const T& number) {
  const std::size_t at = bytes.size();
  bytes.resize(at + sizeof number);
  std::memcpy(bytes.data() + at, &number, sizeof number);
}

std::vector<unsigned char> bytes_of(const WholeNumbers& whole) {
  std::vector<unsigned char> bytes;
  for (const std::int32_t number : whole.numbers) append(bytes, exponential(number, whole.exponent));
  return bytes;
}

std::vector<unsigned char> bytes_of(std::span<const float> numbers) {
  std::vector<unsigned char> bytes;
  for (const float number : numbers) append(bytes, number);
  return bytes;
}

void append_floats(std::vector<float>& numbers, const Eigen::Quaterniond& value) {
  for (const double number : {value.x(), value.y(), value.z(), value.w()})
    numbers.push_back(static_cast<float>(number));
}
void append_floats(std::vector<float>& numbers, const Eigen::Vector3d& value) {
  for (const double number : {value.x(), value.y(), value.z()}) numbers.push_back(static_cast<float>(number));
}

std::vector<unsigned char> as_quaternions(const RotationChannel& channel) {
  std::vector<unsigned char> bytes;
  if (const auto bits = filter_bits(channel))
    for (const Eigen::Quaterniond& value : channel.values) {
      const auto stored = filtered_as_it_is(value, *bits);
      for (const std::int16_t number : *stored) append(bytes, number);
    }
  return bytes;
}
std::vector<unsigned char> as_quaternions(const VectorChannel&) { return {}; }

}  // namespace

std::size_t compressed_size(std::span<const unsigned char> bytes, std::size_t stride) {
  const std::size_t count = bytes.size() / stride;
  std::size_t bits = 0;
  for (std::size_t k = 0; k < stride; ++k)
    for (std::size_t first = 0; first < count; first += run_length) {
      std::array<unsigned char, run_length> differences{};
      for (std::size_t i = std::max<std::size_t>(first, 1); i < std::min(first + run_length, count); ++i)
        differences[i - first] =
            zigzag(static_cast<unsigned char>(bytes[i * stride + k] - bytes[(i - 1) * stride + k]));
      const std::size_t elements = std::min(run_length, count - first);  // those of others fill the run
      bits += bits_of_group(differences) * elements / run_length;
    }
  return bits / 8 + 1;
}

template <CurvePoint P>
std::size_t compressed_bytes(const Channel<P>& channel) {
  constexpr bool are_rotations = std::same_as<P, Eigen::Quaterniond>;
  constexpr std::size_t components = are_rotations ? 4 : 3;
  if (const auto quaternions = as_quaternions(channel); !quaternions.empty()) return compressed_size(quaternions, 8);
  const bool is_spline = channel.interpolation == ChannelInterpolation::cubicspline;
  std::vector<float> numbers;
  for (std::size_t i = 0; i < channel.size(); ++i) {
    if (is_spline) append_floats(numbers, channel.in_tangents[i]);
    append_floats(numbers, channel.values[i]);
    if (is_spline) append_floats(numbers, channel.out_tangents[i]);
  }
  const auto whole = whole_numbers(numbers, are_rotations, is_spline);
  return compressed_size(whole ? bytes_of(*whole) : bytes_of(numbers), components * sizeof(float));
}

std::size_t compressed_bytes(std::span<const double> times) {
  std::vector<float> numbers;
  for (const double time : times) numbers.push_back(static_cast<float>(time));
  return compressed_size(bytes_of(numbers), sizeof(float));
}

template std::size_t compressed_bytes(const RotationChannel&);
template std::size_t compressed_bytes(const VectorChannel&);

}}  // namespace orispline
