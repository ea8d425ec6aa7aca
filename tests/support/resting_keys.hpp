// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <support/properties.hpp>

namespace orispline::testing_support {

/// Random keys of which some are those before them, or their neighbours in the last bit.
struct RestingKeys : RandomKeys {};

/// To each key whose word is 2 or 3 no turn leads, to the others the one that did; with 3 the last bit of a component
/// is another.
[[nodiscard]] inline RestingKeys with_rests(const RandomKeys& moving, const std::vector<int>& words) {
  RestingKeys keys{moving};
  const auto& before = moving.data.orientations;
  auto& orientations = keys.data.orientations;
  for (std::size_t i = 1; i < orientations.size(); ++i) {
    const int word = words[i % words.size()];
    orientations[i] = orientations[i - 1];
    if (word < 2) orientations[i] = orientations[i - 1] * (before[i - 1].conjugate() * before[i]);
    double& nudged = orientations[i].coeffs()[static_cast<Eigen::Index>(i % 4)];
    if (word == 3) nudged = std::nextafter(nudged, nudged < 0.5 ? 1.0 : 0.0);
  }
  return keys;
}

}  // namespace orispline::testing_support

namespace rc {

template <>
struct Arbitrary<orispline::testing_support::RestingKeys> {
  static Gen<orispline::testing_support::RestingKeys> arbitrary() {
    using namespace orispline::testing_support;
    const auto words = gen::container<std::vector<int>>(8, gen::inRange(0, 4));
    return gen::apply(with_rests, gen::arbitrary<RandomKeys>(), words);
  }
};

}  // namespace rc
