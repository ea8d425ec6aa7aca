// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <ostream>

#include <gtest/gtest.h>

#include <orispline/families/registry.hpp>
#include <support/key_use.hpp>
#include <support/near.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>

namespace orispline {

/// How a failing contract test prints its family.
inline void PrintTo(const FamilyInfo& family, std::ostream* out) { *out << family.name; }

namespace contract {

using testing_support::Spacing;  // beside that of the analysis, which a test may include

/// What every family promises, checked through the registry: a new family is under contract without a line of test
/// code.
class FamilyContract : public testing::TestWithParam<FamilyInfo> {
 protected:
  [[nodiscard]] static AnyCurve curve(const Keyframes& keys, const CurveOptions& options = {}) {
    return make_curve({GetParam().name, options}, keys).value();
  }
  [[nodiscard]] static const KeyUse& use() { return GetParam().key_use; }
  /// Keys of a random walk, as many as the family needs for a curve of `segments` segments.
  [[nodiscard]] static KeyframeData walk(std::uint64_t seed, std::size_t segments, Spacing spacing,
                                         double largest_step = 1.5) {
    return testing_support::random_walk(seed, use().keys_for(segments), spacing,
                                        testing_support::step_on(GetParam(), spacing, largest_step));
  }
  /// Times on every segment of a curve, the knots included.
  [[nodiscard]] static std::vector<double> times_on(const AnyCurve& curve, std::size_t count = 5) {
    return testing_support::sample_times(curve.knots().times(), count);
  }
};

inline std::string test_name(const testing::TestParamInfo<FamilyInfo>& test) {
  std::string name(test.param.name);
  std::ranges::replace(name, '-', '_');
  return name;
}

/// Rounding grows from order to order; see tolerance.hpp.
inline constexpr testing_support::MotionTolerance same_motion{tolerance::algebra, tolerance::rates, tolerance::rates,
                                                              tolerance::rates};

}  // namespace contract

}  // namespace orispline

/// Puts one suite of the contract under every family of the list.
#define ORISPLINE_FOR_EVERY_FAMILY(suite) \
  INSTANTIATE_TEST_SUITE_P(Family, suite, testing::ValuesIn(orispline::families_info()), orispline::contract::test_name)
