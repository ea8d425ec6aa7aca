// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>

#include <orispline/math/rotation_matrix.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// Coordinates along one system of axes as those along another: every new one is an old one, or minus an old one. It
/// moves and negates numbers, and changes no digit.
class AxisChange {
 public:
  /// The axes stay as they are.
  constexpr AxisChange() = default;
  /// The new coordinate k is the old one `from[k]`, negated where `negated[k]`. Precondition: `from` is 0, 1, 2 in any
  /// order.
  constexpr AxisChange(std::array<int, 3> from, std::array<bool, 3> negated) : from_(from), negated_(negated) {}

  [[nodiscard]] constexpr bool is_none() const noexcept { return *this == AxisChange(); }
  /// -1 where a right-handed system becomes a left-handed one, or the other way round.
  [[nodiscard]] constexpr int determinant() const noexcept {
    const bool is_odd = (from_[1] - from_[0] + 3) % 3 != 1;
    return is_odd != (negated_[0] != (negated_[1] != negated_[2])) ? -1 : 1;
  }

  /// Of vectors that say a way round, such as angular velocities: the determinant times it, which is a rotation.
  [[nodiscard]] constexpr AxisChange of_turns() const noexcept {
    const bool is_mirror = determinant() < 0;
    return {from_, {negated_[0] != is_mirror, negated_[1] != is_mirror, negated_[2] != is_mirror}};
  }

  /// The new coordinates.
  template <Number T>
  [[nodiscard]] Vector3<T> operator()(const Vector3<T>& v) const noexcept {
    const auto coordinate = [&](std::size_t k) {
      const T& old = v[from_[k]];
      return negated_[k] ? T(0.0) - old : old;  // 0 stays 0, without a sign
    };
    return {coordinate(0), coordinate(1), coordinate(2)};
  }
  [[nodiscard]] Matrix3<double> matrix() const noexcept {
    Matrix3<double> matrix;
    for (int k = 0; k < 3; ++k) matrix.col(k) = (*this)(Vector3<double>(Vector3<double>::Unit(k)));
    return matrix;
  }
  /// A multiple of the quaternion of of_turns(). The turns of a cube have components of one size, but for those that
  /// are 0: here they are 1 or -1.
  [[nodiscard]] Eigen::Quaterniond whole_quaternion() const noexcept {
    const Eigen::Quaterniond unit = quaternion_from_matrix(of_turns().matrix());
    const auto whole = [](double component) { return component > 0.25 ? 1.0 : component < -0.25 ? -1.0 : 0.0; };
    return {whole(unit.w()), whole(unit.x()), whole(unit.y()), whole(unit.z())};
  }

  [[nodiscard]] constexpr bool operator==(const AxisChange&) const noexcept = default;

 private:
  std::array<int, 3> from_{0, 1, 2};
  std::array<bool, 3> negated_{};
};

}}  // namespace orispline
