// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdlib>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <orispline/curve/family.hpp>
#include <support/specimens.hpp>

namespace orispline::testing_support {

/// Random keys as rapidcheck makes and shrinks them: towards few keys, small turns, even times.
struct RandomKeys {
  KeyframeData data;
};

inline std::ostream& operator<<(std::ostream& out, const RandomKeys& keys) {
  for (std::size_t i = 0; i < keys.data.times.size(); ++i)
    out << "\n  t = " << keys.data.times[i] << ", q (xyzw) = " << keys.data.orientations[i].coeffs().transpose();
  return out;
}

/// Runs a property on random cases from a fixed seed; the counterexample, shrunk, is printed.
///
/// RC_PARAMS in the environment overrides seed and number of cases.
template <class Property>
[[nodiscard]] bool holds(const std::string& name, Property&& property) {
  static const int seeded = setenv("RC_PARAMS", "seed=20180101 max_success=100 max_size=60", 0);
  return seeded == 0 && rc::check(name, std::forward<Property>(property));
}

/// The same keys with their turns cut to `widest` [rad].
inline KeyframeData with_turns_within(double widest, const KeyframeData& data) {
  KeyframeData within = data;
  for (std::size_t i = 1; i < data.orientations.size(); ++i) {
    const Eigen::Vector3d turn = increment<double>(data.orientations[i - 1], data.orientations[i]);
    if (turn.norm() > 0.0)
      within.orientations[i] = within.orientations[i - 1] * exp<double>(std::min(1.0, widest / turn.norm()) * turn);
    else within.orientations[i] = within.orientations[i - 1];
  }
  return within;
}

/// Random keys as many as the family takes: cut, or continued by some more turns where there are too few.
inline KeyframeData as_many_as_taken(const FamilyInfo& family, const RandomKeys& random) {
  KeyframeData data = random.data;
  while (data.times.size() < static_cast<std::size_t>(family.min_keys)) {
    data.times.push_back(data.times.back() + 0.5);
    const double turn = 0.2 * static_cast<double>(data.times.size());
    data.orientations.push_back(data.orientations.back() * exp<double>(Eigen::Vector3d(turn, 0.4, -turn)));
  }
  const std::size_t count = family.key_use.cut(data.times.size());
  data.times.resize(count);
  data.orientations.resize(count);
  return data;
}

/// Random keys as many as the family takes and turning no wider than it takes.
inline KeyframeData fitting(const FamilyInfo& family, const RandomKeys& random) {
  const KeyframeData data = as_many_as_taken(family, random);
  const double widest = family.key_use.widest_turn;
  return widest < 2.0 * pi ? with_turns_within(widest, data) : data;
}

/// Inside a property: what EXPECT_TRUE is in a test.
inline void require(const ::testing::AssertionResult& result) {
  if (!result) RC_FAIL(result.message());
}

}  // namespace orispline::testing_support

namespace rc {

template <>
struct Arbitrary<orispline::testing_support::RandomKeys> {
  /// 2 to 8 keys; turns up to 2 rad per step; steps in time of 1 to 10 eighths of a second, so that key times, their
  /// quarters and their multiples are exact.
  static Gen<orispline::testing_support::RandomKeys> arbitrary() {
    using orispline::testing_support::RandomKeys;
    const auto step =
        gen::tuple(gen::inRange(1, 11), gen::inRange(-100, 101), gen::inRange(-100, 101), gen::inRange(-100, 101));
    const auto count = gen::inRange<std::size_t>(2, 9);
    return gen::map(gen::mapcat(count,
                                [step](std::size_t n) {
                                  return gen::container<std::vector<std::tuple<int, int, int, int>>>(n, step);
                                }),
                    [](const std::vector<std::tuple<int, int, int, int>>& steps) {
                      RandomKeys keys;
                      double t = 0.0;
                      auto q = Eigen::Quaterniond::Identity();
                      for (const auto& [dt, x, y, z] : steps) {
                        t += 0.125 * dt;
                        q = q * orispline::exp<double>(Eigen::Vector3d(x, y, z) * 0.0115);
                        keys.data.times.push_back(t);
                        keys.data.orientations.push_back(q);
                      }
                      return keys;
                    });
  }
};

}  // namespace rc
