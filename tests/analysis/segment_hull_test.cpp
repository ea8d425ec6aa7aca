// SPDX-License-Identifier: Apache-2.0
#include <orispline/analysis/segment_hull.hpp>

#include <random>

#include <gtest/gtest.h>

#include <orispline/base/formatted.hpp>
#include <orispline/curve/motion.hpp>
#include <orispline/math/bernstein.hpp>

namespace orispline { namespace {

constexpr double segment_duration = 1.7;  // [s]
using Time = Jet<double, 3>;

/// u as a function of time.
Time at(double u) {
  Time t(u);
  t.c[1] = 1.0 / segment_duration;
  return t;
}

Time value(const BernsteinForm& form, std::size_t degree, double u) {
  // de Casteljau's algorithm in Taylor arithmetic, unlike the hull's
  std::array<Time, form_degree + 1> c;
  for (std::size_t i = 0; i <= degree; ++i) c[i] = Time(form.coefficients[i]);
  for (std::size_t r = 1; r <= degree; ++r)
    for (std::size_t i = 0; i + r <= degree; ++i) c[i] = (Time(1.0) - at(u)) * c[i] + at(u) * c[i + 1];
  return c[0];
}

Motion motion_of(const SegmentForm& form, double u) {
  Quaternion<Time> q = constant<Time>(Eigen::Quaterniond::Identity());
  if (const auto* chart = std::get_if<ChartForm>(&form)) {
    Vector3<Time> p;
    for (std::size_t axis = 0; axis < 3; ++axis)
      p[static_cast<Eigen::Index>(axis)] = value(chart->rotation_vector[axis], chart->degree, u);
    return motion_from_jet(exp<Time>(p));
  }
  if (const auto* rational = std::get_if<RationalForm>(&form)) {
    Vector4<Time> s;
    for (std::size_t k = 0; k < 4; ++k)
      s[static_cast<Eigen::Index>(k)] = value(rational->components[k], RationalForm::degree, u);
    return motion_from_jet(Quaternion<Time>(Vector4<Time>(s / sqrt_of(Time(s.squaredNorm())))));
  }
  const auto& product = std::get<CumulativeForm>(form);
  for (std::size_t k = 0; k < 3; ++k) {
    const Time b = value(product.blending[k], product.degree, u);
    q = q * exp<Time>(Vector3<Time>(constant<Time>(product.increments[k]) * b));
  }
  return motion_from_jet(q);
}

const Eigen::Vector3d common_axis(0.48, -0.6, 0.64);

/// Segments that turn by about so many radians.
class Forms {
 public:
  explicit Forms(unsigned seed) : generator_(seed) {}
  SegmentForm product(double turn) {
    CumulativeForm form{.degree = 7, .base = Eigen::Quaterniond::Identity(), .increments = {}, .blending = {}};
    for (auto& phi : form.increments) phi = turn * Eigen::Vector3d(number(), number(), number());
    for (auto& row : form.blending) row = polynomial(7, 1.0);
    return form;
  }
  SegmentForm chart(double turn) {
    ChartForm form{.degree = 5, .base = Eigen::Quaterniond::Identity(), .rotation_vector = {}};
    for (auto& row : form.rotation_vector) row = polynomial(5, turn);
    return form;
  }
  /// About axes that are no farther apart than `aside`.
  SegmentForm winding_product(double turn, double aside) {
    SegmentForm form = product(0.0);
    for (auto& phi : std::get<CumulativeForm>(form).increments)
      phi = turn * number() * (common_axis + aside * Eigen::Vector3d(number(), number(), number()));
    return form;
  }
  SegmentForm winding_chart(double turn, double aside) {
    SegmentForm form = chart(turn * aside);
    const BernsteinForm angle = polynomial(5, 0.1 * turn);
    auto& p = std::get<ChartForm>(form).rotation_vector;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (std::size_t i = 0; i <= 5; ++i)
        p[axis].coefficients[i] += common_axis[static_cast<Eigen::Index>(axis)] * (turn + angle.coefficients[i]);
    return form;
  }
  /// Of a curve of R⁴ that winds about a point at distance 1.
  SegmentForm rational(double size) {
    RationalForm form;
    for (auto& row : form.components) row = polynomial(RationalForm::degree, size);
    for (std::size_t i = 0; i <= RationalForm::degree; ++i) form.components[3].coefficients[i] += 1.0;
    return form;
  }

 private:
  double number() { return symmetric_(generator_); }
  BernsteinForm polynomial(std::size_t degree, double size) {
    BernsteinForm form;
    for (std::size_t i = 0; i <= degree; ++i) form.coefficients[i] = size * number();
    return form;
  }
  std::mt19937 generator_;
  std::uniform_real_distribution<double> symmetric_{-1.0, 1.0};
};

void expect_above(const SegmentForm& form, const std::string& what) {
  const SegmentHull hull = SegmentHull::of(form, segment_duration).value();
  for (const auto& [start, end] : {std::pair(0.0, 1.0), {0.0, 0.25}, {0.6, 0.7}, {0.99, 1.0}, {0.371, 0.372}}) {
    const HullBounds bounds = hull.on(start, end);
    const double step = (end - start) / 200.0 * segment_duration, rounding = hull.rounding(hull.on(0.0, 1.0)).jerk;
    std::array<Eigen::Vector3d, 3> jerks;
    jerks.fill(motion_of(form, start).angular_jerk);
    for (int i = 0; i <= 200; ++i) {
      const Motion m = motion_of(form, std::lerp(start, end, i / 200.0));
      jerks = {jerks[1], jerks[2], m.angular_jerk};
      ASSERT_LE((jerks[2] - jerks[1]).norm(), bounds.snap * step * (1.0 + 1e-9) + rounding) << what << start;
      if (i > 1) {
        ASSERT_LE((jerks[2] - 2.0 * jerks[1] + jerks[0]).norm(),
                  bounds.crackle * step * step * (1.0 + 1e-9) + 4.0 * rounding)
            << what << start;
      }
      ASSERT_LE(m.angular_velocity.norm(), bounds.rate * (1.0 + 1e-9)) << what << start;
      ASSERT_LE(m.angular_acceleration.norm(), bounds.acceleration * (1.0 + 1e-9)) << what << start;
      ASSERT_LE(m.angular_jerk.norm(), bounds.jerk * (1.0 + 1e-9) + rounding) << what << start;
    }
  }
}

TEST(SegmentHull, IsAboveTheMotionOnEveryPart) {
  Forms forms(3);
  for (const double turn : {0.01, 1.0, 5.0, 60.0, 3000.0})
    for (int i = 0; i < 10; ++i) {
      expect_above(forms.product(turn), "product of " + std::to_string(turn) + " from ");
      expect_above(forms.chart(turn), "chart of " + std::to_string(turn) + " from ");
    }
}

TEST(SegmentHull, IsAboveTheMotionThatWindsAboutNearlyOneAxis) {
  Forms forms(6);
  for (const double turn : {1.0, 60.0, 3000.0, 1e6})
    for (const double aside : {0.0, 1e-9, 1e-3, 0.3})
      for (int i = 0; i < 4; ++i) {
        const std::string of = formatted("of {} with {} aside from ", turn, aside);
        expect_above(forms.winding_product(turn, aside), "product " + of);
        expect_above(forms.winding_chart(turn, aside), "chart " + of);
      }
}

TEST(SegmentHull, IsNearToTheMotionThatWindsAboutOneAxis) {
  Forms forms(7);
  for (const SegmentForm& form : {forms.winding_product(1e4, 0.0), forms.winding_chart(1e4, 0.0)})
    for (const double u : {0.1, 0.5, 0.9}) {
      const HullBounds bounds = SegmentHull::of(form, segment_duration).value().on(u, u + 1e-6);
      EXPECT_NEAR(bounds.jerk / motion_of(form, u).angular_jerk.norm(), 1.0, 1e-3);
      EXPECT_LE(bounds.snap, 1e8);  // of polynomials of 1e4 rad; the fourth power of the rate is 1e16
    }
}

TEST(SegmentHull, IsAboveTheMotionOfACurveOfR4) {
  Forms forms(4);
  for (const double size : {0.01, 0.3, 0.9})
    for (int i = 0; i < 20; ++i) expect_above(forms.rational(size), "rational of " + std::to_string(size) + " from ");
}

TEST(SegmentHull, IsNearToTheRateOfAShortPartOfACurveOfR4) {
  Forms forms(5);
  for (int i = 0; i < 10; ++i) {
    const SegmentForm form = forms.rational(0.3);
    const HullBounds bounds = SegmentHull::of(form, segment_duration).value().on(0.5, 0.5 + 1e-6);
    const auto& s = std::get<RationalForm>(form);
    Eigen::Vector4d point, rate;
    for (std::size_t k = 0; k < 4; ++k) {
      const Time component = value(s.components[k], RationalForm::degree, 0.5);
      point[static_cast<Eigen::Index>(k)] = component.c[0];
      rate[static_cast<Eigen::Index>(k)] = component.c[1];
    }
    EXPECT_NEAR(bounds.rate / (2.0 * rate.norm() / point.norm()), 1.0, 1e-4);
  }
}

TEST(SegmentHull, IsNearToTheRateWhereTheBodyWhirlsAboutTheSecondIncrement) {
  CumulativeForm form{.degree = 1, .base = Eigen::Quaterniond::Identity(), .increments = {}, .blending = {}};
  form.increments = {Eigen::Vector3d(400.0, 100.0, 0.0), Eigen::Vector3d(0.0, 900.0, 0.0),
                     Eigen::Vector3d(0.0, -300.0, 500.0)};
  for (auto& row : form.blending) row.coefficients[1] = 1.0;
  const HullBounds bounds = SegmentHull::of(form, segment_duration).value().on(0.5, 0.51);
  double rate = 0.0;
  for (int i = 0; i <= 10000; ++i) rate = std::max(rate, motion_of(form, 0.5 + 1e-6 * i).angular_velocity.norm());
  EXPECT_NEAR(bounds.rate / rate, 1.0, 1e-5);
  EXPECT_NEAR(bounds.rate * segment_duration, std::hypot(900.0 + 100.0 - 300.0, 400.0 + 500.0), 1e-6);
}

TEST(SegmentHull, IsNothingWithoutPolynomials) { EXPECT_FALSE(SegmentHull::of({}, segment_duration)); }

}}  // namespace orispline
