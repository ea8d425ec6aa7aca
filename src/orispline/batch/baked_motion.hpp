// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <orispline/base/decimal.hpp>
#include <orispline/batch/baked_curve.hpp>
#include <orispline/batch/baked_path.hpp>

namespace orispline { inline namespace ORISPLINE_ABI {

/// A moving body in single precision, which is what players evaluate.
struct BakedMotion {
  BakedCurve<float> curve;
  std::optional<BakedPath> path{};  ///< of the positions; null where there are none
};

/// Bakes orientations within `tolerance` [rad], and positions within `position_tolerance` [m] where there are some.
/// Errors: those of bake() and bake_path(), of the option of the tolerance that is missed.
[[nodiscard]] ORISPLINE_EXPORT Expected<BakedMotion> bake_motion(const PoseCurve& curve, double tolerance,
                                                                 double position_tolerance,
                                                                 const Progress& progress = {});

/// What is stored of it: docs/bake.md describes the two files. `epoch`: the time that those of the curve count from
/// [s].
[[nodiscard]] ORISPLINE_EXPORT std::string baked_json(const BakedMotion& motion, const Decimal& epoch);
[[nodiscard]] ORISPLINE_EXPORT std::string baked_bytes(const BakedMotion& motion, const Decimal& epoch);

}}  // namespace orispline
