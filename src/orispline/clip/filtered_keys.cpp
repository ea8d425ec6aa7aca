// SPDX-License-Identifier: Apache-2.0
#include <orispline/clip/filtered_keys.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <orispline/clip/finite_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

namespace {

constexpr double largest_short = 32767.0;
/// Of two, by which a reader's decoder multiplies: those of normal floats.
constexpr int lowest_power = -100, highest_power = 100;
/// Of two, that are tried for splines of rotations.
constexpr int finest_power = -22, coarsest_power = -4;

std::int16_t whole(double number) { return static_cast<std::int16_t>(std::lround(number)); }

bool is_spline(ChannelInterpolation interpolation) { return interpolation == ChannelInterpolation::cubicspline; }

/// How far apart two rotations are that differ by little [rad].
double apart(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  const double sign = a.dot(b) < 0.0 ? -1.0 : 1.0;
  return 2.0 * (a.coeffs() - sign * b.coeffs()).norm();
}

/// With so many bits; nothing where a value would be farther from what it was.
std::optional<RotationChannel> with_bits(RotationChannel channel, int bits, double farthest) {
  for (Eigen::Quaterniond& value : channel.values) {
    const Eigen::Quaterniond rounded = rotation_of(decoded(filtered(value, bits)));
    if (!(apart(value, rounded) <= farthest)) return std::nullopt;
    value = rounded;
  }
  return channel;
}

double longest_interval(const SharedList<double>& times) {
  double longest = 0.0;
  for (std::size_t i = 0; i + 1 < times.size(); ++i) longest = std::max(longest, times[i + 1] - times[i]);
  return longest;
}

/// The power of two whose half, as the error of each of the numbers, moves a value by no more than that. Of splines the
/// error of a tangent moves the curve by 4/27 of it and the interval, on either side, and a value by all of it.
template <CurvePoint P>
double quantum_for(const Channel<P>& channel, double farthest) {
  constexpr double components = std::same_as<P, Eigen::Quaterniond> ? 4.0 : 3.0;
  constexpr double angle_per_length = std::same_as<P, Eigen::Quaterniond> ? 2.0 : 1.0;
  const double of_tangents = is_spline(channel.interpolation) ? 8.0 / 27.0 * longest_interval(channel.times) : 0.0;
  const double half = farthest / (angle_per_length * std::sqrt(components) * (1.0 + of_tangents));
  return std::isfinite(half) && half > 0.0 ? std::ldexp(1.0, std::ilogb(2.0 * half)) : 0.0;
}

struct Rounding {
  double quantum;
  bool is_sound = true;

  double operator()(double number) {
    const double count = std::round(number / quantum);
    is_sound = is_sound && std::abs(count) <= largest_whole;
    return count * quantum;
  }
};

Eigen::Vector3d rounded(const Eigen::Vector3d& value, Rounding& round) {
  return {round(value.x()), round(value.y()), round(value.z())};
}
Eigen::Quaterniond rounded(const Eigen::Quaterniond& value, Rounding& round) {
  return {round(value.w()), round(value.x()), round(value.y()), round(value.z())};
}

/// In single precision.
bool are_same(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return Eigen::Vector4f(a.coeffs().cast<float>()) == Eigen::Vector4f(b.coeffs().cast<float>());
}

/// As a reader finds numbers that are on a grid: the value is made unit, the tangents are divided in the same
/// proportion.
struct ReadKey {
  Eigen::Quaterniond value, in, out;
};
ReadKey read_key(const ReadKey& stored) {
  const double norm = stored.value.norm();
  ReadKey read = stored;
  for (Eigen::Quaterniond* const part : {&read.value, &read.in, &read.out}) part->coeffs() /= norm;
  return read;
}

/// The numbers on the grid that a key was read from; those nearest to it where there are none.
ReadKey on_grid(const ReadKey& read, Rounding& round) {
  ReadKey stored{rounded(read.value, round), read.in, read.out};
  const double norm = stored.value.norm();
  for (Eigen::Quaterniond* const tangent : {&stored.in, &stored.out})
    *tangent = rounded(Eigen::Quaterniond(Eigen::Vector4d(tangent->coeffs() * norm)), round);
  return stored;
}

bool are_same(const ReadKey& a, const ReadKey& b) {
  return are_same(a.value, b.value) && are_same(a.in, b.in) && are_same(a.out, b.out);
}

/// The numbers on the grid that are read as this key; nothing where there are none.
std::optional<ReadKey> stored_on_grid(const ReadKey& read, Rounding& round) {
  const ReadKey stored = on_grid(read, round);
  if (!round.is_sound || !(stored.value.norm() > 0.9) || !are_same(read_key(stored), read)) return std::nullopt;
  return stored;
}

/// Numbers on a grid are not quite a unit quaternion, and that is not quite on the grid: a few rounds nearly always end
/// where both are the same.
RotationChannel spline_in_whole_numbers(const RotationChannel& channel, double farthest) {
  constexpr int rounds = 16;
  Rounding round{quantum_for(channel, farthest)};
  if (!(round.quantum > 0.0)) return channel;
  RotationChannel result = channel;
  for (std::size_t i = 0; i < channel.size(); ++i) {
    ReadKey key{channel.values[i], channel.in_tangents[i], channel.out_tangents[i]};
    bool is_held = false;
    for (int k = 0; k < rounds && !is_held; ++k) {
      key = read_key(on_grid(key, round));
      is_held = stored_on_grid(key, round).has_value();
    }
    if (!is_held) return channel;
    result.values[i] = key.value, result.in_tangents[i] = key.in, result.out_tangents[i] = key.out;
  }
  return is_finite(result) ? result : channel;
}

/// Of the lowest bit that is set; nothing of zero.
std::optional<int> lowest_exponent(float number) {
  if (number == 0.0F || !std::isfinite(number)) return std::nullopt;
  int exponent = 0;
  const float fraction = std::frexp(number, &exponent);
  auto bits = static_cast<std::int64_t>(std::ldexp(fraction, 24));
  exponent -= 24;
  for (; bits % 2 == 0; bits /= 2) ++exponent;
  return exponent;
}

/// By the largest power of two of which all numbers are whole multiples.
std::optional<WholeNumbers> as_they_are(std::span<const float> numbers) {
  std::optional<int> lowest;
  for (const float number : numbers)
    if (const auto exponent = lowest_exponent(number)) lowest = lowest ? std::min(*lowest, *exponent) : *exponent;
  WholeNumbers whole{.exponent = lowest.value_or(0)};
  if (whole.exponent < lowest_power || whole.exponent > highest_power) return std::nullopt;
  for (const float number : numbers) {
    const double count = std::ldexp(static_cast<double>(number), -whole.exponent);
    if (!(std::abs(count) <= largest_whole)) return std::nullopt;
    whole.numbers.push_back(static_cast<std::int32_t>(count));
  }
  return whole;
}

/// Of a spline of rotations, by the largest power of two that holds its keys.
std::optional<WholeNumbers> as_spline(std::span<const float> numbers, int exponent) {
  Rounding round{std::ldexp(1.0, exponent)};
  WholeNumbers whole{.exponent = exponent};
  for (std::size_t i = 0; i + 12 <= numbers.size(); i += 12) {
    const float* const key = &numbers[i];
    const auto stored = stored_on_grid({quaternion_at(key + 4), quaternion_at(key), quaternion_at(key + 8)}, round);
    if (!stored) return std::nullopt;
    for (const Eigen::Quaterniond* const part : {&stored->in, &stored->value, &stored->out})
      for (const double number : {part->x(), part->y(), part->z(), part->w()})
        whole.numbers.push_back(static_cast<std::int32_t>(std::lround(number / round.quantum)));
  }
  return whole;
}

/// x, y, z, w.
std::array<double, 4> parts_of(const Eigen::Quaterniond& rotation) {
  return {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
}

/// All but one of the four, of a rotation in which that is above 0.
FilteredQuaternion without_part(const std::array<double, 4>& four, std::size_t left_out, int bits) {
  const double one = std::ldexp(1.0, bits - 1) - 1.0;
  const double scale = std::copysign(one * std::numbers::sqrt2, four[left_out]);
  FilteredQuaternion stored{};
  for (std::size_t k = 0; k < 3; ++k) stored[k] = whole(std::clamp(four[(left_out + k + 1) % 4] * scale, -one, one));
  stored[3] = static_cast<std::int16_t>((static_cast<int>(one) & ~3) | static_cast<int>(left_out));
  return stored;
}

}  // namespace

FilteredQuaternion filtered(const Eigen::Quaterniond& rotation, int bits) {
  const std::array<double, 4> four = parts_of(rotation);
  const auto largest = std::ranges::max_element(four, {}, [](double part) { return std::abs(part); });
  return without_part(four, static_cast<std::size_t>(largest - four.begin()), bits);
}

std::optional<FilteredQuaternion> filtered_as_it_is(const Eigen::Quaterniond& rotation, int bits) {
  const std::array<double, 4> four = parts_of(rotation);
  for (std::size_t k = 0; k < four.size(); ++k) {
    const FilteredQuaternion stored = without_part(four, k, bits);
    const Eigen::Quaterniond read = rotation_of(decoded(stored));
    if (are_same(read, rotation) || are_same(Eigen::Quaterniond(-read.coeffs()), rotation)) return stored;
  }
  return std::nullopt;
}

FilteredQuaternion decoded(const FilteredQuaternion& stored) {
  const float scale = (1.0F / std::numbers::sqrt2_v<float>) / static_cast<float>(stored[3] | 3);
  const float x = static_cast<float>(stored[0]) * scale, y = static_cast<float>(stored[1]) * scale,
              z = static_cast<float>(stored[2]) * scale;
  const float w = std::sqrt(std::max(0.0F, 1.0F - (x * x + (y * y + z * z))));
  const auto largest = static_cast<std::size_t>(stored[3] & 3);
  FilteredQuaternion read{};
  read[(largest + 1) % 4] = static_cast<std::int16_t>(std::nearbyint(x * static_cast<float>(largest_short)));
  read[(largest + 2) % 4] = static_cast<std::int16_t>(std::nearbyint(y * static_cast<float>(largest_short)));
  read[(largest + 3) % 4] = static_cast<std::int16_t>(std::nearbyint(z * static_cast<float>(largest_short)));
  read[largest] = static_cast<std::int16_t>(std::nearbyint(w * static_cast<float>(largest_short)));
  return read;
}

Eigen::Quaterniond rotation_of(const FilteredQuaternion& read) {
  Eigen::Quaterniond rotation(read[3] / largest_short, read[0] / largest_short, read[1] / largest_short,
                              read[2] / largest_short);
  rotation.coeffs() /= rotation.norm();
  return rotation;
}

RotationChannel with_fewest_bits(const RotationChannel& channel, double farthest) {
  if (is_spline(channel.interpolation)) return spline_in_whole_numbers(channel, farthest);
  for (int bits = fewest_bits; bits <= most_bits; ++bits)
    if (auto rounded = with_bits(channel, bits, farthest)) return *std::move(rounded);
  return channel;
}

VectorChannel with_fewest_bits(const VectorChannel& channel, double farthest) {
  Rounding round{quantum_for(channel, farthest)};
  if (!(round.quantum > 0.0)) return channel;
  VectorChannel result = channel;
  for (auto* const list : {&result.values, &result.in_tangents, &result.out_tangents})
    for (Eigen::Vector3d& number : *list) number = rounded(number, round);
  return round.is_sound && is_finite(result) ? result : channel;
}

std::optional<int> filter_bits(const RotationChannel& channel) {
  if (is_spline(channel.interpolation)) return std::nullopt;
  for (int bits = fewest_bits; bits <= most_bits; ++bits)
    if (std::ranges::all_of(channel.values,
                            [&](const auto& value) { return filtered_as_it_is(value, bits).has_value(); }))
      return bits;
  return std::nullopt;
}

std::uint32_t exponential(std::int32_t number, int exponent) noexcept {
  return (static_cast<std::uint32_t>(number) & 0xFFFFFFU) | (static_cast<std::uint32_t>(exponent) << 24U);
}

Eigen::Quaterniond quaternion_at(const float* numbers) {
  const auto number = [&](std::size_t i) { return static_cast<double>(numbers[i]); };
  return Eigen::Quaterniond(number(3), number(0), number(1), number(2));
}

std::optional<WholeNumbers> whole_numbers(std::span<const float> numbers, bool are_rotations, bool is_spline) {
  if (!are_rotations || !is_spline) return as_they_are(numbers);
  for (int exponent = coarsest_power; exponent >= finest_power; --exponent)
    if (auto whole = as_spline(numbers, exponent)) return whole;
  return std::nullopt;
}

}}  // namespace orispline
