// SPDX-License-Identifier: Apache-2.0
#include <orispline/io/orientation_form.hpp>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/rotation_matrix.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace io {

namespace {

constexpr std::array<std::string_view, 4> quaternion_names{"qw", "qx", "qy", "qz"};
constexpr std::array<std::string_view, 3> angle_names{"e1", "e2", "e3"};
constexpr std::array<std::string_view, 9> matrix_names{"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"};
constexpr std::array<std::string_view, 3> rotation_vector_names{"rx", "ry", "rz"};
constexpr std::array<std::string_view, 3> axis_names{"roll", "pitch", "yaw"};

/// Of RᵀR - 1: far beyond what is made a rotation.
constexpr double far_from_orthonormal = 0.5;

/// Whether angles of this order go by the names of their axes without anybody having to say the order.
bool is_named_by_axis(const EulerOrder& order) { return order == EulerOrder{}; }

tl::unexpected<Error> reflection(const Matrix3<double>& m) {
  return failure(ErrorCode::bad_data,
                 formatted("the matrix is a reflection: its determinant is {:.4g}, wanted 1", m.determinant()));
}

bool can_be_made_a_rotation(const Matrix3<double>& m) {
  return m.determinant() > 0.0 && orthonormality_error(m) <= far_from_orthonormal &&
         (m - nearest_rotation_matrix(m)).norm() <= rotation_distance_limit;
}

Expected<Eigen::Quaterniond> orientation_from_matrix(const Matrix3<double>& m) {
  const double error = orthonormality_error(m);
  if (!(error <= orthonormality_limit))
    return failure(ErrorCode::bad_data,
                   formatted("the matrix is no rotation: its transpose times itself is off by {:.3g} from 1, wanted at "
                             "most {:g}{}",
                             error, orthonormality_limit,
                             can_be_made_a_rotation(m) ? "; `normalise` takes the nearest rotation" : ""));
  if (m.determinant() < 0.0) return reflection(m);
  return quaternion_from_matrix(m);
}

}  // namespace

std::span<const std::string_view> names_by_component(Representation representation) noexcept {
  switch (representation) {
    case Representation::euler:
      return angle_names;
    case Representation::matrix:
      return matrix_names;
    case Representation::rotation_vector:
      return rotation_vector_names;
    case Representation::quaternion:
      break;
  }
  return quaternion_names;
}

std::array<std::string_view, 3> names_by_axis(const EulerOrder& order) noexcept {
  const auto name = [&order](std::size_t turn) { return axis_names[static_cast<std::size_t>(order.turns[turn])]; };
  return {name(0), name(1), name(2)};
}

std::vector<std::string> written_names(const OrientationForm& form) {
  auto names = names_by_component(form.representation);
  if (form.representation == Representation::euler && is_named_by_axis(form.order)) names = axis_names;
  std::vector<std::string> written(names.begin(), names.end());
  if (form.representation == Representation::euler)
    for (std::string& name : written) name += info_of(form.unit).suffix;
  return written;
}

OrientationNumbers numbers_of_angles(const Eigen::Vector3d& angles, const OrientationForm& form) {
  const AngleUnitInfo& unit = info_of(form.unit);
  const OrientationNumbers turns = Eigen::Vector3d(angles * unit.denominator / unit.numerator);
  return is_named_by_axis(form.order) ? OrientationNumbers(turns.reverse()) : turns;
}

OrientationNumbers numbers_of(const Eigen::Quaterniond& q, const OrientationForm& form) {
  switch (form.representation) {
    case Representation::euler:
      return numbers_of_angles(euler_angles(form.order, q), form);
    case Representation::matrix:
      return q.toRotationMatrix().reshaped<Eigen::RowMajor>();
    case Representation::rotation_vector:
      return log<double>(q);
    case Representation::quaternion:
      break;
  }
  return Eigen::Vector4d(q.w(), q.x(), q.y(), q.z());
}

Expected<Eigen::Quaterniond> orientation_from(const OrientationNumbers& numbers, const OrientationForm& form) {
  switch (form.representation) {
    case Representation::euler:
      return quaternion_from_euler(form.order, numbers.head<3>());
    case Representation::rotation_vector:
      return exp<double>(numbers.head<3>());
    case Representation::matrix:
      return orientation_from_matrix(numbers.head<9>().reshaped<Eigen::RowMajor>(3, 3));
    case Representation::quaternion:
      break;
  }
  return quaternion_wxyz(numbers[0], numbers[1], numbers[2], numbers[3]);
}

Expected<NearestRotation> nearest_rotation(const OrientationNumbers& numbers) {
  const Matrix3<double> m = numbers.head<9>().reshaped<Eigen::RowMajor>(3, 3);
  const double error = orthonormality_error(m);
  if (m.determinant() < 0.0) return reflection(m);
  if (error <= norm_error_limit) return NearestRotation{quaternion_from_matrix(m)};
  if (!can_be_made_a_rotation(m))
    return failure(ErrorCode::bad_data,
                   formatted("the matrix is far from any rotation: its transpose times itself is off by {:.3g} from 1, "
                             "wanted a rotation within {:g} by Frobenius' norm",
                             error, rotation_distance_limit));
  const Matrix3<double> rotation = nearest_rotation_matrix(m);
  return NearestRotation{quaternion_from_matrix(rotation), (m - rotation).norm()};
}

}}}  // namespace orispline::io
