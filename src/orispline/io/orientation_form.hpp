// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <orispline/base/expected.hpp>
#include <orispline/math/euler.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

/// The frame in which angular rates are stated. Positions and their rates are always in the world frame.
enum class Frame { body, world };

/// What the orientations of a file turn into what.
enum class Turning { body_to_world, world_to_body };

/// What columns may state an orientation by.
enum class Representation {
  quaternion,       ///< `qw,qx,qy,qz`
  euler,            ///< three angles: `roll,pitch,yaw`, or `e1,e2,e3` in the order of their turns
  matrix,           ///< `r11,r12,…,r33`: R_world_body, row by row
  rotation_vector,  ///< `rx,ry,rz` [rad]: the axis times the angle
};

enum class AngleUnit { degrees, radians, milliradians, arcseconds };

/// How a unit of angles is called, and what it is: an angle · numerator / denominator is in radians.
struct AngleUnitInfo {
  AngleUnit unit;
  std::string_view word;    ///< `deg`
  std::string_view suffix;  ///< of names of columns: `_deg`
  double numerator = 1.0, denominator = 1.0;
};
inline constexpr std::array angle_units{
    AngleUnitInfo{AngleUnit::degrees, "deg", "_deg", std::numbers::pi, 180.0},
    AngleUnitInfo{AngleUnit::radians, "rad", "_rad"},
    AngleUnitInfo{AngleUnit::milliradians, "mrad", "_mrad", 1.0, 1000.0},
    AngleUnitInfo{AngleUnit::arcseconds, "arcsec", "_arcsec", std::numbers::pi, 648000.0}};

[[nodiscard]] constexpr const AngleUnitInfo& info_of(AngleUnit unit) noexcept {
  return angle_units[static_cast<std::size_t>(unit)];
}

/// A representation with what it leaves open.
struct OrientationForm {
  Representation representation = Representation::quaternion;
  EulerOrder order{};                   ///< of Euler angles
  AngleUnit unit = AngleUnit::degrees;  ///< of Euler angles that are written
  bool continuous = true;               ///< these run on from row to row, beyond a full turn and through the pole

  [[nodiscard]] bool runs_on() const noexcept { return continuous && representation == Representation::euler; }
};

/// Elements of a rotation matrix farther than this from orthonormal, as RᵀR - 1, are an error, not rounding.
inline constexpr double orthonormality_limit = 1e-3;

/// Matrices farther than this from a rotation, by Frobenius' norm, are not made one.
inline constexpr double rotation_distance_limit = 0.1;

/// The names that the columns of a representation have, without units. Euler angles: `e1`, `e2`, `e3` in the order of
/// their turns.
[[nodiscard]] ORISPLINE_EXPORT std::span<const std::string_view> names_by_component(
    Representation representation) noexcept;
/// The names of Euler angles by the axes that they turn about, `roll` x, `pitch` y, `yaw` z, in the order of the turns.
[[nodiscard]] ORISPLINE_EXPORT std::array<std::string_view, 3> names_by_axis(const EulerOrder& order) noexcept;

/// The names of the columns of inner quaternions, of the segments that leave the keys and of those that arrive at them.
inline constexpr std::array<std::array<std::string_view, 4>, 2> inner_names{
    {{"a_qw", "a_qx", "a_qy", "a_qz"}, {"b_qw", "b_qx", "b_qy", "b_qz"}}};

/// The names of the columns that hold a form when it is written: `roll_deg,pitch_deg,yaw_deg` for the order ZYX.
[[nodiscard]] ORISPLINE_EXPORT std::vector<std::string> written_names(const OrientationForm& form);

/// Up to nine numbers that state an orientation.
using OrientationNumbers = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 9, 1>;

/// An orientation in a form, in the order of `written_names`.
[[nodiscard]] ORISPLINE_EXPORT OrientationNumbers numbers_of(const Eigen::Quaterniond& q, const OrientationForm& form);

/// Euler angles [rad], in the order of the turns, in such a form.
[[nodiscard]] OrientationNumbers numbers_of_angles(const Eigen::Vector3d& angles, const OrientationForm& form);

/// The orientation that finite numbers state: those of `names_by_component`, Euler angles [rad] in the order of the
/// turns. Quaternions are taken as they are.
///
/// Error (bad_data): a matrix that is no rotation.
[[nodiscard]] ORISPLINE_EXPORT Expected<Eigen::Quaterniond> orientation_from(const OrientationNumbers& numbers,
                                                                             const OrientationForm& form);

/// The rotation that is nearest to a matrix by Frobenius' norm, and how far it is.
struct NearestRotation {
  Eigen::Quaterniond orientation;
  double distance = 0.0;
};

/// Of nine numbers, row by row. Error (bad_data): a reflection, or a matrix that is far from any rotation.
[[nodiscard]] ORISPLINE_EXPORT Expected<NearestRotation> nearest_rotation(const OrientationNumbers& numbers);

}}}  // namespace orispline::io
