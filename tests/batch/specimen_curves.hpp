// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <orispline/families/registry.hpp>
#include <support/key_use.hpp>
#include <support/specimens.hpp>

namespace orispline::testing_support {

struct NamedCurve {
  std::string name;
  AnyCurve curve;
};

/// One curve of every family, through a random walk at uneven times.
[[nodiscard]] inline std::vector<NamedCurve> curve_of_every_family(std::uint64_t seed, std::size_t segments = 7) {
  std::vector<NamedCurve> curves;
  for (const FamilyInfo& family : families_info()) {
    const KeyframeData walk =
        random_walk(seed, family.key_use.keys_for(segments), Spacing::uneven, step_on(family, Spacing::uneven, 0.7));
    curves.push_back({std::string(family.name), make_curve(family.name, keyframes(walk)).value()});
  }
  return curves;
}

/// Cumulative with three factors, with one, a chart, a cubic of R⁴, and two that only the scalar evaluator knows.
inline constexpr const char* kinds_of_curves[] = {"timed-c2", "slerp", "auto", "rational", "squad", "barry-goldman"};

[[nodiscard]] inline AnyCurve specimen_curve(const char* family, std::uint64_t seed = 51, std::size_t keys = 9) {
  return make_curve(family, keyframes(random_walk(seed, keys, Spacing::uneven, 0.7))).value();
}

}  // namespace orispline::testing_support
