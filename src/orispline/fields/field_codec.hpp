// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/fields/field.hpp>
#include <orispline/math/eigen.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

template <>
struct FieldCodec<Eigen::Vector3d> {
  static constexpr FieldType type = FieldType::vector;
  static FieldValue value(const Eigen::Vector3d& v) { return std::vector{v.x(), v.y(), v.z()}; }
  static bool assign(Eigen::Vector3d& member, const FieldValue& value) {
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    if (!numbers || numbers->size() != 3) return false;
    member = Eigen::Vector3d(numbers->data());
    return true;
  }
};

/// A symmetric matrix, such as an inertia: its diagonal, or that and its elements xy, xz, yz.
template <>
struct FieldCodec<Eigen::Matrix3d> {
  static constexpr FieldType type = FieldType::symmetric_matrix;
  static FieldValue value(const Eigen::Matrix3d& m) {
    return std::vector{m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(0, 2), m(1, 2)};
  }
  static bool assign(Eigen::Matrix3d& member, const FieldValue& value) {
    const auto* numbers = std::get_if<std::vector<double>>(&value);
    if (!numbers || (numbers->size() != 3 && numbers->size() != 6)) return false;
    member = Eigen::Vector3d(numbers->data()).asDiagonal();
    if (numbers->size() == 3) return true;
    member(0, 1) = member(1, 0) = (*numbers)[3];
    member(0, 2) = member(2, 0) = (*numbers)[4];
    member(1, 2) = member(2, 1) = (*numbers)[5];
    return true;
  }
};

}}  // namespace orispline
