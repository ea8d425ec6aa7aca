// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/math/rotation_matrix.hpp>

// Other axes for the world, for the body, or for both: docs/frames.md.

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

/// How coordinates in one frame become those in another: along other axes first, then turned.
struct CoordinateChange {
  AxisChange axes{};
  std::optional<Eigen::Quaterniond> rotation{};  ///< new coordinates are R(rotation) times the old ones

  [[nodiscard]] bool is_none() const noexcept { return axes.is_none() && !rotation; }
};

/// What a system of axes belongs to.
enum class AxesOf { world, body };

/// The change between two systems of axes, `NED:ENU`. Three letters say where +x, +y and +z point: N or S, E or W, U or
/// D in a world with a compass; R or L, F or B, U or D (right, left, front, back, up, down) in one without, and of
/// bodies.
///
/// Error (bad_argument): no two such systems of one kind.
[[nodiscard]] ORISPLINE_EXPORT Expected<AxisChange> axis_change_of(std::string_view text, AxesOf whose);

/// Other frames on either side of an orientation: with W and B what becomes of coordinates of the world and of the
/// body, R becomes W R Bᵀ, and positions W p.
struct FrameChange {
  CoordinateChange world{}, body{};

  [[nodiscard]] bool is_none() const noexcept { return world.is_none() && body.is_none(); }
};

/// Error (bad_argument, of `world_axes`, `body_axes`, `world_rotation` or `body_rotation`): handedness that changes on
/// one side only; a rotation whose norm is not 1.
[[nodiscard]] ORISPLINE_EXPORT Expected<void> check(const FrameChange& change);

/// What is stated in the old frames, as it is stated in the new ones.
///
/// Axes move and negate vectors, and change no digit of them. What they make of a quaternion is rounded once where it
/// has sums at all: the factors of both sides are multiplied out in whole numbers first.
class ORISPLINE_EXPORT NewFrames {
 public:
  /// Precondition: check(change).
  explicit NewFrames(const FrameChange& change = {});

  [[nodiscard]] bool change_nothing() const noexcept { return change_.is_none(); }

  /// An orientation, of any norm; linear in it, so that signs stay what they are to each other.
  template <Number T>
  [[nodiscard]] Quaternion<T> orientation(const Quaternion<T>& q) const noexcept {
    if (change_nothing()) return q;
    Quaternion<T> turned = q;
    if (!keeps_axes_) {
      const std::array old{q.w(), q.x(), q.y(), q.z()};
      const auto component = [&](std::size_t row) {
        T sum(0.0);
        for (std::size_t k = 0; k < old.size(); ++k)
          if (product_[row][k] != 0.0) sum = sum + old[k] * product_[row][k];
        return sum / scale_;
      };
      turned = Quaternion<T>(component(0), component(1), component(2), component(3));
    }
    if (change_.world.rotation) turned = constant<T>(*change_.world.rotation) * turned;
    if (change_.body.rotation) turned = turned * constant<T>(change_.body.rotation->conjugate());
    return turned;
  }

  /// A position, or a rate of it, in the frame of the world.
  template <Number T>
  [[nodiscard]] Vector3<T> in_world(const Vector3<T>& v) const noexcept {
    return turned<T>(change_.world, v);
  }

  /// An angular velocity, acceleration or jerk, in the frame of the body: det(B) B ω.
  [[nodiscard]] Eigen::Vector3d body_rate(const Eigen::Vector3d& rate) const noexcept {
    return turned<double>({change_.body.axes.of_turns(), change_.body.rotation}, rate);
  }

 private:
  template <Number T>
  [[nodiscard]] static Vector3<T> turned(const CoordinateChange& change, const Vector3<T>& v) noexcept {
    const Vector3<T> along = change.axes(v);
    return change.rotation ? to_world<T>(constant<T>(*change.rotation), along) : along;
  }

  FrameChange change_;
  bool keeps_axes_ = true;
  std::array<std::array<double, 4>, 4> product_{};  // of the axes, on w, x, y, z; whole numbers
  double scale_ = 1.0;                              // that the product is too long by
};

/// Where the body is that has the world's origin there, in its own frame: -R p. `orientation`: of the body, of any
/// norm.
[[nodiscard]] ORISPLINE_EXPORT Eigen::Vector3d place_of_body(const Eigen::Quaterniond& orientation,
                                                             const Eigen::Vector3d& origin);
/// Keys whose orientations take the world into the body, as keys have them. Rates and positions stay.
[[nodiscard]] ORISPLINE_EXPORT KeyframeData conjugated(KeyframeData data);
/// The same of poses x_body = R x_world + p, where positions become those of the body.
[[nodiscard]] ORISPLINE_EXPORT KeyframeData inverted(KeyframeData data);

/// Keys in other frames, with all that they carry. Precondition: check(change).
[[nodiscard]] ORISPLINE_EXPORT KeyframeData in_frames(KeyframeData data, const NewFrames& frames);
/// A track in other frames, with its recipe: rates of clamped ends turn as the keys do. What its file looked like is
/// forgotten. Errors: of check(); of Keyframes::make().
[[nodiscard]] ORISPLINE_EXPORT Expected<Track> in_frames(const Track& track, const FrameChange& change);
/// What keys in the old frames are for, of keys in the new ones.
[[nodiscard]] ORISPLINE_EXPORT Recipe in_frames(Recipe recipe, const NewFrames& frames);

}}  // namespace orispline
