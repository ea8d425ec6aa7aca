// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <orispline/batch/baked_motion.hpp>
#include <orispline/fields/json.hpp>
#include <orispline/jobs/curve_of_keys.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace jobs {

/// What is asked of a curve that is baked.
struct BakeSettings {
  double tolerance = 0.0;            ///< [rad], as orispline::bake() measures it; from that on which `float` can hold
  double position_tolerance = 1e-3;  ///< [m], where there are positions
};

struct BakeRequest {
  std::shared_ptr<const Track> keys;
  ChosenMethod method{};
  BakeSettings options{};
};

/// A curve in single precision, and what was asked for.
struct BakeOutcome {
  BakeRequest request;
  Method method;  ///< of the curve
  BakedMotion baked;
  std::vector<Warning> warnings{};  ///< of the request's method, and of the curve
};

/// Errors: those of curve_of_keys(), bake_motion(), with their places; bad_argument for gaps.
[[nodiscard]] ORISPLINE_EXPORT Expected<BakeOutcome> bake(BakeRequest request, const Progress& progress = {});

/// Described in docs/inspect-json.md, but for the names of files and the warnings.
[[nodiscard]] ORISPLINE_EXPORT Json document_of(const BakeOutcome& outcome);
/// One line for people.
[[nodiscard]] ORISPLINE_EXPORT std::string summary_of(const BakeOutcome& outcome);

}}}  // namespace orispline::jobs
