// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include <orispline/curve/stretches.hpp>
#include <orispline/families/motion_band.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

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
