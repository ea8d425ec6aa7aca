// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include <rapidcheck.h>

#include <support/properties.hpp>

namespace orispline::testing_support {

/// A neighbour in the last bits of those components that odd numbers are given for.
[[nodiscard]] inline Eigen::Quaterniond nudged(Eigen::Quaterniond q, int x, int y, int z) {
  constexpr double last_bit = std::numeric_limits<double>::epsilon() / 4.0;
  q.x() += x % 2 * last_bit;
  q.y() += y % 2 * last_bit;
  q.z() += z % 2 * last_bit;
  return q;
}

/// Random keys with rests among them, whose keys are equal or differ in their last bits.
struct RestingKeys : RandomKeys {};

/// How a key follows the one before it: 0 equals it but for the last bits of three components, others as it was drawn.
using Following = std::tuple<int, int, int, int>;

[[nodiscard]] inline RestingKeys with_rests(const RandomKeys& drawn, const std::vector<Following>& following) {
  RestingKeys keys{drawn};
  auto& q = keys.data.orientations;
  for (std::size_t i = 1; i < q.size() && i <= following.size(); ++i)
    if (const auto& [kind, x, y, z] = following[i - 1]; kind == 0) q[i] = nudged(q[i - 1], x, y, z);
  return keys;
}

}  // namespace orispline::testing_support

namespace rc {

template <>
struct Arbitrary<orispline::testing_support::RestingKeys> {
  static Gen<orispline::testing_support::RestingKeys> arbitrary() {
    using namespace orispline::testing_support;
    const auto bit = gen::inRange(-1, 2);
    const auto following = gen::container<std::vector<Following>>(8, gen::tuple(gen::inRange(0, 3), bit, bit, bit));
    return gen::map(
        gen::pair(gen::arbitrary<RandomKeys>(), following),
        [](const std::pair<RandomKeys, std::vector<Following>>& made) { return with_rests(made.first, made.second); });
  }
};

}  // namespace rc
