// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <vector>

#include <orispline/curve/keyframe.hpp>
#include <orispline/curve/method.hpp>
#include <orispline/curve/path.hpp>
#include <orispline/curve/stretches.hpp>
#include <orispline/curve/track.hpp>
#include <orispline/families/motion_band.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// The keys of a stretch, with the signs that they have.
[[nodiscard]] ORISPLINE_EXPORT Expected<Keyframes> keys_of_stretch(const Keyframes& keys, const Stretch& stretch);

/// A method for so many keys as one for those of a stretch: with their own settings, and with a rate that is given for
/// an end at that end only.
[[nodiscard]] ORISPLINE_EXPORT Method method_for_stretch(Method method, const Stretch& stretch, std::size_t keys);

/// A curve of its own through each stretch, one at least, and NaN between them. Errors: those of make_pose_curve(),
/// with the stretch; bad_argument for a closed curve.
[[nodiscard]] ORISPLINE_EXPORT Expected<PoseCurve> curve_in_stretches(const Method& method, const Keyframes& keys,
                                                                      std::span<const Stretch> stretches);

/// The curve through all keys, or where they have gaps [s] or jumps that in stretches. Errors: those of
/// make_pose_curve(), of stretches_between_gaps() and of curve_in_stretches().
[[nodiscard]] ORISPLINE_EXPORT Expected<PoseCurve> curve_beside_gaps(const Method& method, const Keyframes& keys,
                                                                     std::optional<double> gap);

/// Its keys cut at the gaps that it states and at its jumps; none where it has neither. Errors: those of
/// stretches_between_gaps().
[[nodiscard]] ORISPLINE_EXPORT Expected<std::vector<Stretch>> stretches_of(const Track& track);

/// Where the true motion may be beside a curve in stretches, each of which has a band by its own keys.
class ORISPLINE_EXPORT BandInStretches {
 public:
  /// Without stretches one band by all keys. Errors: those of MotionBand::make().
  [[nodiscard]] static Expected<BandInStretches> make(const Method& method, const Keyframes& keys,
                                                      std::span<const Stretch> stretches, double share);

  /// At time t [s], as of MotionBand; NaN in gaps. [rad]
  [[nodiscard]] double operator()(double t) const noexcept;

 private:
  struct Part {
    double start, end;  ///< [s]
    MotionBand band;
  };

  std::vector<Part> parts_;
};

}}  // namespace orispline
