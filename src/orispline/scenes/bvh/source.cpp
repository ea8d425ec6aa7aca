// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/bvh/source.hpp>

#include <algorithm>

#include <orispline/math/degrees.hpp>
#include <orispline/math/so3.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes::bvh {

namespace {

bool is_same(const Joint& a, const Joint& b) {
  return a.name == b.name && a.parent == b.parent && a.rest.translation == b.rest.translation &&
         a.rest.rotation.coeffs() == b.rest.rotation.coeffs() && a.rest.scale == b.rest.scale;
}

}  // namespace

bool Source::has(const Skeleton& other) const noexcept {
  return std::ranges::equal(skeleton.joints(), other.joints(), is_same);
}

std::size_t columns_of(std::span<const WrittenJoint> joints) noexcept {
  std::size_t columns = 0;
  for (const WrittenJoint& joint : joints) columns += joint.columns.size();
  return columns;
}

Eigen::Quaterniond rotation_of(std::span<const Column> columns, const double* numbers) noexcept {
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::Kind::rotation)
      q = q * exp<double>(numbers[i] * radians_per_degree * Eigen::Vector3d::Unit(columns[i].axis));
  return q;
}

Eigen::Vector3d translation_of(std::span<const Column> columns, const double* numbers,
                               const Eigen::Vector3d& offset) noexcept {
  Eigen::Vector3d translation = offset;
  for (std::size_t i = 0; i < columns.size(); ++i)
    if (columns[i].kind == Column::Kind::position) translation[columns[i].axis] = numbers[i];
  return translation;
}

std::size_t count_of(std::span<const Column> columns, Column::Kind kind) noexcept {
  return static_cast<std::size_t>(std::ranges::count(columns, kind, &Column::kind));
}

}}}  // namespace orispline::scenes::bvh
