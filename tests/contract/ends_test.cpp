// SPDX-License-Identifier: Apache-2.0
// Contract: the rule of the start acts at the start and that of the end at the end, whatever the other one is.
#include <contract/family_contract.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

/// An end by that rule; the rates of the two ends differ.
End start_by(EndRule rule) {
  return {.rule = rule,
          .angular_velocity = rule == EndRule::clamped ? Eigen::Vector3d(0.4, -0.3, 0.2) : Eigen::Vector3d::Zero()};
}
End end_by(EndRule rule) {
  return {.rule = rule,
          .angular_velocity = rule == EndRule::clamped ? Eigen::Vector3d(-0.1, 0.5, 0.3) : Eigen::Vector3d::Zero()};
}

/// Two names of one rule where no key is missing beyond the neighbour.
bool are_one_rule(EndRule a, EndRule b) {
  const auto continues = [](EndRule rule) { return rule == EndRule::natural || rule == EndRule::reflect; };
  return a == b || (continues(a) && continues(b));
}

class EndContract : public FamilyContract {
 protected:
  [[nodiscard]] static AnyCurve curve_by(const Keyframes& keys, EndRule start, EndRule end) {
    return curve(keys, {.start = start_by(start), .end = end_by(end)});
  }
  /// Times within the first or the last segment.
  [[nodiscard]] static std::vector<double> times_in(const AnyCurve& c, std::size_t segment) {
    return sample_times(c.knots().times().subspan(segment, 2), 4);
  }
  [[nodiscard]] static double distance(const AnyCurve& a, const AnyCurve& b, std::size_t segment) {
    double largest = 0.0;
    for (const double t : times_in(a, segment)) largest = std::max(largest, angular_distance(a(t), b(t)));
    return largest;
  }

  /// What a curve that solves equations misses its rule by at an end: its rate, or the acceleration that it must not
  /// have; `secant` is the rate of the increment there.
  [[nodiscard]] static double missed(const Motion& m, const End& end, const Eigen::Vector3d& secant) {
    switch (end.rule) {
      case EndRule::natural:
        return m.angular_acceleration.norm();
      case EndRule::secant:
        return (m.angular_velocity - secant).norm();
      default:
        return (m.angular_velocity - end.angular_velocity).norm();
    }
  }
};

TEST_P(EndContract, EachRuleActsAtItsOwnEndOfALocalCurve) {
  if (GetParam().is_global()) return;
  const Keyframes keys = keyframes(walk(17, 9, Spacing::uneven, 0.8));
  for (const EndRule a : GetParam().ends)
    for (const EndRule b : GetParam().ends) {
      const AnyCurve mixed = curve_by(keys, a, b), of_a = curve_by(keys, a, a), of_b = curve_by(keys, b, b);
      const std::size_t last = mixed.knots().segments() - 1;
      EXPECT_EQ(distance(mixed, of_a, 0), 0.0) << name_of(a) << ", " << name_of(b);
      EXPECT_EQ(distance(mixed, of_b, last), 0.0) << name_of(a) << ", " << name_of(b);
      if (are_one_rule(a, b)) continue;
      EXPECT_GT(distance(mixed, of_b, 0), tolerance::visible_jump) << name_of(a) << ", " << name_of(b);
      EXPECT_GT(distance(mixed, of_a, last), tolerance::visible_jump) << name_of(a) << ", " << name_of(b);
    }
}

TEST_P(EndContract, EachRuleActsAtItsOwnEndOfASolvedCurve) {
  if (!GetParam().is_global()) return;
  const KeyframeData data = walk(18, 7, Spacing::even, 0.8);
  const Keyframes keys = keyframes(data);
  const auto q = keys.orientations();
  const std::size_t last = q.size() - 1;
  const double h = data.times[1] - data.times[0];
  const Eigen::Vector3d first_secant = increment<double>(q[0], q[1]) / h,
                        last_secant = increment<double>(q[last - 1], q[last]) / h;
  for (const EndRule a : GetParam().ends)
    for (const EndRule b : GetParam().ends) {
      const AnyCurve mixed = curve_by(keys, a, b);
      const Motion start = mixed.motion(data.times.front()), end = mixed.motion(data.times.back());
      EXPECT_LE(missed(start, start_by(a), first_secant), tolerance::rates) << name_of(a) << ", " << name_of(b);
      EXPECT_LE(missed(end, end_by(b), last_secant), tolerance::rates) << name_of(a) << ", " << name_of(b);
    }
}

ORISPLINE_FOR_EVERY_FAMILY(EndContract);

}}  // namespace orispline::contract
