// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <orispline/clip/clip.hpp>
#include <orispline/curve/curve_through.hpp>
#include <orispline/curve/knots.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The value of a channel over time. Before its first key and after its last one it stands still.
///
/// `cubicspline` of rotations is the cubic Hermite polynomial of the four components, normalised, with the signs of the
/// file: q = s/|s|. Where s passes through 0, as between opposite keys at rest, q is not a number. `linear` of
/// rotations is slerp the shorter way, whatever the signs. Source: glTF 2.0, section 3.11 and appendix C.
template <CurvePoint P>
class ORISPLINE_EXPORT ChannelCurve {
 public:
  /// Precondition: check_clip() finds the channel sound.
  explicit ChannelCurve(const Channel<P>& channel);

  [[nodiscard]] std::size_t joint() const noexcept { return joint_; }
  [[nodiscard]] const Knots& knots() const noexcept { return curve_.knots(); }
  [[nodiscard]] P at(double t) const noexcept;
  /// With its rates at time t [s]; at an interior key of the segment after it.
  [[nodiscard]] MotionOf<P> motion(double t) const noexcept;
  [[nodiscard]] const ErasedCurve<P>& curve() const noexcept { return curve_; }

 private:
  ErasedCurve<P> curve_;
  P last_;  ///< the value from the last key on, where a step ends
  std::size_t joint_;
};

extern template class ChannelCurve<Eigen::Quaterniond>;
extern template class ChannelCurve<Eigen::Vector3d>;

}}  // namespace orispline
