// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fuzz/fuzz_input.hpp>
#include <orispline/curve/keyframe.hpp>
#include <orispline/math/so3.hpp>

namespace orispline::fuzz {

/// How the times of keys are drawn. make_corpus.py knows the numbers.
enum class Steps : unsigned {
  whole,     ///< 1 s
  even,      ///< one of 2^-20 … 2^20 s
  moderate,  ///< of their own, 1/16 … 1 s
  wild,      ///< of their own, 2^-20 … 2^20 s
};

/// How a key is turned from the one before.
enum class Turn : unsigned { none, full, half, tiny, ordinary, wide, back, off_norm };

/// Keys that are valid, as far as drawing goes.
struct FuzzedKeys {
  KeyframeData data;
  Signs signs = Signs::shortest;
  double step_ratio = 1.0;   ///< of the longest to the shortest step
  double widest_turn = 0.0;  ///< [rad], of successive keys as given
};

[[nodiscard]] inline double fuzzed_step(FuzzInput& input, Steps steps) {
  if (steps == Steps::whole) return 1.0;
  if (steps == Steps::moderate) return static_cast<double>(1 + input.below(16)) / 16.0;
  return std::ldexp(1.0, static_cast<int>(input.below(41)) - 20);
}

/// `first`: the first key's orientation, for those that come back to it.
[[nodiscard]] inline Eigen::Quaterniond fuzzed_turn(FuzzInput& input, const Eigen::Quaterniond& q,
                                                    const Eigen::Quaterniond& first) {
  switch (static_cast<Turn>(input.below(8))) {
    case Turn::none:
      return q;
    case Turn::full:
      return Eigen::Quaterniond(-q.coeffs());
    case Turn::half: {
      const auto axis = static_cast<Eigen::Index>(input.below(3));
      return q * Eigen::Quaterniond(Eigen::Vector4d::Unit(axis));
    }
    case Turn::tiny: {
      const double size = std::pow(10.0, -static_cast<double>(input.below(20)));
      return q * exp<double>(size * input.vector());
    }
    case Turn::ordinary:
      return q * exp<double>(input.vector());
    case Turn::wide:
      return q * exp<double>(2.0 * std::numbers::pi / std::sqrt(3.0) * input.vector());
    case Turn::back:
      return first;
    case Turn::off_norm: {
      const double norm = (input.below(2) == 0 ? 1.0 : -1.0) * (1.0 + 5e-4 * input.signed_unit());
      return Eigen::Quaterniond(norm * (q * exp<double>(input.vector())).coeffs());
    }
  }
  return q;
}

/// 1 to `most` keys; by their own byte with positions and rates of the first three orders.
[[nodiscard]] inline FuzzedKeys fuzzed_keys(FuzzInput& input, std::size_t most) {
  constexpr std::array starts{0.0, 1.7e9, -1000.0, 0.001};  // [s]
  FuzzedKeys keys;
  const std::size_t count = 1 + input.below(most);
  Flags how(input), parts(input);
  const auto steps = static_cast<Steps>(how.next(4));
  double t = starts[how.next(4)];
  keys.signs = how.next() ? Signs::as_given : Signs::shortest;
  const double even_step = steps == Steps::even ? fuzzed_step(input, steps) : 0.0;
  Eigen::Quaterniond q = how.next() ? quaternion_wxyz(0.5, 0.5, 0.5, 0.5) : Eigen::Quaterniond::Identity();
  const bool positions = parts.next();
  const unsigned rates = parts.next(4);
  double longest = 0.0, shortest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) {
      const double wanted = even_step > 0.0 ? even_step : fuzzed_step(input, steps), before = t;
      t += wanted;
      if (!(t > before)) t = std::nextafter(before, std::numeric_limits<double>::infinity());
      longest = std::max(longest, t - before);
      shortest = std::min(shortest, t - before);
      const Eigen::Quaterniond next = fuzzed_turn(input, q, keys.data.orientations.front());
      keys.widest_turn = std::max(keys.widest_turn, increment<double>(q.normalized(), next.normalized()).norm());
      q = next;
    }
    keys.data.times.push_back(t);
    keys.data.orientations.push_back(q);
    if (positions) keys.data.positions.push_back(3.0 * input.vector());
    for (auto* of_order : {&keys.data.angular_velocities, &keys.data.angular_accelerations, &keys.data.angular_jerks})
      if (rates > static_cast<unsigned>(of_order == &keys.data.angular_accelerations) +
                      2 * static_cast<unsigned>(of_order == &keys.data.angular_jerks))
        of_order->push_back(input.vector());
  }
  if (count > 1) keys.step_ratio = longest / shortest;
  return keys;
}

/// The keys as a file that the command reads, with all digits.
[[nodiscard]] inline std::string csv_of(const KeyframeData& data) {
  std::string text = "t,qw,qx,qy,qz";
  for (const auto& [names, list] : {std::pair(",px,py,pz", &data.positions),
                                    {",wx,wy,wz", &data.angular_velocities},
                                    {",ax,ay,az", &data.angular_accelerations},
                                    {",jx,jy,jz", &data.angular_jerks}})
    if (!list->empty()) text += names;
  for (std::size_t i = 0; i < data.times.size(); ++i) {
    const Eigen::Quaterniond& q = data.orientations[i];
    text += fmt::format("\n{},{},{},{},{}", data.times[i], q.w(), q.x(), q.y(), q.z());
    for (const auto* list :
         {&data.positions, &data.angular_velocities, &data.angular_accelerations, &data.angular_jerks})
      if (!list->empty()) text += fmt::format(",{},{},{}", (*list)[i].x(), (*list)[i].y(), (*list)[i].z());
  }
  return text + "\n";
}

}  // namespace orispline::fuzz
