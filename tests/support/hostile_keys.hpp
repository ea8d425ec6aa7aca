// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include <rapidcheck.h>

#include <support/resting_keys.hpp>

namespace orispline::testing_support {

/// Random keys that are hard on a method: steps of 1 ms to 60 s side by side, turns of up to 179 degrees, most of them
/// about one axis, rests, and rests whose keys differ in their last bits.
struct HostileKeys : RandomKeys {};

/// One key after another, as numbers that rapidcheck makes and shrinks.
struct HostileStep {
  int duration;  ///< 0 to 100: 1 ms to 60 s
  int kind;      ///< up to 2: about the common axis; then about one of its own, a rest, a rest but for the last bits
  int turn;      ///< [degrees]
  int x, y, z;   ///< an axis, or last bits
};

[[nodiscard]] inline double duration_of(const HostileStep& step) { return 1e-3 * std::pow(6e4, 0.01 * step.duration); }

[[nodiscard]] inline Eigen::Quaterniond next_key(const Eigen::Quaterniond& q, const HostileStep& step,
                                                 const Eigen::Vector3d& common_axis) {
  if (step.kind == 4) return q;
  if (step.kind == 5) return nudged(q, step.x, step.y, step.z);
  const Eigen::Vector3d own = Eigen::Vector3d(step.x, step.y, step.z + 0.5).normalized();
  return q * exp<double>(step.turn * pi / 180.0 * (step.kind == 3 ? own : common_axis));
}

[[nodiscard]] inline HostileKeys hostile_keys(const std::vector<HostileStep>& steps) {
  HostileKeys keys;
  double t = 0.0;
  Eigen::Quaterniond q = exp<double>(Eigen::Vector3d(0.3, -0.8, 1.1));
  const Eigen::Vector3d axis(0.48, -0.6, 0.64);
  for (const HostileStep& step : steps) {
    keys.data.times.push_back(t);
    keys.data.orientations.push_back(q);
    t += duration_of(step);
    q = next_key(q, step, axis);
  }
  return keys;
}

}  // namespace orispline::testing_support

namespace rc {

template <>
struct Arbitrary<orispline::testing_support::HostileKeys> {
  /// 2 to 60 keys.
  static Gen<orispline::testing_support::HostileKeys> arbitrary() {
    using namespace orispline::testing_support;
    const auto small = gen::inRange(-100, 101);
    const auto turn = gen::oneOf(gen::inRange(-179, 180), gen::just(179));
    const auto step = gen::construct<HostileStep>(gen::oneOf(gen::inRange(0, 101), gen::element(0, 100)),
                                                  gen::inRange(0, 6), turn, small, small, small);
    const auto steps = gen::mapcat(gen::inRange<std::size_t>(2, 61), [step](std::size_t count) {
      return gen::container<std::vector<HostileStep>>(count, step);
    });
    return gen::map(steps, [](const std::vector<HostileStep>& made) { return hostile_keys(made); });
  }
};

}  // namespace rc
