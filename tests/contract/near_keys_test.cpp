// SPDX-License-Identifier: Apache-2.0
// Contract: keys that differ by little give curves that differ by little, also where the body rests and what a method
// divides by is as small as the difference.
#include <contract/family_contract.hpp>

namespace orispline::contract { namespace {

using namespace testing_support;

constexpr double rounding = std::numeric_limits<double>::epsilon();
constexpr double largest_response = 1e3;  // 470 for the rates that hermite-c3 takes from uneven keys

class NearKeysContract : public FamilyContract {
 protected:
  static constexpr std::uint64_t walks = 40;

  /// Moving and resting by turns, at times that are even, or uneven by a ratio of up to 20. A few are long enough for
  /// what `measured` finds of keys.
  [[nodiscard]] static Keyframes stop_and_go(std::uint64_t seed) {
    Dice dice(seed);
    const std::size_t count = use().keys_for(seed % 8 == 7 ? 30 : 3 + seed % 12);
    KeyframeData data;
    double t = 0.0, resting = 0.0;
    Eigen::Quaterniond q = exp<double>(2.0 * dice.vector());
    for (std::size_t i = 0; i < count; ++i) {
      data.times.push_back(t);
      data.orientations.push_back(q);
      t += seed % 3 == 0 ? 0.5 : std::exp(dice.between(-1.5, 1.5));
      if (resting > 0.0) resting -= 1.0;
      else if (dice() < 0.3) resting = 1.0 + std::floor(6.0 * dice());
      const double turn = std::min(1.5, GetParam().key_use.widest_turn) * dice.between(0.05, 1.0);
      const Eigen::Vector3d axis = dice.vector().normalized();
      if (!(resting > 0.0)) q = q * exp<double>(turn * axis);
    }
    return keyframes(std::move(data), Signs::shortest);
  }

  /// Keys of which each is turned from the right by what `turn` gives.
  template <class Turn>
  [[nodiscard]] static Keyframes disturbed(const Keyframes& keys, Turn turn) {
    KeyframeData data{.times = {keys.times().begin(), keys.times().end()}};
    for (const Eigen::Quaterniond& q : keys.orientations()) data.orientations.push_back((q * turn()).normalized());
    return keyframes(std::move(data));
  }

  /// Two keys that are nearer to each other tell no circle, and from there on the step between them decides which way
  /// it sets out: docs/families/circular.md, "The limit". Turns that point aside by 1e-6 have no longer one axis, about
  /// which what goes on for ten steps winds: docs/families/barry-goldman.md.
  [[nodiscard]] static double largest_noise() {
    return GetParam().name == "circular" || GetParam().name == "barry-goldman" ? 1e-8 : 1e-6;
  }

  [[nodiscard]] static double distance(const AnyCurve& a, const AnyCurve& b, const Eigen::Quaterniond& turn) {
    double largest = 0.0;
    for (const double t : times_on(a, 7)) largest = std::max(largest, angular_distance(turn * a(t), b(t)));
    return largest;
  }
};

TEST_P(NearKeysContract, NoiseInRestsMovesTheCurveInProportion) {
  for (std::uint64_t seed = 0; seed < walks; ++seed) {
    const Keyframes keys = stop_and_go(seed);
    const auto still = make_curve(GetParam().name, keys);
    if (!still && may_refuse(GetParam())) continue;
    ASSERT_TRUE(still) << describe(still.error());
    Dice dice(1000 + seed);
    for (double noise = 1e-16; noise < 1.5 * largest_noise(); noise *= 10.0) {
      const AnyCurve noisy = curve(disturbed(keys, [&] { return exp<double>(noise * dice.vector()); }));
      EXPECT_LE(distance(*still, noisy, Eigen::Quaterniond::Identity()), largest_response * (noise + rounding))
          << "walk " << seed << ", noise " << noise;
    }
  }
}

TEST_P(NearKeysContract, TurningTheWorldTurnsTheCurveThroughRests) {
  const Eigen::Quaterniond world = exp<double>(Eigen::Vector3d(1.3, -2.1, 0.4));
  for (std::uint64_t seed = 0; seed < walks; ++seed) {
    const Keyframes keys = stop_and_go(seed);
    Dice dice(2000 + seed);
    for (const double noise : {0.0, 1e-16, 1e-12, 1e-8}) {
      const Keyframes rough = disturbed(keys, [&] { return exp<double>(noise * dice.vector()); });
      KeyframeData turned{.times = {keys.times().begin(), keys.times().end()}};
      for (const Eigen::Quaterniond& q : rough.orientations()) turned.orientations.push_back((world * q).normalized());
      const auto before = make_curve(GetParam().name, rough);
      if (!before && may_refuse(GetParam())) continue;
      ASSERT_TRUE(before) << describe(before.error());
      EXPECT_LE(distance(*before, curve(keyframes(std::move(turned))), world), tolerance::series)
          << "walk " << seed << ", noise " << noise;
    }
  }
}

ORISPLINE_FOR_EVERY_FAMILY(NearKeysContract);

}}  // namespace orispline::contract
