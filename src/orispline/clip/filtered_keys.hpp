// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <orispline/clip/clip.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

// Numbers as the filters of the glTF extension EXT_meshopt_compression hold them. Source: its specification, of the
// Khronos Group.

/// A rotation by the filter QUATERNION: three components, and in the last number their width and which one is left out.
/// A reader's, of four components: x, y, z, w, each times 32767.
using FilteredQuaternion = std::array<std::int16_t, 4>;

/// The fewest and the most bits of a component.
inline constexpr int fewest_bits = 4, most_bits = 16;

[[nodiscard]] FilteredQuaternion filtered(const Eigen::Quaterniond& rotation, int bits);
/// The numbers that are read as this rotation, its components in single precision; nothing where there are none.
[[nodiscard]] std::optional<FilteredQuaternion> filtered_as_it_is(const Eigen::Quaterniond& rotation, int bits);
/// What a reader's decoder makes of it, in single precision as usual decoders do, of which some differ in the last bit.
[[nodiscard]] FilteredQuaternion decoded(const FilteredQuaternion& stored);
/// The unit quaternion that a reader takes these numbers for.
[[nodiscard]] Eigen::Quaterniond rotation_of(const FilteredQuaternion& read);

/// A number by the filter EXPONENTIAL is a whole one of 24 bits times a power of two. The most that the whole number
/// may be.
inline constexpr double largest_whole = 8388607.0;  // 2^23 - 1

/// The channel as a reader finds it in a file where rotations, but not those of splines, have the filter QUATERNION and
/// all other numbers EXPONENTIAL, with the fewest bits for which no value is farther than that [rad, or a length] from
/// what it was, nor a spline farther by its tangents. Times stay as they are. The channel as it was where the filters
/// do not hold it so.
[[nodiscard]] RotationChannel with_fewest_bits(const RotationChannel& channel, double farthest);
[[nodiscard]] VectorChannel with_fewest_bits(const VectorChannel& channel, double farthest);

/// The fewest bits by which the filter QUATERNION holds all values of a channel as they are; nothing where it cannot.
[[nodiscard]] std::optional<int> filter_bits(const RotationChannel& channel);

/// Numbers by the filter EXPONENTIAL, with one exponent for all.
struct WholeNumbers {
  std::vector<std::int32_t> numbers{};
  int exponent = 0;
};

/// The bits of one of them: the whole number in the lower 24, the exponent above.
[[nodiscard]] std::uint32_t exponential(std::int32_t number, int exponent) noexcept;

/// Of x, y, z, w, as glTF has them in a row.
[[nodiscard]] Eigen::Quaterniond quaternion_at(const float* numbers);

/// The numbers of the values of a channel, and of a spline its tangents, as they are; nothing where the filter cannot
/// hold them. Of rotations the numbers need not be those of unit quaternions: they are what a reader makes unit, with
/// the tangents of each in the same proportion.
[[nodiscard]] std::optional<WholeNumbers> whole_numbers(std::span<const float> numbers, bool are_rotations,
                                                        bool is_spline);

}}  // namespace orispline
