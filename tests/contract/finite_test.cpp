// SPDX-License-Identifier: Apache-2.0
// Contract: at the limits of what keys, ends and parameters may be, every curve that is given out is finite with all
// its rates, and its orientations are unit.
#include <contract/family_contract.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

/// Times at steps from `shortest` to `longest`, the shortest ones nearest to time 0, where doubles are dense.
std::vector<double> times_at_limits(Dice& dice, std::size_t count, double shortest, double longest) {
  const double only = dice() < 0.5 ? shortest : longest;
  const bool even = dice() < 0.4;
  const auto step = [&]() -> double {
    const double r = dice();
    return even ? only : r < 0.3 ? shortest : r < 0.6 ? longest : shortest * std::pow(longest / shortest, dice());
  };
  const auto before = static_cast<std::size_t>(dice() * static_cast<double>(count));
  std::vector<double> left(before), right(count - 1 - before), times{0.0};
  std::ranges::generate(left, step);
  std::ranges::generate(right, step);
  std::ranges::sort(left);
  std::ranges::sort(right);
  for (const double h : right) times.push_back(times.back() + h);
  for (const double h : left) times.insert(times.begin(), times.front() - h);
  return times;
}

/// Steps that make formulas break: none, hardly any, half turns, full turns, any.
Eigen::Quaterniond hard_step(Dice& dice) {
  const double kind = dice();
  if (kind < 0.15) return Eigen::Quaterniond::Identity();
  if (kind < 0.3) return exp<double>(std::pow(10.0, -320.0 * dice()) * dice.vector());
  if (kind < 0.45) return exp<double>(dice() < 0.5 ? Eigen::Vector3d(pi, 0, 0) : Eigen::Vector3d(0, pi, 0));
  if (kind < 0.6) return dice() < 0.5 ? Eigen::Quaterniond(0, 1, 0, 0) : Eigen::Quaterniond(0, 0, 1, 0);
  if (kind < 0.8) return Eigen::Quaterniond(-1, 0, 0, 0);
  return exp<double>(6.0 * dice.vector());
}

/// Components at the limit, with any sign, or none.
Eigen::Vector3d largest_vector(Dice& dice) {
  const double size = dice() < 0.3 ? 0.0 : largest_component;
  return size * Eigen::Vector3d(dice() < 0.5 ? -1 : 1, dice() < 0.5 ? -1 : 1, dice.between(-1, 1));
}

/// The values at the borders of a parameter's range and those that most callers take.
double border_value(Dice& dice, const Parameter& p) {
  return std::array{p.lowest, p.highest, p.initial, std::max(p.lowest, 0.0)}.at(static_cast<std::size_t>(4 * dice()));
}

template <class List>
const auto& one_of(Dice& dice, const List& list) {
  return list[static_cast<std::size_t>(dice() * static_cast<double>(list.size()))];
}

class FiniteContract : public FamilyContract {
 protected:
  [[nodiscard]] static KeyframeData keys_at_limits(Dice& dice) {
    const std::size_t count = use().keys_for(1 + static_cast<std::size_t>(7 * dice()));
    constexpr double ratio = 0.9 * widest_step_ratio;  // of times that are rounded
    const double shortest = dice() < 0.3   ? 1.1 * shortest_step
                            : dice() < 0.4 ? 0.9 * longest_step / ratio
                                           : std::pow(10.0, dice.between(-18, 4));
    KeyframeData data{.times = times_at_limits(dice, count, shortest, shortest * ratio)};
    Eigen::Quaterniond q = dice() < 0.5 ? Eigen::Quaterniond::Identity() : Eigen::Quaterniond(0.5, 0.5, 0.5, 0.5);
    const Eigen::Quaterniond again = hard_step(dice);
    const bool same_steps = dice() < 0.4;
    for (std::size_t i = 0; i < count; ++i) {
      data.orientations.push_back(q);
      data.positions.push_back(largest_vector(dice));
      q = q * (same_steps ? again : hard_step(dice));
    }
    for (auto* rates : {&data.angular_velocities, &data.angular_accelerations, &data.angular_jerks}) {
      if (GetParam().rate_orders == 0 || dice() < 0.3) break;
      for (std::size_t i = 0; i < count; ++i) rates->push_back(largest_vector(dice));
    }
    return data;
  }

  [[nodiscard]] static CurveOptions options_at_limits(Dice& dice, const KeyframeData& data) {
    CurveOptions options;
    if (dice() < 0.5)
      for (const Parameter& p : GetParam().parameters)
        options.parameters[std::string(p.name)] = {border_value(dice, p)};
    for (const Choice& c : GetParam().choices) options.choices[std::string(c.name)] = one_of(dice, c.words);
    const double span = data.times.back() - data.times.front();
    if (GetParam().closes && dice() < 0.2) {
      options.loop = Loop{span + 0.5 * (data.times[1] - data.times[0])};
    } else if (!GetParam().ends.empty()) {
      for (End* end : {&options.start, &options.end}) {
        end->rule = one_of(dice, GetParam().ends);
        if (end->rule == EndRule::clamped) end->angular_velocity = largest_vector(dice);
      }
    }
    return options;
  }

  static void expect_finite(const PoseCurve& pose) {
    for (const double t : times_on(pose.orientation, 4))
      for (const Side side : {Side::left, Side::right}) {
        const Motion m = pose.orientation.motion(t, side);
        ASSERT_NEAR(m.orientation.norm(), 1.0, tolerance::algebra) << t;
        ASSERT_NEAR(pose.orientation(t).norm(), 1.0, tolerance::algebra) << t;
        ASSERT_TRUE(m.angular_velocity.allFinite()) << t;
        ASSERT_TRUE(m.angular_acceleration.allFinite()) << t;
        ASSERT_TRUE(m.angular_jerk.allFinite()) << t;
        if (!pose.position) continue;
        const LinearMotion p = pose.position->linear_motion(t, side);
        ASSERT_TRUE(p.position.allFinite() && p.velocity.allFinite()) << t;
        ASSERT_TRUE(p.acceleration.allFinite() && p.jerk.allFinite()) << t;
      }
  }
};

TEST_P(FiniteContract, AtTheLimitsOfWhatIsAdmitted) {
  constexpr std::uint64_t cases = 120;
  std::size_t made = 0;
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Dice dice(7919 * seed);
    const KeyframeData data = keys_at_limits(dice);
    const CurveOptions options = options_at_limits(dice, data);
    const auto keys = Keyframes::make(data, dice() < 0.7 ? Signs::as_given : Signs::shortest);
    ASSERT_TRUE(keys) << describe(keys.error());
    const auto pose = make_pose_curve({GetParam().name, options}, *keys);
    if (!pose) continue;
    ++made;
    expect_finite(*pose);
    if (HasFatalFailure()) return;
  }
  // `least` makes the fewest: 14 of 120.
  EXPECT_GE(made, GetParam().is_global() || GetParam().rate_orders > 0 ? cases / 10 : cases / 2);
}

TEST_P(FiniteContract, OnKeysThatTurnFullyWithSignsAsGiven) {
  const Eigen::Quaterniond q(0.5, 0.5, 0.5, 0.5), back(-0.5, -0.5, -0.5, -0.5),
      other = q * exp<double>(Eigen::Vector3d(0, 1, 0));
  for (const auto& four : {std::array{q, back, q, q}, std::array{q, back, q, back}, std::array{q, q, back, back},
                           std::array{q, back, other, other}, std::array{other, q, back, other}})
    for (const double tension : {0.0, 1.0}) {
      CurveOptions options;
      if (has_name(GetParam().parameters, "tension")) options.parameters["tension"] = {tension};
      const std::size_t count = use().cut(std::max<std::size_t>(4, use().keys_for(1)));
      KeyframeData data;
      for (std::size_t i = 0; i < count; ++i) {
        data.times.push_back(static_cast<double>(i));
        data.orientations.push_back(four.at(i % 4));
      }
      const auto made = make_pose_curve({GetParam().name, options}, keyframes(data, Signs::as_given));
      if (made) expect_finite(*made);
    }
}

TEST_P(FiniteContract, OnEvenStepsOfEveryLengthThatIsAdmitted) {
  for (const double step : {1.1 * shortest_step, 1e-9, 1.0, 1e9, 0.9 * longest_step}) {
    KeyframeData data = walk(16, 6, Spacing::even, 0.5);
    for (std::size_t i = 0; i < data.times.size(); ++i) data.times[i] = step * static_cast<double>(i);
    expect_finite(make_pose_curve(GetParam().name, keyframes(data)).value());
  }
}

ORISPLINE_FOR_EVERY_FAMILY(FiniteContract);

}}  // namespace orispline::contract
