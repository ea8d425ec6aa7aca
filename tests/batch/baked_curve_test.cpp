// SPDX-License-Identifier: Apache-2.0
// Baked curves stay within their tolerance, whatever the curve is.

#include <batch/agreement.hpp>
#include <batch/baked_rates.hpp>
#include <batch/specimen_curves.hpp>
#include <curve/counting_new.hpp>
#include <support/follower.hpp>
#include <support/not_finite.hpp>
#include <support/tracks.hpp>

namespace orispline { namespace {

using namespace testing_support;

/// Twice the largest distance in R⁴ from the curve's own quaternions, signs and all, at many times of every segment.
template <class T>
double largest_difference(const BakedCurve<T>& baked, const AnyCurve& curve, std::size_t per_segment = 97) {
  double largest = 0.0;
  const Knots& knots = curve.knots();
  for (const double knot : knots.times())
    largest = std::max(largest, 2.0 * (baked(knot).coeffs().template cast<double>() - curve(knot).coeffs()).norm());
  for (std::size_t i = 0; i < knots.segments(); ++i)
    for (std::size_t k = 1; k < per_segment; ++k) {
      const double t =
          knots.span(i).start() + knots.span(i).step() * static_cast<double>(k) / static_cast<double>(per_segment);
      const double off = 2.0 * (baked(t).coeffs().template cast<double>() - curve(t).coeffs()).norm();
      if (!(off <= largest)) largest = off;
    }
  return largest;
}

TEST(BakedCurve, OfEveryFamilyIsWithinItsTolerance) {
  for (const std::uint64_t seed : {111U, 112U})
    for (const auto& [name, curve] : curve_of_every_family(seed))
      for (const double tolerance : {1e-6, 1e-9, 1e-12}) {
        SCOPED_TRACE(name);
        const auto baked = bake(curve, tolerance);
        ASSERT_TRUE(baked) << describe(baked.error());
        EXPECT_LE(largest_difference(*baked, curve), tolerance);
        EXPECT_LE(baked->largest_difference(), 0.5 * tolerance);
        EXPECT_LE(baked->knots().segments(), 64 * curve.knots().segments());
      }
}

TEST(BakedCurve, InFloatIsWithinItsTolerance) {
  for (const auto& [name, curve] : curve_of_every_family(113))
    for (const double tolerance : {1e-6, 1e-4}) {
      SCOPED_TRACE(name);
      const auto baked = bake<float>(curve, tolerance);
      ASSERT_TRUE(baked) << describe(baked.error());
      EXPECT_LE(largest_difference(*baked, curve), tolerance);
    }
}

TEST(BakedCurve, AtItsLeastToleranceExistsForEveryFamily) {
  for (const auto& [name, curve] : curve_of_every_family(114)) {
    SCOPED_TRACE(name);
    const auto baked = bake(curve, least_bake_tolerance<double>);
    ASSERT_TRUE(baked) << describe(baked.error());
    EXPECT_LE(largest_difference(*baked, curve), least_bake_tolerance<double>);
  }
}

TEST(BakedCurve, TakesMorePiecesWhereTheToleranceIsSmaller) {
  const AnyCurve curve = specimen_curve("squad");
  const auto pieces = [&](double tolerance) { return bake(curve, tolerance)->knots().segments(); };
  EXPECT_EQ(pieces(1.0), curve.knots().segments());
  EXPECT_LT(pieces(1e-6), pieces(1e-9));
  EXPECT_LT(pieces(1e-9), pieces(1e-12));
}

TEST(BakedCurve, OfALoopOrWithLargeAnglesIsWithinItsTolerance) {
  CurveOptions loop;
  const KeyframeData walk = random_walk(115, 9, Spacing::uneven);
  loop.loop = Loop{.period = walk.times.back() - walk.times.front() + 1.0};
  CurveOptions tense;
  tense.parameters.emplace("tension", std::vector{20.0});
  const Keyframes keys = keyframes(walk);
  std::vector<AnyCurve> curves{make_curve({"quintic", tense}, keys).value()};
  for (const FamilyInfo& family : families_info())
    if (family.closes)
      if (auto closed = make_curve({family.name, loop}, keys)) curves.push_back(*std::move(closed));
  EXPECT_GT(curves.size(), 5U);
  for (const AnyCurve& curve : curves) {
    const auto baked = bake(curve, 1e-10);
    ASSERT_TRUE(baked) << describe(baked.error());
    EXPECT_LE(largest_difference(*baked, curve), 1e-10);
  }
}

TEST(BakedCurve, AtLargeTimesIsWithinItsTolerance) {
  for (const double scale : {1.0, 1e-3}) {  // keys a second or a millisecond apart, that is some 4000 doubles
    KeyframeData data = random_walk(117, 12, Spacing::uneven, 0.7);
    for (double& t : data.times) t = 1.7e9 + scale * t;
    for (const char* name : {"timed-c2", "squad", "auto"}) {
      const AnyCurve curve = make_curve(name, keyframes(data)).value();
      const auto baked = bake(curve, 1e-11);
      ASSERT_TRUE(baked) << name << ": " << describe(baked.error());
      EXPECT_LE(largest_difference(*baked, curve), 1e-11) << name;
    }
  }
}

TEST(BakedCurve, RefusesTolerancesThatCannotBe) {
  const AnyCurve curve = specimen_curve("squad");
  for (const double tolerance : {0.0, -1e-6, 9e-14, nan, infinity, -infinity}) {
    const auto baked = bake(curve, tolerance);
    ASSERT_FALSE(baked) << tolerance;
    EXPECT_EQ(baked.error().code, ErrorCode::bad_argument);
    EXPECT_NE(baked.error().message.find("wanted a number from 1e-13 on"), std::string::npos) << baked.error().message;
  }
  EXPECT_FALSE(bake<float>(curve, 9e-7));
  EXPECT_NE(bake<float>(curve, 0.0).error().message.find("wanted a number from 1e-06 on"), std::string::npos);
}

/// Jumps within its only segment, where no polynomials can follow.
class JumpingCurve {
 public:
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t) const noexcept {
    return constant<T>(value_of(t) < 0.3 ? Eigen::Quaterniond::Identity() : Eigen::Quaterniond(0.0, 1.0, 0.0, 0.0));
  }

 private:
  Knots knots_{{0.0, 1.0}};
};

/// Five keys of which two are close, so that the curve between them is hard to follow.
Keyframes close_keys(double ratio) {
  KeyframeData data = random_walk(91, 5, Spacing::even);
  data.times = {0.0, 1.0, 1.0 + 1.0 / ratio, 2.0, 3.0};
  return keyframes(data);
}

TEST(BakedCurve, HasAsManyPiecesAsAreAllowedAndNoMore) {
  const AnyCurve curve = make_curve("auto", close_keys(100.0)).value();
  const std::size_t needed = bake(curve, 1e-6)->knots().segments();
  EXPECT_EQ(bake(curve, 1e-6, {.max_pieces = needed})->knots().segments(), needed);
  const auto fewer = bake(curve, 1e-6, {.max_pieces = needed - 1});
  ASSERT_FALSE(fewer);
  EXPECT_EQ(fewer.error().where.key, 3U);
  EXPECT_FALSE(bake<float>(curve, 1e-6, {.max_pieces = 4}));
}

TEST(BakedCurve, NamesTheSegmentAndTheLimitBeforeMemoryGoes) {
  const auto baked = bake("auto", close_keys(3e5), 1e-6, {.max_pieces = 2000});
  ASSERT_FALSE(baked);
  EXPECT_EQ(baked.error().code, ErrorCode::bad_argument);
  EXPECT_LE(baked.error().where.key.value(), 2U);
  EXPECT_TRUE(baked.error().message.starts_with("the 2000 pieces that are allowed reach to ")) << baked.error().message;
  EXPECT_TRUE(baked.error().message.ends_with(
      " s, wanted the end of the curve: ask for a larger tolerance, or a curve that turns less there"));
  EXPECT_EQ(BakeOptions{}.max_pieces, 1U << 20);
}

TEST(BakedCurve, NamesTheSegmentWhereTheToleranceCannotBeReached) {
  const auto baked = bake(AnyCurve(JumpingCurve()), 1e-3);
  ASSERT_FALSE(baked);
  EXPECT_EQ(baked.error().code, ErrorCode::bad_argument);
  EXPECT_EQ(baked.error().where.key, 0U);
  EXPECT_NE(baked.error().message.find("even the shortest piece reaches"), std::string::npos) << baked.error().message;
}

/// The tolerance that an error of `bake` asks for [rad].
double tolerance_in(const std::string& message) {
  const std::size_t at = message.find("ask for ");
  EXPECT_NE(message.find(" rad or more, which all of the curve keeps to"), std::string::npos) << message;
  return std::stod(message.substr(at + 8));
}

template <class T>
void expect_a_tolerance_that_works(const AnyCurve& curve, double tolerance) {
  const auto refused = bake<T>(curve, tolerance);
  ASSERT_FALSE(refused) << tolerance;
  const double offered = tolerance_in(refused.error().message);
  EXPECT_GT(offered, tolerance);
  const auto baked = bake<T>(curve, offered);
  ASSERT_TRUE(baked) << offered << ", " << baked.error().message;
  EXPECT_LE(2.0 * baked->largest_difference(), offered);
}

/// Jumps by 0.1 rad, later by 0.3 rad.
class TwiceJumpingCurve {
 public:
  [[nodiscard]] const Knots& knots() const noexcept { return knots_; }
  template <Number T>
  [[nodiscard]] Quaternion<T> point(const T& t, std::size_t) const noexcept {
    const double angle = value_of(t) < 0.3 ? 0.0 : value_of(t) < 1.3 ? 0.1 : 0.4;
    return constant<T>(Eigen::Quaterniond(std::cos(0.5 * angle), std::sin(0.5 * angle), 0.0, 0.0));
  }

 private:
  Knots knots_{{0.0, 1.0, 2.0}};
};

TEST(BakedCurve, NamesAToleranceThatAllOfTheCurveKeepsTo) {
  for (const double tolerance : {1e-3, 1e-2, 0.05}) {
    expect_a_tolerance_that_works<double>(AnyCurve(TwiceJumpingCurve()), tolerance);
    expect_a_tolerance_that_works<float>(AnyCurve(TwiceJumpingCurve()), tolerance);
  }
  for (const double ratio : {5e7, 7e7})
    expect_a_tolerance_that_works<float>(make_curve("rational", close_keys(ratio)).value(), 1e-6);
}

TEST(BakedCurve, OffersNoToleranceWhereItKnowsNone) {
  for (const AnyCurve& curve : {make_curve("timed-c2", close_keys(1e9)).value(), AnyCurve(JumpingCurve())}) {
    const auto baked = bake<float>(curve, 1e-6);
    ASSERT_FALSE(baked);
    EXPECT_TRUE(baked.error().message.ends_with("ask for a much larger tolerance, or a curve that turns less there"))
        << baked.error().message;
  }
}

template <class T>
void expect_the_same_by_every_door(const AnyCurve& curve) {
  const BakedCurve<T> baked = bake<T>(curve, 1e-6).value();
  constexpr std::size_t count = 1000;
  const double start = curve.domain().start, length = curve.domain().end - start;
  const double dt = 1.02 * length / count, t0 = start - 0.01 * length;
  std::vector<double> times;
  for (std::size_t k = 0; k < count; ++k) times.push_back(static_cast<double>(k) * dt + t0);
  Sampled<T> given(count, Wanted::jerk), even = given, any = given, threads = given;
  Sampled<T> planar(count, Wanted::jerk, Layout::planar);
  const std::size_t before = allocations_of_this_thread();
  EXPECT_TRUE(sample<T>(baked, times, given.spans()));
  EXPECT_TRUE(sample_uniform<T>(baked, t0, dt, even.spans()));
  EXPECT_TRUE(sample_at<T>(baked, times, any.spans()));
  EXPECT_TRUE(sample<T>(baked, times, planar.spans()));
  EXPECT_EQ(allocations_of_this_thread(), before);
  EXPECT_TRUE(sample<T>(baked, times, threads.spans(), {.threads = 2}));
  EXPECT_TRUE(even.same_bits(given));
  EXPECT_TRUE(any.same_bits(given));
  EXPECT_TRUE(threads.same_bits(given));
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(planar.orientation(i), given.orientation(i)) << i;
    EXPECT_EQ(planar.velocity(i), given.velocity(i)) << i;
    EXPECT_EQ(planar.acceleration(i), given.acceleration(i)) << i;
    EXPECT_EQ(planar.jerk(i), given.jerk(i)) << i;
    EXPECT_EQ(baked(times[i]).coeffs().template cast<double>(), given.orientation(i)) << i;
  }
}

TEST(BakedCurve, GivesTheSameBitsByEveryDoorAndAllocatesNothing) {
  for (const char* kind : kinds_of_curves) {
    SCOPED_TRACE(kind);
    expect_the_same_by_every_door<double>(specimen_curve(kind));
    expect_the_same_by_every_door<float>(specimen_curve(kind));
  }
}

TEST(BakedCurve, HoldsItsEndsAndAnswersNaNByNaN) {
  const AnyCurve curve = specimen_curve("squad");
  const BakedCurve<> baked = bake(curve, 1e-9).value();
  const auto [start, end] = baked.domain();
  for (const double t : {-infinity, start - 1.0, std::nextafter(start, -infinity)})
    EXPECT_EQ(baked(t).coeffs(), baked(start).coeffs()) << t;
  for (const double t : {infinity, end + 1.0, std::nextafter(end, infinity)})
    EXPECT_EQ(baked(t).coeffs(), baked(end).coeffs()) << t;
  EXPECT_TRUE(baked(nan).coeffs().array().isNaN().all());
}

TEST(BakedCurve, OfOneKeyIsThatKey) {
  const KeyframeData data = random_walk(119, 1, Spacing::even);
  const BakedCurve<> baked = bake(make_curve("squad", keyframes(data)).value(), 1e-9).value();
  for (const double t : {-infinity, data.times[0] - 1.0, data.times[0], data.times[0] + 1.0, infinity})
    EXPECT_EQ(baked(t).coeffs(), data.orientations[0].coeffs()) << t;
}

TEST(BakedCurve, IsAtRestBeyondItsEndsAndHasNoRatesAtTimesThatAreNoNumbers) {
  const BakedCurve<> baked = bake(specimen_curve("squad"), 1e-9).value();
  const auto [start, end] = baked.domain();
  const std::vector<double> times{start - 1.0, start, end, end + 1.0, nan};
  Sampled<double> samples(times.size(), Wanted::jerk);
  ASSERT_TRUE(sample_at<double>(baked, times, samples.spans()));
  for (const std::size_t i : {0U, 3U}) {
    EXPECT_EQ(samples.velocity(i), Eigen::Vector3d::Zero()) << i;
    EXPECT_EQ(samples.acceleration(i), Eigen::Vector3d::Zero()) << i;
    EXPECT_EQ(samples.jerk(i), Eigen::Vector3d::Zero()) << i;
  }
  for (const std::size_t i : {1U, 2U}) EXPECT_GT(samples.velocity(i).norm(), 0.1) << i;
  EXPECT_TRUE(samples.velocity(4).array().isNaN().all() && samples.acceleration(4).array().isNaN().all() &&
              samples.jerk(4).array().isNaN().all());
}

template <class T>
void expect_rates(const AnyCurve& curve, double tolerance, bool jerk_jumps_inside) {
  const Eigen::Array3d found = largest_rate_differences<T>(curve, tolerance);
  Eigen::Array3d allowed = allowed_rate_differences<T>();
  if (jerk_jumps_inside) allowed[2] = infinity;
  EXPECT_TRUE((found <= allowed).all()) << found.transpose() << " at " << tolerance;
}

TEST(BakedCurve, HasRatesAsFarFromTheCurvesOwnAsItsToleranceAndItsPiecesLet) {
  for (const std::uint64_t seed : {111U, 116U})
    for (const auto& [name, curve] : curve_of_every_family(seed)) {
      SCOPED_TRACE(name);
      const bool in_pieces = name == "least";  // which join within a segment, C²
      for (const double tolerance : {1e-6, 1e-9, 1e-12}) expect_rates<double>(curve, tolerance, in_pieces);
      for (const double tolerance : {1e-6, 1e-4}) expect_rates<float>(curve, tolerance, in_pieces);
    }
}

TEST(BakedCurve, IsTheSameFromAMethodAndKeysAsFromTheirCurve) {
  const Keyframes keys = keyframes(random_walk(118, 9, Spacing::uneven, 0.7));
  const Method method{"quintic", {.parameters = {{"tension", {0.4}}}}};
  const BakedCurve<> a = bake(method, keys, 1e-9).value(), b = bake(make_curve(method, keys).value(), 1e-9).value();
  EXPECT_EQ(a.knots().segments(), b.knots().segments());
  EXPECT_EQ(a(1.234).coeffs(), b(1.234).coeffs());
  const auto refused = bake("no-such-method", keys, 1e-9);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::bad_argument);
}

TEST(BakedCurve, IsFollowedAndStopped) {
  const AnyCurve curve = specimen_curve("squad", 51, 41);
  expect_to_be_followed_and_stopped([&](const Progress& progress) { return bake(curve, 1e-9, {}, progress); });
}

}}  // namespace orispline
