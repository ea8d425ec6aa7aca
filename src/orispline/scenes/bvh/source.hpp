// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <orispline/base/decimal.hpp>
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

/// What a number of a frame says of its joint: one coordinate of its translation, or one turn [°].
struct Column {
  enum class Kind { position, rotation };

  Kind kind = Kind::rotation;
  int axis = 0;  ///< 0 x, 1 y, 2 z

  [[nodiscard]] bool operator==(const Column&) const noexcept = default;
};

/// How a file writes a joint.
struct WrittenJoint {
  std::vector<Column> columns{};
  std::string offset{};  ///< its three numbers with all their digits
  bool is_end_site = false;
};

/// A BVH file as it was read.
struct Source : SceneSource {
  std::string hierarchy{};  ///< its text up to the word MOTION
  Skeleton skeleton{};
  std::vector<WrittenJoint> joints{};  ///< those of the skeleton
  Decimal frame_time{};                ///< [s]
  std::size_t frames = 0;
  std::vector<double> numbers{};  ///< of the frames, one after the other

  /// Whether a skeleton is still the one that was read.
  [[nodiscard]] bool has(const Skeleton& other) const noexcept;
};

/// Deeper joints are neither read nor written.
inline constexpr std::size_t deepest_joint = 512;

/// More numbers in all frames, 2 GiB in memory, are neither read nor written.
inline constexpr std::size_t most_numbers = std::size_t{1} << 28;

/// The number of columns of all joints together.
[[nodiscard]] std::size_t columns_of(std::span<const WrittenJoint> joints) noexcept;

/// The turns of a joint in a frame, about the axes of the body in the order of the columns.
[[nodiscard]] Eigen::Quaterniond rotation_of(std::span<const Column> columns, const double* numbers) noexcept;
/// Where the joint is: its offset but for the coordinates that have a column.
[[nodiscard]] Eigen::Vector3d translation_of(std::span<const Column> columns, const double* numbers,
                                             const Eigen::Vector3d& offset) noexcept;

/// How many columns are of a kind.
[[nodiscard]] std::size_t count_of(std::span<const Column> columns, Column::Kind kind) noexcept;

}}}  // namespace orispline::scenes::bvh
