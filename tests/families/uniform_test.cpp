// SPDX-License-Identifier: Apache-2.0
// The general uniform family: every order is as smooth as its number, and the papers' splines are members.
#include <gtest/gtest.h>

#include <families/same_curve.hpp>
#include <orispline/families/registry.hpp>
#include <support/near.hpp>
#include <support/relative_jumps.hpp>
#include <support/specimens.hpp>
#include <support/tolerance.hpp>
#include <support/typed_curves.hpp>

namespace orispline {

namespace {

using namespace testing_support;
using families::UniformFamily;
using Parameters = std::map<std::string, std::vector<double>, std::less<>>;

constexpr std::size_t key_count = 8;

/// Random tensions of every order at every key, of the size of those that the papers use.
Parameters random_tensions(std::size_t order, std::uint64_t seed) {
  Dice dice(seed);
  Parameters parameters{{"order", {static_cast<double>(order)}}};
  const std::array sizes{0.5, 1.0, 8.0, 20.0, 60.0};
  for (std::size_t m = 1; m <= order; ++m) {
    std::vector<double>& values = parameters["tension" + std::to_string(m)];
    for (std::size_t i = 0; i < key_count; ++i) values.push_back(sizes[m - 1] * dice.between(0.5, 1.5));
  }
  return parameters;
}

template <class Order>
class UniformOrder : public testing::Test {
 protected:
  static constexpr std::size_t order = Order::value;
  static auto typed(const Keyframes& keys, const CurveOptions& options) {
    const FamilySettings settings = settle(UniformFamily::info, options, keys.size()).value();
    return four_key_curve(keys, settings, uniform_basis<order>(settings)).value();
  }
};
using Orders = testing::Types<std::integral_constant<std::size_t, 1>, std::integral_constant<std::size_t, 2>,
                              std::integral_constant<std::size_t, 3>, std::integral_constant<std::size_t, 4>,
                              std::integral_constant<std::size_t, 5>>;
TYPED_TEST_SUITE(UniformOrder, Orders);

TYPED_TEST(UniformOrder, IsExactlyAsSmoothOnEvenTimes) {
  const Keyframes keys = keyframes(random_walk(311, key_count, Spacing::even));
  const auto jumps = relative_jumps<7>(TestFixture::typed(keys, {.parameters = random_tensions(this->order, 312)}));
  for (std::size_t k = 0; k <= this->order; ++k) EXPECT_LE(jumps[k], tolerance::continuity) << "order " << k;
  EXPECT_GE(jumps[this->order + 1], tolerance::visible_jump);
}

TYPED_TEST(UniformOrder, IsC0InTimeOnUnevenTimes) {
  const Keyframes keys = keyframes(random_walk(313, key_count, Spacing::uneven));
  const auto jumps = relative_jumps<7>(TestFixture::typed(keys, {.parameters = random_tensions(this->order, 314)}));
  EXPECT_LE(jumps[0], tolerance::continuity);
  EXPECT_GE(jumps[1], tolerance::visible_jump);
}

TYPED_TEST(UniformOrder, OfTheRegistryIsTheSameCurve) {
  const Keyframes keys = keyframes(random_walk(315, key_count, Spacing::uneven));
  const CurveOptions options{.parameters = random_tensions(this->order, 316)};
  const AnyCurve erased = make_curve({"uniform", options}, keys).value(), typed(TestFixture::typed(keys, options));
  for (const double t : sample_times(keys.times()))
    EXPECT_TRUE(near(erased.motion(t), typed.motion(t), {0.0, 0.0, 0.0, 0.0})) << t;
}

TYPED_TEST(UniformOrder, HasTheStatedDerivativesInSpace) {
  // p^(m) = t_m (P_{i+1} - P_{i-1}) for odd m, t_m (P_{i+1} - 2P_i + P_{i-1}) for even m, from either side.
  KeyframeData data = random_walk(317, key_count, Spacing::even);
  for (std::size_t i = 0; i < key_count; ++i) data.times[i] = static_cast<double>(i);
  Dice dice(318);
  for (std::size_t i = 0; i < key_count; ++i) data.positions.push_back(dice.vector());
  const Keyframes keys = keyframes(data);
  const Parameters parameters = random_tensions(this->order, 319);
  const FamilySettings settings = settle(UniformFamily::info, {.parameters = parameters}, key_count).value();
  const auto path =
      four_key_curve<Eigen::Vector3d>(keys, settings, uniform_basis<TestFixture::order>(settings)).value();
  for (std::size_t i = 1; i + 1 < key_count; ++i)
    for (const std::size_t segment : {i - 1, i}) {
      const auto p = path.point(Jet<double, 5>::variable(data.times[i]), segment);
      const auto &before = data.positions[i - 1], &here = data.positions[i], &after = data.positions[i + 1];
      for (std::size_t m = 1; m <= this->order; ++m) {
        const double tension = parameters.at("tension" + std::to_string(m))[i];
        Eigen::Vector3d difference = after - before;
        if (m % 2 == 0) difference = after - 2.0 * here + before;
        const Eigen::Vector3d found(p.x().derivative(m), p.y().derivative(m), p.z().derivative(m));
        EXPECT_TRUE(near(found, tension * difference, tolerance::rates)) << "key " << i << ", order " << m;
      }
    }
}

void expect_uniform_is(const char* family, const Parameters& parameters, const Parameters& of_the_family,
                       std::uint64_t seed) {
  const Keyframes keys = keyframes(random_walk(seed, key_count, Spacing::uneven));
  const AnyCurve wanted = make_curve({family, {.parameters = parameters}}, keys).value();
  const AnyCurve found = make_curve({"uniform", {.parameters = of_the_family}}, keys).value();
  for (const double t : sample_times(keys.times(), 7))
    for (const Side side : {Side::left, Side::right})
      EXPECT_TRUE(near(found.motion(t, side), wanted.motion(t, side), same_curve)) << family << " at " << t;
}

TEST(UniformFamily, OfOrderTwoWithEqualTensionsIsTansQuintic) {
  const std::vector<double> alpha{0.5, 0.6, 0.3, 0.45, 0.7, 0.2, 0.5, 0.55};
  expect_uniform_is("quintic", {{"tension", alpha}}, {{"order", {2}}, {"tension1", alpha}, {"tension2", alpha}}, 321);
}

TEST(UniformFamily, OfOrderThreeWithThePapersTensionsIsThe6thDegreeSpline) {
  const std::vector<double> beta{0.1, 0.08, 0.05, 0.12, 0.02, 0.09, 0.07, 0.11};
  std::vector<double> first, third;
  for (const double b : beta) {
    first.push_back(6.0 * b);
    third.push_back(30.0 - 360.0 * b);
  }
  expect_uniform_is("sextic", {{"tension", beta}},
                    {{"order", {3}}, {"tension1", first}, {"tension2", {2.5}}, {"tension3", third}}, 322);
}

TEST(UniformFamily, OfOrderThreeWithOneSpecialSetIsXingsQuintic) {
  expect_uniform_is("xing-quintic", {},
                    {{"order", {3}}, {"tension1", {5.0 / 16.0}}, {"tension2", {2.5}}, {"tension3", {11.25}}}, 323);
}

TEST(UniformFamily, OfOrderOneIsCatmullRomOnEvenTimes) {
  const Keyframes keys = keyframes(random_walk(324, key_count, Spacing::even));
  const CurveOptions options{.parameters = {{"order", {1}}}};
  const AnyCurve cubic = make_curve({"uniform", options}, keys).value();
  const AnyCurve timed = make_curve({"timed-c1", {.start = {EndRule::repeat}, .end = {EndRule::repeat}}}, keys).value();
  for (const double t : sample_times(keys.times(), 7))
    EXPECT_TRUE(near(cubic.motion(t), timed.motion(t), same_curve)) << t;
}

TEST(UniformFamily, DefaultsToOrderTwo) {
  expect_uniform_is("uniform", {{"order", {2}}, {"tension1", {0.5}}, {"tension2", {1.0}}}, {}, 325);
}

TEST(UniformFamily, HasSpecialTensionsThatLowerItsDegree) {
  const auto leading = [](auto order, std::vector<double> tensions) {
    constexpr std::size_t k = decltype(order)::value, degree = 2 * k + 1;
    UniformFamily::Basis<k> basis{
        [&]<std::size_t... M>(std::index_sequence<M...>)->std::array<PerKey, k>{return {PerKey({tensions.at(M)})...};
  }(std::make_index_sequence<k>{})
};
const Knots unit({0.0, 1.0});
double largest = 0.0;
for (const auto& function : basis(unit.span(0), Jet<double, degree>::variable(0.4)))
  largest = std::max(largest, std::abs(function.c[degree]));
return largest;
};
const std::integral_constant<std::size_t, 4> four;
const std::integral_constant<std::size_t, 5> five;
const double t3 = 8.0, t4 = -9.0, t5 = 40.0;
EXPECT_LE(leading(four, {0.5 - t3 / 42.0, 7.0 / 3.0 - t4 / 180.0, t3, t4}), tolerance::rates);
EXPECT_GT(leading(four, {0.5, 7.0 / 3.0 - t4 / 180.0, t3, t4}), 0.1);
EXPECT_LE(leading(five, {0.5 - t3 / 36.0 - t5 / 15120.0, 2.25 - t4 / 112.0, t3, t4, t5}), tolerance::rates);
}

TEST(UniformFamily, RefusesAnOrderThatIsNotAWholeNumber) {
  const Keyframes keys = keyframes(random_walk(326, 4, Spacing::even));
  const auto half = make_curve({"uniform", {.parameters = {{"order", {2.5}}}}}, keys);
  ASSERT_FALSE(half);
  EXPECT_EQ(half.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(half.error().message, "uniform: order is 2.5, wanted a whole number");
  for (const double order : {0.0, 6.0, -1.0}) {
    const auto refused = make_curve({"uniform", {.parameters = {{"order", {order}}}}}, keys);
    ASSERT_FALSE(refused) << order;
    EXPECT_EQ(refused.error().message,
              "uniform: order is " + std::to_string(static_cast<int>(order)) + ", wanted 1 to 5");
  }
  const auto each = make_curve({"uniform", {.parameters = {{"order", {2, 2, 2, 3}}}}}, keys);
  ASSERT_FALSE(each);
  EXPECT_EQ(each.error().message, "uniform: found 4 values of order, wanted 1");
}

}  // namespace

}  // namespace orispline
