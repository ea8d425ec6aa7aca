// SPDX-License-Identifier: Apache-2.0
// Contract: on wide steps at very uneven times, where curves wind, no frame is special and nothing jumps. A curve that
// winds so far that rounding would decide its orientation is refused.
#include <functional>

#include <contract/family_contract.hpp>
#include <support/jump_search.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

constexpr double most_rounding = 1e-6;  // of an orientation that is millions of turns away from its key [rad]

class UnevenStepsContract : public FamilyContract {
 protected:
  using Claim = std::function<void(const KeyframeData&, const AnyCurve&)>;

  /// Calls it with keys of ten to 170 degrees a step, whose times are uneven by a thousand, or by a million, and with
  /// their curve.
  static void expect_on_uneven_steps(const Claim& claim) {
    const bool solves = GetParam().is_global();  // it takes its time for keys that have no solution
    for (const double ratio : {solves ? 1e1 : 1e6, 1e3})
      for (std::uint64_t seed = 1; seed <= (solves ? 2U : 8U); ++seed) {
        SCOPED_TRACE(testing::Message() << "ratio " << ratio << ", seed " << seed);
        const KeyframeData data = keys_at(seed, ratio);
        if (const auto curve = curve_or_refusal(data)) claim(data, *curve);
      }
  }

  /// Methods that solve equations may find no solution, and rates may wind a curve too far.
  [[nodiscard]] static Expected<AnyCurve> curve_or_refusal(const KeyframeData& data) {
    auto made = make_curve(GetParam().name, keyframes(data, Signs::shortest));
    if (!made) {
      EXPECT_TRUE(made.error().code == ErrorCode::not_converged || is_wound_too_far(GetParam(), made.error()))
          << describe(made.error());
    }
    return made;
  }

 private:
  [[nodiscard]] static KeyframeData keys_at(std::uint64_t seed, double ratio) {
    Dice dice(7919 * seed);
    KeyframeData data;
    double t = 0.0;
    Eigen::Quaterniond q = exp<double>(2.0 * dice.vector());
    for (std::size_t i = 0; i < use().keys_for(7); ++i) {
      data.times.push_back(t);
      data.orientations.push_back(q);
      t += std::pow(ratio, dice.between(-0.5, 0.5));
      const Eigen::Vector3d axis = dice.vector().normalized();
      q = q * exp<double>(pi / 180.0 * dice.between(10.0, 170.0) * axis);
    }
    return data;
  }
};

TEST_P(UnevenStepsContract, TurningTheWorldOrTheBodyTurnsTheCurve) {
  const Eigen::Quaterniond none = Eigen::Quaterniond::Identity(), other = exp<double>(Eigen::Vector3d(1.3, -2.1, 0.4));
  expect_on_uneven_steps([&](const KeyframeData& data, const AnyCurve& curve) {
    for (const auto& [left, right] : {std::pair(other, none), std::pair(none, other)}) {
      KeyframeData turned = data;
      for (Eigen::Quaterniond& q : turned.orientations) q = left * q * right;
      const auto same = curve_or_refusal(turned);
      if (!same) continue;
      double farthest = 0.0;
      for (const double t : times_on(curve, 12))
        farthest = std::max(farthest, angular_distance(left * curve(t) * right, (*same)(t)));
      EXPECT_LE(farthest, most_rounding);
    }
  });
}

TEST_P(UnevenStepsContract, NothingJumps) {
  expect_on_uneven_steps([](const KeyframeData&, const AnyCurve& curve) { EXPECT_TRUE(JumpSearch(curve)()); });
}

ORISPLINE_FOR_EVERY_FAMILY(UnevenStepsContract);

}}  // namespace orispline::contract
